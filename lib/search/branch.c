#include "search/branch.h"

#include <math.h>

#include "model/rounding.h"

bool qtr_branch_rules_out(const qtr_branch *branch, const qtr_label *route) {
  const bool has_a = qtr_label_has(route, branch->a);
  if (branch->of_squad) return has_a && (route->squad == branch->b) != branch->holds;
  return branch->holds ? has_a != qtr_label_has(route, branch->b) : has_a && qtr_label_has(route, branch->b);
}

static double share_of(const qtr_mixture *mixture, const qtr_branch *branch) {
  double sum = 0.0;
  for (uint32_t i = 0; i < mixture->count; i++) {
    const qtr_label *route = mixture->route[i];
    const bool other = branch->of_squad ? route->squad == branch->b : qtr_label_has(route, branch->b);
    if (qtr_label_has(route, branch->a) && other) sum += mixture->share[i];
  }
  return sum;
}

/* The nearer its share is to a half, the better. */
static void weigh(const qtr_mixture *mixture, const qtr_branch *branch, qtr_branch *best, double *nearest) {
  const double distance = fabs(share_of(mixture, branch) - 0.5);
  if (distance >= *nearest) return;
  *nearest = distance;
  *best = *branch;
}

/* Whose a place is divides nothing where all seekers are of one squad. */
bool qtr_branch_find(const qtr_mixture *mixture, unsigned places, unsigned squads, double least, qtr_branch *branch) {
  double nearest = 0.5 - least;
  for (unsigned a = 0; a < places; a++) {
    for (unsigned b = a + 1; b < places; b++)
      weigh(mixture, &(qtr_branch){(uint16_t)a, (uint16_t)b, false, true, false, 0.0}, branch, &nearest);
    for (unsigned squad = 0; squad < squads && squads > 1; squad++)
      weigh(mixture, &(qtr_branch){(uint16_t)a, (uint16_t)squad, true, true, false, 0.0}, branch, &nearest);
  }
  return nearest < 0.5 - least;
}
