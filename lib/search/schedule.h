/* A division of the places with its times: when each place is visited, and what is at stake from there on, so that what
 * an insertion changes is known without following the route anew.
 *
 * Under expected time a delay of d steps costs d times the likelihood that is still to be visited; discounted, what is
 * still to come is worth gamma^d of itself. So for each place the sum over itself and those behind it is kept, and an
 * insertion is O(1). By a deadline, and where the first visit is at the start itself, what is behind is gone through.
 */
#ifndef QUARTER_SEARCH_SCHEDULE_H
#define QUARTER_SEARCH_SCHEDULE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/game.h"
#include "search/play.h"

#define QTR_NO_ROUTE 0xFFu /* of a place that is on none */

typedef struct {
  const qtr_game *game;
  qtr_routes routes;
  uint8_t route_of[QTR_MAX_PLACES];
  uint16_t at[QTR_MAX_PLACES];                   /* of each place on a seeker's route: its number there */
  qtr_steps when[QTR_MAX_PLACES];                /* of each place on a route: its visit */
  double behind[QTR_MAX_PLACES];                 /* likelihood, or discounted worth, from its visit on */
  qtr_steps spare[QTR_IF_TERMS(QTR_MAX_PLACES)]; /* with an end: how much later it may be visited */
} qtr_schedule;

/* Where a place can be inserted, and what that changes in the worth of the game. */
typedef struct {
  double gain; /* -HUGE_VAL: nowhere */
  unsigned route, at;
} qtr_insertion;

/* Take over routes that can be played; their scores are evaluated. The game must outlive the schedule. */
void qtr_schedule_begin(qtr_schedule *schedule, const qtr_game *game, const qtr_routes *routes);

/* What the worth of the game changes by if `place`, on no route, comes before the place now `at` on a seeker's route,
 * or at its end; -HUGE_VAL if it cannot be visited there, or what comes behind cannot any more. */
double qtr_schedule_try(const qtr_schedule *schedule, unsigned route, unsigned at, uint16_t place);

/* The best so far, or what is better than it of the insertions from..to-1 on a seeker's route. */
void qtr_schedule_find(const qtr_schedule *schedule, unsigned route, unsigned from, unsigned to, uint16_t place,
                       qtr_insertion *best);

/* Insert a place, or take places out of a route. Scores stay as they are. */
void qtr_schedule_insert(qtr_schedule *schedule, unsigned route, unsigned at, uint16_t place);
void qtr_schedule_remove(qtr_schedule *schedule, unsigned route, unsigned from, unsigned count);

/* Put a route in place of the one there is, whose places must be on no other one by now; its score comes with it. */
void qtr_schedule_set(qtr_schedule *schedule, unsigned route, const qtr_routes *from);

#endif
