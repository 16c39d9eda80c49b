#include "hope.h"

#include <limits.h>

void hope_begin(hope *h, int64_t utime) {
  *h = (hope){QTR_NO_CELL, UINT_MAX, utime};
}

unsigned hope_steps(const qtr_field *way, const qtr_grid *grid, qtr_cell cell) {
  unsigned steps = 0;
  for (qtr_cell next = qtr_field_next(way, grid, cell); next != cell; next = qtr_field_next(way, grid, cell)) {
    if (next == QTR_NO_CELL) return UINT_MAX;
    steps += qtr_grid_cost(grid, next);
    cell = next;
  }
  return steps;
}

/* Pushed into a wall, or off the grid, it is not where it could go on from: that says nothing of the target. */
bool hope_left(hope *h, const qtr_field *way, const ground *g, point at, double speed, int64_t utime) {
  const qtr_cell cell = ground_cell(g, at);
  if (cell == QTR_NO_CELL || qtr_grid_cost(&g->grid, cell) == 0) return true;
  if (cell != h->cell) {
    const unsigned steps = hope_steps(way, &g->grid, cell);
    if (steps == UINT_MAX) return false;
    h->cell = cell;
    if (steps < h->least) {
      h->least = steps;
      h->since = utime;
    }
  }
  if (utime < h->since) h->since = utime; /* a clock set anew */
  return (double)(utime - h->since) <= ground_slowness(g, at) * (HOPE_PATIENCE / speed);
}
