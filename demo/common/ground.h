/* Two ways to say where something is. Points: in cells, x to the right from the left edge, y UP from the bottom edge of the
 * grid; so does the world think, and so do robots drive. Metres: in the map frame, as messages have it. */
#ifndef QUARTER_DEMO_GROUND_H
#define QUARTER_DEMO_GROUND_H

#include "quarter/policy.h"

typedef struct {
  double x, y;
} point;

typedef struct {
  qtr_grid grid;
  double cell_size; /* metres; 1 where the map has none */
  double origin_x, origin_y;
} ground;

static inline ground ground_of(const qtr_policy *policy) {
  const qtr_frame *frame = &policy->frame;
  const bool metric = frame->cell_size_um > 0;
  return (ground){policy->grid, metric ? frame->cell_size_um / 1e6 : 1.0, (double)frame->origin_x_um / 1e6,
                  (double)frame->origin_y_um / 1e6};
}

static inline point ground_point(const ground *g, double x_m, double y_m) {
  return (point){(x_m - g->origin_x) / g->cell_size, (y_m - g->origin_y) / g->cell_size};
}

static inline double ground_x_m(const ground *g, point p) {
  return g->origin_x + p.x * g->cell_size;
}

static inline double ground_y_m(const ground *g, point p) {
  return g->origin_y + p.y * g->cell_size;
}

static inline point ground_centre(const ground *g, qtr_cell cell) {
  return (point){cell % g->grid.columns + 0.5, g->grid.rows - 0.5 - cell / g->grid.columns};
}

/* The cell at a point; QTR_NO_CELL off the grid. */
static inline qtr_cell ground_cell(const ground *g, point p) {
  if (!(p.x >= 0.0 && p.y >= 0.0 && p.x < g->grid.columns && p.y < g->grid.rows)) return QTR_NO_CELL;
  const unsigned row = g->grid.rows - 1u - (unsigned)p.y;
  return (qtr_cell)(row * g->grid.columns + (unsigned)p.x);
}

/* Steps that the ground takes at a point, 1 off the grid and on blocked cells: how much slower things go there. */
static inline unsigned ground_slowness(const ground *g, point p) {
  const qtr_cell cell = ground_cell(g, p);
  const unsigned cost = cell != QTR_NO_CELL ? qtr_grid_cost(&g->grid, cell) : 1;
  return cost > 0 ? cost : 1;
}

#endif
