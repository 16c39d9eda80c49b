/* The game of a mission, as the learner plays it: the joint game with its clock, and what it is played for
 * (quarter/objective.h). */
#ifndef QUARTER_GAME_H
#define QUARTER_GAME_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/joint.h"
#include "quarter/mission.h"
#include "quarter/objective.h"
#include "quarter/travel.h"

QTR_C_BEGIN

#define QTR_MAX_NODES (QTR_MAX_PLACES + QTR_MAX_SEEKERS)
/* Large: keep it in static storage. */
typedef struct {
  const qtr_mission *mission;
  qtr_board board;
  qtr_objective objective;
  double probability[QTR_MAX_PLACES]; /* P, sum 1 */
  uint8_t steps[4 * QTR_MAX_NODES * QTR_MAX_PLACES];
  uint16_t first_at[QTR_MAX_SEEKERS]; /* of each distinct start, the first seeker there */
  qtr_box used;                       /* part of the map where there is a way to a place, or a start */
  uint16_t measured;                  /* places to which the travel times are known: all, but after a stop */
} qtr_game;

/* A moment of the game. */
typedef struct {
  qtr_joint joint;
  qtr_steps now;    /* since the start */
  double unvisited; /* probability of the places left */
} qtr_state;

/* Solve the elemental tasks of a checked mission and set the game up. `travel` is scratch. The mission must outlive the
 * game. QTR_OK, QTR_ERR_LIMIT, QTR_ERR_UNREACHABLE with the first such place in `*culprit` (may be NULL),
 * QTR_ERR_DISCOUNT with the nearest place in it, QTR_ERR_CONFIG if the caller was built under other sizes, or
 * QTR_ERR_STOPPED by the mission's watch, which is asked after each place: the game is of no use then. */
#define qtr_game_init(game, mission, travel, culprit) qtr_game_init_built(game, mission, travel, culprit, QTR_CONFIG_ID)
int qtr_game_init_built(qtr_game *game, const qtr_mission *mission, qtr_travel *travel, int *culprit,
                        uint32_t config_id);

/* The cell of one of the board's starts. */
static inline qtr_cell qtr_game_start_cell(const qtr_game *game, unsigned start) {
  return game->mission->start[game->first_at[start]];
}

/* Whether any seeker can reach a place; false if there is no such place. */
bool qtr_game_reachable(const qtr_game *game, unsigned place);

/* What visiting `place` at step `when` is worth, under the mission's objective. The innermost of the learner's loops:
 * the place, one of the game's, is not checked. */
static inline double qtr_game_worth(const qtr_game *game, unsigned place, qtr_steps when) {
  return qtr_objective_worth(&game->objective, game->probability[place], when);
}

/* The first state. */
void qtr_game_start(const qtr_game *game, qtr_state *state);

/* `seeker`, whose turn it is, makes an allowed choice (of others nothing comes: qtr_joint_choose()). No time passes.
 * Returns the reward of a place at no distance, visited at once: only a place on a start cell is. */
double qtr_game_choose(const qtr_game *game, qtr_state *state, int seeker, uint16_t choice);

/* Let time pass until somebody is to choose or the game is over: Q(s,a) = reward + discount * max Q(s',a') (Eq.
 * 4.7). */
void qtr_game_pass(const qtr_game *game, qtr_state *state, qtr_outcome *outcome);

/* Score a game given each place's step of first visit. */
void qtr_game_score(const qtr_game *game, const qtr_steps *visit, qtr_score *score);

QTR_C_END

#endif
