/* Cells that wait for their time, in a ring of buckets (Dial 1969): as no cell costs more than 255 steps, a bucket a
 * step and one for now are enough, and whoever goes round the ring meets the cells in the order of their times. */
#ifndef QUARTER_RING_H
#define QUARTER_RING_H

#include "quarter/config.h"
#include "quarter/grid.h"

/* `link` holds the next cell of the same bucket, for every cell. */
static inline void ring_put(qtr_cell ring[QTR_TRAVEL_RING], qtr_cell *link, qtr_cell cell, qtr_steps when) {
  link[cell] = ring[when % QTR_TRAVEL_RING];
  ring[when % QTR_TRAVEL_RING] = cell;
}

/* The first of those whose time is now, the others by their links; QTR_NO_CELL: none. The bucket is empty then. */
static inline qtr_cell ring_take(qtr_cell ring[QTR_TRAVEL_RING], qtr_steps now) {
  const qtr_cell first = ring[now % QTR_TRAVEL_RING];
  ring[now % QTR_TRAVEL_RING] = QTR_NO_CELL;
  return first;
}

static inline void ring_clear(qtr_cell ring[QTR_TRAVEL_RING]) {
  for (int i = 0; i < QTR_TRAVEL_RING; i++) ring[i] = QTR_NO_CELL;
}

#endif
