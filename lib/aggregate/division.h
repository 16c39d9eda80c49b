/* A division of the ground into regions under way: the room that its steps share. `growing` makes a first division,
 * `settling` betters it. */
#ifndef QUARTER_AGGREGATE_DIVISION_H
#define QUARTER_AGGREGATE_DIVISION_H

#include "aggregate/nearby.h"
#include "quarter/regions.h"

/* What stands at the start of the caller's scratch. */
typedef struct {
  qtr_nearby nearby; /* nearby.work: what the division cost */
  /* by cell, or by region of those grown so far, which are no more */
  qtr_cell *waiting;                 /* free cells beside the regions grown so far */
  uint16_t *error;                   /* distance from the representative, afterwards too */
  uint8_t *changed;                  /* since its representative was found */
  uint32_t sum[QTR_NEARBY_MOST];     /* of the listed cells: distances from a region's members */
  uint8_t touching[QTR_NEARBY_MOST]; /* of the listed cells: neighbours in a growing region */
  uint32_t chosen_count;
  qtr_cell chosen[QTR_NEARBY_MOST];       /* cells that may change their region */
  qtr_steps chosen_away[QTR_NEARBY_MOST]; /* and their distances from the representative there */
} qtr_regions_scratch;

typedef struct {
  qtr_regions *regions;
  const qtr_regions_config *config;
  qtr_regions_scratch *scratch;
  qtr_nearby *nearby; /* the scratch's */
  uint32_t cells;
} qtr_division;

static inline bool division_may_go_on(const qtr_division *d) {
  return qtr_watch_go_on(&d->config->watch);
}

/* How many of a cell's neighbours are in a region. */
static inline int division_neighbours_in(const qtr_division *d, qtr_cell cell, qtr_region region) {
  qtr_cell next[4];
  const int count = qtr_nearby_neighbours(d->nearby, cell, next);
  int in = 0;
  for (int i = 0; i < count; i++) in += d->regions->of[next[i]] == region;
  return in;
}

/* List the cells of a region that are joined to `from` within it, nearest first, at most `most`; or those of a whole
 * region. */
void qtr_division_list(const qtr_division *d, qtr_cell from, qtr_region region, uint32_t most);
void qtr_division_list_whole(const qtr_division *d, qtr_region region);

/* The distances of the listed cells from `from`; true if none may not be of its region. */
bool qtr_division_measure(const qtr_division *d, qtr_cell from);

/* Make a region's true median its representative; and bring the representatives of all regions that have changed near
 * to theirs. */
void qtr_division_find_median(const qtr_division *d, qtr_region region);
void qtr_division_follow_medians(const qtr_division *d);

#endif
