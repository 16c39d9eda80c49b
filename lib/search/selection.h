/* The best game out of routes that are listed (search/pool.h): a route for each seeker, each place on one of them.
 *
 * The linear programme over all routes (search/master.h), with triples as long as they bring something; where it still
 * mixes routes, branching: two places are on one route or not (Ryan and Foster 1981), or a place is some seekers' or
 * not. Routes that are too far below the most of their squad are in no better game, and are dropped.
 */
#ifndef QUARTER_SEARCH_SELECTION_H
#define QUARTER_SEARCH_SELECTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "search/branch.h"
#include "search/master.h"
#include "search/play.h"
#include "search/pool.h"

#define QTR_SELECTION_DEPTH 120u /* of branches */

enum qtr_selecting {
  QTR_SELECTING = 0,
  QTR_SELECTED = 1,       /* no game out of the routes is worth more than the target */
  QTR_SELECTION_GAME = 2, /* one may be: see qtr_selection_routes(), then go on */
  QTR_SELECTION_STUCK = 3 /* nothing more can be told */
};

typedef struct {
  const qtr_pool *pool;
  double target, upper; /* on all games that the routes make */
  double node_upper;    /* on those of the branches at hand */
  double round_upper;   /* before the last round of triples */
  uint32_t fruitless;   /* rounds of triples that brought next to nothing */
  qtr_master master;
  qtr_branch branch[QTR_SELECTION_DEPTH];
  uint32_t depth;
  uint8_t phase;
} qtr_selection;

/* Begin, in what the pool leaves of its block, aligned for a double, from the duals in force, the squads' as much as
 * any route of theirs collects. Where all routes of games that are worth more than `target` are listed, `upper` bounds
 * all games. False: the block is too small. */
bool qtr_selection_begin(qtr_selection *selection, const qtr_pool *pool, void *block, size_t bytes,
                         const qtr_duals *from, const qtr_basis *basis, double target);

/* Go on for a bounded amount of work: a look at all routes, or some pivots. */
enum qtr_selecting qtr_selection_go_on(qtr_selection *selection);

/* The game that was found, as routes. */
void qtr_selection_routes(const qtr_selection *selection, qtr_routes *routes);

/* After a game was found: what counts is what is worth more than `target`. One that is no better than was known before
 * ends in QTR_SELECTION_STUCK, or it would be found for ever. */
void qtr_selection_raise(qtr_selection *selection, double target);

#endif
