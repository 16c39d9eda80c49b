/* Prices in a linear programme that chooses among routes: of places, of squads (seekers that set out alike), and tolls
 * of triples of places. A route collects what its visits are worth, net of the prices of its places and of the toll of
 * each triple of which it visits two places or three.
 *
 * In a game each place is on one route at most, and of each triple's routes there is one at most. So whatever the
 * prices, no less than 0 where a place may be left out, and tolls of 0 or more: a game is worth no more than the sum of
 * prices and tolls, and for each seeker the most that a route of its squad collects net of them. With prices of places
 * alone this is the bound of search/bound.h, but for routes in place of walks.
 */
#ifndef QUARTER_SEARCH_DUALS_H
#define QUARTER_SEARCH_DUALS_H

#include <stdint.h>

#include "quarter/config.h"
#include "search/triples.h"

typedef struct {
  double place[QTR_MAX_PLACES];
  double squad[QTR_MAX_SEEKERS]; /* what a route of its is to collect, net */
  uint32_t triples;
  qtr_triple triple[QTR_MOST_TRIPLES];
  double toll[QTR_MOST_TRIPLES];
} qtr_duals;

#endif
