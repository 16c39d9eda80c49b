#include "aggregate/settling.h"

#include <string.h>

/* ---- moving cells from region to region ---- */

/* Neither representative is found anew: that is done for all that changed when a pass over the regions is over. */
static void move(const qtr_division *d, qtr_cell cell, qtr_region to) {
  const qtr_region from = d->regions->of[cell];
  d->regions->size[from]--;
  d->regions->size[to]++;
  d->regions->of[cell] = to;
  d->scratch->changed[from] = d->scratch->changed[to] = 1;
}

static bool has_room(const qtr_division *d, qtr_region region) {
  return d->regions->size[region] < d->config->max_size;
}

/* All of a region is listed from one of its cells if and only if it hangs together. */
static bool is_connected(const qtr_division *d, qtr_region region) {
  qtr_division_list_whole(d, region);
  return d->nearby->listed == d->regions->size[region];
}

/* Whether a region is in order now that it has this cell. */
static bool holds(const qtr_division *d, qtr_region region, qtr_cell cell) {
  qtr_division_list(d, cell, region, d->regions->size[region]);
  return d->nearby->listed == d->regions->size[region] && qtr_division_measure(d, cell);
}

/* Move the cell if both regions stay in order. Distances are the map's, so what is left of `from` is no further apart
 * than it was and need only be connected; in `to` the new cell alone has distances that were not within the diameter
 * before. */
static bool try_move(const qtr_division *d, qtr_cell cell, qtr_region to) {
  const qtr_region from = d->regions->of[cell];
  move(d, cell, to);
  if (is_connected(d, from) && holds(d, to, cell)) return true;
  move(d, cell, from);
  return false;
}

/* ---- exchanging: cells go to the nearer of two representatives ---- */

/* The cell that a full region would best give to another one, and what its distance becomes; QTR_NO_CELL if that would
 * lose all of `gain`: the sum of all cells' errors falls with each trade as with each move, so exchanging settles. */
static qtr_cell find_return(const qtr_division *d, qtr_region full, qtr_region other, qtr_steps gain, qtr_steps *away) {
  const qtr_nearby *nearby = d->nearby;
  qtr_cell best = QTR_NO_CELL;
  int64_t least = gain;
  qtr_division_list_whole(d, full);
  qtr_division_measure(d, d->regions->representative[other]);
  for (uint32_t i = 0; i < nearby->listed; i++) {
    const qtr_cell cell = nearby->list[i];
    if (nearby->away[i] == QTR_NEVER || cell == d->regions->representative[full]) continue;
    const int64_t loss = (int64_t)nearby->away[i] - d->scratch->error[cell];
    if (loss >= least || division_neighbours_in(d, cell, other) == 0) continue;
    least = loss;
    best = cell;
    *away = nearby->away[i];
  }
  return best;
}

/* Trade the cell for one of a full region. */
static bool try_trade(const qtr_division *d, qtr_cell cell, qtr_region full, qtr_steps gain) {
  const qtr_region other = d->regions->of[cell];
  qtr_steps away = 0;
  const qtr_cell back = find_return(d, full, other, gain, &away);
  if (back == QTR_NO_CELL) return false;
  move(d, cell, full);
  move(d, back, other);
  if (holds(d, full, cell) && holds(d, other, back)) {
    d->scratch->error[back] = (uint16_t)away;
    return true;
  }
  move(d, cell, other);
  move(d, back, full);
  return false;
}

/* Add a cell to those chosen, the greatest gain first: later ones may find the region full. */
static void insert_chosen(qtr_regions_scratch *s, qtr_cell cell, qtr_steps away) {
  const uint32_t gain = s->error[cell] - away;
  uint32_t at = s->chosen_count++;
  for (; at > 0 && s->error[s->chosen[at - 1]] - s->chosen_away[at - 1] < gain; at--) {
    s->chosen[at] = s->chosen[at - 1];
    s->chosen_away[at] = s->chosen_away[at - 1];
  }
  s->chosen[at] = cell;
  s->chosen_away[at] = away;
}

