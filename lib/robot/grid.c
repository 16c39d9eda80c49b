#include "quarter/grid.h"

qtr_cell qtr_grid_neighbour(const qtr_grid *grid, qtr_cell cell, enum qtr_direction direction) {
  const qtr_cell columns = grid->columns;
  const qtr_cell column = (qtr_cell)(cell % columns);
  switch (direction) {
  case QTR_NORTH: return cell >= columns ? (qtr_cell)(cell - columns) : QTR_NO_CELL;
  case QTR_EAST: return column + 1 < columns ? (qtr_cell)(cell + 1) : QTR_NO_CELL;
  case QTR_SOUTH:
    return (uint32_t)cell + columns < (uint32_t)columns * grid->rows ? (qtr_cell)(cell + columns) : QTR_NO_CELL;
  case QTR_WEST: return column > 0 ? (qtr_cell)(cell - 1) : QTR_NO_CELL;
  default: return QTR_NO_CELL;
  }
}

uint32_t qtr_grid_size(uint32_t cells, uint8_t encoding) {
  return encoding == QTR_GRID_BYTES ? cells : (cells + 7) / 8;
}
