/* A game as it was played: who chose what, in order, and what it earned on the true map. */
#ifndef QUARTER_PLAY_H
#define QUARTER_PLAY_H

#include <stdint.h>

#include "quarter/config.h"
#include "quarter/game.h"

QTR_C_BEGIN

/* A game has no more choices than this: each place is chosen once, and each seeker stands down once. Under the paper's
 * rule seekers follow others when no place is left for them alone: then no more places than seekers are left, and each
 * seeker goes to each of them at most once. */
#define QTR_MAX_CHOICES (QTR_MAX_PLACES + QTR_MAX_SEEKERS * (QTR_MAX_SEEKERS + 1))

typedef struct {
  uint16_t choices;
  uint8_t seeker[QTR_MAX_CHOICES];
  uint16_t choice[QTR_MAX_CHOICES];
  qtr_steps visit[QTR_MAX_PLACES]; /* each place's step of first visit; QTR_NEVER: left out */
  qtr_score score;
} qtr_play;

/* What a route brings. Of two that are worth the same as far as a sum can tell, because what they differ in is
 * discounted away, the one with less expected time is better. */
typedef struct {
  double worth; /* under the mission's objective; -HUGE_VAL if a place on it cannot be visited, and home in time */
  double time;  /* its share of the expected time, steps */
} qtr_route_score;

/* A route for each seeker and, in games with an end, behind them one of the places that nobody visits. */
#define QTR_MAX_ROUTES (QTR_MAX_SEEKERS + (QTR_TERMS ? 1 : 0))

/* Whether the learner of this build searches for games by ruin and recreate, too: a few places are searched well by
 * moves one at a time alone. */
#define QTR_RECREATES (QTR_MAX_PLACES > 12)

/* Games of more places than this are searched in the vicinity of each place alone, so many places that are near. */
#define QTR_SEARCHED_WHOLE 128
#define QTR_VICINITY (QTR_MAX_PLACES > QTR_SEARCHED_WHOLE ? 24 : 1)
#define QTR_VICINITY_PLACES (QTR_MAX_PLACES > QTR_SEARCHED_WHOLE ? QTR_MAX_PLACES : 1)

typedef struct {
  uint16_t length[QTR_MAX_ROUTES];
  uint16_t place[QTR_MAX_ROUTES][QTR_MAX_PLACES]; /* in the order of the visits */
  qtr_route_score score[QTR_MAX_ROUTES];
} qtr_routes;

/* Fill in visits and score by playing the choices again: what is reported is what they earn, whatever was learnt. */
void qtr_play_score(qtr_play *play, const qtr_game *game);

/* The routes that a play's choices make. */
void qtr_play_to_routes(const qtr_play *play, const qtr_game *game, qtr_routes *routes);

QTR_C_END

#endif
