/* The map as cells. A grid is a view: it never owns or copies its cells, so a robot reads them in flash. */
#ifndef QUARTER_GRID_H
#define QUARTER_GRID_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

enum qtr_grid_encoding {
  QTR_GRID_BITS = 0, /* a bit a cell, 1 = free at cost 1; cell c is bit c % 8 of byte c / 8 */
  QTR_GRID_BYTES = 1 /* a byte a cell: 0 = blocked, 1..255 = steps that entering the cell takes */
};

typedef struct {
  uint16_t columns;     /* 1 or more; columns * rows <= QTR_MAX_CELLS */
  uint16_t rows;        /* 1 or more */
  uint8_t encoding;     /* enum qtr_grid_encoding */
  const uint8_t *cells; /* row by row from the top; must outlive the grid */
} qtr_grid;

/* In the order in which ties are broken. */
enum qtr_direction { QTR_NORTH = 0, QTR_EAST = 1, QTR_SOUTH = 2, QTR_WEST = 3 };

/* Steps that entering `cell` takes, 1..255; 0 if it is blocked. `cell` must lie in the grid. */
static inline unsigned qtr_grid_cost(const qtr_grid *grid, qtr_cell cell) {
  if (grid->encoding == QTR_GRID_BYTES) return grid->cells[cell];
  return ((unsigned)grid->cells[cell / 8] >> (cell % 8)) & 1u;
}

/* The cell next to `cell` in a direction, blocked or not; QTR_NO_CELL beyond the map's edge. */
qtr_cell qtr_grid_neighbour(const qtr_grid *grid, qtr_cell cell, enum qtr_direction direction);

/* Bytes that a grid of this many cells takes in an encoding. */
uint32_t qtr_grid_size(uint32_t cells, uint8_t encoding);

#endif
