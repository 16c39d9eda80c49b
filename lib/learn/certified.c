#include "learn/certified.h"

#include <math.h>

#include "learn/certificate.h"
#include "learn/episode.h"
#include "learn/planning.h"
#include "learn/role.h"
#include "model/rounding.h"
#include "quarter/status.h"

#define LATER_ROUNDS 4 /* of shaking a better game */

static bool is_below_entry(const qtr_learner *learner, const qtr_key *key, double backup) {
  double stored;
  return !qtr_qtable_get(&learner->table, key, &stored) || backup < stored;
}

/* Q(s,a) <- min(Q(s,a), backup); `value` is the largest Q of the state where the episode ended. Returns the largest Q
 * of the first state.
 *
 * Q >= Q* before means Q >= Q* after: the backup R + gamma^tau max Q(s', .) is no less than R + gamma^tau max Q*(s',
 * .), which is Q*(s, a). From the end to the start, so that what was found out at the end reaches the start in one
 * episode. */
static double back_up_all(qtr_learner *learner, double value) {
  for (unsigned i = learner->play.choices; i-- > 0;) {
    const qtr_trace *trace = &learner->trace[i];
    const double backup = qtr_qtable_round_up(&learner->table, qtr_episode_backup(trace, value));
    double q = trace->at_once + backup;
    /* Q only ever falls: an entry is the least of bounds, each of them Q* or more. */
    QTR_ASSERT(q >= trace->q || is_below_entry(learner, &trace->key, backup));
    if (q < trace->q && qtr_qtable_set(&learner->table, &trace->key, backup))
      learner->updates++;
    else
      q = trace->q;
    value = q > trace->runner_up ? q : trace->runner_up;
  }
  return value;
}

/* One game, given up as soon as it cannot beat the best one, or when stopped: it can earn no more than earned + gamma^t
 * Q. What it has shown until then is backed up. Greedy on Q >= Q*, so the first choice's Q is a bound on every policy:
 * where a greedy game earns as much as it promised, it is optimal. */
static void certified_run(qtr_learner *learner) {
  /* Half of the gap: the other half takes up what rounding adds on the way back to the first state. */
  const double hopeless = qtr_certificate_within(learner, 0.5);
  qtr_situation state;
  qtr_outcome first; /* until somebody is ready: of no time where one is from the start */
  double value = 0.0;
  int seeker;
  qtr_play_begin(&learner->play);
  qtr_environment_start(learner->environment, &state);
  qtr_environment_pass(learner->environment, &state, &first);
  double earned = first.reward;
  double discount = first.discount;
  while ((seeker = qtr_joint_chooser(&state.joint, &learner->environment->board)) != QTR_NOBODY) {
    qtr_episode_list(learner, &state, seeker);
    const unsigned picked = qtr_episode_greedy(&learner->candidates);
    const qtr_trace *trace = &learner->trace[learner->play.choices];
    qtr_episode_note(learner, picked);
    if (earned + discount * trace->q <= hopeless || !learner_may_go_on(learner)) {
      value = trace->q;
      break;
    }
    qtr_episode_act(learner, &state, seeker, learner->candidates.choice[picked]);
    earned += discount * (trace->at_once + trace->outcome.reward);
    discount *= trace->outcome.discount;
  }
  const double upper = first.reward + first.discount * back_up_all(learner, value);
  /* A game played to its end is what some policy earns: Q(s0, a) >= Q* is no less. */
  QTR_ASSERT(seeker != QTR_NOBODY || qtr_certificate_bounds(upper, earned));
  if (upper < learner->upper) learner->upper = upper;
  if (!learner_is_aggregate(learner)) learner->ground_upper = learner->upper;
  if (seeker == QTR_NOBODY) qtr_episode_keep_if_best(learner);
}

/* ---- local search on the best game ---- */

/* Not where the setting's own best policy is sought; nor under the paper's rule, where routes alone do not make a game:
 * who must choose when depends on the others. */
void qtr_certified_refine(qtr_learner *learner, unsigned rounds) {
  if (learner_learns_alone(learner) || learner->game->board.rule != QTR_RULE_FREE) return;
  qtr_play_to_routes(&learner->best, learner->game, &learner->routes);
  qtr_refine(&learner->refinery, &learner->routes, learner->game, rounds, learner->config.seed + learner->episodes);
  qtr_play_routes(&learner->play, learner->game, &learner->routes);
  if (qtr_score_is_better(&learner->play.score, &learner->best.score)) learner->best = learner->play;
}

enum qtr_learning qtr_certified_step(qtr_learner *learner) {
  const uint64_t updates = learner->updates;
  const double best = learner->best.score.worth;
  const double upper = learner->upper;
  learner->episodes++;
  certified_run(learner);
  if (learner->best.score.worth > best) qtr_certified_refine(learner, LATER_ROUNDS);
  qtr_planning_step(learner);
  if (!learner_is_aggregate(learner)) learner->ground_upper = learner->upper;
  /* Anytime: what is known when learning stops is the best that was ever known. */
  QTR_ASSERT(learner->best.score.worth >= best && learner->upper <= upper);
  const bool learnt = learner->updates > updates || learner->best.score.worth > best || learner->upper < upper;
  return learnt || qtr_certificate_closed(learner) || !learner_may_go_on(learner) ? qtr_certificate_verdict(learner)
                                                                                  : QTR_CONVERGED;
}
