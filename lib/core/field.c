#include "quarter/field.h"

#include "quarter/status.h"

/* What the upper 4 bits of a cell hold: enum qtr_direction, or one of these; and whether its row ends with it, so that
 * nothing has to be divided by the columns. */
enum { HERE = 4, UNKNOWN = 5, WAYS = 7, LAST_OF_ROW = 8 };

#define SHIFT (8 * sizeof(qtr_field_cell) - 4)
#define NO_LINK ((qtr_field_cell)(((qtr_field_cell)1 << SHIFT) - 1)) /* no cell has this number */

static unsigned way_of(const qtr_field *field, uint32_t cell) {
  return (unsigned)(field->cell[cell] >> SHIFT) & WAYS;
}

static bool ends_row(const qtr_field *field, uint32_t cell) {
  return ((field->cell[cell] >> SHIFT) & LAST_OF_ROW) != 0;
}

/* A cell keeps its end of row all along; its link is good only while it waits in a bucket, and lies where nobody asks
 * afterwards. */
static void set(qtr_field *field, uint32_t cell, unsigned way, qtr_field_cell link) {
  const unsigned high = (ends_row(field, cell) ? (unsigned)LAST_OF_ROW : 0u) | way;
  field->cell[cell] = (qtr_field_cell)(((qtr_field_cell)high << SHIFT) | (link & NO_LINK));
}

/* The last of a bucket has a link of all ones, which fits in the bits there are whatever the cells are called. */
static qtr_cell link_of(const qtr_field *field, qtr_cell cell) {
  const qtr_field_cell link = field->cell[cell] & NO_LINK;
  return (link == NO_LINK) ? QTR_NO_CELL : (qtr_cell)link;
}

/* A cell is told which way to go. All neighbours that can tell it tell it the same time, for that is what entering
 * itself costs more: so the first one is as good as any, and it waits in the ring once, until it can tell others. */
static void tell(qtr_field *field, const qtr_grid *grid, uint32_t cell, unsigned way) {
  const unsigned cost = qtr_grid_cost(grid, (qtr_cell)cell);
  if ((cost == 0u) || (way_of(field, cell) != UNKNOWN)) {
    return;
  }
  const unsigned bucket = (field->now + cost) % QTR_TRAVEL_RING;
  const qtr_cell waiting = field->ring[bucket];
  set(field, cell, way, (waiting == QTR_NO_CELL) ? NO_LINK : (qtr_field_cell)waiting);
  field->ring[bucket] = (qtr_cell)cell;
}

/* Tell the neighbour of `cell` that goes on to it in the field's direction: it lies on the other side. */
static void tell_neighbour(qtr_field *field, const qtr_grid *grid, uint32_t cell) {
  const uint32_t columns = grid->columns;
  switch (field->direction) {
  case QTR_NORTH:
    if ((cell + columns) < field->cells) {
      tell(field, grid, cell + columns, QTR_NORTH);
    }
    break;
  case QTR_EAST:
    if ((cell > 0u) && !ends_row(field, cell - 1u)) {
      tell(field, grid, cell - 1u, QTR_EAST);
    }
    break;
  case QTR_SOUTH:
    if (cell >= columns) {
      tell(field, grid, cell - columns, QTR_SOUTH);
    }
    break;
  default:
    if (!ends_row(field, cell)) {
      tell(field, grid, cell + 1u, QTR_WEST);
    }
    break;
  }
}

int qtr_field_begin_built(qtr_field *field, const qtr_grid *grid, qtr_cell target, uint32_t config_id) {
  const uint32_t cells = qtr_grid_cells(grid);
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  if (cells > QTR_MAX_CELLS) {
    return QTR_ERR_LIMIT;
  }
  uint32_t last = grid->columns - 1u;
  for (uint32_t cell = 0; cell < cells; cell++) {
    const bool is_last = cell == last;
    field->cell[cell] = (qtr_field_cell)((qtr_field_cell)(is_last ? (UNKNOWN | LAST_OF_ROW) : UNKNOWN) << SHIFT);
    if (is_last) {
      last += grid->columns;
    }
  }
  for (unsigned bucket = 0; bucket < QTR_TRAVEL_RING; bucket++) {
    field->ring[bucket] = QTR_NO_CELL;
  }
  field->cells = cells;
  field->first = QTR_NO_CELL;
  field->at = QTR_NO_CELL;
  field->empty = QTR_TRAVEL_RING;
  field->direction = QTR_WEST;
  field->now = 0;
  if (qtr_grid_cost(grid, target) == 0u) {
    return QTR_ERR_ARGUMENT;
  }
  field->empty = 0;
  tell(field, grid, target, HERE);
  return QTR_OK;
}

/* The next bucket's cells are settled; each tells its neighbours, first all that go north, then all that go east, and
 * so on: of ways that take the same time a cell so takes the first in this order. */
static void settle_next(qtr_field *field) {
  if ((field->direction < QTR_WEST) && (field->first != QTR_NO_CELL)) {
    field->direction++;
  } else {
    field->now++;
    field->first = field->ring[field->now];
    field->ring[field->now] = QTR_NO_CELL;
    field->empty = (field->first == QTR_NO_CELL) ? (uint16_t)(field->empty + 1u) : 0;
    field->direction = QTR_NORTH;
  }
  field->at = field->first;
}

bool qtr_field_work(qtr_field *field, const qtr_grid *grid, unsigned steps) {
  /* Times rise by at most 255 from cell to cell: a whole turn of empty buckets means that all is settled. */
  for (; (steps > 0u) && (field->empty < QTR_TRAVEL_RING); steps--) {
    if (field->at == QTR_NO_CELL) {
      settle_next(field);
    } else {
      tell_neighbour(field, grid, field->at);
      field->at = link_of(field, field->at);
    }
  }
  return field->empty < QTR_TRAVEL_RING;
}

int qtr_field_fill_built(qtr_field *field, const qtr_grid *grid, qtr_cell target, uint32_t config_id) {
  const int status = qtr_field_begin_built(field, grid, target, config_id);
  while ((status == QTR_OK) && qtr_field_work(field, grid, UINT16_MAX)) {}
  return status;
}

/* A cell was told by the neighbour through which its way goes, so the way is read off backwards, with no times kept. */
qtr_cell qtr_field_next(const qtr_field *field, const qtr_grid *grid, qtr_cell cell) {
  if ((cell >= field->cells) || (field->cells != qtr_grid_cells(grid))) {
    return QTR_NO_CELL; /* of another grid */
  }
  switch (way_of(field, cell)) {
  case QTR_NORTH: return (qtr_cell)(cell - grid->columns);
  case QTR_EAST: return (qtr_cell)(cell + 1u);
  case QTR_SOUTH: return (qtr_cell)(cell + grid->columns);
  case QTR_WEST: return (qtr_cell)(cell - 1u);
  case HERE: return cell;
  default: return QTR_NO_CELL;
  }
}
