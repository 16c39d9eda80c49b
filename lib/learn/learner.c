#include "quarter/learner.h"

#include <math.h>
#include <stddef.h>

#include "quarter/status.h"

#define PRICE_STEPS 16 /* of the bound in one step of the learner */
#define FIRST_ROUNDS 8 /* of shaking the first game */
#define LATER_ROUNDS 4 /* of shaking a better one */

void qtr_learner_config_default(qtr_learner_config *config) {
  config->gap = 1e-5;
  config->seed = 1;
}

/* ---- games as they are played ---- */

static void play_begin(qtr_play *play) {
  play->choices = 0;
  for (unsigned place = 0; place < QTR_MAX_PLACES; place++) play->visit[place] = QTR_NEVER;
}

static void play_choose(qtr_play *play, int seeker, uint16_t choice) {
  play->seeker[play->choices] = (uint8_t)seeker;
  play->choice[play->choices++] = choice;
}

/* Score a game by playing its choices again: what is reported is what these choices earn, whatever was learnt. */
static void play_score(qtr_play *play, const qtr_game *game) {
  qtr_state state;
  qtr_outcome outcome;
  qtr_game_start(game, &state);
  for (unsigned i = 0; i < play->choices; i++) {
    const uint16_t choice = play->choice[i];
    if (choice != QTR_STAND_DOWN) {
      const qtr_steps when =
          state.now + qtr_board_steps(&game->board, state.joint.node[play->seeker[i]], choice);
      if (when < play->visit[choice]) play->visit[choice] = when;
    }
    qtr_game_choose(game, &state, play->seeker[i], choice);
    qtr_game_pass(game, &state, &outcome);
  }
  qtr_game_score(game, play->visit, &play->score);
}

/* ---- the certified setting's action strategy: greedy on Q ---- */

/* Q of an entry, or the bound where there is none yet. */
static double entry_value(const qtr_learner *learner, const qtr_state *after, const qtr_key *key) {
  const double bound = qtr_bound_state(&learner->bound, &after->joint, after->now, after->unvisited);
  float stored;
  if (qtr_qtable_get(&learner->table, key, &stored) && (double)stored < bound) return (double)stored;
  return bound;
}

static void consider(const qtr_learner *learner, const qtr_state *state, int seeker, uint16_t choice, qtr_trace *trace,
                     uint16_t *best) {
  qtr_state after = *state;
  qtr_key key;
  const double at_once = qtr_game_choose(learner->game, &after, seeker, choice);
  qtr_joint_key(&key, &after.joint, &learner->game->board);
  const double q = at_once + entry_value(learner, &after, &key);
  if (q <= trace->q) {
    if (q > trace->runner_up) trace->runner_up = q;
    return;
  }
  trace->runner_up = trace->q;
  trace->q = q;
  trace->at_once = at_once;
  trace->key = key;
  *best = choice;
}

/* The choice with the largest Q, the lowest place among equals. */
static uint16_t act_greedily(const qtr_learner *learner, const qtr_state *state, int seeker, qtr_trace *trace) {
  const qtr_board *board = &learner->game->board;
  qtr_places choices;
  uint16_t best = QTR_STAND_DOWN;
  const bool may_stand_down = qtr_joint_choices(&state->joint, board, seeker, &choices);
  trace->q = -HUGE_VAL;
  trace->runner_up = -HUGE_VAL;
  for (uint16_t place = 0; place < board->places; place++)
    if (qtr_places_has(&choices, place)) consider(learner, state, seeker, place, trace, &best);
  if (may_stand_down) consider(learner, state, seeker, QTR_STAND_DOWN, trace, &best);
  return best;
}

/* ---- the Q-learning unit ---- */

/* Rounded up, so that a float bounds what its double bounds. */
static float round_up(double value) {
  const float rounded = (float)value;
  return (double)rounded < value ? nextafterf(rounded, HUGE_VALF) : rounded;
}

/* Q(s,a) <- min(Q(s,a), backup), from the episode's end to its start; `value` is the largest Q of the state where it
 * ended. Returns the largest Q of the first state. */
