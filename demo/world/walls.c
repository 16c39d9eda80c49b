#include "walls.h"

#include <stdbool.h>
#include <stdlib.h>

typedef struct {
  const qtr_grid *grid;
  bool *taken; /* cells that a wall covers already */
} mason;

static bool open_to(const mason *m, unsigned column, unsigned row) {
  const qtr_cell cell = (qtr_cell)(row * m->grid->columns + column);
  return qtr_grid_cost(m->grid, cell) == 0 && !m->taken[cell];
}

static bool row_fits(const mason *m, const wall *w, unsigned row) {
  for (unsigned column = w->column; column < (unsigned)w->column + w->columns; column++)
    if (!open_to(m, column, row)) return false;
  return true;
}

/* As far to the right as can be, then as far down. */
static wall grow(const mason *m, unsigned column, unsigned row) {
  wall w = {(uint16_t)column, (uint16_t)row, 1, 1};
  while (column + w.columns < m->grid->columns && open_to(m, column + w.columns, row)) w.columns++;
  while (row + w.rows < m->grid->rows && row_fits(m, &w, row + w.rows)) w.rows++;
  for (unsigned r = row; r < row + w.rows; r++)
    for (unsigned c = column; c < column + w.columns; c++) m->taken[r * m->grid->columns + c] = true;
  return w;
}

int walls_make(wall **walls, const qtr_grid *grid) {
  const size_t cells = qtr_grid_cells(grid);
  const mason m = {grid, calloc(cells, sizeof *m.taken)};
  int count = 0;
  *walls = malloc(cells * sizeof **walls);
  if (*walls == NULL || m.taken == NULL) {
    free(*walls);
    free(m.taken);
    return -1;
  }
  for (unsigned row = 0; row < grid->rows; row++)
    for (unsigned column = 0; column < grid->columns; column++)
      if (open_to(&m, column, row)) (*walls)[count++] = grow(&m, column, row);
  free(m.taken);
  return count;
}
