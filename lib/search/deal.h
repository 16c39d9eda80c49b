/* The best game out of routes that are listed (search/pool.h), where places are few: they are dealt to the seekers one
 * after another, by dynamic programming over sets of places,
 *
 *   best(i, S) = max over the routes r of i's squad within S of worth(r) + best(i - 1, S without r's places).
 *
 * 3^n sums for each seeker at most, and exact but for rounding: a linear programme (search/selection.h) takes longer
 * and tells less.
 */
#ifndef QUARTER_SEARCH_DEAL_H
#define QUARTER_SEARCH_DEAL_H

#include <stdbool.h>
#include <stddef.h>

#include "search/play.h"
#include "search/pool.h"

#define QTR_DEALT_MOST 10u /* places */

/* Bytes that it takes of a block, aligned for a double. Here and below the game has QTR_DEALT_MOST places at most. */
size_t qtr_deal_bytes(const qtr_pool *pool);

/* The best game in which each seeker goes one of the routes listed, and no two to the same place; all places are
 * visited where the objective needs that. Routes come without scores. False: there is none, and the routes are as they
 * were. */
bool qtr_deal(const qtr_pool *pool, void *block, qtr_routes *routes);

#endif
