#include "aggregate/division.h"

#include <string.h>

#include "model/rounding.h"
#include "quarter/status.h"

/* Breadth first, with the list for a queue. A region is connected if and only if all of it is listed from one of its
 * cells. */
void qtr_division_list(const qtr_division *d, qtr_cell from, qtr_region region, uint32_t most) {
  qtr_nearby *nearby = d->nearby;
  qtr_cell next[4];
  qtr_nearby_clear(nearby);
  qtr_nearby_list(nearby, from);
  for (uint32_t i = 0; i < nearby->listed; i++) {
    const int count = qtr_nearby_neighbours(nearby, nearby->list[i], next);
    for (int k = 0; k < count && nearby->listed < most; k++)
      if (d->regions->of[next[k]] == region) qtr_nearby_list(nearby, next[k]);
  }
}

void qtr_division_list_whole(const qtr_division *d, qtr_region region) {
  qtr_division_list(d, d->regions->representative[region], region, d->regions->size[region]);
}

/* ---- distances ---- */

/* Whether the map lets two places be of one region and their likelihoods do not:
 * d (1 + W (P_max / P_min - 1)) > Dia, as between the places of a spot. */
static bool are_unlike(const qtr_regions_config *config, unsigned p, unsigned q, qtr_steps away) {
  const double a = config->weight[p];
  const double b = config->weight[q];
  return away * (1.0 + config->likelihood * ((a > b ? a / b : b / a) - 1.0)) > config->diameter;
}

/* Let the listed places that are unlike this one be too far from it; true if there are none. */
static bool keep_apart(const qtr_division *d, unsigned place) {
  qtr_nearby *nearby = d->nearby;
  bool alike = true;
  for (unsigned q = 0; q < d->config->places; q++) {
    const unsigned slot = nearby->slot[d->config->place[q]];
    if (slot == 0 || nearby->away[slot - 1] == QTR_NEVER) continue;
    if (!are_unlike(d->config, place, q, nearby->away[slot - 1])) continue;
    nearby->away[slot - 1] = QTR_NEVER;
    alike = false;
  }
  return alike;
}

bool qtr_division_measure(const qtr_division *d, qtr_cell from) {
  bool near = qtr_nearby_measure(d->nearby, from, d->config->diameter);
  if (!(d->config->likelihood > 0.0)) return near;
  for (unsigned p = 0; p < d->config->places; p++)
    if (d->config->place[p] == from && !keep_apart(d, p)) near = false;
  return near;
}

/* ---- representatives ---- */

/* The sum of a listed region's distances from a member: the geometric median is the member with the least (section
 * 5.2.2). */
static uint32_t sum_from(const qtr_division *d, qtr_cell member) {
  uint32_t sum = 0;
  qtr_division_measure(d, member);
  for (uint32_t i = 0; i < d->nearby->listed; i++) sum += d->nearby->away[i];
  return sum;
}

/* The error of a cell is what taking the representative's travel times for its own may be wrong by: |d(r, p) - d(c, p)|
 * is no more than the longer of d(r, c) and d(c, r). */
static void represent(const qtr_division *d, qtr_region region, qtr_cell member) {
  qtr_division_measure(d, member);
  for (uint32_t i = 0; i < d->nearby->listed; i++) {
    /* What taking the representative's time for a member's is wrong by (section 5.2.3) is within the diameter. */
    QTR_ASSERT(d->nearby->away[i] <= d->config->diameter);
    d->scratch->error[d->nearby->list[i]] = (uint16_t)d->nearby->away[i];
  }
  d->regions->representative[region] = member;
  d->scratch->changed[region] = 0;
}

void qtr_division_find_median(const qtr_division *d, qtr_region region) {
  qtr_division_list_whole(d, region);
  /* A region is connected: all of it is found from any of its cells. */
  QTR_ASSERT(d->nearby->listed == d->regions->size[region]);
  qtr_cell median = d->nearby->list[0];
  uint32_t least = sum_from(d, median);
  for (uint32_t i = 1; i < d->nearby->listed; i++) {
    const qtr_cell member = d->nearby->list[i];
    const uint32_t sum = sum_from(d, member);
    if (sum > least || (sum == least && member > median)) continue;
    least = sum;
    median = member;
  }
  represent(d, region, median);
}

/* The member next to `cell` whose sum is least, if it is below *least; else the cell itself. */
static qtr_cell step_down(const qtr_division *d, qtr_cell cell, uint32_t *least) {
  qtr_cell next[4];
  qtr_cell best = cell;
  const int count = qtr_nearby_neighbours(d->nearby, cell, next);
  for (int i = 0; i < count; i++) {
    if (d->nearby->slot[next[i]] == 0) continue;
    uint32_t *sum = &d->scratch->sum[d->nearby->slot[next[i]] - 1];
    if (*sum == 0) *sum = sum_from(d, next[i]);
    if (*sum >= *least) continue;
    *least = *sum;
    best = next[i];
  }
  return best;
}

/* Nearly the median, step by step from the representative there was: for regions that will change again, at a fraction
 * of the searches. Each step makes the sum less, so they end, at a member none of whose neighbours is better. */
static void follow_median(const qtr_division *d, qtr_region region) {
  qtr_division_list_whole(d, region);
  memset(d->scratch->sum, 0, d->nearby->listed * sizeof *d->scratch->sum);
  qtr_cell at = d->regions->representative[region];
  uint32_t least = sum_from(d, at);
  for (qtr_cell from = QTR_NO_CELL; from != at;) {
    from = at;
    at = step_down(d, from, &least);
  }
  represent(d, region, at);
}

void qtr_division_follow_medians(const qtr_division *d) {
  for (uint32_t region = 0; region < d->regions->count && division_may_go_on(d); region++)
    if (d->scratch->changed[region] && d->regions->size[region] > 0) follow_median(d, (qtr_region)region);
}
