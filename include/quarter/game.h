/* The game of a mission, as the learner plays it: the joint game with its clock, and what it is played for
 * (quarter/objective.h). */
#ifndef QUARTER_GAME_H
#define QUARTER_GAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/joint.h"
#include "quarter/mission.h"
#include "quarter/objective.h"
#include "quarter/travel.h"

QTR_C_BEGIN

#define QTR_MAX_NODES (QTR_MAX_PLACES + QTR_MAX_SEEKERS)
#define QTR_IF_TERMS(count) (QTR_TERMS ? (count) : 1) /* of an array that only the field's terms need */
/* Large: keep it in static storage, or in a block of qtr_game_bytes(), which ends early: of the travel times, the last
 * of its members, there are no more then than the mission has. */
typedef struct {
  const qtr_mission *mission;
  qtr_board board;
  qtr_objective objective;
  double probability[QTR_MAX_PLACES]; /* of each of the board's places, of all that can be found: sum 1 */
  uint8_t look_of[QTR_IF_TERMS(2 * QTR_MAX_PLACES)]; /* u16: the mission's place that each is a look at */
  uint8_t ready[QTR_IF_TERMS(4 * QTR_MAX_SEEKERS)];  /* as the board's terms have them */
  uint8_t end[QTR_IF_TERMS(4 * QTR_MAX_SEEKERS)];
  uint8_t home[QTR_IF_TERMS(4 * QTR_MAX_SEEKERS * QTR_MAX_PLACES)]; /* with an end, or a weight of coming home */
  uint16_t first_at[QTR_MAX_SEEKERS];                               /* of each distinct start, the first seeker there */
  qtr_box used;      /* part of the map where there is a way to a place, or a start */
  uint16_t measured; /* places to which the travel times are known: all, but after a stop */
  bool by_legs;      /* there is no map, and a way by way of other places may be sooner than the direct one */
  uint8_t steps[4 * QTR_MAX_NODES * QTR_MAX_PLACES * QTR_MAX_CLASSES];
} qtr_game;

/* Bytes that the game of a mission takes, which need not have been checked: no more than sizeof(qtr_game). */
size_t qtr_game_bytes(const qtr_mission *mission);

/* A moment of the game. */
typedef struct {
  qtr_joint joint;
  double unvisited; /* probability of the places left */
} qtr_state;

/* Solve the elemental tasks of a checked mission and set the game up. Its places are the mission's, in their order, and
 * then later looks at them: n looks at a place are n places in one cell, the m-th worth P q (1-q)^(m-1). `travel` is
 * scratch. The mission must outlive the game. QTR_OK, QTR_ERR_LIMIT, QTR_ERR_UNREACHABLE with the first such place in
 * `*culprit` (may be NULL), QTR_ERR_DISCOUNT with the nearest place in it, QTR_ERR_HORIZON likewise if no place can be
 * searched in the time that there is, QTR_ERR_START for a seeker on ground that its class may not enter, QTR_ERR_CONFIG
 * if the caller was built under other sizes, or QTR_ERR_STOPPED by the mission's watch, which is asked after each
 * place: the game is of no use then. */
#define qtr_game_init(game, mission, travel, culprit) qtr_game_init_built(game, mission, travel, culprit, QTR_CONFIG_ID)
int qtr_game_init_built(qtr_game *game, const qtr_mission *mission, qtr_travel *travel, int *culprit,
                        uint32_t config_id);

/* As qtr_game_init() without a search: out of a board that knows the travel times already. Its place `place[p]` is the
 * mission's place p, its start `start_of[i]` is seeker i's; its classes are the mission's. */
#define qtr_game_init_known(game, mission, known, place, start_of)                                                     \
  qtr_game_init_known_built(game, mission, known, place, start_of, QTR_CONFIG_ID)
int qtr_game_init_known_built(qtr_game *game, const qtr_mission *mission, const qtr_board *known, const uint16_t *place,
                              const uint16_t *start_of, uint32_t config_id);

/* Legs: travel times of a problem that has no map, between places and from its starts, one row of places for each place
 * and then for each start. They are taken as they are: who goes from one place to another passes by no third one on its
 * way, though by way of that it may be sooner there. */
typedef struct {
  unsigned starts;        /* rows behind the places' */
  const qtr_steps *steps; /* above 0 between two places; QTR_NEVER: no way */
  const qtr_steps *home;  /* a row of places for each start: the ways home to it. NULL where nobody must come home */
} qtr_legs;

/* As qtr_game_init() of a mission without a map, whose columns and rows are 0: the start of seeker i is the legs' start
 * number start[i]. The legs are copied. QTR_OK and errors as there; QTR_ERR_ARGUMENT for the paper's rule, several
 * classes, scan times, places avoided and second looks, for a start that there is not, for two places 0 steps apart and
 * for ways home that are missing. No table can be exported of such a game, nor can it be aggregated. */
#define qtr_game_init_legs(game, mission, legs, culprit)                                                               \
  qtr_game_init_legs_built(game, mission, legs, culprit, QTR_CONFIG_ID)
int qtr_game_init_legs_built(qtr_game *game, const qtr_mission *mission, const qtr_legs *legs, int *culprit,
                             uint32_t config_id);

/* The cell of one of the board's starts. */
static inline qtr_cell qtr_game_start_cell(const qtr_game *game, unsigned start) {
  return game->mission->start[game->first_at[start]];
}

/* Which of the mission's places one of the game's is a look at. */
unsigned qtr_game_place(const qtr_game *game, unsigned place);

/* Whether any seeker can reach a place, in whatever time; false if there is no such place. */
bool qtr_game_reachable(const qtr_game *game, unsigned place);

/* Steps from a node to a seeker's start: 0 where coming home is no part of the game. */
qtr_steps qtr_game_way_home(const qtr_game *game, unsigned seeker, unsigned node);

/* How many seekers have not gone home. */
unsigned qtr_game_seekers_out(const qtr_game *game, const qtr_joint *joint);

/* What the seekers cost that have gone home since `before`, which was `passed` steps ago, counted from now. */
double qtr_game_leave(const qtr_game *game, const qtr_joint *before, const qtr_joint *after, qtr_steps passed);

/* What visiting `place` at step `when` is worth, under the mission's objective. The innermost of the learner's loops:
 * the place, one of the game's, is not checked. */
static inline double qtr_game_worth(const qtr_game *game, unsigned place, qtr_steps when) {
  return qtr_objective_worth(&game->objective, game->probability[place], when);
}

/* The first state. Time passes in it, by qtr_game_pass(), where nobody is ready from the start. */
void qtr_game_start(const qtr_game *game, qtr_state *state);

/* `seeker`, whose turn it is, makes an allowed choice (of others nothing comes: qtr_joint_choose()). No time passes.
 * Returns the reward of a place at no distance, visited at once: only a place on a start cell is. */
double qtr_game_choose(const qtr_game *game, qtr_state *state, int seeker, uint16_t choice);

/* Let time pass until somebody is to choose or the game is over: Q(s,a) = reward + discount * max Q(s',a') (Eq.
 * 4.7). */
void qtr_game_pass(const qtr_game *game, qtr_state *state, qtr_outcome *outcome);

/* Score a game given each place's step of first visit, QTR_NEVER for one left out, and the steps until they are home of
 * all seekers in all (0 where that is no part of the game). */
void qtr_game_score(const qtr_game *game, const qtr_steps *visit, uint64_t home, qtr_score *score);

QTR_C_END

#endif
