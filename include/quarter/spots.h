/* Hiding aggregation (paper, section 5.2.4): close places grouped into spots, and the tour inside a spot.
 *
 * A spot is one target: the seeker that chooses it visits all of its places without a break. Fewer targets are fewer
 * states, at the price of the plays that would have left a spot half done.
 */
#ifndef QUARTER_SPOTS_H
#define QUARTER_SPOTS_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/objective.h"

QTR_C_BEGIN

/* What spots are made and toured on: a view, which owns nothing. Nodes are numbered as on the board: places first. */
typedef struct {
  uint16_t places;           /* 1..QTR_MAX_PLACES */
  const uint8_t *steps;      /* travel times as the board's: 4 bytes little-endian each, a row of `places` for every
                                node, QTR_NEVER for no way. Spots look at the places' rows alone */
  const double *probability; /* of each place, above 0, in any unit */
  const qtr_objective *objective; /* of tours */
} qtr_spot_ground;

/* ---- which places form a spot ---- */

/* The distance of two places is the travel time from one to the other, the greater one where the two ways differ.
 *
 * `likelihood` stretches it where the places are not alike: times 1 + likelihood * (P_max / P_min - 1). Going for the
 * lesser place first makes the likelier one wait d steps; d * P_max / P_min is that wait for each unit of likelihood
 * which it brings, and so what a weight of 1 holds against the diameter. 0: distance alone, as in the paper. Stretching
 * only ever splits, so the limits below are kept in true steps whatever the weight. */
typedef struct {
  uint32_t made;      /* by qtr_spots_default() */
  uint8_t size;       /* places of a spot at most, 1..QTR_MAX_SPOT_SIZE; 1: every place is a spot */
  qtr_steps diameter; /* greatest distance of any two places of a spot, 1..QTR_NEVER - 1 steps */
  double likelihood;  /* 0 or more, finite; places as likely as one another are never held apart by it */
} qtr_spots_config;

/* 5 places, 25 steps; distance alone. */
void qtr_spots_default(qtr_spots_config *config);

/* QTR_OK; QTR_ERR_ARGUMENT for a config that is not from its default, or a size, diameter or likelihood out of its
 * range; QTR_ERR_LIMIT for a size past the build's. */
int qtr_spots_check(const qtr_spots_config *config);

/* Every place is in exactly one spot. Spots are numbered by their lowest place, and list their places in order. */
typedef struct {
  uint16_t count;
  uint16_t spot_of[QTR_MAX_PLACES];
  uint8_t size[QTR_MAX_PLACES]; /* of each spot */
  uint16_t place[QTR_MAX_PLACES][QTR_MAX_SPOT_SIZE];
} qtr_spots;

/* Group the places: few spots first of all, then little summed distance inside them. Spots grow by complete linkage
 * (the two are joined whose farthest places are nearest), then places move from spot to spot as long as that empties a
 * spot or brings places closer. The same input gives the same spots on every machine. `probability` may be NULL if
 * `likelihood` is 0. `scratch` is overwritten. QTR_OK; what qtr_spots_check() says of the config; QTR_ERR_ARGUMENT
 * for no places, QTR_ERR_LIMIT for a number of them past the build's, QTR_ERR_WEIGHT for a probability not above 0,
 * QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_spots_build(spots, ground, config, scratch)                                                                \
  qtr_spots_build_sized(spots, ground, config, scratch, QTR_CONFIG_ID)
int qtr_spots_build_sized(qtr_spots *spots, const qtr_spot_ground *ground, const qtr_spots_config *config,
                          qtr_spots *scratch, uint32_t config_id);

/* ---- in which order a spot's places are visited ---- */

enum qtr_spot_order {
  QTR_SPOT_BEST = 0,   /* the order that earns most */
  QTR_SPOT_NEAREST = 1 /* always the nearest place next (paper) */
};

#define QTR_SPOT_ANY_EXIT (-1)

/* The visits of a spot, or of those of its places that are left, by a seeker that comes from a node. */
typedef struct {
  uint8_t places;
  uint16_t place[QTR_MAX_SPOT_SIZE]; /* in the order of the visits; the last one is the exit */
  qtr_steps step[QTR_MAX_SPOT_SIZE]; /* of each visit, from leaving the node; the last one is when the tour ends */
  double worth;                      /* sum of P gamma^step, or under expected time minus the sum of P step */
} qtr_spot_tour;

typedef struct {
  double worth[1 << QTR_MAX_SPOT_SIZE][QTR_MAX_SPOT_SIZE];
  qtr_steps left[1 << QTR_MAX_SPOT_SIZE][QTR_MAX_SPOT_SIZE];
} qtr_spot_scratch;

/* Visit the `count` places of `place` (1..QTR_MAX_SPOT_SIZE, all different) from `node`, the nearest first, the lowest
 * place among equally near ones. False if some place cannot be reached that way, or a place, or how many they are, is
 * out of range; the tour is undefined then. The node must be one of the ground's. */
bool qtr_spot_tour_nearest(qtr_spot_tour *tour, const qtr_spot_ground *ground, unsigned node, const uint16_t *place,
                           unsigned count);

/* The best of all orders, exactly, by dynamic programming over the subsets (Bellman; Held and Karp 1962). The order
 * that is best does not depend on the step at which the seeker sets out.
 *
 * What follows the spot matters too, in two ways that the caller settles. `exit` fixes the place where the tour ends,
 * as an index into `place`; QTR_SPOT_ANY_EXIT leaves it open. `rest`, 0 or more, is the likelihood that waits until the
 * spot is done: the tour maximises the worth of its visits plus rest * gamma^finish (expected time: minus rest *
 * finish). With 0 the spot is seen by itself. Among orders of equal worth, to within rounding, the one that finishes
 * first is taken.
 *
 * False if there is no such tour, or an argument is out of range as above; it is undefined then. */
bool qtr_spot_tour_best(qtr_spot_tour *tour, const qtr_spot_ground *ground, unsigned node, const uint16_t *place,
                        unsigned count, int exit, double rest, qtr_spot_scratch *scratch);

QTR_C_END

#endif
