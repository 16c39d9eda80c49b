/* Local search on a division of the places: each seeker's route, improved until no single change betters it, then shaken
 * and improved again. It gives the learner good games to start from; what they are worth is found by playing them.
 *
 * Seekers do not hinder one another, so under the free rule any division of the places and any orders are a game that can
 * be played, and its worth is the sum over the routes.
 */
#ifndef QUARTER_REFINE_H
#define QUARTER_REFINE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/game.h"

/* What a route brings. Of two that are worth the same as far as a sum can tell, because what they differ in is discounted
 * away, the one with less expected time is better. */
typedef struct {
  double worth; /* under the mission's objective; -HUGE_VAL if a place on it cannot be reached */
  double time;  /* its share of the expected time, steps */
} qtr_route_score;

typedef struct {
  uint16_t length[QTR_MAX_SEEKERS];
  uint16_t place[QTR_MAX_SEEKERS][QTR_MAX_PLACES]; /* in the order of the visits */
  qtr_route_score score[QTR_MAX_SEEKERS];
} qtr_routes;

/* Caller's memory for the search. */
typedef struct {
  qtr_routes best;
  uint16_t a[QTR_MAX_PLACES]; /* routes being tried */
  uint16_t b[QTR_MAX_PLACES];
  uint64_t random;
} qtr_refinery;

/* What one seeker's route brings; as of one with a place that cannot be reached where there is no such place or seeker. */
qtr_route_score qtr_route_evaluate(const qtr_game *game, unsigned seeker, const uint16_t *places, unsigned length);

/* Whether no place is on two routes, or on one twice. */
bool qtr_routes_are_division(const qtr_routes *routes, unsigned seekers);

/* Improve `routes` (their scores need not be set), with `rounds` of shaking; `seed` decides how they shake. A stop by
 * the mission's watch leaves the best routes found so far. */
void qtr_refine(qtr_refinery *refinery, qtr_routes *routes, const qtr_game *game, unsigned rounds, uint64_t seed);

#endif
