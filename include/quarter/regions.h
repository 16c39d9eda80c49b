/* Topological aggregation (paper, section 5.2.2): the free cells of a grid divided into regions, each of which is one
 * position to the learner.
 *
 * A region is connected, has at most max_size cells, and no two of its cells are further apart than `diameter`, as
 * lib/aggregate/nearby.h measures it: by the shortest way on the map, which may leave the region, and in the direction
 * that takes longer. Every free cell is in exactly one region.
 *
 * A region's representative is its geometric median: the member with the least sum of distances to the members, the
 * lowest such cell. A travel time taken from the representative is wrong by no more than the cell's distance from it.
 */
#ifndef QUARTER_REGIONS_H
#define QUARTER_REGIONS_H

#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/grid.h"
#include "quarter/status.h"
#include "quarter/watch.h"

QTR_C_BEGIN

/* `likelihood` stretches the distance of two places that are not alike, as it does between the places of a spot: times
 * 1 + likelihood * (P_max / P_min - 1). Two that are then further apart than the diameter are in different regions, so
 * that a likely place is not taken for where an unlikely one lies. Stretching only ever keeps apart: limits, distances
 * and representatives stay in true steps. */
typedef struct {
  uint32_t made;     /* by qtr_regions_default() */
  uint32_t max_size; /* cells of a region, 1..QTR_MAX_REGION_SIZE; with 1 every free cell is a region */
  uint32_t diameter; /* steps between two of its cells, 1..QTR_MAX_REGION_DIAMETER */
  double likelihood; /* 0 or more, finite; 0: by the map alone, as in the paper, and what follows is not looked at */
  uint16_t places;   /* 0..QTR_MAX_PLACES */
  const qtr_cell *place; /* their cells */
  const double *weight;  /* their likelihoods, above 0, in any unit */
  qtr_watch watch;       /* ends the division early; none by default */
} qtr_regions_config;

/* Large: keep it in static storage. Regions are numbered by their lowest cells. */
typedef struct {
  uint32_t count;
  uint32_t cells;                           /* of the grid */
  qtr_region of[QTR_MAX_CELLS];             /* QTR_NO_REGION on blocked cells */
  qtr_cell representative[QTR_MAX_REGIONS]; /* by region */
  uint16_t size[QTR_MAX_REGIONS];           /* cells, by region */
} qtr_regions;

/* The limits of the paper's example (Fig. 5.3): 25 cells, 15 steps; no places. */
void qtr_regions_default(qtr_regions_config *config);

/* QTR_OK; QTR_ERR_ARGUMENT for a config that is not from its default, a limit of 0, or a likelihood out of its range;
 * QTR_ERR_LIMIT for limits or places beyond what the build holds. */
int qtr_regions_check(const qtr_regions_config *config);

/* Bytes of scratch that dividing a grid of so many cells takes. */
size_t qtr_regions_scratch_bytes(uint32_t cells);

/* At most, for a block in static storage. */
#define QTR_REGIONS_SCRATCH_BYTES                                                                                      \
  ((size_t)QTR_MAX_CELLS * (sizeof(qtr_steps) + 3 * sizeof(qtr_cell) + 6) + QTR_MAX_REGION_SIZE * 64 + 2048)

/* Divide the free cells of a grid, in `bytes` of scratch, aligned as for a uint64_t. Regions are grown greedily; then
 * borders are straightened, and the cells of leftovers given to their neighbours. Work and time are linear in the
 * cells. The same input gives the same regions. What qtr_regions_check() says of the config; QTR_ERR_ARGUMENT: a side
 * of the grid is 0, or the scratch is not aligned; QTR_ERR_SPACE: it is smaller than qtr_regions_scratch_bytes();
 * QTR_ERR_LIMIT: the grid is beyond what the build holds, or more than QTR_MAX_REGIONS regions were grown;
 * QTR_ERR_PLACE, QTR_ERR_WEIGHT: a place lies outside the grid, a likelihood is not above 0; QTR_ERR_CONFIG: the caller
 * was built under other sizes; QTR_ERR_STOPPED by the watch. The regions are then of no use. */
#define qtr_regions_build(regions, grid, config, scratch, bytes)                                                       \
  qtr_regions_build_built(regions, grid, config, scratch, bytes, QTR_CONFIG_ID)
int qtr_regions_build_built(qtr_regions *regions, const qtr_grid *grid, const qtr_regions_config *config, void *scratch,
                            size_t bytes, uint32_t config_id);

/* Steps to each free cell from its region's representative, as the division left them in its scratch: by so much at
 * most a travel time taken from there is wrong. */
const uint16_t *qtr_regions_errors(const void *scratch);

/* The region of a cell; QTR_NO_REGION if it is blocked or outside the grid. */
static inline qtr_region qtr_regions_of(const qtr_regions *regions, qtr_cell cell) {
  return cell < regions->cells ? regions->of[cell] : QTR_NO_REGION;
}

/* Where the travel times of a seeker seen in a region are taken from. */
enum qtr_region_times {
  QTR_TIMES_STANDING = 0, /* the region's representative: alike for all of the region (section 5.2.3) */
  QTR_TIMES_TRUE =
      1 /* the seeker's own cell: the section's first solution, whose Q may go to and fro. To show just that */
};

/* The cell that stands for a free cell: where its travel times are taken from (section 5.2.3). QTR_NO_CELL for
 * others. */
static inline qtr_cell qtr_regions_standing(const qtr_regions *regions, qtr_cell cell) {
  const qtr_region region = qtr_regions_of(regions, cell);
  return region < regions->count ? regions->representative[region] : QTR_NO_CELL;
}

QTR_C_END

#endif
