/* Blocked cells as few rectangles: a body that slides along a wall made cell by cell snags at the seams. */
#ifndef QUARTER_DEMO_WALLS_H
#define QUARTER_DEMO_WALLS_H

#include "quarter/grid.h"

typedef struct {
  uint16_t column, row, columns, rows; /* in cells; row 0 is the top row */
} wall;

/* Cover the blocked cells of a grid by rectangles that do not overlap: newly allocated `*walls`, which the caller
 * frees. Returns their number, or -1 if there is no memory. */
int walls_make(wall **walls, const qtr_grid *grid);

#endif
