/* Two ways to say where something is. Points: in cells, x to the right from the left edge, y UP from the bottom edge of
 * the grid; so does the world think, and so do robots drive. Metres: in the map frame, as messages have it. */
#ifndef QUARTER_DEMO_GROUND_H
#define QUARTER_DEMO_GROUND_H

#include <math.h>

#include "quarter/policy.h"

typedef struct {
  double x, y;
} point;

typedef struct {
  qtr_grid grid;
  double cell_size; /* metres; 1 where the map has none */
  double origin_x, origin_y;
  double cosine, sine, turn; /* of the grid against the map frame, counter-clockwise; radians */
} ground;

static inline ground ground_in(const qtr_grid *grid, const qtr_frame *frame) {
  const bool metric = frame->cell_size_um > 0;
  const bool turned = frame->cosine != 0 || frame->sine != 0;
  const double turn = turned ? atan2(frame->sine, frame->cosine) : 0.0;
  return (ground){*grid,
                  metric ? frame->cell_size_um / 1e6 : 1.0,
                  (double)frame->origin_x_um / 1e6,
                  (double)frame->origin_y_um / 1e6,
                  turned ? cos(turn) : 1.0,
                  turned ? sin(turn) : 0.0,
                  turn};
}

static inline ground ground_of(const qtr_policy *policy) {
  const qtr_frame frame = qtr_policy_frame(policy);
  return ground_in(&policy->grid, &frame);
}

static inline point ground_point(const ground *g, double x_m, double y_m) {
  const double east = x_m - g->origin_x, north = y_m - g->origin_y;
  return (point){(g->cosine * east + g->sine * north) / g->cell_size,
                 (g->cosine * north - g->sine * east) / g->cell_size};
}

static inline double ground_x_m(const ground *g, point p) {
  return g->origin_x + (g->cosine * p.x - g->sine * p.y) * g->cell_size;
}

static inline double ground_y_m(const ground *g, point p) {
  return g->origin_y + (g->sine * p.x + g->cosine * p.y) * g->cell_size;
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
