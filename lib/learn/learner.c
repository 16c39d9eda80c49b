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
  config->setting = QTR_SETTING_CERTIFIED;
  config->alpha = 1.0;
  config->ground_search = true;
  qtr_exploration_default(&config->exploration);
}

static bool is_paper(const qtr_learner *learner) {
  return learner->config.setting == QTR_SETTING_PAPER;
}

static bool may_go_on(const qtr_learner *learner) {
  return qtr_watch_go_on(&learner->game->mission->watch);
}

static bool is_aggregate(const qtr_learner *learner) {
  return learner->environment != learner->ground;
}

/* Whether the result is to be what the setting learns, and nothing found beside it. */
static bool learns_alone(const qtr_learner *learner) {
  return is_paper(learner) || (is_aggregate(learner) && !learner->config.ground_search);
}

/* ---- first difference of the settings: what Q is before it is learnt ---- */

static double initial_value(const qtr_learner *learner, const qtr_situation *after) {
  if (is_paper(learner)) return 0.0;
  return qtr_bound_state(&learner->bound, after);
}

/* In the certified setting the bound may be tighter than an entry that was made at another step of the clock. */
static double entry_value(const qtr_learner *learner, const qtr_situation *after, const qtr_key *key) {
  const double initial = initial_value(learner, after);
  double stored;
  if (!qtr_qtable_get(&learner->table, key, &stored)) return initial;
  return is_paper(learner) || stored < initial ? stored : initial;
}

static void add_candidate(qtr_learner *learner, const qtr_situation *state, int seeker, uint16_t choice) {
  qtr_candidates *c = &learner->candidates;
  const unsigned i = c->count++;
  qtr_situation after = *state;
  c->choice[i] = choice;
  c->at_once[i] = qtr_environment_choose(learner->environment, &after, seeker, choice);
  qtr_environment_key(learner->environment, &after, &c->key[i]);
  c->q[i] = c->at_once[i] + entry_value(learner, &after, &c->key[i]);
}

/* Q of all that a seeker may choose, the places in their order, standing down last. */
static void list_candidates(qtr_learner *learner, const qtr_situation *state, int seeker) {
  const qtr_board *board = &learner->environment->board;
  qtr_places choices;
  const bool may_stand_down = qtr_joint_choices(&state->joint, board, seeker, &choices);
  learner->candidates.count = 0;
  for (uint16_t place = 0; place < board->places; place++)
    if (qtr_places_has(&choices, place)) add_candidate(learner, state, seeker, place);
  if (may_stand_down) add_candidate(learner, state, seeker, QTR_STAND_DOWN);
}

/* The candidate with the largest Q, the first among equals. */
static unsigned greedy(const qtr_candidates *c) {
  unsigned best = 0;
  for (unsigned i = 1; i < c->count; i++)
    if (c->q[i] > c->q[best]) best = i;
  return best;
}

static double largest_but(const qtr_candidates *c, unsigned picked) {
  double largest = -HUGE_VAL;
  for (unsigned i = 0; i < c->count; i++)
    if (i != picked && c->q[i] > largest) largest = c->q[i];
  return largest;
}

static void note_choice(qtr_learner *learner, unsigned picked) {
  const qtr_candidates *c = &learner->candidates;
  qtr_trace *trace = &learner->trace[learner->play.choices];
  trace->key = c->key[picked];
  trace->q = c->q[picked];
  trace->runner_up = largest_but(c, picked);
  trace->at_once = c->at_once[picked];
}

/* Make the choice noted last, and let time pass. */
static void act(qtr_learner *learner, qtr_situation *state, int seeker, uint16_t choice) {
  qtr_trace *trace = &learner->trace[learner->play.choices];
  qtr_environment_choose(learner->environment, state, seeker, choice);
  trace->first = state->at[seeker];
  qtr_environment_pass(learner->environment, state, &trace->outcome);
  qtr_play_add(&learner->play, seeker, choice);
}

/* Eq. 4.7, for the entry of a choice: `value` is the largest Q of the state that it led to. */
static double backup_of(const qtr_trace *trace, double value) {
  return trace->outcome.reward + trace->outcome.discount * value;
}

