/* Steps towards the least value of a convex function, from what it has been so far: a level bundle method (Lemarechal,
 * Nemirovskii, Nesterov: New variants of bundle methods, 1995).
 *
 * Each point that was looked at gives a cut: nowhere is the function less than its value there + slope . (x - point).
 * The next point is the one nearest to the best so far, the center, at which no cut is above a level. With a single cut
 * that is Polyak's step; more of them keep it from going to and fro, as it does where several seekers are alike and
 * walk the same way under any prices.
 */
#ifndef QUARTER_SEARCH_BUNDLE_H
#define QUARTER_SEARCH_BUNDLE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

typedef struct {
  uint16_t size; /* coordinates */
  uint8_t cuts;
  double value[QTR_MAX_CUTS];             /* of each cut at the center */
  double weight[QTR_MAX_CUTS];            /* how much it held the last step back: 0 or more */
  float gram[QTR_MAX_CUTS][QTR_MAX_CUTS]; /* slope . slope */
  int16_t slope[QTR_MAX_CUTS][QTR_MAX_PLACES];
} qtr_bundle;

/* No cuts, of a function of `size` coordinates. */
void qtr_bundle_init(qtr_bundle *bundle, unsigned size);

/* Add a cut, known by its value at the center and its slope. One that says little makes room for it. */
void qtr_bundle_add(qtr_bundle *bundle, double value, const int16_t *slope);

/* The center moves by a step, one number a coordinate. */
void qtr_bundle_move(qtr_bundle *bundle, const double *step);

/* The shortest step, one number a coordinate, from the center to where no cut is above `level` by more than `slack`.
 * False: as far as was looked there is no such point, and the step is of no use. */
bool qtr_bundle_step(qtr_bundle *bundle, double level, double slack, double *step);

#endif
