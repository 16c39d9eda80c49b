#include "quarter/grid.h"

qtr_cell qtr_grid_neighbour(const qtr_grid *grid, qtr_cell cell, enum qtr_direction direction) {
  if (cell >= qtr_grid_cells(grid)) return QTR_NO_CELL;
  const qtr_cell columns = grid->columns;
  const qtr_cell column = (qtr_cell)(cell % columns);
  switch (direction) {
  case QTR_NORTH: return cell >= columns ? (qtr_cell)(cell - columns) : QTR_NO_CELL;
  case QTR_EAST: return column + 1 < columns ? (qtr_cell)(cell + 1) : QTR_NO_CELL;
  case QTR_SOUTH: return (uint32_t)cell + columns < qtr_grid_cells(grid) ? (qtr_cell)(cell + columns) : QTR_NO_CELL;
  case QTR_WEST: return column > 0 ? (qtr_cell)(cell - 1) : QTR_NO_CELL;
  default: return QTR_NO_CELL;
  }
}

uint32_t qtr_grid_size(uint32_t cells, uint8_t encoding) {
  return encoding == QTR_GRID_BYTES ? cells : cells / 8 + (cells % 8 > 0);
}

/* Differences and sums of two such coordinates do not overflow. */
static bool is_on_earth(int64_t coordinate_um) {
  return coordinate_um > -QTR_FRAME_LIMIT_UM && coordinate_um < QTR_FRAME_LIMIT_UM;
}

static bool has_metres(const qtr_frame *frame) {
  return frame->cell_size_um > 0 && is_on_earth(frame->origin_x_um) && is_on_earth(frame->origin_y_um);
}

bool qtr_frame_centre(const qtr_frame *frame, const qtr_grid *grid, qtr_cell cell, int64_t *x_um, int64_t *y_um) {
  if (!has_metres(frame) || cell >= qtr_grid_cells(grid)) return false;
  const int64_t side = frame->cell_size_um;
  const int64_t column = cell % grid->columns;
  const int64_t row_up = grid->rows - 1 - cell / grid->columns;
  *x_um = frame->origin_x_um + column * side + side / 2;
  *y_um = frame->origin_y_um + row_up * side + side / 2;
  return true;
}

qtr_cell qtr_frame_cell(const qtr_frame *frame, const qtr_grid *grid, int64_t x_um, int64_t y_um) {
  const int64_t side = frame->cell_size_um;
  if (!has_metres(frame) || !is_on_earth(x_um) || !is_on_earth(y_um)) return QTR_NO_CELL;
  if (x_um < frame->origin_x_um || y_um < frame->origin_y_um) return QTR_NO_CELL;
  const int64_t column = (x_um - frame->origin_x_um) / side;
  const int64_t row_up = (y_um - frame->origin_y_um) / side;
  if (column >= grid->columns || row_up >= grid->rows) return QTR_NO_CELL;
  return (qtr_cell)((grid->rows - 1 - row_up) * grid->columns + column);
}
