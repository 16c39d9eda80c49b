#include "learn/exploring.h"

#include <math.h>
#include <string.h>

#include "learn/certificate.h"
#include "learn/episode.h"
#include "learn/role.h"
#include "model/rounding.h"

/* ---- what the greedy game has read ---- */

static uint32_t bit_of(const qtr_learner *learner, const qtr_key *key) {
  return qtr_qtable_hash(&learner->table, key) % QTR_READ_BITS;
}

static void note_read(qtr_learner *learner) {
  const qtr_candidates *c = &learner->candidates;
  for (unsigned i = 0; i < c->count; i++) {
    const uint32_t bit = bit_of(learner, &c->key[i]);
    learner->read[bit / 32] |= (uint32_t)1 << bit % 32;
  }
}

static bool was_read(const qtr_learner *learner, const qtr_key *key) {
  const uint32_t bit = bit_of(learner, key);
  return (learner->read[bit / 32] >> bit % 32 & 1u) != 0;
}

/* ---- episodes ---- */

/* Q(s,a) <- (1 - alpha) Q(s,a) + alpha backup, for the choice made last; `value` is the largest Q of the state now.
 * With alpha = 1 that is Eq. 4.7 itself, right where a choice always leads to one state. */
static void back_up_last(qtr_learner *learner, double value) {
  if (learner->play.choices == 0) return;
  const qtr_trace *trace = &learner->trace[learner->play.choices - 1];
  const double before = trace->q - trace->at_once;
  const double after = before + learner->config.alpha * (qtr_episode_backup(trace, value) - before);
  const bool changes = qtr_qtable_nearest(&learner->table, after) != qtr_qtable_nearest(&learner->table, before);
  if (!changes && before != 0.0) return;
  if (qtr_qtable_set(&learner->table, &trace->key, after)) learner->updates++;
  if (changes && was_read(learner, &trace->key)) learner->replayed = false;
}

/* Each choice is backed up when the next one's Q are known (Fig. 3.1), the last one when nothing more can come. False:
 * stopped. What was learnt until then stays. */
static bool run_exploring_episode(qtr_learner *learner) {
  qtr_situation state;
  qtr_outcome first;
  int seeker;
  qtr_play_begin(&learner->play);
  qtr_environment_start(learner->environment, &state);
  qtr_environment_pass(learner->environment, &state, &first);
  while ((seeker = qtr_joint_chooser(&state.joint, &learner->environment->board)) != QTR_NOBODY) {
    if (!learner_may_go_on(learner)) return false;
    qtr_episode_list(learner, &state, seeker);
    const double largest = learner->candidates.q[qtr_episode_greedy(&learner->candidates)];
    back_up_last(learner, largest);
    const unsigned picked = qtr_explorer_pick(&learner->explorer, learner->candidates.q, learner->candidates.count);
    qtr_episode_note(learner, picked);
    qtr_episode_act(learner, &state, seeker, learner->candidates.choice[picked]);
  }
  back_up_last(learner, 0.0);
  qtr_explorer_next(&learner->explorer);
  return true;
}

/* What has been learnt so far, played without learning: the policy that the paper measures. The first such game is the
 * best one, whatever was played before, for the setting is to show what it learns by itself. */
static void play_greedily(qtr_learner *learner) {
  qtr_situation state;
  qtr_outcome first;
  int seeker;
  memset(learner->read, 0, sizeof learner->read);
  qtr_play_begin(&learner->play);
  qtr_environment_start(learner->environment, &state);
  qtr_environment_pass(learner->environment, &state, &first);
  while ((seeker = qtr_joint_chooser(&state.joint, &learner->environment->board)) != QTR_NOBODY) {
    if (!learner_may_go_on(learner)) return;
    qtr_episode_list(learner, &state, seeker);
    note_read(learner);
    const unsigned picked = qtr_episode_greedy(&learner->candidates);
    if (learner->play.choices == 0) learner->max_q = learner->candidates.q[picked];
    qtr_episode_act(learner, &state, seeker, learner->candidates.choice[picked]);
  }
  if (learner->episodes == 1) learner->best.score.worth = -HUGE_VAL;
  qtr_episode_keep_if_best(learner);
  learner->replayed = true;
}

/* The greedy game is the last one for as long as no entry has changed that it read. That saves most replays, of which
 * each takes as long as an episode. With a gap of 0 the paper's experiments go on for as many episodes as they ask
 * for. */
enum qtr_learning qtr_exploring_step(qtr_learner *learner) {
  if (!run_exploring_episode(learner)) return QTR_LEARNING;
  learner->episodes++;
  if (!learner->replayed) play_greedily(learner);
  return learner->config.gap > 0.0 && qtr_certificate_closed(learner) ? QTR_CERTIFIED : QTR_LEARNING;
}
