/* The best game out of routes that are listed (search/pool.h): a route for each seeker, each place on one of them.
 *
 * A linear programme over all routes (search/simplex.h, search/triples.h) and, where it mixes routes, branching: two
 * places are on one route or not (Ryan and Foster 1981), or a place is some seekers' or not. The simplex method only
 * proposes prices. What they prove is added up anew from every route: sum of prices + sum over seekers of the most that
 * a route of theirs collects net of them (search/bound.h), with a price of 0 or more for each triple, of whose routes
 * one is in a game at most. Routes that are too far below the most are in no better game, and are dropped.
 */
#ifndef QUARTER_SEARCH_SELECTION_H
#define QUARTER_SEARCH_SELECTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "search/branch.h"
#include "search/play.h"
#include "search/pool.h"
#include "search/simplex.h"
#include "search/triples.h"

#define QTR_SELECTION_DEPTH 120u /* of branches */
#define QTR_SELECTION_ACTIVE 512u

typedef struct {
  double worth; /* its way home counted */
  double net;   /* of prices, when last looked at */
  uint32_t label;
  uint8_t off; /* the branch that rules it out, from 1 on; 0: none does */
  bool in_basis;
} qtr_choice;

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
  double left, scale, finest;
  qtr_choice *choice;
  uint32_t choices;
  qtr_simplex simplex;
  qtr_triple triple[QTR_MOST_TRIPLES];
  uint32_t triples, fruitless; /* rounds of triples that brought next to nothing */
  double round_upper;          /* before the last round */
  double penalty;              /* for each row of a column that is ruled out */
  uint32_t entered;            /* columns since all were looked at */
  double *price;               /* as looked at with: no slack's below 0 */
  double *sum_of_byte;         /* of prices, for each byte of a set and its 256 values */
  uint32_t *active;            /* choices that may enter, their rows behind one another */
  uint32_t actives;
  uint16_t *row;
  uint32_t *row_begin;
  qtr_branch branch[QTR_SELECTION_DEPTH];
  uint32_t depth;
  uint8_t phase;
} qtr_selection;

/* Begin, in what the pool leaves of its block, aligned for a double; routes of games that are worth more than `target`
 * must all be listed. False: the block is too small. */
bool qtr_selection_begin(qtr_selection *selection, const qtr_pool *pool, void *block, size_t bytes, double target);

/* Go on for a bounded amount of work: a look at all routes, or some pivots. */
enum qtr_selecting qtr_selection_go_on(qtr_selection *selection);

/* The game that was found, as routes. */
void qtr_selection_routes(const qtr_selection *selection, qtr_routes *routes);

/* After a game was found: what counts is what is worth more than `target`. One that is no better than was known before
 * ends in QTR_SELECTION_STUCK, or it would be found for ever. */
void qtr_selection_raise(qtr_selection *selection, double target);

#endif