static double back_up(qtr_learner *learner, unsigned choices, double value) {
  for (unsigned i = choices; i-- > 0;) {
    const qtr_trace *trace = &learner->trace[i];
    const float backup = round_up(trace->outcome.reward + trace->outcome.discount * value);
    double q = trace->at_once + (double)backup;
    if (q < trace->q) {
      if (qtr_qtable_set(&learner->table, &trace->key, backup))
        learner->updates++;
      else
        q = trace->q;
    } else {
      q = trace->q;
    }
    value = q > trace->runner_up ? q : trace->runner_up;
  }
  return value;
}

/* The best game's worth and a share of the gap asked for. */
static double within_gap(const qtr_learner *learner, double share) {
  return learner->best.score.worth + share * learner->config.gap * fabs(learner->best.score.worth);
}

static bool is_certified(const qtr_learner *learner) {
  return learner->upper <= within_gap(learner, 1.0);
}

static void keep_best(qtr_learner *learner) {
  play_score(&learner->play, learner->game);
  if (learner->play.score.worth > learner->best.score.worth) learner->best = learner->play;
}

/* One game, greedy, given up as soon as it cannot beat the best one. */
static void run_episode(qtr_learner *learner) {
  const qtr_game *game = learner->game;
  /* Half of the gap: the other half takes up what rounding adds on the way back to the first state. */
  const double hopeless = within_gap(learner, 0.5);
  qtr_state state;
  double earned = 0.0;
  double discount = 1.0;
  double value = 0.0;
  int seeker;
  play_begin(&learner->play);
  qtr_game_start(game, &state);
  while ((seeker = qtr_joint_chooser(&state.joint, &game->board)) != QTR_NOBODY) {
    qtr_trace *trace = &learner->trace[learner->play.choices];
    const uint16_t choice = act_greedily(learner, &state, seeker, trace);
    if (earned + discount * trace->q <= hopeless) {
      value = trace->q;
      break;
    }
    earned += discount * qtr_game_choose(game, &state, seeker, choice);
    qtr_game_pass(game, &state, &trace->outcome);
    play_choose(&learner->play, seeker, choice);
    earned += discount * trace->outcome.reward;
    discount *= trace->outcome.discount;
  }
  learner->episodes++;
  const double upper = back_up(learner, learner->play.choices, value);
  if (upper < learner->upper) learner->upper = upper;
  if (seeker == QTR_NOBODY) keep_best(learner);
}

/* ---- local search on the best game ---- */

static void routes_of_best(qtr_learner *learner) {
  qtr_routes *routes = &learner->routes;
  for (unsigned seeker = 0; seeker < learner->game->board.seekers; seeker++) routes->length[seeker] = 0;
  for (unsigned i = 0; i < learner->best.choices; i++) {
    const unsigned seeker = learner->best.seeker[i];
    if (learner->best.choice[i] == QTR_STAND_DOWN) continue;
    routes->place[seeker][routes->length[seeker]++] = learner->best.choice[i];
  }
}

/* Play routes as a game: each seeker takes its next place, and stands down at its route's end. */
static void play_routes(qtr_learner *learner) {
  const qtr_game *game = learner->game;
  const qtr_routes *routes = &learner->routes;
  uint16_t next[QTR_MAX_SEEKERS] = {0};
  qtr_state state;
  qtr_outcome outcome;
  int seeker;
  play_begin(&learner->play);
  qtr_game_start(game, &state);
  while ((seeker = qtr_joint_chooser(&state.joint, &game->board)) != QTR_NOBODY) {
    const bool ended = next[seeker] == routes->length[seeker];
    const uint16_t choice = ended ? QTR_STAND_DOWN : routes->place[seeker][next[seeker]++];
    qtr_game_choose(game, &state, seeker, choice);
    qtr_game_pass(game, &state, &outcome);
    play_choose(&learner->play, seeker, choice);
  }
}

/* Under the paper's rule routes alone do not make a game: who must choose when depends on the others. */
static void refine_best(qtr_learner *learner, unsigned rounds) {
  if (learner->game->board.rule != QTR_RULE_FREE) return;
  routes_of_best(learner);
  qtr_refine(&learner->refinery, &learner->routes, learner->game, rounds, learner->config.seed + learner->episodes);
  play_routes(learner);
  keep_best(learner);
}

