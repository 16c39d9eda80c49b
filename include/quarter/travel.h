/* The elemental tasks (paper, section 4.1): shortest travel times on the grid and the next step towards a cell. A robot
 * needs the step alone, and has quarter/field.h.
 *
 * Travel time counts what entering each cell on the way costs, the target included, the start not. With terrain it is
 * not symmetric.
 */
#ifndef QUARTER_TRAVEL_H
#define QUARTER_TRAVEL_H

#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/grid.h"
#include "quarter/status.h"

QTR_C_BEGIN

/* Travel times from every cell to one target. Large: keep it in static storage, or, for grids of so many cells and no
 * more, in a block of qtr_travel_bytes(), which ends early. */
typedef struct {
  qtr_cell ring[QTR_TRAVEL_RING]; /* scratch: cells by the time at which they are settled */
  qtr_steps to_go[QTR_MAX_CELLS]; /* QTR_NEVER where the target cannot be reached */
  qtr_cell link[QTR_MAX_CELLS];   /* scratch: cells waiting in the same ring entry, behind the times in use */
} qtr_travel;

size_t qtr_travel_bytes(uint32_t cells);

/* Fill `travel` with the travel times to `target`. Dijkstra's algorithm over a ring of time buckets (Dial 1969): time
 * and memory linear in the cells. QTR_OK; QTR_ERR_ARGUMENT for a target that is blocked or outside, which is then in
 * reach of no cell; QTR_ERR_LIMIT for a grid of more cells than the build holds, QTR_ERR_CONFIG if the caller was built
 * under other sizes, both with nothing filled. */
#define qtr_travel_fill(travel, grid, target) qtr_travel_fill_built(travel, grid, target, QTR_CONFIG_ID)
int qtr_travel_fill_built(qtr_travel *travel, const qtr_grid *grid, qtr_cell target, uint32_t config_id);

/* The cell to enter next on a shortest path from `cell` to the travel's target: the first in the order N, E, S, W.
 * `cell` itself at the target; QTR_NO_CELL where the target cannot be reached, and for a cell outside the grid. */
qtr_cell qtr_travel_next(const qtr_travel *travel, const qtr_grid *grid, qtr_cell cell);

QTR_C_END

#endif
