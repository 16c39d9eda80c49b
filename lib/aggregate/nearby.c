#include "aggregate/nearby.h"

#include "core/block.h"
#include "model/ring.h"

static bool is_free(const qtr_grid *grid, uint32_t cell) {
  return cell < qtr_grid_cells(grid) && qtr_grid_cost(grid, (qtr_cell)cell) > 0;
}

/* Looked up once, because searches ask for it all the time. */
static uint8_t find_ways(const qtr_grid *grid, uint32_t cell) {
  const uint32_t columns = grid->columns;
  const uint32_t column = cell % columns;
  unsigned ways = 0;
  if (cell >= columns && is_free(grid, cell - columns)) ways |= QTR_WAY_NORTH;
  if (column + 1 < columns && is_free(grid, cell + 1)) ways |= QTR_WAY_EAST;
  if (is_free(grid, cell + columns)) ways |= QTR_WAY_SOUTH;
  if (column > 0 && is_free(grid, cell - 1)) ways |= QTR_WAY_WEST;
  return (uint8_t)ways;
}

size_t qtr_nearby_bytes(uint32_t cells) {
  return block_piece(cells * sizeof(qtr_steps)) + 2 * block_piece(cells * sizeof(qtr_cell)) +
         block_piece(cells * sizeof(uint16_t)) + block_piece(cells);
}

void qtr_nearby_init(qtr_nearby *nearby, void *block, const qtr_grid *grid) {
  const uint32_t cells = qtr_grid_cells(grid);
  uint8_t *left = block;
  nearby->time = block_cut(&left, cells * sizeof *nearby->time);
  nearby->link = block_cut(&left, cells * sizeof *nearby->link);
  nearby->reached = block_cut(&left, cells * sizeof *nearby->reached);
  nearby->slot = block_cut(&left, cells * sizeof *nearby->slot);
  nearby->ways = block_cut(&left, cells);
  nearby->grid = grid;
  nearby->work = 0;
  nearby->listed = 0;
  for (uint32_t cell = 0; cell < cells; cell++) {
    nearby->time[cell] = QTR_NEVER;
    nearby->ways[cell] = find_ways(grid, cell);
    nearby->slot[cell] = 0;
  }
  ring_clear(nearby->ring);
}

/* In one step, for the order of the list means nothing: the last one moves into the gap. */
void qtr_nearby_unlist(qtr_nearby *nearby, uint32_t index) {
  if (index >= nearby->listed) return;
  const uint32_t last = --nearby->listed;
  nearby->slot[nearby->list[index]] = 0;
  if (index == last) return;
  nearby->list[index] = nearby->list[last];
  nearby->away[index] = nearby->away[last];
  nearby->slot[nearby->list[index]] = (uint16_t)(index + 1);
}

/* Slots of listed cells alone, which are few: clearing the map's would cost all of it for each region. */
void qtr_nearby_clear(qtr_nearby *nearby) {
  for (uint32_t i = 0; i < nearby->listed; i++) nearby->slot[nearby->list[i]] = 0;
  nearby->listed = 0;
}

/* ---- the search of quarter/travel.h, which ends when all listed cells are found or the rest are too far ---- */

/* When a cell that was reached comes up: as the search goes backwards, its cost is paid on the way out of it. */
static qtr_steps time_up(const qtr_nearby *nearby, qtr_cell cell) {
  return nearby->time[cell] + qtr_grid_cost(nearby->grid, cell);
}

/* Whether the cell is a listed one. A shortest way back enters the same cells but for the one at its end, so the times
 * there and back differ by what the two ends cost. */
static bool reach(qtr_nearby *nearby, qtr_cell cell, qtr_steps time, qtr_cell from, uint32_t nth) {
  nearby->time[cell] = time;
  ring_put(nearby->ring, nearby->link, cell, time_up(nearby, cell));
  nearby->reached[nth] = cell;
  if (nearby->slot[cell] == 0) return false;
  const unsigned cost = qtr_grid_cost(nearby->grid, cell);
  const unsigned cost_from = qtr_grid_cost(nearby->grid, from);
  nearby->away[nearby->slot[cell] - 1] = time + (cost > cost_from ? cost - cost_from : 0);
  return true;
}

/* Reach what lies next to the cells that come up `now`, from `cell` on; `reached` counts all so far. The number of
 * listed ones. */
static uint32_t pass(qtr_nearby *nearby, qtr_cell cell, qtr_steps now, qtr_cell from, uint32_t *reached) {
  uint32_t found = 0;
  qtr_cell next[4];
  while (cell != QTR_NO_CELL) {
    const qtr_cell after = nearby->link[cell];
    const int count = qtr_nearby_neighbours(nearby, cell, next);
    for (int i = 0; i < count; i++)
      if (nearby->time[next[i]] == QTR_NEVER && reach(nearby, next[i], now, from, (*reached)++)) found++;
    cell = after;
  }
  return found;
}

/* Undo what the search wrote, which costs no more than the search did: clearing all cells would make a division into
 * regions quadratic. */
static void forget(qtr_nearby *nearby, uint32_t reached) {
  for (uint32_t i = 0; i < reached; i++) {
    ring_take(nearby->ring, time_up(nearby, nearby->reached[i]));
    nearby->time[nearby->reached[i]] = QTR_NEVER;
  }
  nearby->work += reached;
}

/* Dijkstra's search with a ring for a queue (core/ring.h), backwards from `from`: time[c] is the way from c to there.
 * It is over when no entry of the ring has held a cell for a whole round. */
static void search(qtr_nearby *nearby, qtr_cell from, qtr_steps limit) {
  uint32_t reached = 1;
  unsigned empty = 0;
  /* The search before this one has been undone: or cells would be taken for reached. */
  QTR_ASSERT(nearby->time[from] == QTR_NEVER);
  uint32_t found = reach(nearby, from, 0, from, 0) ? 1 : 0;
  for (qtr_steps now = 0; now <= limit && found < nearby->listed && empty < QTR_TRAVEL_RING; now++) {
    const qtr_cell first = ring_take(nearby->ring, now);
    empty = first == QTR_NO_CELL ? empty + 1 : 0;
    found += pass(nearby, first, now, from, &reached);
  }
  forget(nearby, reached);
}

/* The search goes by the way from a cell to `from`; where the way back is the longer one, that is held against the
 * limit when the search is over. */
bool qtr_nearby_measure(qtr_nearby *nearby, qtr_cell from, qtr_steps limit) {
  for (uint32_t i = 0; i < nearby->listed; i++) nearby->away[i] = QTR_NEVER;
  if (is_free(nearby->grid, from)) search(nearby, from, limit);
  bool near = true;
  for (uint32_t i = 0; i < nearby->listed; i++) {
    if (nearby->away[i] > limit) nearby->away[i] = QTR_NEVER;
    near = near && nearby->away[i] != QTR_NEVER;
  }
  return near;
}