/* Targets chosen become routes of places, each place for whoever chose it first. */
static void play_on_ground(qtr_learner *learner) {
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
static void keep_if_best(qtr_learner *learner) {
  if (is_aggregate(learner))
    play_on_ground(learner);
  else
    qtr_play_score(&learner->play, learner->game);
  if (qtr_score_is_better(&learner->play.score, &learner->best.score)) learner->best = learner->play;
}

/* ---- the certified setting: greedy, backed up from the end to the start ---- */

/* Q(s,a) <- min(Q(s,a), backup); `value` is the largest Q of the state where the episode ended. Returns the largest Q of
 * the first state. */
static double back_up_all(qtr_learner *learner, double value) {
  for (unsigned i = learner->play.choices; i-- > 0;) {
    const qtr_trace *trace = &learner->trace[i];
    const double backup = qtr_qtable_round_up(&learner->table, backup_of(trace, value));
    double q = trace->at_once + backup;
    if (q < trace->q && qtr_qtable_set(&learner->table, &trace->key, backup))
      learner->updates++;
    else
      q = trace->q;
    value = q > trace->runner_up ? q : trace->runner_up;
  }
  return value;
}

/* The best game's worth and a share of the gap asked for. */
static double within_gap(const qtr_learner *learner, double share) {
  const double gap = learner->config.gap > QTR_LEAST_GAP ? learner->config.gap : QTR_LEAST_GAP;
  return learner->best.score.worth + share * gap * fabs(learner->best.score.worth);
}

static bool is_certified(const qtr_learner *learner) {
  return learner->ground_upper <= within_gap(learner, 1.0);
}

/* One game, given up as soon as it cannot beat the best one, or when stopped. */
static void run_certified_episode(qtr_learner *learner) {
  /* Half of the gap: the other half takes up what rounding adds on the way back to the first state. */
  const double hopeless = within_gap(learner, 0.5);
  qtr_situation state;
  double earned = 0.0;
  double discount = 1.0;
  double value = 0.0;
  int seeker;
  qtr_play_begin(&learner->play);
  qtr_environment_start(learner->environment, &state);
  while ((seeker = qtr_joint_chooser(&state.joint, &learner->environment->board)) != QTR_NOBODY) {
    list_candidates(learner, &state, seeker);
    const unsigned picked = greedy(&learner->candidates);
    const qtr_trace *trace = &learner->trace[learner->play.choices];
    note_choice(learner, picked);
    if (earned + discount * trace->q <= hopeless || !may_go_on(learner)) {
      value = trace->q;
      break;
    }
    act(learner, &state, seeker, learner->candidates.choice[picked]);
    earned += discount * (trace->at_once + trace->outcome.reward);
    discount *= trace->outcome.discount;
  }
  const double upper = back_up_all(learner, value);
  if (upper < learner->upper) learner->upper = upper;
  if (!is_aggregate(learner)) learner->ground_upper = learner->upper;
  if (seeker == QTR_NOBODY) keep_if_best(learner);
}

/* ---- the paper setting: exploring, each step backed up as it comes ---- */

/* Q(s,a) <- (1 - alpha) Q(s,a) + alpha backup, for the choice made last; `value` is the largest Q of the state now. */
static void back_up_last(qtr_learner *learner, double value) {
  if (learner->play.choices == 0) return;
  const qtr_trace *trace = &learner->trace[learner->play.choices - 1];
  const double before = trace->q - trace->at_once;
  const double after = before + learner->config.alpha * (backup_of(trace, value) - before);
  if (qtr_qtable_nearest(&learner->table, after) == qtr_qtable_nearest(&learner->table, before) && before != 0.0)
    return;
  if (qtr_qtable_set(&learner->table, &trace->key, after)) learner->updates++;
}

/* False: stopped. What was learnt until then stays. */
static bool run_exploring_episode(qtr_learner *learner) {
  qtr_situation state;
  int seeker;
  qtr_play_begin(&learner->play);
  qtr_environment_start(learner->environment, &state);
  while ((seeker = qtr_joint_chooser(&state.joint, &learner->environment->board)) != QTR_NOBODY) {
    if (!may_go_on(learner)) return false;
    list_candidates(learner, &state, seeker);
    const double largest = learner->candidates.q[greedy(&learner->candidates)];
    back_up_last(learner, largest);
    const unsigned picked = qtr_explorer_pick(&learner->explorer, learner->candidates.q, learner->candidates.count);
    note_choice(learner, picked);
    act(learner, &state, seeker, learner->candidates.choice[picked]);
  }
  back_up_last(learner, 0.0);
  qtr_explorer_next(&learner->explorer);
  return true;
}

/* What has been learnt so far, played without learning. The first such game is the best one, whatever was played before. */
static void play_greedily(qtr_learner *learner) {
  qtr_situation state;
  int seeker;
  qtr_play_begin(&learner->play);
  qtr_environment_start(learner->environment, &state);
  while ((seeker = qtr_joint_chooser(&state.joint, &learner->environment->board)) != QTR_NOBODY) {
    if (!may_go_on(learner)) return;
    list_candidates(learner, &state, seeker);
    const unsigned picked = greedy(&learner->candidates);
    if (learner->play.choices == 0) learner->max_q = learner->candidates.q[picked];
    act(learner, &state, seeker, learner->candidates.choice[picked]);
  }
  if (learner->episodes == 1) learner->best.score.worth = -HUGE_VAL;
  keep_if_best(learner);
}

/* ---- local search on the best game ---- */

/* Not where the setting's own best policy is sought; nor under the paper's rule, where routes alone do not make a game: who
 * must choose when depends on the others. */
static void refine_best(qtr_learner *learner, unsigned rounds) {
  if (learns_alone(learner) || learner->game->board.rule != QTR_RULE_FREE) return;
  qtr_play_to_routes(&learner->best, learner->game, &learner->routes);
  qtr_refine(&learner->refinery, &learner->routes, learner->game, rounds, learner->config.seed + learner->episodes);
  qtr_play_routes(&learner->play, learner->game, &learner->routes);
  if (qtr_score_is_better(&learner->play.score, &learner->best.score)) learner->best = learner->play;
}

/* ---- set-up and steps ---- */

static int check_config(qtr_learner *learner, const qtr_learner_config *config) {
  if (!(config->gap >= 0.0 && config->gap < HUGE_VAL) || config->setting > QTR_SETTING_PAPER) return QTR_ERR_ARGUMENT;
  if (!(config->alpha > 0.0 && config->alpha <= 1.0)) return QTR_ERR_ARGUMENT;
  if (config->setting == QTR_SETTING_CERTIFIED && !qtr_sight_is_exact(&learner->environment->sight))
    return QTR_ERR_ARGUMENT;
  if (is_aggregate(learner) && learner->game->board.rule != QTR_RULE_FREE) return QTR_ERR_ARGUMENT;
  return qtr_explorer_init(&learner->explorer, &config->exploration, config->seed);
}

/* As on the ground: always the most likely target for the time that it takes. */
static void play_aggregate_by_rate(qtr_learner *learner) {
  const qtr_environment *environment = learner->environment;
  qtr_situation state;
  int seeker;
  qtr_play_begin(&learner->play);
  qtr_environment_start(environment, &state);
  while ((seeker = qtr_joint_chooser(&state.joint, &environment->board)) != QTR_NOBODY) {
    qtr_places choices;
    uint16_t choice = QTR_STAND_DOWN;
    double best = -1.0;
    qtr_joint_choices(&state.joint, &environment->board, seeker, &choices);
    for (uint16_t target = 0; target < environment->targets.count; target++) {
      if (!qtr_places_has(&choices, target)) continue;
      const double rate = qtr_environment_rate(environment, state.at[seeker], target);
      if (rate <= best) continue;
      best = rate;
      choice = target;
    }
    act(learner, &state, seeker, choice);
  }
  play_on_ground(learner);
  learner->best = learner->play;
}

/* A first game to tune the ground's prices by. The paper setting and aggregates learn alone: it counts for nothing once
 * they have played. */
static void play_first(qtr_learner *learner) {
  qtr_play_by_rate(&learner->best, learner->game);
  if (is_aggregate(learner)) play_aggregate_by_rate(learner);
  if (learns_alone(learner)) return;
  learner->episodes = 1;
  refine_best(learner, FIRST_ROUNDS);
}

int qtr_learner_init_built(qtr_learner *learner, const qtr_environment *ground, const qtr_environment *aggregate,
                           const qtr_learner_config *config, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  learner->game = ground->game;
  learner->ground = ground;
  learner->environment = aggregate != NULL ? aggregate : ground;
  const int status = check_config(learner, config);
  if (status != QTR_OK) return status;
  learner->config = *config;
  learner->episodes = 0;
  learner->updates = 0;
  learner->max_q = 0.0;
  learner->pricing = true;
  learner->aggregate_priced = !is_aggregate(learner) || is_paper(learner);
  play_first(learner);
  qtr_qtable_init(&learner->table, &learner->environment->keys, !is_paper(learner) && config->gap < QTR_FLOAT_GAP);
  qtr_bound_init(&learner->bound, ground, learner->best.visit);
  learner->upper = learner->bound.upper;
  learner->ground_upper = learner->upper;
  return QTR_OK;
}

/* From the ground's prices to the aggregate's: those bound its policies, and no others. */
static void price_aggregate(qtr_learner *learner) {
  learner->aggregate_priced = true;
  learner->pricing = true;
  qtr_bound_init(&learner->bound, learner->environment, learner->best.visit);
  learner->upper = learner->bound.upper;
}

static void note_upper(qtr_learner *learner) {
  const double upper = learner->bound.upper;
  const bool of_ground = learner->bound.environment == learner->ground;
  if (of_ground && upper < learner->ground_upper) learner->ground_upper = upper;
  if ((!of_ground || !is_aggregate(learner)) && upper < learner->upper) learner->upper = upper;
}

static void tune_prices(qtr_learner *learner) {
  for (int i = 0; i < PRICE_STEPS && learner->pricing; i++)
    learner->pricing = qtr_bound_improve(&learner->bound, learner->best.score.worth);
  note_upper(learner);
  if (learner->pricing) return;
  learner->pricing = !qtr_bound_settle(&learner->bound);
  if (learner->pricing) return;
  if (!learner->aggregate_priced) price_aggregate(learner);
}

static enum qtr_learning verdict(const qtr_learner *learner) {
  if (learner->pricing || learner->upper > within_gap(learner, 1.0)) return QTR_LEARNING;
  return is_certified(learner) ? QTR_CERTIFIED : QTR_CONVERGED;
}

static enum qtr_learning step_certified(qtr_learner *learner) {
  const uint64_t updates = learner->updates;
  const double best = learner->best.score.worth;
  const double upper = learner->upper;
  learner->episodes++;
  run_certified_episode(learner);
  if (learner->best.score.worth > best) refine_best(learner, LATER_ROUNDS);
  if (!is_aggregate(learner)) learner->ground_upper = learner->upper;
  const bool learnt = learner->updates > updates || learner->best.score.worth > best || learner->upper < upper;
  return learnt || is_certified(learner) || !may_go_on(learner) ? verdict(learner) : QTR_CONVERGED;
}

static enum qtr_learning step_paper(qtr_learner *learner) {
  if (!run_exploring_episode(learner)) return QTR_LEARNING;
  learner->episodes++;
  play_greedily(learner);
  return learner->config.gap > 0.0 && is_certified(learner) ? QTR_CERTIFIED : QTR_LEARNING;
}

enum qtr_learning qtr_learner_step(qtr_learner *learner) {
  const bool alone = learns_alone(learner);
  if (learner->pricing) {
    if (!alone && is_certified(learner)) return QTR_CERTIFIED;
    tune_prices(learner);
    return !alone && is_certified(learner) ? QTR_CERTIFIED : QTR_LEARNING;
  }
  if (is_paper(learner)) return step_paper(learner);
  return verdict(learner) != QTR_LEARNING ? verdict(learner) : step_certified(learner);
}

/* Places that count for next to nothing: discounted away, or hardly likely. */
static uint16_t count_negligible(const qtr_learner *learner) {
  const qtr_play *best = &learner->best;
  const double least = QTR_NEGLIGIBLE * fabs(best->score.worth);
  uint16_t count = 0;
  for (unsigned place = 0; place < learner->game->board.places; place++)
    if (fabs(qtr_game_worth(learner->game, place, best->visit[place] > 0 ? best->visit[place] : 1)) < least) count++;
  return count;
}

void qtr_learner_certificate(const qtr_learner *learner, qtr_certificate *certificate) {
  const qtr_score *score = &learner->best.score;
  const qtr_objective *objective = &learner->game->objective;
  const double worth = qtr_objective_of_score(objective, score);
  const double upper = learner->ground_upper > worth ? learner->ground_upper : worth;
  certificate->value = score->value;
  certificate->expected_time = score->expected_time;
  certificate->objective = qtr_objective_figure(objective, worth);
  certificate->bound = qtr_objective_figure(objective, upper);
  certificate->gap = upper > worth ? (upper - worth) / fabs(worth) : 0.0;
  certificate->certified = is_certified(learner);
  certificate->negligible_places = count_negligible(learner);
  certificate->episodes = learner->episodes;
  certificate->updates = learner->updates;
  certificate->max_q = is_paper(learner) ? learner->max_q : learner->upper;
  certificate->price_steps = learner->bound.iterations;
}

const qtr_play *qtr_learner_best(const qtr_learner *learner) {
  return &learner->best;
}
