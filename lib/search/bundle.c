#include "search/bundle.h"

#include <math.h>
#include <string.h>

#include "model/rounding.h"

#define SWEEPS 60u /* over the weights: what they have not found by then is as good as not there */

void qtr_bundle_init(qtr_bundle *bundle, unsigned size) {
  bundle->cuts = 0;
  bundle->size = (uint16_t)size;
}

static float dot(const qtr_bundle *bundle, unsigned i, unsigned j) {
  double sum = 0.0;
  for (unsigned k = 0; k < bundle->size; k++) sum += (double)bundle->slope[i][k] * (double)bundle->slope[j][k];
  return (float)sum;
}

/* As many as hold a least value in place, and no more in a larger build. */
static unsigned most_cuts(const qtr_bundle *bundle) {
  return bundle->size < QTR_MAX_CUTS ? bundle->size + 1u : QTR_MAX_CUTS;
}

static bool says_less(const qtr_bundle *bundle, unsigned i, unsigned j) {
  if (bundle->weight[i] != bundle->weight[j]) return bundle->weight[i] < bundle->weight[j];
  return bundle->value[i] < bundle->value[j];
}

/* A new one as long as there is room; then that of the cut which held the last step back least. */
static unsigned room_for_cut(qtr_bundle *bundle) {
  unsigned least = 0;
  if (bundle->cuts < most_cuts(bundle)) return bundle->cuts++;
  for (unsigned i = 1; i < bundle->cuts; i++)
    if (says_less(bundle, i, least)) least = i;
  return least;
}

void qtr_bundle_add(qtr_bundle *bundle, double value, const int16_t *slope) {
  const unsigned i = room_for_cut(bundle);
  bundle->value[i] = value;
  bundle->weight[i] = 0.0;
  memcpy(bundle->slope[i], slope, bundle->size * sizeof slope[0]);
  for (unsigned j = 0; j < bundle->cuts; j++) bundle->gram[i][j] = bundle->gram[j][i] = dot(bundle, i, j);
}

void qtr_bundle_move(qtr_bundle *bundle, const double *step) {
  for (unsigned i = 0; i < bundle->cuts; i++)
    for (unsigned k = 0; k < bundle->size; k++) bundle->value[i] += (double)bundle->slope[i][k] * step[k];
}

/* How far each cut is above the level after the step that the weights stand for, -sum of w_j slope_j. */
static void measure_excess(const qtr_bundle *bundle, double level, double *excess) {
  for (unsigned i = 0; i < bundle->cuts; i++) {
    excess[i] = bundle->value[i] - level;
    for (unsigned j = 0; j < bundle->cuts; j++) excess[i] -= bundle->weight[j] * (double)bundle->gram[i][j];
  }
}

/* The nearest point is that of the weights, 0 or more, which minimise |sum of w slope|^2 / 2 - sum of w (value -
 * level). Each in turn takes its best value for what the others are. Returns by how much that changed a cut's own
 * excess. */
static double sweep(qtr_bundle *bundle, double *excess) {
  double most = 0.0;
  for (unsigned i = 0; i < bundle->cuts; i++) {
    const double square = (double)bundle->gram[i][i];
    if (square == 0.0) continue;
    double change = excess[i] / square;
    if (bundle->weight[i] + change < 0.0) change = -bundle->weight[i];
    if (change == 0.0) continue;
    bundle->weight[i] += change;
    for (unsigned j = 0; j < bundle->cuts; j++) excess[j] -= change * (double)bundle->gram[i][j];
    if (fabs(change) * square > most) most = fabs(change) * square;
  }
  return most;
}

static bool are_below(const qtr_bundle *bundle, const double *excess, double slack) {
  for (unsigned i = 0; i < bundle->cuts; i++)
    if (excess[i] > slack) return false;
  return true;
}

bool qtr_bundle_step(qtr_bundle *bundle, double level, double slack, double *step) {
  double excess[QTR_MAX_CUTS];
  measure_excess(bundle, level, excess);
  for (unsigned n = 0; n < SWEEPS && sweep(bundle, excess) > slack / 5.0; n++) {}
  for (unsigned k = 0; k < bundle->size; k++) step[k] = 0.0;
  for (unsigned i = 0; i < bundle->cuts; i++)
    for (unsigned k = 0; k < bundle->size; k++) step[k] -= bundle->weight[i] * (double)bundle->slope[i][k];
  return are_below(bundle, excess, slack);
}
