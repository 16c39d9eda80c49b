#include "quarter/travel.h"

#include "model/ring.h"

/* Where numbers of cells are as wide as steps, the links of a smaller grid lie right behind its times, so that they end
 * together. */
#define ARE_ALIKE (sizeof(qtr_cell) == sizeof(qtr_steps))

static qtr_cell *links_of(qtr_travel *travel, uint32_t cells) {
  return ARE_ALIKE ? (qtr_cell *)(void *)(travel->to_go + cells) : travel->link;
}

size_t qtr_travel_bytes(uint32_t cells) {
  if (!ARE_ALIKE || cells > QTR_MAX_CELLS) return sizeof(qtr_travel);
  return offsetof(qtr_travel, to_go) + (size_t)cells * (sizeof(qtr_steps) + sizeof(qtr_cell));
}

/* A cell n is entered from any neighbour at the same price, so its neighbours all learn the same travel time, to_go(n)
 * + cost(n), and the first to tell a cell tells it the least. Each cell therefore waits in the ring once, under that
 * time, and is never moved. */
static void wait_in_ring(qtr_travel *travel, const qtr_grid *grid, qtr_cell cell, qtr_steps to_go) {
  travel->to_go[cell] = to_go;
  ring_put(travel->ring, links_of(travel, qtr_grid_cells(grid)), cell, to_go + qtr_grid_cost(grid, cell));
}

/* North of the first row a number wraps around to one beyond the cells, and south of the last it is beyond them: these
 * ends need no case of their own. */
static void settle_neighbours(qtr_travel *travel, const qtr_grid *grid, qtr_cell cell, qtr_steps told) {
  const qtr_cell columns = grid->columns;
  const qtr_cell column = (qtr_cell)(cell % columns);
  const uint32_t cells = qtr_grid_cells(grid);
  const uint32_t next[4] = {(uint32_t)cell - columns, column + 1u < columns ? cell + 1u : cells,
                            (uint32_t)cell + columns, column > 0 ? cell - 1u : cells};
  for (int i = 0; i < 4; i++) {
    if (next[i] >= cells || travel->to_go[next[i]] != QTR_NEVER) continue;
    if (qtr_grid_cost(grid, (qtr_cell)next[i]) > 0) wait_in_ring(travel, grid, (qtr_cell)next[i], told);
  }
}

int qtr_travel_fill_built(qtr_travel *travel, const qtr_grid *grid, qtr_cell target, uint32_t config_id) {
  const uint32_t cells = qtr_grid_cells(grid);
  const qtr_cell *link = links_of(travel, cells);
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  if (cells > QTR_MAX_CELLS) return QTR_ERR_LIMIT;
  for (uint32_t cell = 0; cell < cells; cell++) travel->to_go[cell] = QTR_NEVER;
  ring_clear(travel->ring);
  if (qtr_grid_cost(grid, target) == 0) return QTR_ERR_ARGUMENT;
  wait_in_ring(travel, grid, target, 0);
  /* Times rise by at most 255 from cell to cell: a whole turn of empty entries means that all is settled. */
  unsigned empty = 0;
  for (qtr_steps now = 0; empty < QTR_TRAVEL_RING; now++) {
    qtr_cell cell = ring_take(travel->ring, now);
    empty = cell == QTR_NO_CELL ? empty + 1 : 0;
    while (cell != QTR_NO_CELL) {
      const qtr_cell after = link[cell];
      settle_neighbours(travel, grid, cell, now);
      cell = after;
    }
  }
  return QTR_OK;
}

/* Any neighbour that is nearer by its own cost is on a shortest way; of several the first in the order of directions,
 * so that all robots go the same. */
qtr_cell qtr_travel_next(const qtr_travel *travel, const qtr_grid *grid, qtr_cell cell) {
  const uint32_t cells = qtr_grid_cells(grid);
  if (cell >= cells || cells > QTR_MAX_CELLS) return QTR_NO_CELL;
  const qtr_steps to_go = travel->to_go[cell];
  if (to_go == QTR_NEVER) return QTR_NO_CELL;
  if (to_go == 0) return cell;
  for (int direction = QTR_NORTH; direction <= QTR_WEST; direction++) {
    const qtr_cell next = qtr_grid_neighbour(grid, cell, (enum qtr_direction)direction);
    if (next == QTR_NO_CELL || travel->to_go[next] == QTR_NEVER) continue;
    if (travel->to_go[next] + qtr_grid_cost(grid, next) == to_go) return next;
  }
  /* A cell in reach has a neighbour that is nearer by its cost, from which it was told its time. */
  QTR_ASSERT(false);
  return QTR_NO_CELL;
}
