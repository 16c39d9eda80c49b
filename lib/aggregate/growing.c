#include "aggregate/growing.h"

#include <string.h>

#define WINDOW_SHARE 2 /* times max_size: the cells that a region may choose from while it grows */

/* The last one takes its place: sums and counts go along with the list, index by index. */
static void unlist(const qtr_division *d, uint32_t index) {
  qtr_regions_scratch *s = d->scratch;
  qtr_nearby_unlist(d->nearby, index);
  s->sum[index] = s->sum[d->nearby->listed];
  s->touching[index] = s->touching[d->nearby->listed];
}

/* Make the cell a member. It and the cells that are too far from it leave the list of those that may still join: so any
 * listed cell is within the diameter of all members (complete linkage), and whichever joins, the limit is kept. */
static void join(const qtr_division *d, qtr_cell cell, qtr_region region) {
  qtr_nearby *nearby = d->nearby;
  qtr_cell next[4];
  d->regions->of[cell] = region;
  d->regions->size[region]++;
  unlist(d, nearby->slot[cell] - 1u);
  const int count = qtr_nearby_neighbours(nearby, cell, next);
  for (int i = 0; i < count; i++)
    if (nearby->slot[next[i]] != 0) d->scratch->touching[nearby->slot[next[i]] - 1]++;
  qtr_division_measure(d, cell);
  for (uint32_t i = nearby->listed; i-- > 0;) {
    if (nearby->away[i] == QTR_NEVER)
      unlist(d, i);
    else
      d->scratch->sum[i] += nearby->away[i];
  }
}

/* What a listed cell costs the region that takes it: near to the members is good, and so are few free neighbours that
 * are left over. A cell that would be left alone is taken at once.
 * 2 sum of d(cell, member) + open |region|: twice the mean distance and the open neighbours, both times the members. */
static uint64_t find_price(const qtr_division *d, uint32_t index, qtr_region region) {
  const int open = division_neighbours_in(d, d->nearby->list[index], QTR_NO_REGION);
  if (open == 0) return 0;
  return 2 * (uint64_t)d->scratch->sum[index] + (uint64_t)open * d->regions->size[region];
}

/* The best cell next to the growing region, the lowest of equals; QTR_NO_CELL if there is none. Only next to it: so the
 * region stays connected. */
static qtr_cell choose(const qtr_division *d, qtr_region region) {
  uint64_t least = UINT64_MAX;
  qtr_cell best = QTR_NO_CELL;
  for (uint32_t i = 0; i < d->nearby->listed; i++) {
    if (d->scratch->touching[i] == 0) continue;
    const uint64_t price = find_price(d, i, region);
    if (price > least || (price == least && d->nearby->list[i] > best)) continue;
    least = price;
    best = d->nearby->list[i];
  }
  return best;
}

/* One region, from its seed. It chooses among a window of the cells nearest to that, so the work for it has a bound. */
static void grow(const qtr_division *d, qtr_cell seed) {
  qtr_regions_scratch *s = d->scratch;
  const qtr_region region = (qtr_region)d->regions->count++;
  qtr_division_list(d, seed, QTR_NO_REGION, WINDOW_SHARE * d->config->max_size);
  memset(s->sum, 0, d->nearby->listed * sizeof *s->sum);
  memset(s->touching, 0, d->nearby->listed * sizeof *s->touching);
  d->regions->representative[region] = seed;
  d->regions->size[region] = 0;
  s->changed[region] = 1;
  qtr_cell cell = seed;
  while (cell != QTR_NO_CELL) {
    join(d, cell, region);
    cell = d->regions->size[region] < d->config->max_size ? choose(d, region) : QTR_NO_CELL;
  }
}

/* Let the free cells beside a region wait, each once: its error, not known yet, marks it. */
static uint32_t line_up(const qtr_division *d, qtr_region region, uint32_t waiting) {
  qtr_regions_scratch *s = d->scratch;
  qtr_cell next[4];
  qtr_division_list_whole(d, region);
  for (uint32_t i = 0; i < d->nearby->listed; i++) {
    const int count = qtr_nearby_neighbours(d->nearby, d->nearby->list[i], next);
    for (int k = 0; k < count; k++) {
      if (d->regions->of[next[k]] != QTR_NO_REGION || s->error[next[k]] != 0) continue;
      s->error[next[k]] = 1;
      s->waiting[waiting++] = next[k];
    }
  }
  return waiting;
}

/* The tightest corner of the ground left over near a cell, the furthest of several: a region that starts there leaves
 * fewer crumbs behind. */
static qtr_cell find_corner(const qtr_division *d, qtr_cell from) {
  qtr_cell best = from;
  int least = 4;
  qtr_division_list(d, from, QTR_NO_REGION, d->config->max_size);
  for (uint32_t i = 0; i < d->nearby->listed; i++) {
    const int open = division_neighbours_in(d, d->nearby->list[i], QTR_NO_REGION);
    if (open > least) continue;
    least = open;
    best = d->nearby->list[i];
  }
  return best;
}

/* Cover all ground that is joined to `start`, from the regions there are outwards. Each region takes a cell at least,
 * so it ends; and each cell waits once, so it takes time in proportion to the cells. */
static int cover(const qtr_division *d, qtr_cell start) {
  const qtr_cell *waiting = d->scratch->waiting;
  uint32_t lined_up = 0;
  uint32_t at = 0;
  qtr_cell from = start;
  for (;;) {
    if (d->regions->count == QTR_MAX_REGIONS) return QTR_ERR_LIMIT;
    if (!division_may_go_on(d)) return QTR_ERR_STOPPED;
    grow(d, find_corner(d, from));
    lined_up = line_up(d, (qtr_region)(d->regions->count - 1), lined_up);
    while (at < lined_up && d->regions->of[waiting[at]] != QTR_NO_REGION) at++;
    if (at == lined_up) return QTR_OK;
    from = waiting[at];
  }
}

/* A map may fall into parts: each is covered from its first cell on, and no region reaches into two. */
int qtr_division_grow(const qtr_division *d) {
  for (uint32_t cell = 0; cell < d->cells; cell++) {
    if (qtr_grid_cost(d->nearby->grid, (qtr_cell)cell) == 0 || d->regions->of[cell] != QTR_NO_REGION) continue;
    const int status = cover(d, (qtr_cell)cell);
    if (status != QTR_OK) return status;
  }
  return QTR_OK;
}
