/* Ruin and recreate on a division of the places: strings of places near one another are taken out of their routes and
 * put back one by one where that costs least, and what comes of it is kept as simulated annealing has it (Christiaens
 * and Vanden Berghe 2020, Slack Induction by String Removals). It moves many places at once, between many routes, which
 * moves one at a time (search/refine.h) do not; those better long single routes.
 */
#ifndef QUARTER_SEARCH_RECREATE_H
#define QUARTER_SEARCH_RECREATE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/game.h"
#include "search/play.h"
#include "search/schedule.h"
#include "search/vicinity.h"

/* Caller's memory for the search. */
typedef struct {
  qtr_schedule trial; /* what is ruined and recreated: but for that, `now` */
  qtr_routes now;     /* where annealing is */
  qtr_routes best;
  const qtr_vicinity *vicinity;
  uint16_t removed[QTR_MAX_PLACES];
  double order[QTR_MAX_PLACES]; /* by which those removed are put back, least first */
  unsigned count;               /* removed */
  bool touched[QTR_MAX_ROUTES];
  bool found; /* a better one than ever; for the caller to set back */
  double temperature;
  uint32_t rounds; /* of one run: from hot to cold */
  uint32_t round;  /* of the run under way */
  uint32_t positions_to_blink;
  uint64_t random;
} qtr_recreation;

/* Begin a run of so many rounds on routes that can be played. The game and its vicinity must outlive it; `seed` decides
 * all that is random. */
void qtr_recreation_begin(qtr_recreation *recreation, const qtr_game *game, const qtr_vicinity *vicinity,
                          const qtr_routes *routes, uint32_t rounds, uint64_t seed);

/* Go on from other routes of the same game, as hot as it is; the best stays the best. */
void qtr_recreation_adopt(qtr_recreation *recreation, const qtr_routes *routes);

/* Go on for so many rounds at most, until the run is over or the mission's watch stops it. `best` is then the best
 * division found so far, with its scores: never worse than what was given. */
void qtr_recreation_go_on(qtr_recreation *recreation, uint32_t rounds);

/* Whether the run has come to its end; true of one that was all 0. */
bool qtr_recreation_is_over(const qtr_recreation *recreation);

#endif
