#include "quarter/grid.h"

/* The copies that are called. */
extern inline uint32_t qtr_grid_cells(const qtr_grid *grid);
extern inline unsigned qtr_grid_cost(const qtr_grid *grid, qtr_cell cell);

/* Cells are counted from the north-west corner, row by row: east is one on, south a row on. Only in a row can a
 * neighbour be lost without leaving the array, so east and west ask for the column. */
qtr_cell qtr_grid_neighbour(const qtr_grid *grid, qtr_cell cell, enum qtr_direction direction) {
  if (cell >= qtr_grid_cells(grid)) {
    return QTR_NO_CELL;
  }
  const qtr_cell columns = grid->columns;
  const qtr_cell column = (qtr_cell)(cell % columns);
  switch (direction) {
  case QTR_NORTH: return (cell >= columns) ? (qtr_cell)(cell - columns) : QTR_NO_CELL;
  case QTR_EAST: return ((column + 1u) < columns) ? (qtr_cell)(cell + 1u) : QTR_NO_CELL;
  case QTR_SOUTH: return (((uint32_t)cell + columns) < qtr_grid_cells(grid)) ? (qtr_cell)(cell + columns) : QTR_NO_CELL;
  case QTR_WEST: return (column > 0u) ? (qtr_cell)(cell - 1u) : QTR_NO_CELL;
  default: return QTR_NO_CELL;
  }
}

uint32_t qtr_grid_size(uint32_t cells, uint8_t encoding) {
  return (encoding != QTR_GRID_BITS) ? cells : ((cells / 8u) + ((cells % 8u) > 0u));
}

/* Right and bottom are the first column and row that are out: a box that holds nothing is all 0, and none that holds a
 * cell has a right of 0. */
void qtr_box_add(qtr_box *box, const qtr_grid *grid, qtr_cell cell) {
  const uint16_t column = (uint16_t)(cell % grid->columns);
  const uint16_t row = (uint16_t)(cell / grid->columns);
  const bool is_first = box->right == 0u;
  if (is_first || (column < box->left)) {
    box->left = column;
  }
  if (is_first || (row < box->top)) {
    box->top = row;
  }
  if (column >= box->right) {
    box->right = (uint16_t)(column + 1u);
  }
  if (row >= box->bottom) {
    box->bottom = (uint16_t)(row + 1u);
  }
}

/* Differences and sums of two such coordinates do not overflow. */
static bool is_on_earth(int64_t coordinate_um) {
  return (coordinate_um > -QTR_FRAME_LIMIT_UM) && (coordinate_um < QTR_FRAME_LIMIT_UM);
}

/* The length of (cosine, sine) is 1, but for their rounding. */
static bool is_turn(int32_t cosine, int32_t sine) {
  const int64_t one = (int64_t)QTR_FRAME_ONE * QTR_FRAME_ONE;
  const int64_t square = ((int64_t)cosine * cosine) + ((int64_t)sine * sine);
  return ((cosine == 0) && (sine == 0)) ||
         ((square > (one - (4 * (int64_t)QTR_FRAME_ONE))) && (square < (one + (4 * (int64_t)QTR_FRAME_ONE))));
}

bool qtr_frame_is_one(const qtr_frame *frame) {
  if (frame->cell_size_um == 0u) {
    return (frame->origin_x_um == 0) && (frame->origin_y_um == 0) && (frame->cosine == 0) && (frame->sine == 0);
  }
  return is_on_earth(frame->origin_x_um) && is_on_earth(frame->origin_y_um) && is_turn(frame->cosine, frame->sine);
}

static bool has_metres(const qtr_frame *frame) {
  return (frame->cell_size_um > 0u) && qtr_frame_is_one(frame);
}

/* length * factor / QTR_FRAME_ONE, in two parts, for the product has more than 64 bits: the length is below 2^52. */
static int64_t part_of(int64_t length, int32_t factor) {
  /* Divided by magnitude: a shift of a negative number is the compiler's own in C99, and both signs are to round
   * alike. */
  const bool is_negative = (length < 0) != (factor < 0);
  const uint64_t size = (uint64_t)((length < 0) ? -length : length);
  const uint64_t by = (uint64_t)((factor < 0) ? -(int64_t)factor : factor);
  const uint64_t high = (size >> 24) * by;
  const uint64_t low = (size & 0xFFFFFFu) * by;
  const int64_t part = (int64_t)((high + (low >> 24)) >> 6);
  return is_negative ? -part : part;
}

/* The turn (c, s) takes (across, up) from the corner to (c across - s up, s across + c up); without one nothing is
 * rounded. */
bool qtr_frame_centre(const qtr_frame *frame, const qtr_grid *grid, qtr_cell cell, int64_t *x_um, int64_t *y_um) {
  if (!has_metres(frame) || (cell >= qtr_grid_cells(grid))) {
    return false;
  }
  const int64_t side = frame->cell_size_um;
  const int64_t across = (cell % grid->columns * side) + (side / 2);
  const int64_t up = ((grid->rows - 1 - (cell / grid->columns)) * side) + (side / 2);
  const bool is_turned = (frame->cosine != 0) || (frame->sine != 0);
  *x_um = frame->origin_x_um + (is_turned ? (part_of(across, frame->cosine) - part_of(up, frame->sine)) : across);
  *y_um = frame->origin_y_um + (is_turned ? (part_of(across, frame->sine) + part_of(up, frame->cosine)) : up);
  return true;
}

/* From the bottom-left corner of the grid, along its bottom and up. */
static qtr_cell cell_at(const qtr_grid *grid, int64_t side, int64_t across, int64_t up) {
  if ((across < 0) || (up < 0) || ((across / side) >= grid->columns) || ((up / side) >= grid->rows)) {
    return QTR_NO_CELL;
  }
  return (qtr_cell)(((grid->rows - 1 - (up / side)) * grid->columns) + (across / side));
}

/* The inverse of a turn is its transpose, (c, -s). */
qtr_cell qtr_frame_cell(const qtr_frame *frame, const qtr_grid *grid, int64_t x_um, int64_t y_um) {
  const int64_t side = frame->cell_size_um;
  if (!has_metres(frame) || !is_on_earth(x_um) || !is_on_earth(y_um)) {
    return QTR_NO_CELL;
  }
  const int64_t x = x_um - frame->origin_x_um;
  const int64_t y = y_um - frame->origin_y_um;
  const bool is_turned = (frame->cosine != 0) || (frame->sine != 0);
  if (!is_turned) {
    return cell_at(grid, side, x, y);
  }
  return cell_at(grid, side, part_of(x, frame->cosine) + part_of(y, frame->sine),
                 part_of(y, frame->cosine) - part_of(x, frame->sine));
}
