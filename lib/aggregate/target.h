/* What seekers choose: targets. Without aggregation a target is a place; with hiding aggregation (paper, section 5.2.4)
 * it is a spot, whose places are visited one after the other, without a break.
 *
 * What follows the first place of a spot does not depend on where the seeker came from, so a tour is known by its first
 * place: as many tours as places, and the state of a seeker on its way is (first place, steps left).
 */
#ifndef QUARTER_AGGREGATE_TARGET_H
#define QUARTER_AGGREGATE_TARGET_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/game.h"
#include "quarter/spots.h"

/* What a seeker does that has come to a place: the rest of the target's tour. */
typedef struct {
  uint16_t target;
  uint8_t places;                    /* this one included; 0: no tour begins here */
  uint16_t place[QTR_MAX_SPOT_SIZE]; /* in the order of the visits; the last one is the exit */
  qtr_steps step[QTR_MAX_SPOT_SIZE]; /* of each visit, from the first on */
} qtr_tour;

/* Large: keep it in static storage. */
typedef struct {
  const qtr_game *game;
  uint16_t count;
  qtr_tour tour[QTR_MAX_PLACES];                  /* by the first place visited */
  uint16_t first[QTR_MAX_NODES * QTR_MAX_PLACES]; /* of the target's places, from a node: a row of targets a node */
  qtr_spots spots;
  qtr_spots spots_scratch;
  qtr_spot_scratch tour_scratch;
} qtr_targets;

/* Every place a target of its own. */
void qtr_targets_places(qtr_targets *targets, const qtr_game *game);

/* Spots as targets; `order` is an enum qtr_spot_order. QTR_OK, an error of qtr_spots_build(), or QTR_ERR_STOPPED by the
 * mission's watch: the targets are of no use then. */
int qtr_targets_spots(qtr_targets *targets, const qtr_game *game, const qtr_spots_config *config, uint8_t order);

/* The innermost of the learner's loops call the functions below: nodes, places and targets, which must be the game's,
 * are not checked. */

/* The first place of a target's tour from a node; QTR_STAND_DOWN if there is no way. */
static inline uint16_t qtr_targets_first(const qtr_targets *targets, unsigned node, unsigned target) {
  return targets->first[(size_t)node * targets->count + target];
}

/* The tour that begins at a place. */
static inline const qtr_tour *qtr_targets_tour(const qtr_targets *targets, unsigned place) {
  return &targets->tour[place];
}

/* The target that a place belongs to. */
static inline uint16_t qtr_targets_of(const qtr_targets *targets, unsigned place) {
  return targets->spots.spot_of[place];
}

/* How many places a target has, and which: `i` from 0, in ascending order. */
static inline unsigned qtr_targets_size(const qtr_targets *targets, unsigned target) {
  return targets->spots.size[target];
}
static inline uint16_t qtr_targets_place(const qtr_targets *targets, unsigned target, unsigned i) {
  return targets->spots.place[target][i];
}

/* Likelihood of all of a target's places. */
double qtr_targets_probability(const qtr_targets *targets, unsigned target);

/* Steps that a seeker takes from a node to the end of a target's tour; QTR_NEVER if there is no way. */
qtr_steps qtr_targets_duration(const qtr_targets *targets, unsigned seeker, unsigned node, unsigned target);

/* Steps from a tour's first visit to its last, and the place of that. */
static inline qtr_steps qtr_tour_length(const qtr_tour *tour) {
  return tour->step[tour->places - 1];
}
static inline uint16_t qtr_tour_exit(const qtr_tour *tour) {
  return tour->place[tour->places - 1];
}

#endif
