/* What a key sees of a seeker on its way, and where its travel times are taken from.
 *
 * Exact: the steps that are left, and nothing of the map. With regions (seeking aggregation, paper, section 5.2.3): the
 * region of the cell where it is, and how much of its tour is done; its steps are those from the region's
 * representative, alike for all of the region. Its true cell moves on along its true way, unseen.
 */
#ifndef QUARTER_AGGREGATE_SIGHT_H
#define QUARTER_AGGREGATE_SIGHT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "aggregate/target.h"
#include "quarter/config.h"
#include "quarter/game.h"
#include "quarter/regions.h"

typedef struct {
  const qtr_game *game;
  const qtr_regions *regions; /* NULL: exact, and what follows is not used */
  bool estimating;            /* times are the representatives' */
  qtr_steps *estimate;        /* from a region's representative to each place: a row of places a region */
  uint8_t *way;               /* to each place, the direction from each cell, in two bits: a row of cells a place */
  uint32_t way_bytes;         /* of such a row */
} qtr_sight;

/* Where a seeker truly is that is seen in a region. */
typedef struct {
  qtr_cell cell;
  qtr_steps carried; /* steps spent on entering the next cell */
  uint8_t stage;     /* how many places of its tour it has passed */
} qtr_walk;

/* Exact sight, of the game's own times. */
void qtr_sight_exact(qtr_sight *sight, const qtr_game *game);

/* Bytes of the block that sight by so many regions takes. */
size_t qtr_sight_bytes(const qtr_game *game, uint32_t regions);

/* Sight by regions, which must outlive it, as must the block, aligned for qtr_steps; `times` is an enum
 * qtr_region_times, `travel` is scratch. QTR_OK, or QTR_ERR_STOPPED by the mission's watch: the sight is of no use
 * then. */
int qtr_sight_by_regions(qtr_sight *sight, void *block, const qtr_game *game, const qtr_regions *regions, uint8_t times,
                         qtr_travel *travel);

/* Whether seekers are seen exactly. Only then are travel times bounds, and each place of a spot counts when it is
 * visited rather than with the spot. */
static inline bool qtr_sight_is_exact(const qtr_sight *sight) {
  return sight->regions == NULL;
}

/* A walk begun, or ended, at a cell. */
static inline qtr_walk qtr_walk_at(qtr_cell cell) {
  return (qtr_walk){cell, 0, 0};
}

/* Go on along the true way of a tour for some steps. */
void qtr_sight_walk(const qtr_sight *sight, qtr_walk *walk, const qtr_tour *tour, qtr_steps steps);

/* Steps to the end of a tour as they are seen, when `exact` of them are left: with regions 1 at the least. */
qtr_steps qtr_sight_left(const qtr_sight *sight, const qtr_walk *walk, const qtr_tour *tour, qtr_steps exact);

/* With regions: the digit of a key that stands for a walk, instead of the steps that are left, and the greatest there
 * is. */
qtr_steps qtr_sight_digit(const qtr_sight *sight, const qtr_walk *walk, bool is_idle);
qtr_steps qtr_sight_last_digit(const qtr_sight *sight);

#endif
