#include "learn/learner.h"

#include <math.h>
#include <stddef.h>

#include "core/block.h"
#include "learn/certificate.h"
#include "learn/certified.h"
#include "learn/episode.h"
#include "learn/exploring.h"
#include "learn/planning.h"
#include "learn/role.h"
#include "learn/tail.h"
#include "model/rounding.h"
#include "model/settings.h"
#include "quarter/status.h"

#define FIRST_ROUNDS 4 /* of shaking the first game, where nothing else betters it; */
#define MORE_ROUNDS 8  /* where ways home count or run out, and on an aggregate, which soon has no more to give */

void qtr_learner_config_default(qtr_learner_config *config) {
  config->made = SETTINGS_MADE;
  config->gap = 1e-5;
  config->seed = 1;
  config->price_steps = 0;
  config->setting = QTR_SETTING_CERTIFIED;
  config->alpha = 1.0;
  config->ground_search = true;
  qtr_exploration_default(&config->exploration);
}

int qtr_learner_config_check(const qtr_learner_config *config) {
  if (config->made != SETTINGS_MADE) return QTR_ERR_ARGUMENT;
  if (!(config->gap >= 0.0 && config->gap < HUGE_VAL) || config->setting > QTR_SETTING_PAPER) return QTR_ERR_ARGUMENT;
  if (!(config->alpha > 0.0 && config->alpha <= 1.0)) return QTR_ERR_ARGUMENT;
  return qtr_exploration_check(&config->exploration);
}

/* ---- set-up ---- */

/* Regions have estimates for times, which bound nothing; and only under the free rule are routes that were learnt on an
 * aggregate a game on the ground. */
static int check_together(const qtr_learner *learner, const qtr_learner_config *config) {
  if (config->setting == QTR_SETTING_CERTIFIED && !qtr_sight_is_exact(&learner->environment->sight))
    return QTR_ERR_ARGUMENT;
  return learner_is_aggregate(learner) && learner->game->board.rule != QTR_RULE_FREE ? QTR_ERR_ARGUMENT : QTR_OK;
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
      const double rate = qtr_environment_rate(environment, (unsigned)seeker, state.at[seeker], target);
      if (rate <= best) continue;
      best = rate;
      choice = target;
    }
    qtr_episode_act(learner, &state, seeker, choice);
  }
  qtr_episode_play_on_ground(learner);
  learner->best = learner->play;
}

static unsigned first_rounds(const qtr_learner *learner) {
  const qtr_game *game = learner->game;
  if (learner_is_aggregate(learner) && game->board.places <= QTR_SEARCHED_WHOLE) return MORE_ROUNDS;
  if (qtr_planning_follows(learner) || qtr_tail_comes_first(learner)) return 0;
  return game->board.terms.end != NULL || game->objective.terms.home_weight != 0.0 ? MORE_ROUNDS : FIRST_ROUNDS;
}

/* A first game to tune the ground's prices by. The paper setting and aggregates learn alone: it counts for nothing once
 * they have played. */
static void play_first(qtr_learner *learner) {
  qtr_play_by_rate(&learner->best, learner->game);
  if (learner_is_aggregate(learner)) play_aggregate_by_rate(learner);
  if (learner_learns_alone(learner)) return;
  learner->episodes = 1;
  qtr_certified_refine(learner, first_rounds(learner));
  qtr_planning_first(learner);
}

/* The public header's sizes hold what stands in the workspace. */
typedef char learner_fits[sizeof(qtr_learner) + QTR_GAINS_BYTES(QTR_MAX_CLASSES) <= QTR_LEARNER_BYTES ? 1 : -1];

size_t qtr_learner_bytes(const qtr_game *game) {
  return sizeof(qtr_learner) + qtr_gains_bytes(game);
}

#define ROUTE_BYTES_A_PAIR (1u << 16) /* of places */

size_t qtr_learner_route_bytes(const qtr_game *game) {
  const size_t places = game->board.places;
  const size_t useful = places * places * ROUTE_BYTES_A_PAIR;
  return useful > QTR_ROUTE_BYTES ? QTR_ROUTE_BYTES : useful;
}

static int check_blocks(const qtr_learner_blocks *blocks, const qtr_game *game) {
  if ((uintptr_t)blocks->routes % sizeof(uint64_t) != 0) return QTR_ERR_ARGUMENT;
  if (blocks->table == NULL || blocks->table_words < QTR_QTABLE_LEAST_WORDS) return QTR_ERR_SPACE;
  return block_check(blocks->work, blocks->work_bytes, qtr_learner_bytes(game));
}

static void begin_prices(qtr_learner *learner, const qtr_environment *environment) {
  qtr_bound_init(&learner->bound, learner + 1, environment, learner->best.visit);
  learner->upper = learner->bound.upper;
  if (learner->game->board.places > QTR_SEARCHED_WHOLE && qtr_bound_at_once(&learner->bound) < learner->upper)
    learner->upper = qtr_bound_at_once(&learner->bound);
}

/* The bound begins on the ground, whatever is learnt on: its prices are the certificate's. Floats round Q up by as much
 * as 1.2e-7 of it for each backup, which a gap below QTR_FLOAT_GAP would not forgive. */
