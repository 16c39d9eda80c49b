#include "learn/episode.h"

#include <math.h>
#include <stddef.h>

#include "learn/role.h"
#include "model/rounding.h"
#include "quarter/status.h"

/* The first difference of the settings: what Q is before it is learnt. The paper setting knows nothing; the certified
 * one begins at an upper bound. */
static double initial_value(const qtr_learner *learner, const qtr_situation *after) {
  return learner_is_paper(learner) ? 0.0 : qtr_bound_state(&learner->bound, after);
}

/* Q(s, a) is what the choice earns at once + the entry of the joint state after it: pairs (s, a) that lead to one such
 * state share the entry. Here is all but the entry: what it is before it is learnt. */
static void add_candidate(qtr_learner *learner, qtr_situation *after, int seeker, uint16_t choice) {
  qtr_candidates *c = &learner->candidates;
  const unsigned i = c->count++;
  c->choice[i] = choice;
  c->at_once[i] = qtr_environment_choose(learner->environment, after, seeker, choice);
  qtr_environment_key(learner->environment, after, &c->key[i]);
  c->q[i] = initial_value(learner, after);
}

/* One situation is all choices', one after the other, for most of its bytes stay as they are. */
static void list_choices(qtr_learner *learner, const qtr_situation *state, int seeker) {
  const qtr_board *board = &learner->environment->board;
  qtr_situation after = *state;
  qtr_places choices;
  const bool may_stand_down = qtr_joint_choices(&state->joint, board, seeker, &choices);
  learner->candidates.count = 0;
  for (uint16_t place = 0; place < board->places; place++) {
    if (!qtr_places_has(&choices, place)) continue;
    add_candidate(learner, &after, seeker, place);
    qtr_environment_undo(learner->environment, &after, state, seeker, place);
  }
  if (may_stand_down) add_candidate(learner, &after, seeker, QTR_STAND_DOWN);
}

/* In the certified setting the bound may be tighter than an entry that was made at another step of the clock: keys
 * without a clock know no time, prices do. Both are Q* or more, so the lesser is. */
static double entry_value(const qtr_learner *learner, unsigned i, uint32_t home) {
  const qtr_candidates *c = &learner->candidates;
  double stored;
  if (!qtr_qtable_get_from(&learner->table, &c->key[i], home, &stored)) return c->q[i];
  return learner_is_paper(learner) || stored < c->q[i] ? stored : c->q[i];
}

/* All entries' memory is asked for before the first is read: the waits for it go by together. */
static void look_entries_up(qtr_learner *learner) {
  qtr_candidates *c = &learner->candidates;
  uint32_t home[QTR_MAX_PLACES + 1];
  for (unsigned i = 0; i < c->count; i++) home[i] = qtr_qtable_home(&learner->table, &c->key[i]);
  for (unsigned i = 0; i < c->count; i++) c->q[i] = c->at_once[i] + entry_value(learner, i, home[i]);
}

void qtr_episode_list(qtr_learner *learner, const qtr_situation *state, int seeker) {
  list_choices(learner, state, seeker);
  /* Whose turn it is has a target to choose: max Q(s', a') of Eq. 4.7 is over something. */
  QTR_ASSERT(learner->candidates.count > 0);
  look_entries_up(learner);
}

unsigned qtr_episode_greedy(const qtr_candidates *c) {
  unsigned best = 0;
  for (unsigned i = 1; i < c->count; i++)
    if (c->q[i] > c->q[best]) best = i;
  return best;
}

/* max over a' != a of Q(s, a'): with it the backup knows max Q of a state without listing its choices again. */
static double largest_but(const qtr_candidates *c, unsigned picked) {
  double largest = -HUGE_VAL;
  for (unsigned i = 0; i < c->count; i++)
    if (i != picked && c->q[i] > largest) largest = c->q[i];
  return largest;
}

void qtr_episode_note(qtr_learner *learner, unsigned picked) {
  const qtr_candidates *c = &learner->candidates;
  /* Each place is chosen once and each seeker stands down once: a game is no longer than its trace. */
  QTR_ASSERT(learner->play.choices < QTR_MAX_CHOICES);
  qtr_trace *trace = &learner->trace[learner->play.choices];
  trace->key = c->key[picked];
  trace->q = c->q[picked];
  trace->runner_up = largest_but(c, picked);
  trace->at_once = c->at_once[picked];
}

void qtr_episode_act(qtr_learner *learner, qtr_situation *state, int seeker, uint16_t choice) {
  qtr_trace *trace = &learner->trace[learner->play.choices];
  qtr_environment_choose(learner->environment, state, seeker, choice);
  trace->first = state->at[seeker];
  qtr_environment_pass(learner->environment, state, &trace->outcome);
  qtr_play_add(&learner->play, seeker, choice);
}

/* gamma^(tau-1) R + gamma^tau max Q(s', a'): the outcome's reward and discount hold both powers. */
double qtr_episode_backup(const qtr_trace *trace, double value) {
  /* gamma^tau: a backup never makes more of what comes after, so that it keeps a bound one. */
  QTR_ASSERT(trace->outcome.discount >= 0.0 && trace->outcome.discount <= 1.0);
  return trace->outcome.reward + trace->outcome.discount * value;
}

/* ---- what an episode is worth: what its choices earn on the ground ---- */

/* Targets chosen become routes of places, each place for whoever chose it first. */
void qtr_episode_play_on_ground(qtr_learner *learner) {
  qtr_routes *routes = &learner->routes;
  qtr_places taken;
  qtr_places_clear(&taken);
  for (unsigned seeker = 0; seeker < learner->game->board.seekers; seeker++) routes->length[seeker] = 0;
  for (unsigned i = 0; i < learner->play.choices; i++) {
    if (learner->play.choice[i] == QTR_STAND_DOWN) continue;
    const unsigned seeker = learner->play.seeker[i];
    const qtr_tour *tour = qtr_targets_tour(&learner->environment->targets, learner->trace[i].first);
    for (unsigned j = 0; j < tour->places; j++) {
      if (qtr_places_has(&taken, tour->place[j])) continue;
      qtr_places_add(&taken, tour->place[j]);
      routes->place[seeker][routes->length[seeker]++] = tour->place[j];
    }
  }
  qtr_play_routes(&learner->play, learner->game, routes);
}

/* What counts is what the choices earn on the ground. */
void qtr_episode_keep_if_best(qtr_learner *learner) {
  if (learner_is_aggregate(learner))
    qtr_episode_play_on_ground(learner);
  else
    qtr_play_score(&learner->play, learner->game);
  if (qtr_score_is_better(&learner->play.score, &learner->best.score)) learner->best = learner->play;
}
