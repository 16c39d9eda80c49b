/* Prices of the programme that chooses among all routes, where too many are within the gap to list them: column
 * generation (Desrosiers, Soumis, Desrochers 1984). The programme over the routes at hand (search/master.h) proposes
 * prices; the routes that gain by them are listed (search/pool.h) and join in, and where there are none the programme
 * is solved. What is listed proves a bound each time: no route of a squad collects more than the best one listed.
 *
 * Prices are proposed near those that prove the least bound so far, and nearer after each failure (boxstep: Marsten,
 * Hogan, Blankenship 1975). Where next to nothing is left to gain, triples that the routes' mixture breaks get rows. So
 * the bound comes down from that of walks to within some tenths of a percent of the best game: and then the routes
 * within the gap are few enough to list them all.
 *
 * C takes tolls by halves: a route pays half of a triple's toll for each move from one place of it straight to another.
 * There are two of those at most, on a route that pays the toll whole, so C is never less than what routes collect. A
 * route begun has paid whole at the triple's second place, and C from there on may take half of it again, for the move
 * to the third: so what the pool grows on is judged by half of the toll paid last.
 */
#ifndef QUARTER_SEARCH_COLUMNS_H
#define QUARTER_SEARCH_COLUMNS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "search/bound.h"
#include "search/duals.h"
#include "search/master.h"
#include "search/pool.h"

#define QTR_COLUMNS_ROUND 32u /* triples that are added at once */

enum qtr_pricing {
  QTR_PRICING = 0,
  QTR_PRICED = 1,       /* next to nothing is left to gain but by more triples, and those are added */
  QTR_PRICING_STUCK = 2 /* nor are there any */
};

/* What the caller has for it, neither in the pool's way. */
typedef struct {
  double *charge; /* for each pair of places */
  void *block;    /* for the programme, aligned for a double */
  size_t bytes;
  uint32_t labels; /* that the pool may hold meanwhile */
} qtr_columns_room;

typedef struct {
  qtr_bound *bound;
  qtr_pool *pool;
  qtr_columns_room room;
  uint32_t labels; /* that the pool is given: more where routes that gain are hard to find */
  double target;
  double upper;       /* on all games, that the center's prices prove */
  qtr_duals center;   /* the best prices so far, and as much of each squad as any route of its collects */
  qtr_duals trial;    /* being tried */
  qtr_basis basis;    /* that the programme ended in */
  double model;       /* what these would prove if there were no other routes than those at hand */
  double box;         /* how far from the center, in parts of the master's scale */
  uint32_t fruitless; /* rounds in a row that brought no triples */
  uint32_t barren;    /* lists in a row that brought the bound down by next to nothing */
  uint32_t raised;    /* how often what routes are to collect has been raised */
  uint32_t broken;
  qtr_triple triple[QTR_COLUMNS_ROUND]; /* that the last mixture breaks */
  qtr_master master;
  uint8_t phase;
} qtr_columns;

/* Begin at the prices of a bound, whose C must be filled with them, with a pool that is empty. */
void qtr_columns_begin(qtr_columns *columns, qtr_bound *bound, qtr_pool *pool, const qtr_columns_room *room,
                       double target);

/* Go on for a bounded amount of work, with the routes that were listed last; `upper` may come down with each. */
enum qtr_pricing qtr_columns_go_on(qtr_columns *columns);

/* Fill C with the center's prices. False: stopped by the mission's watch, and to be called again. */
bool qtr_columns_settle(qtr_columns *columns);

/* Then: begin to list, in the pool, the routes that collect less than the most of their squad by no more than `gap`;
 * with a gap from a target up to `upper`, all routes of games that are worth more than the target. Prices
 * that are gone on with begin with these routes, and those at hand before. */
void qtr_columns_list(qtr_columns *columns, double gap);

#endif