int qtr_learner_init_built(qtr_learner **made, const qtr_learner_blocks *blocks, const qtr_environment *ground,
                           const qtr_environment *aggregate, const qtr_learner_config *config, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  int status = check_blocks(blocks, ground->game);
  if (status != QTR_OK) return status;
  qtr_learner *learner = blocks->work;
  learner->game = ground->game;
  learner->ground = ground;
  learner->environment = aggregate != NULL ? aggregate : ground;
  status = qtr_learner_config_check(config);
  if (status == QTR_OK) status = check_together(learner, config);
  if (status == QTR_OK) status = qtr_explorer_init(&learner->explorer, &config->exploration, config->seed);
  if (status != QTR_OK) return status;
  learner->config = *config;
  learner->episodes = 0;
  learner->updates = 0;
  learner->max_q = 0.0;
  learner->replayed = false;
  learner->phase = QTR_PHASE_GROUND_PRICES;
  qtr_planning_init(learner);
  qtr_tail_init(learner, blocks->routes, blocks->route_bytes);
  play_first(learner);
  qtr_qtable_init(&learner->table, blocks->table, blocks->table_words, &learner->environment->keys,
                  !learner_is_paper(learner) && config->gap < QTR_FLOAT_GAP);
  begin_prices(learner, ground);
  learner->ground_upper = learner->upper;
  *made = learner;
  return QTR_OK;
}

/* ---- phases: prices of the ground, prices of an aggregate, episodes ---- */

/* The aggregate's prices bound its policies, and no others: they are where its Q begins. */
static void begin_aggregate(qtr_learner *learner) {
  learner->phase = QTR_PHASE_AGGREGATE_PRICES;
  begin_prices(learner, learner->environment);
}

/* Prices of the ground bound what is learnt on it, too; those of an aggregate nothing but that. */
static void note_upper(qtr_learner *learner) {
  const double upper = learner->bound.upper;
  const bool of_ground = learner->phase == QTR_PHASE_GROUND_PRICES;
  if (of_ground && upper < learner->ground_upper) learner->ground_upper = upper;
  if ((!of_ground || !learner_is_aggregate(learner)) && upper < learner->upper) learner->upper = upper;
}

static bool may_tune(const qtr_learner *learner) {
  return learner->config.price_steps == 0 || learner->bound.iterations < learner->config.price_steps;
}

/* The goal is the best game known, which no bound falls below. Episodes need the best prices' C, so they are settled
 * first. */
static void tune_prices(qtr_learner *learner) {
  bool improves = true;
  const uint32_t steps = qtr_planning_price_steps(learner, QTR_PRICE_STEPS);
  for (uint32_t i = 0; i < steps && improves; i++)
    improves = may_tune(learner) && qtr_bound_improve(&learner->bound, learner->best.score.worth);
  note_upper(learner);
  if (improves || !qtr_bound_settle(&learner->bound)) return;
  if (learner->phase == QTR_PHASE_GROUND_PRICES && learner_is_aggregate(learner) && !learner_is_paper(learner))
    begin_aggregate(learner);
  else
    learner->phase = QTR_PHASE_EPISODES;
}

/* All routes of few places are listed sooner than the first steps of the prices are taken. Whether they are. */
static bool list_first(qtr_learner *learner) {
  return learner->bound.iterations == 0 && !learner_learns_alone(learner) && qtr_tail_comes_first(learner) &&
         qtr_tail_try_early(learner);
}

/* Prices alone often close the gap, when local search has found the best game: then no Q is needed. */
static enum qtr_learning step_prices(qtr_learner *learner) {
  if (!learner_learns_alone(learner) && qtr_certificate_closed(learner)) return QTR_CERTIFIED;
  qtr_planning_step(learner);
  if (list_first(learner)) return qtr_certificate_verdict(learner);
  tune_prices(learner);
  if (learner_learns_alone(learner)) return QTR_LEARNING;
  if (qtr_certificate_closed(learner)) return QTR_CERTIFIED;
  if (learner->phase == QTR_PHASE_GROUND_PRICES) qtr_tail_try_early(learner);
  return qtr_certificate_verdict(learner);
}

/* Each place, or what is made of some, is chosen once, and see QTR_MAX_CHOICES. */
static uint32_t most_choices(const qtr_learner *learner) {
  const uint32_t seekers = learner->game->board.seekers;
  return learner->game->board.places + seekers * (seekers + 1);
}

/* Ahead of an episode, so that none has to wait for its table to double: 256 MB take seconds. What a stop leaves undone
 * the next step goes on with. */
static bool make_room(qtr_learner *learner) {
  while (qtr_qtable_make_room(&learner->table, most_choices(learner)))
    if (!learner_may_go_on(learner)) return false;
  return true;
}

enum qtr_learning qtr_learner_step(qtr_learner *learner) {
  if (learner->phase != QTR_PHASE_EPISODES) return step_prices(learner);
  if (!make_room(learner)) return QTR_LEARNING;
  if (learner_is_paper(learner)) return qtr_exploring_step(learner);
  const enum qtr_learning verdict = qtr_certificate_verdict(learner);
  if (verdict != QTR_LEARNING) return verdict;
  return qtr_tail_step(learner) ? qtr_certificate_verdict(learner) : qtr_certified_step(learner);
}

const qtr_play *qtr_learner_best(const qtr_learner *learner) {
  return &learner->best;
}

/* ---- the Q-table ---- */

uint32_t qtr_learner_entries(const qtr_learner *learner) {
  return learner->table.entries;
}

uint32_t qtr_learner_entry_bytes(const qtr_learner *learner) {
  return qtr_qtable_entry_bytes(&learner->table);
}

/* An episode learns at most one entry a choice. */
size_t qtr_learner_table_needs(const qtr_learner *learner) {
  return qtr_qtable_needs(&learner->table, most_choices(learner));
}

int qtr_learner_move_table(qtr_learner *learner, uint32_t *table, size_t words) {
  return qtr_qtable_move(&learner->table, table, words);
}