/* Choose the cells beside a region that are nearer to its representative than to their own. */
static void choose_nearer(const qtr_division *d, qtr_region region) {
  qtr_nearby *nearby = d->nearby;
  qtr_cell next[4];
  qtr_division_list_whole(d, region);
  const uint32_t members = nearby->listed;
  for (uint32_t i = 0; i < members; i++) {
    const int count = qtr_nearby_neighbours(nearby, nearby->list[i], next);
    for (int k = 0; k < count; k++) qtr_nearby_list(nearby, next[k]);
  }
  qtr_division_measure(d, d->regions->representative[region]);
  d->scratch->chosen_count = 0;
  for (uint32_t i = members; i < nearby->listed; i++)
    if (nearby->away[i] < d->scratch->error[nearby->list[i]])
      insert_chosen(d->scratch, nearby->list[i], nearby->away[i]);
}

/* Each cell chosen is checked again as it is moved: those moved before it have changed both regions. */
static void attract(const qtr_division *d, qtr_region region) {
  qtr_regions_scratch *s = d->scratch;
  choose_nearer(d, region);
  for (uint32_t i = 0; i < s->chosen_count; i++) {
    const qtr_cell cell = s->chosen[i];
    const qtr_steps away = s->chosen_away[i];
    const bool moved =
        has_room(d, region) ? try_move(d, cell, region) : try_trade(d, cell, region, s->error[cell] - away);
    if (moved) s->error[cell] = (uint16_t)away;
  }
}

/* Representatives stay where they are during a pass, or the errors that cells are compared by would be of two
 * divisions. */
void qtr_division_exchange(const qtr_division *d) {
  for (uint32_t region = 0; region < d->regions->count && division_may_go_on(d); region++)
    if (d->regions->size[region] > 0) attract(d, (qtr_region)region);
  qtr_division_follow_medians(d);
}

/* ---- dissolving: the cells of a small region are given to its neighbours ---- */

/* Give the cell to the neighbour with the most room, which is then the last to be full. */
static bool give_away(const qtr_division *d, qtr_cell cell) {
  const qtr_region from = d->regions->of[cell];
  qtr_cell next[4];
  const int count = qtr_nearby_neighbours(d->nearby, cell, next);
  qtr_region best = QTR_NO_REGION;
  for (int i = 0; i < count; i++) {
    const qtr_region to = d->regions->of[next[i]];
    if (to == from || !has_room(d, to)) continue;
    if (best != QTR_NO_REGION && d->regions->size[to] >= d->regions->size[best]) continue;
    move(d, cell, to);
    if (holds(d, to, cell)) best = to;
    move(d, cell, from);
  }
  if (best == QTR_NO_REGION) return false;
  move(d, cell, best);
  return true;
}

/* All of the region's cells are given away, or none. Inner cells can go when the outer ones have gone, so they are
 * tried again as long as one goes. */
static void dissolve_one(const qtr_division *d, qtr_region region) {
  qtr_regions_scratch *s = d->scratch;
  qtr_division_list_whole(d, region);
  s->chosen_count = d->nearby->listed;
  memcpy(s->chosen, d->nearby->list, s->chosen_count * sizeof *s->chosen);
  for (bool moved = true; moved && d->regions->size[region] > 0;) {
    moved = false;
    for (uint32_t i = s->chosen_count; i-- > 0;)
      if (d->regions->of[s->chosen[i]] == region) moved = give_away(d, s->chosen[i]) || moved;
  }
  if (d->regions->size[region] == 0) return;
  for (uint32_t i = 0; i < s->chosen_count; i++)
    if (d->regions->of[s->chosen[i]] != region) move(d, s->chosen[i], region);
}

/* The smallest first, for they are the easiest to be rid of. Only the number of regions counts here: errors are settled
 * by the exchange that follows. */
void qtr_division_dissolve(const qtr_division *d) {
  for (uint32_t size = 1; size < d->config->max_size; size++)
    for (uint32_t region = 0; region < d->regions->count; region++)
      if (d->regions->size[region] == size && division_may_go_on(d)) dissolve_one(d, (qtr_region)region);
  qtr_division_follow_medians(d);
}
