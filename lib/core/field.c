#include "quarter/field.h"

#include <stddef.h>

#include "core/bytes.h"
#include "quarter/status.h"

/* What the upper 4 bits of a cell hold: whether its row begins with it, so that nothing has to be divided by the
 * columns, and 1 + the direction to go on in, or one of these. A field of zeros knows no way. */
enum { UNKNOWN = 0, HERE = 5, WAYS = 7, FIRST_OF_ROW = 8 };

#define SHIFT (8 * sizeof(qtr_field_cell) - 4)
#define LINK ((qtr_field_cell)(((qtr_field_cell)1 << SHIFT) - 1))

static unsigned way_of(const qtr_field *field, uint32_t cell) {
  return (unsigned)(field->cell[cell] >> SHIFT) & WAYS;
}

static bool begins_row(const qtr_field *field, uint32_t cell) {
  return ((field->cell[cell] >> SHIFT) & FIRST_OF_ROW) != 0;
}

/* One cell on in a direction, wherever that leads. North and south are the even ones. */
static uint32_t next_to(uint32_t cell, unsigned direction, uint32_t columns) {
  const uint32_t by = ((direction % 2u) == 0u) ? columns : 1u;
  return ((direction == QTR_EAST) || (direction == QTR_SOUTH)) ? (cell + by) : (cell - by);
}

/* A cell is told which way to go. All neighbours that can tell it tell it the same time, for that is what entering
 * itself costs more: so the first one is as good as any, and it waits in the ring once, until it can tell others. Its
 * link is good only while it waits, and lies where nobody asks afterwards. */
static void tell(qtr_field *field, const qtr_grid *grid, uint32_t cell, unsigned way) {
  const unsigned cost = qtr_grid_cost(grid, (qtr_cell)cell);
  if ((cost == 0u) || (way_of(field, cell) != UNKNOWN)) {
    return;
  }
  qtr_cell *waiting = &field->ring[(field->now + cost) % QTR_TRAVEL_RING];
  field->cell[cell] |= (qtr_field_cell)(((qtr_field_cell)way << SHIFT) | *waiting);
  *waiting = (qtr_cell)(cell + 1u);
}

/* Tell the neighbour of `cell` that goes on to it in the field's direction: it lies on the other side. */
static void tell_neighbour(qtr_field *field, const qtr_grid *grid, uint32_t cell) {
  const unsigned direction = field->direction;
  const uint32_t neighbour = next_to(cell, direction ^ 2u, grid->columns);
  if (neighbour >= field->cells) {
    return;
  }
  /* Of two cells side by side the right one does not begin a row. */
  if ((direction == QTR_EAST) && begins_row(field, cell)) {
    return;
  }
  if ((direction == QTR_WEST) && begins_row(field, neighbour)) {
    return;
  }
  tell(field, grid, neighbour, direction + 1u);
}

int qtr_field_begin_built(qtr_field *field, const qtr_grid *grid, qtr_cell target, uint32_t config_id) {
  const uint32_t cells = qtr_grid_cells(grid);
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  if (cells > QTR_MAX_CELLS) {
    return QTR_ERR_LIMIT;
  }
  bytes_clear(field, (uint32_t)(offsetof(qtr_field, cell) + (cells * sizeof(field->cell[0]))));
  field->cells = cells;
  if (qtr_grid_cost(grid, target) == 0u) {
    field->empty = QTR_TRAVEL_RING;
    return QTR_ERR_ARGUMENT;
  }
  for (uint32_t first = 0; first < cells; first += grid->columns) {
    field->cell[first] = (qtr_field_cell)((qtr_field_cell)FIRST_OF_ROW << SHIFT);
  }
  tell(field, grid, target, HERE);
  return QTR_OK;
}

/* The next bucket's cells are settled; each tells its neighbours, first all that go north, then all that go east, and
 * so on: of ways that take the same time a cell so takes the first in this order. */
static void settle_next(qtr_field *field) {
  field->direction++;
  if ((field->direction > QTR_WEST) || (field->first == 0u)) {
    field->now++;
    field->first = field->ring[field->now];
    field->ring[field->now] = 0;
    field->empty = (field->first == 0u) ? (uint16_t)(field->empty + 1u) : 0;
    field->direction = QTR_NORTH;
  }
  field->at = field->first;
}

bool qtr_field_work(qtr_field *field, const qtr_grid *grid, uint32_t steps) {
  /* Times rise by at most 255 from cell to cell: a whole turn of empty buckets means that all is settled. */
  for (; (steps > 0u) && (field->empty < QTR_TRAVEL_RING); steps--) {
    if (field->at == 0u) {
      settle_next(field);
    } else {
      const uint32_t cell = field->at - 1u;
      tell_neighbour(field, grid, cell);
      field->at = (qtr_cell)(field->cell[cell] & LINK);
    }
  }
  return field->empty < QTR_TRAVEL_RING;
}

int qtr_field_fill_built(qtr_field *field, const qtr_grid *grid, qtr_cell target, uint32_t config_id) {
  const int status = qtr_field_begin_built(field, grid, target, config_id);
  if (status == QTR_OK) {
    (void)qtr_field_work(field, grid, UINT32_MAX); /* more than there are */
  }
  return status;
}

/* A cell was told by the neighbour through which its way goes, so the way is read off backwards, with no times kept. */
qtr_cell qtr_field_next(const qtr_field *field, const qtr_grid *grid, qtr_cell cell) {
  if ((cell >= field->cells) || (field->cells != qtr_grid_cells(grid))) {
    return QTR_NO_CELL; /* of another grid */
  }
  const unsigned way = way_of(field, cell);
  if (way == UNKNOWN) {
    return QTR_NO_CELL;
  }
  return (way == HERE) ? cell : (qtr_cell)next_to(cell, way - 1u, grid->columns);
}
