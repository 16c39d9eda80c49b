#include "search/ways.h"

#include <math.h>
#include <stdbool.h>

#include "model/rounding.h"

qtr_steps qtr_ways_apart(const qtr_gains *gains, unsigned kind, unsigned place, unsigned target) {
  const qtr_tour *tour = gains_tour_at(gains, place);
  if (tour->places == 0 || tour->target == target) return QTR_NEVER;
  const uint16_t last = tour->place[tour->places - 1];
  const uint16_t first = gains_first_of(gains, last, target);
  if (first == QTR_STAND_DOWN || qtr_gains_travel(gains, kind, last)[first] == QTR_NEVER) return QTR_NEVER;
  return tour->step[tour->places - 1] + qtr_gains_travel(gains, kind, last)[first];
}

/* How far `into` a slot lies on the line to the next one. Worth is linear in gamma^t, whose first step is different: a
 * place visited at step 0 is worth as much as at step 1. */
double qtr_ways_share(const qtr_gains *gains, uint32_t slot, qtr_steps into) {
  if (gains->clocked || into == 0) return 0.0;
  if (gains->game->objective.kind == QTR_TIME) return (double)into / (double)gains->slot_steps;
  return slot == 0 ? 0.0 : (1.0 - qtr_objective_power(&gains->game->objective, into)) / gains->slot_fall;
}

/* As a float that is not above it: less of the line is more of the bound. */
static float share_below(double share) {
  const float nearest = (float)share;
  return (double)nearest > share ? nextafterf(nearest, 0.0f) : nearest;
}

static qtr_gains_way way_between(const qtr_gains *gains, unsigned kind, unsigned place, unsigned target) {
  const qtr_steps apart = qtr_ways_apart(gains, kind, place, target);
  qtr_gains_way way = {0, 0.0f, QTR_NO_WAY, (uint16_t)target};
  if (apart == QTR_NEVER || qtr_looks_is_before(&gains->looks, target, gains_target_of(gains, place))) return way;
  const uint32_t slots = apart / gains->slot_steps;
  way.slots = (uint16_t)(slots < gains->slots ? slots : gains->slots);
  way.share = share_below(qtr_ways_share(gains, slots, apart % gains->slot_steps));
  way.entry = gains->entry[gains_first_of(gains, qtr_tour_exit(gains_tour_at(gains, place)), target)] -
              gains_best_ahead(gains, target) + qtr_near_mark(&gains->near, target, gains_target_of(gains, place));
  return way;
}

static bool is_nearer(const qtr_gains_way *way, const qtr_gains_way *other) {
  return way->slots != other->slots ? way->slots < other->slots : way->target < other->target;
}

/* Shell's method: rows are sorted once for hundreds of fillings. */
static void sort(qtr_gains_way *ways, unsigned count) {
  for (unsigned gap = count / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11) {
    for (unsigned i = gap; i < count; i++) {
      const qtr_gains_way way = ways[i];
      unsigned at = i;
      for (; at >= gap && is_nearer(&way, &ways[at - gap]); at -= gap) ways[at] = ways[at - gap];
      ways[at] = way;
    }
  }
}

static void measure_from(const qtr_gains *gains, unsigned kind, unsigned place) {
  qtr_gains_way *ways = gains_ways_from(gains, kind, place);
  const unsigned next = qtr_looks_next(&gains->looks, place);
  for (unsigned target = 0; target < gains->looks.firsts; target++)
    ways[target] = way_between(gains, kind, place, target);
  sort(ways, gains->looks.firsts);
  if (next != QTR_STAND_DOWN) *gains_way_to_next(gains, kind, place) = way_between(gains, kind, place, next);
}

void qtr_ways_measure(qtr_gains *gains) {
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    for (unsigned place = 0; place < gains_places(gains); place++) measure_from(gains, kind, place);
}
