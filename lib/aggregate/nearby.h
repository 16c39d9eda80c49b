/* Distances between cells that lie near one another, by searches that go no further than they must.
 *
 * How far apart two cells are is the travel time between them on the map, by the shortest way there is. With terrain
 * the two directions differ, and the longer one counts.
 */
#ifndef QUARTER_AGGREGATE_NEARBY_H
#define QUARTER_AGGREGATE_NEARBY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/grid.h"

/* The most cells looked at together: a region and all that border on it. */
#define QTR_NEARBY_MOST (3 * QTR_MAX_REGION_SIZE + 2)

enum { QTR_WAY_NORTH = 1, QTR_WAY_EAST = 2, QTR_WAY_SOUTH = 4, QTR_WAY_WEST = 8 };

typedef struct {
  const qtr_grid *grid;
  uint64_t work; /* cells that all searches came to since the start: what they cost */
  /* by cell */
  qtr_steps *time;   /* of the search under way: from the cell to its start; QTR_NEVER between searches */
  qtr_cell *link;    /* cells waiting in the same ring entry */
  qtr_cell *reached; /* by the search under way, in its order */
  uint16_t *slot;    /* 1 + the cell's index in the list; 0: not listed */
  uint8_t *ways;     /* bits QTR_WAY_...: which neighbours are free */
  qtr_cell ring[QTR_TRAVEL_RING];
  uint32_t listed;
  qtr_cell list[QTR_NEARBY_MOST];  /* the cells that a search is about */
  qtr_steps away[QTR_NEARBY_MOST]; /* their distances from the last search's start; QTR_NEVER: beyond its limit */
} qtr_nearby;

/* Bytes of the block that searches of a grid of so many cells take. */
size_t qtr_nearby_bytes(uint32_t cells);

/* An empty list. Grid and block, which is aligned as for a uint64_t, must outlive the structure. */
void qtr_nearby_init(qtr_nearby *nearby, void *block, const qtr_grid *grid);

/* List a cell that is not listed yet; nothing happens to one that is, or lies outside, or is one more than
 * QTR_NEARBY_MOST. */
static inline void qtr_nearby_list(qtr_nearby *nearby, qtr_cell cell) {
  if (cell >= qtr_grid_cells(nearby->grid) || nearby->slot[cell] != 0 || nearby->listed == QTR_NEARBY_MOST) return;
  nearby->list[nearby->listed++] = cell;
  nearby->slot[cell] = (uint16_t)nearby->listed;
}

/* Take a cell off the list, by its index; the last one takes its place. Nothing happens for an index beyond the
 * list. */
void qtr_nearby_unlist(qtr_nearby *nearby, uint32_t index);

void qtr_nearby_clear(qtr_nearby *nearby);

/* The distance of each listed cell from `from`, a free cell. True if none is beyond `limit`, 0..65535. From a blocked
 * cell or one outside all are. */
bool qtr_nearby_measure(qtr_nearby *nearby, qtr_cell from, qtr_steps limit);

/* The free cells next to a free cell: their number, in the order N, E, S, W. 0 for a cell outside. */
static inline int qtr_nearby_neighbours(const qtr_nearby *nearby, qtr_cell cell, qtr_cell next[4]) {
  const unsigned ways = cell < qtr_grid_cells(nearby->grid) ? nearby->ways[cell] : 0;
  const uint32_t columns = nearby->grid->columns;
  int count = 0;
  if (ways & QTR_WAY_NORTH) next[count++] = (qtr_cell)(cell - columns);
  if (ways & QTR_WAY_EAST) next[count++] = (qtr_cell)(cell + 1u);
  if (ways & QTR_WAY_SOUTH) next[count++] = (qtr_cell)(cell + columns);
  if (ways & QTR_WAY_WEST) next[count++] = (qtr_cell)(cell - 1u);
  return count;
}

#endif
