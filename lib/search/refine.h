/* Local search on a division of the places: each seeker's route, improved until no single change betters it, then
 * shaken and improved again. It gives the learner good games to start from; what they are worth is found by playing
 * them.
 *
 * Seekers do not hinder one another, so under the free rule any division of the places and any orders are a game that
 * can be played, and its worth is the sum over the routes.
 */
#ifndef QUARTER_SEARCH_REFINE_H
#define QUARTER_SEARCH_REFINE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/game.h"
#include "search/pieces.h"
#include "search/play.h"
#include "search/vicinity.h"

/* Caller's memory for the search. */
typedef struct {
  qtr_routes best;
  uint16_t a[QTR_MAX_PLACES]; /* routes being tried */
  uint16_t b[QTR_MAX_PLACES];
  uint64_t random;
  qtr_pieces pieces; /* of the routes searched */
  bool told;         /* whether they tell what moves bring */
#if QTR_VICINITY_PLACES > 1
  const qtr_vicinity *vicinity; /* of the game; NULL: all places are near one another */
#endif
} qtr_refinery;

/* Begin with a refinery: moves put places beside those near them alone. NULL: beside any. The vicinity must outlive
 * it. */
void qtr_refine_begin(qtr_refinery *refinery, const qtr_vicinity *vicinity);

/* Improve `routes` (their scores need not be set), with `rounds` of shaking; `seed` decides how they shake. A stop by
 * the mission's watch leaves the best routes found so far. */
void qtr_refine(qtr_refinery *refinery, qtr_routes *routes, const qtr_game *game, unsigned rounds, uint64_t seed);

#endif
