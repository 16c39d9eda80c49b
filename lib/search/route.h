/* What one seeker's route brings, and which of two is better. */
#ifndef QUARTER_SEARCH_ROUTE_H
#define QUARTER_SEARCH_ROUTE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/game.h"
#include "quarter/play.h"

/* What one seeker's route brings; as of one with a place that cannot be reached where there is no such place or
 * seeker. */
qtr_route_score qtr_route_evaluate(const qtr_game *game, unsigned seeker, const uint16_t *places, unsigned length);

qtr_route_score qtr_route_sum(qtr_route_score a, qtr_route_score b);

/* By more than rounding: or a move and its undoing could both be gains, and a search go to and fro. */
bool qtr_route_is_worth_more(qtr_route_score after, qtr_route_score before);
bool qtr_route_is_sooner(qtr_route_score after, qtr_route_score before);

/* Worth more or else, at no loss of worth, sooner. In a search that keeps what is better the sum of the routes' worths
 * never falls, and where it stays the sum of their times falls: no series of changes comes back to where it was, so the
 * search ends. */
bool qtr_route_is_better(qtr_route_score after, qtr_route_score before);

#endif
