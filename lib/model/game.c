#include "quarter/game.h"

#include <math.h>
#include <stddef.h>

#include "model/matrix.h"
#include "model/rounding.h"
#include "quarter/status.h"

#define ROUNDING 1e-9 /* more than adding up the likelihoods of all places is wrong by */

/* ---- set-up ---- */

/* Seekers who set out from one cell share a node, so that the key cannot tell them apart. */
static void find_starts(qtr_game *game) {
  qtr_board *board = &game->board;
  board->starts = 0;
  for (unsigned i = 0; i < board->seekers; i++) {
    uint16_t start = 0;
    while (start < board->starts && game->mission->start[game->first_at[start]] != game->mission->start[i]) start++;
    if (start == board->starts) game->first_at[board->starts++] = (uint16_t)i;
    board->start_of[i] = start;
  }
}

/* The elemental tasks (section 4.1): the composite task, which is what is learnt, sees of the map these times alone.
 * False: stopped. */
static bool measure_travel(qtr_game *game, qtr_travel *travel) {
  qtr_cell start[QTR_MAX_SEEKERS];
  for (unsigned i = 0; i < game->board.starts; i++) start[i] = qtr_game_start_cell(game, i);
  game->used = (qtr_box){0, 0, 0, 0};
  game->measured = qtr_matrix_fill(game->steps, game->mission, start, game->board.starts, travel, &game->used);
  return game->measured == game->mission->places;
}

/* Once more, over what was rounded: for the assertion alone. */
static double sum_of_probabilities(const qtr_game *game) {
  double sum = 0.0;
  for (unsigned place = 0; place < game->board.places; place++) sum += game->probability[place];
  return sum;
}

/* P = weight / sum of weights: what was told in any unit is a distribution (section 4.1). */
static void set_probabilities(qtr_game *game) {
  const qtr_mission *mission = game->mission;
  double sum = 0.0;
  for (unsigned place = 0; place < mission->places; place++) sum += mission->weight[place];
  for (unsigned place = 0; place < mission->places; place++) game->probability[place] = mission->weight[place] / sum;
  /* P is a distribution (section 4.1): what is unvisited begins at 1 and ends at 0. */
  QTR_ASSERT(fabs(sum_of_probabilities(game) - 1.0) < ROUNDING);
}

static qtr_steps steps_at_first(const qtr_game *game, unsigned seeker, unsigned place) {
  return qtr_board_steps(&game->board, seeker, (unsigned)game->board.places + game->board.start_of[seeker], place);
}

bool qtr_game_reachable(const qtr_game *game, unsigned place) {
  for (unsigned i = 0; i < game->board.seekers; i++)
    if (steps_at_first(game, i, place) != QTR_NEVER) return true;
  return false;
}

/* The place that a seeker can be at first. */
static unsigned nearest_place(const qtr_game *game, qtr_steps *steps) {
  unsigned nearest = 0;
  *steps = QTR_NEVER;
  for (unsigned i = 0; i < game->board.seekers; i++) {
    for (unsigned place = 0; place < game->board.places; place++) {
      const qtr_steps way = steps_at_first(game, i, place);
      if (way >= *steps) continue;
      *steps = way;
      nearest = place;
    }
  }
  return nearest;
}

/* Whether there is anything in reach that can be told from nothing: gamma^(t-1) of the nearest place is the most that
 * any game keeps of its rewards. */
static int check_discount(const qtr_game *game, int *culprit) {
  qtr_steps steps;
  const unsigned nearest = nearest_place(game, &steps);
  if (qtr_objective_tells(&game->objective, steps)) return QTR_OK;
  if (culprit != NULL) *culprit = (int)nearest;
  return QTR_ERR_DISCOUNT;
}

int qtr_game_init_built(qtr_game *game, const qtr_mission *mission, qtr_travel *travel, int *culprit,
                        uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  game->mission = mission;
  game->board.places = mission->places;
  game->board.seekers = mission->seekers;
  game->board.rule = mission->rule;
  game->board.step_bytes = 4;
  game->board.steps = game->steps;
  find_starts(game);
  if (!measure_travel(game, travel)) return QTR_ERR_STOPPED;
  set_probabilities(game);
  qtr_objective_init(&game->objective, &mission->aim);
  for (unsigned place = 0; place < mission->places; place++) {
    if (qtr_game_reachable(game, place)) continue;
    if (culprit != NULL) *culprit = (int)place;
    return QTR_ERR_UNREACHABLE;
  }
  const int status = check_discount(game, culprit);
  return status == QTR_OK ? qtr_board_init(&game->board) : status;
}

/* ---- rewards ---- */

/* From visits alone and not from the course of play, so that games and routes are scored by one sum, in one order. */
void qtr_game_score(const qtr_game *game, const qtr_steps *visit, qtr_score *score) {
  qtr_objective_score(&game->objective, score, game->probability, visit, game->board.places);
}

/* ---- play ---- */

/* A place on a start cell is unvisited until somebody chooses it: that takes no time, and is still a choice. */
void qtr_game_start(const qtr_game *game, qtr_state *state) {
  qtr_joint_start(&state->joint, &game->board, NULL, NULL);
  state->now = 0;
  state->unvisited = 1.0;
}

/* Let `passed` steps, one or more, go by in an outcome; at their end the places in `arrived` are visited. */
static void collect(const qtr_game *game, qtr_state *state, qtr_outcome *outcome, qtr_steps passed,
                    const qtr_places *arrived) {
  double probability = 0.0;
  for (unsigned place = 0; place < game->board.places; place++)
    if (qtr_places_has(arrived, place)) probability += game->probability[place];
  qtr_objective_wait(&game->objective, outcome, state->unvisited, passed);
  qtr_objective_collect(&game->objective, outcome, probability, passed, passed);
  qtr_objective_pass(&game->objective, outcome, passed);
  state->now += passed;
  state->unvisited -= probability;
  /* No place is taken off twice: a likelihood below 0 would earn by waiting. */
  QTR_ASSERT(state->unvisited > -ROUNDING);
}

/* Q(s,a) = max Q(s',a') where no time passes: a choice earns nothing by itself, but for a place that is reached in 0
 * steps. */
double qtr_game_choose(const qtr_game *game, qtr_state *state, int seeker, uint16_t choice) {
  if (!qtr_joint_choose(&state->joint, &game->board, seeker, choice)) return 0.0;
  state->unvisited -= game->probability[choice];
  return qtr_objective_at_once(&game->objective, game->probability[choice], state->now);
}

/* Stretch by stretch, each as long as the least travel time left, until a seeker is idle that has a choice: for the
 * backup they are one transition, tau their sum. */
void qtr_game_pass(const qtr_game *game, qtr_state *state, qtr_outcome *outcome) {
  qtr_objective_begin(outcome, state->now);
  while (qtr_joint_chooser(&state->joint, &game->board) == QTR_NOBODY) {
    qtr_places arrived;
    qtr_places_clear(&arrived);
    const qtr_steps passed = qtr_joint_advance(&state->joint, &game->board, &arrived);
    if (passed == 0) break;
    collect(game, state, outcome, passed, &arrived);
  }
}
