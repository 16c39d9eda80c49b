/* The way to a cell, as a robot goes it: from every cell the next one to enter on a shortest path.
 *
 * The search spreads from the target and is done in one go, or in parts where a robot has other things to do meanwhile:
 *
 *   qtr_field_begin(&field, &grid, target);
 *   while (qtr_field_work(&field, &grid, 50)) { ... }      50 cells looked at a call
 *
 * The next step from a cell is known as soon as the search has come there: it need not be waited for to the end.
 */
#ifndef QUARTER_FIELD_H
#define QUARTER_FIELD_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/grid.h"

QTR_C_BEGIN

/* Of each cell: in the upper 4 bits the direction to go on in, below them the next cell of those that wait for the same
 * time. Such cells are counted from 1: 0 is none. */
#if QTR_MAX_CELLS < 4096
typedef uint16_t qtr_field_cell;
#else
typedef uint32_t qtr_field_cell;
#endif

/* Large: keep it in static storage. 2 bytes a cell below 4,096 cells, else 4; and the ring. */
typedef struct {
  uint8_t now;                    /* bucket */
  uint8_t direction;              /* in which neighbours are told */
  uint16_t empty;                 /* buckets in a row that held nothing: a whole turn of them is the end */
  qtr_cell first;                 /* of the cells that are settled now, from 1 on; 0: none */
  qtr_cell at;                    /* the one whose neighbour is told next, likewise */
  uint32_t cells;                 /* of the grid that it is of */
  qtr_cell ring[QTR_TRAVEL_RING]; /* scratch: such cells by the time at which they are settled, modulo its size */
  qtr_field_cell cell[QTR_MAX_CELLS];
} qtr_field;

/* Begin a search for the ways to `target`. QTR_OK; QTR_ERR_ARGUMENT for a target that is blocked or outside, which then
 * has a way from no cell; QTR_ERR_LIMIT for a grid of more cells than the build holds, QTR_ERR_CONFIG if the caller was
 * built under other sizes, both with nothing written. */
#define qtr_field_begin(field, grid, target) qtr_field_begin_built(field, grid, target, QTR_CONFIG_ID)
int qtr_field_begin_built(qtr_field *field, const qtr_grid *grid, qtr_cell target, uint32_t config_id);

/* Go on with it, over the grid that it was begun with, for at most so many steps, each of which looks at one neighbour
 * of a cell. False when there is no more to do. Dijkstra's algorithm over a ring of time buckets (Dial 1969), linear in
 * the cells. */
bool qtr_field_work(qtr_field *field, const qtr_grid *grid, uint32_t steps);

/* All of it at once. Returns what qtr_field_begin() does. */
#define qtr_field_fill(field, grid, target) qtr_field_fill_built(field, grid, target, QTR_CONFIG_ID)
int qtr_field_fill_built(qtr_field *field, const qtr_grid *grid, qtr_cell target, uint32_t config_id);

/* The cell to enter next on a shortest path from `cell` to the field's target: the first in the order N, E, S, W.
 * `cell` itself at the target; QTR_NO_CELL where there is no way, or none is known yet, and for a cell outside the
 * grid. */
qtr_cell qtr_field_next(const qtr_field *field, const qtr_grid *grid, qtr_cell cell);

QTR_C_END

#endif