/* ---- set-up and steps ---- */

/* The first game, to have something to improve on: always the most likely place for the way. */
static void play_by_rate(qtr_learner *learner) {
  const qtr_game *game = learner->game;
  qtr_state state;
  qtr_outcome outcome;
  int seeker;
  play_begin(&learner->best);
  qtr_game_start(game, &state);
  while ((seeker = qtr_joint_chooser(&state.joint, &game->board)) != QTR_NOBODY) {
    qtr_places choices;
    uint16_t choice = QTR_STAND_DOWN;
    double best = -1.0;
    qtr_joint_choices(&state.joint, &game->board, seeker, &choices);
    for (uint16_t place = 0; place < game->board.places; place++) {
      if (!qtr_places_has(&choices, place)) continue;
      const qtr_steps steps = qtr_board_steps(&game->board, state.joint.node[seeker], place);
      const double rate = game->probability[place] / (steps > 0 ? (double)steps : 0.5);
      if (rate <= best) continue;
      best = rate;
      choice = place;
    }
    qtr_game_choose(game, &state, seeker, choice);
    qtr_game_pass(game, &state, &outcome);
    play_choose(&learner->best, seeker, choice);
  }
  play_score(&learner->best, game);
  learner->episodes++;
}

int qtr_learner_init_built(qtr_learner *learner, const qtr_game *game, const qtr_learner_config *config,
                           uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  if (!(config->gap >= 0.0 && config->gap < HUGE_VAL)) return QTR_ERR_ARGUMENT;
  learner->game = game;
  learner->config = *config;
  learner->episodes = 0;
  learner->updates = 0;
  learner->pricing = true;
  play_by_rate(learner);
  refine_best(learner, FIRST_ROUNDS);
  qtr_qtable_init(&learner->table, &game->board);
  qtr_bound_init(&learner->bound, game, learner->best.visit);
  learner->upper = learner->bound.upper;
  return QTR_OK;
}

static void tune_prices(qtr_learner *learner) {
  for (int i = 0; i < PRICE_STEPS && learner->pricing; i++)
    learner->pricing = qtr_bound_improve(&learner->bound, learner->best.score.worth);
  if (learner->bound.upper < learner->upper) learner->upper = learner->bound.upper;
  if (!learner->pricing) qtr_bound_settle(&learner->bound);
}

enum qtr_learning qtr_learner_step(qtr_learner *learner) {
  if (is_certified(learner)) return QTR_CERTIFIED;
  if (learner->pricing) {
    tune_prices(learner);
  } else {
    const uint64_t updates = learner->updates;
    const double best = learner->best.score.worth;
    const double upper = learner->upper;
    run_episode(learner);
    if (learner->best.score.worth > best) refine_best(learner, LATER_ROUNDS);
    const bool learnt = learner->updates > updates || learner->best.score.worth > best || learner->upper < upper;
    if (!learnt) return is_certified(learner) ? QTR_CERTIFIED : QTR_CONVERGED;
  }
  return is_certified(learner) ? QTR_CERTIFIED : QTR_LEARNING;
}

void qtr_learner_certificate(const qtr_learner *learner, qtr_certificate *certificate) {
  const qtr_score *score = &learner->best.score;
  const double upper = learner->upper > score->worth ? learner->upper : score->worth;
  const bool time = learner->game->mission->objective == QTR_TIME;
  certificate->value = score->value;
  certificate->expected_time = score->expected_time;
  certificate->objective = time ? score->expected_time : score->value;
  certificate->bound = time ? -upper : upper;
  certificate->gap = upper > score->worth ? (upper - score->worth) / fabs(score->worth) : 0.0;
  certificate->certified = is_certified(learner);
  certificate->episodes = learner->episodes;
  certificate->updates = learner->updates;
  certificate->price_steps = learner->bound.iterations;
}

const qtr_play *qtr_learner_best(const qtr_learner *learner) {
  return &learner->best;
}
