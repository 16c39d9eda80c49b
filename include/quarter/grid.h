/* The map as cells. A grid is a view: it never owns or copies its cells, so a robot reads them in flash. */
#ifndef QUARTER_GRID_H
#define QUARTER_GRID_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

#define QTR_TRAVEL_RING 256 /* one more than the greatest cost of a cell: what a search needs (quarter/travel.h) */

enum qtr_grid_encoding {
  QTR_GRID_BITS = 0,  /* a bit a cell, 1 = free at cost 1; cell c is bit c % 8 of byte c / 8 */
  QTR_GRID_BYTES = 1, /* a byte a cell: 0 = blocked, 1..255 = steps that entering the cell takes */
  QTR_GRID_SMOOTH = 2 /* the same bytes for who may not enter rough ground: what costs more than 1 is blocked. A view,
                         never stored; of builds with QTR_TERMS */
};

typedef struct {
  uint16_t columns;     /* 1 or more; columns * rows <= QTR_MAX_CELLS */
  uint16_t rows;        /* 1 or more */
  uint8_t encoding;     /* enum qtr_grid_encoding */
  const uint8_t *cells; /* row by row from the top; must outlive the grid */
} qtr_grid;

/* Part of a grid: columns left..right-1, rows top..bottom-1. Empty where right is 0. */
typedef struct {
  uint16_t left, top, right, bottom;
} qtr_box;

/* Widen a box so that it holds the cell. */
void qtr_box_add(qtr_box *box, const qtr_grid *grid, qtr_cell cell);

#define QTR_FRAME_LIMIT_UM ((int64_t)1000000000000000) /* coordinates lie between this and its negative */

/* Where a grid lies in the world: in the map frame, y up, of the ROS map or whatever the robots localise in. In
 * micrometres, so that a robot needs no floating point. */
typedef struct {
  uint32_t cell_size_um; /* side of a cell; 0: the map has no metres, and the rest is 0 */
  int64_t origin_x_um;   /* the bottom-left cell's outer corner */
  int64_t origin_y_um;
  int32_t cosine; /* of the angle by which the grid is turned, counter-clockwise, in units of 1 / QTR_FRAME_ONE */
  int32_t sine;   /* both 0: it is not turned */
} qtr_frame;

#define QTR_FRAME_ONE ((int32_t)1 << 30)

/* Whether a frame is one: no metres and all 0, or its origin within QTR_FRAME_LIMIT_UM and its turn the cosine and sine
 * of some angle. */
bool qtr_frame_is_one(const qtr_frame *frame);

/* In the order in which ties are broken. */
enum qtr_direction { QTR_NORTH = 0, QTR_EAST = 1, QTR_SOUTH = 2, QTR_WEST = 3 };

/* Cells of a grid, blocked ones included. */
inline uint32_t qtr_grid_cells(const qtr_grid *grid) {
  return (uint32_t)grid->columns * grid->rows;
}

/* Steps that entering `cell` takes, 1..255; 0 if it is blocked or outside the grid. */
inline unsigned qtr_grid_cost(const qtr_grid *grid, qtr_cell cell) {
  if (cell >= qtr_grid_cells(grid)) {
    return 0;
  }
  if (grid->encoding != QTR_GRID_BITS) {
    const unsigned cost = grid->cells[cell];
    return (!QTR_TERMS || (grid->encoding != QTR_GRID_SMOOTH) || (cost == 1u)) ? cost : 0u;
  }
  return ((unsigned)grid->cells[cell / 8u] >> (cell % 8u)) & 1u;
}

/* The cell next to `cell` in a direction, blocked or not; QTR_NO_CELL beyond the map's edge, and next to a cell
 * outside. */
qtr_cell qtr_grid_neighbour(const qtr_grid *grid, qtr_cell cell, enum qtr_direction direction);

/* The middle of a cell in the map frame. False, with nothing written, for a cell outside the grid, a frame without
 * metres, or one that is none. */
bool qtr_frame_centre(const qtr_frame *frame, const qtr_grid *grid, qtr_cell cell, int64_t *x_um, int64_t *y_um);

/* The cell at a point of the map frame, free or blocked. QTR_NO_CELL off the grid, however far off a localisation that
 * has gone astray puts it; in a frame without metres, or one that is none. */
qtr_cell qtr_frame_cell(const qtr_frame *frame, const qtr_grid *grid, int64_t x_um, int64_t y_um);

/* Bytes that a grid of this many cells takes in an encoding. */
uint32_t qtr_grid_size(uint32_t cells, uint8_t encoding);

QTR_C_END

#endif
