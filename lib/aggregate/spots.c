#include "quarter/spots.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "core/bytes.h"
#include "model/rounding.h"
#include "model/settings.h"
#include "quarter/status.h"

#define TOO_FAR HUGE_VAL
#define NOT_ONE QTR_MAX_PLACES /* no place */
#define ROUNDING 1e-12         /* worths that differ by less, relatively, are equal */

/* The board's own bytes, by node and place. */
static qtr_steps way(const qtr_spot_ground *ground, unsigned node, unsigned place) {
  return qtr_load32(ground->steps + 4 * ((uint32_t)node * ground->places + place));
}

/* ---- distances ---- */

typedef struct {
  const qtr_spot_ground *ground;
  const qtr_spots_config *config;
  double least_gain; /* of a move that is made: above what rounding may feign, so that the search ends */
} clustering;

/* How much the distance of two places counts for, since they are not equally likely: 1 + W (P_max / P_min - 1). */
static double stretch(const clustering *c, unsigned p, unsigned q) {
  if (!(c->config->likelihood > 0.0)) return 1.0;
  const double a = c->ground->probability[p];
  const double b = c->ground->probability[q];
  return 1.0 + c->config->likelihood * ((a > b ? a / b : b / a) - 1.0);
}

/* Distance of two places, TOO_FAR if they cannot be of one spot: the longer of the two ways, stretched. TOO_FAR is
 * infinite, so any sum that it is in is TOO_FAR too, and a spot with two such places is never the best of anything. */
static double apart(const clustering *c, unsigned p, unsigned q) {
  const qtr_steps there = way(c->ground, p, q);
  const qtr_steps back = way(c->ground, q, p);
  const qtr_steps longer = there > back ? there : back;
  if (longer > c->config->diameter) return TOO_FAR;
  const double distance = longer * stretch(c, p, q);
  return distance <= c->config->diameter ? distance : TOO_FAR;
}

/* Summed distance of `place` to the places of a spot but itself and `without`; TOO_FAR if any is. */
static double reach(const clustering *c, const qtr_spots *spots, unsigned spot, unsigned place, unsigned without) {
  double sum = 0.0;
  for (unsigned i = 0; i < spots->size[spot]; i++) {
    const unsigned other = spots->place[spot][i];
    if (other != place && other != without) sum += apart(c, place, other);
  }
  return sum;
}

/* ---- places in and out of spots ---- */

static void put(qtr_spots *spots, unsigned spot, unsigned place) {
  spots->place[spot][spots->size[spot]++] = (uint16_t)place;
  spots->spot_of[place] = (uint16_t)spot;
}

static void take(qtr_spots *spots, unsigned place) {
  const unsigned spot = spots->spot_of[place];
  unsigned at = 0;
  while (spots->place[spot][at] != place) at++;
  spots->place[spot][at] = spots->place[spot][--spots->size[spot]];
}

static void move(qtr_spots *spots, unsigned place, unsigned spot) {
  take(spots, place);
  put(spots, spot, place);
}

static void swap(qtr_spots *spots, unsigned p, unsigned q) {
  const unsigned from = spots->spot_of[p];
  const unsigned to = spots->spot_of[q];
  take(spots, p);
  take(spots, q);
  put(spots, to, p);
  put(spots, from, q);
}

/* Give the number of an empty spot to the last one. */
static void drop(qtr_spots *spots, unsigned spot) {
  const unsigned last = spots->count - 1u;
  while (spot != last && spots->size[last] > 0) move(spots, spots->place[last][0], spot);
  spots->count--;
}

/* Each place is a spot of its own: that any two joined are within the diameter then holds from the start. */
static void start_alone(qtr_spots *spots, unsigned places) {
  spots->count = (uint16_t)places;
  for (unsigned p = 0; p < places; p++) {
    spots->size[p] = 0;
    put(spots, p, p);
  }
}

/* ---- growing spots: complete linkage ---- */

typedef struct {
  double longest, total;
} linkage;

/* The longest decides, and the sum of all tells equal ones apart. */
static linkage link_of(const clustering *c, const qtr_spots *spots, unsigned s, unsigned t) {
  linkage link = {0.0, 0.0};
  for (unsigned i = 0; i < spots->size[s]; i++)
    for (unsigned j = 0; j < spots->size[t]; j++) {
      const double distance = apart(c, spots->place[s][i], spots->place[t][j]);
      if (distance > link.longest) link.longest = distance;
      link.total += distance;
    }
  return link;
}

static bool is_closer(linkage a, linkage b) {
  return a.longest < b.longest || (a.longest <= b.longest && a.total < b.total);
}

/* Join the two spots that are closest. False: no two may be joined. How far two spots are is how far their farthest
 * places are (complete linkage), for those must be within the diameter when they are one. */
static bool join_closest(const clustering *c, qtr_spots *spots) {
  linkage best = {TOO_FAR, TOO_FAR};
  unsigned first = 0, second = 0;
  for (unsigned s = 0; s < spots->count; s++)
    for (unsigned t = s + 1; t < spots->count; t++) {
      if (spots->size[s] + spots->size[t] > c->config->size) continue;
      const linkage link = link_of(c, spots, s, t);
      if (!is_closer(link, best)) continue;
      best = link;
      first = s;
      second = t;
    }
  if (!(best.longest < TOO_FAR)) return false;
  while (spots->size[second] > 0) move(spots, spots->place[second][0], first);
  drop(spots, second);
  return true;
}

/* ---- fewer spots: empty one into the others ---- */

/* A place of the spot `from` into another spot, and if need be one of that spot's places on into a third. */
typedef struct {
  double cost;
  unsigned to;
  unsigned ejected; /* NOT_ONE: nobody has to make room */
  unsigned onto;
} rehousing;

static void try_direct(rehousing *best, const clustering *c, const qtr_spots *spots, unsigned place, unsigned to) {
  if (spots->size[to] >= c->config->size) return;
  const double cost = reach(c, spots, to, place, NOT_ONE);
  if (cost < best->cost) *best = (rehousing){cost, to, NOT_ONE, 0};
}

/* The place goes into the spot of another one, which moves on to a third: costs are what summed distances grow by. */
static void try_ejecting(rehousing *best, const clustering *c, const qtr_spots *spots, unsigned place,
                         unsigned ejected) {
  const unsigned from = spots->spot_of[place];
  const unsigned to = spots->spot_of[ejected];
  const double inside = reach(c, spots, to, place, ejected);
  if (!(inside < TOO_FAR)) return;
  const double gone = reach(c, spots, to, ejected, NOT_ONE);
  for (unsigned onto = 0; onto < spots->count; onto++) {
    if (onto == from || onto == to || spots->size[onto] >= c->config->size) continue;
    const double cost = inside - gone + reach(c, spots, onto, ejected, NOT_ONE);
    if (cost < best->cost) *best = (rehousing){cost, to, ejected, onto};
  }
}

/* The cheapest place elsewhere; only if there is none, somebody is ejected to make room. */
static bool rehouse(const clustering *c, qtr_spots *spots, unsigned place) {
  const unsigned from = spots->spot_of[place];
  rehousing best = {TOO_FAR, 0, NOT_ONE, 0};
  for (unsigned to = 0; to < spots->count; to++)
    if (to != from) try_direct(&best, c, spots, place, to);
  if (!(best.cost < TOO_FAR))
    for (unsigned other = 0; other < c->ground->places; other++)
      if (spots->spot_of[other] != from) try_ejecting(&best, c, spots, place, other);
  if (!(best.cost < TOO_FAR)) return false;
  if (best.ejected != NOT_ONE) move(spots, best.ejected, best.onto);
  move(spots, place, best.to);
  return true;
}

/* All of a spot's places move, or none: a spot less, or everything as it was. So emptying ends. */
static bool empty(const clustering *c, qtr_spots *spots, unsigned spot, qtr_spots *scratch) {
  *scratch = *spots;
  while (spots->size[spot] > 0)
    if (!rehouse(c, spots, spots->place[spot][0])) {
      *spots = *scratch;
      return false;
    }
  drop(spots, spot);
  return true;
}

/* From the first spot on again after each one emptied: places that moved may have made room in those that failed
 * before. */
static void empty_spots(const clustering *c, qtr_spots *spots, qtr_spots *scratch) {
  for (unsigned spot = 0; spot < spots->count;) spot = empty(c, spots, spot, scratch) ? 0 : spot + 1;
}

/* ---- closer places: moves and swaps ---- */

/* A place nearer to another spot's places than to its own goes there. The summed distance within spots falls by
 * least_gain at the least, and it is never below 0: so this ends. The last place of a spot stays: a spot less is for
 * empty() to find. */
static bool try_move(const clustering *c, qtr_spots *spots, unsigned place, unsigned to) {
  const unsigned from = spots->spot_of[place];
  if (to == from || spots->size[to] >= c->config->size || spots->size[from] == 1) return false;
  const double gain = reach(c, spots, from, place, NOT_ONE) - reach(c, spots, to, place, NOT_ONE);
  if (!(gain > c->least_gain)) return false;
  move(spots, place, to);
  return true;
}

/* Full spots take nobody in, so two places that would be nearer elsewhere can only change places. */
static bool try_swap(const clustering *c, qtr_spots *spots, unsigned p, unsigned q) {
  const unsigned s = spots->spot_of[p];
  const unsigned t = spots->spot_of[q];
  if (s == t) return false;
  const double before = reach(c, spots, s, p, NOT_ONE) + reach(c, spots, t, q, NOT_ONE);
  const double after = reach(c, spots, t, p, q) + reach(c, spots, s, q, p);
  if (!(before - after > c->least_gain)) return false;
  swap(spots, p, q);
  return true;
}

static bool bring_closer(const clustering *c, qtr_spots *spots) {
  bool better = false;
  for (unsigned p = 0; p < c->ground->places; p++) {
    for (unsigned spot = 0; spot < spots->count; spot++) better |= try_move(c, spots, p, spot);
    for (unsigned q = p + 1; q < c->ground->places; q++) better |= try_swap(c, spots, p, q);
  }
  return better;
}

/* ---- building ---- */

/* Spots by their lowest place, places in order. */
static void put_in_order(qtr_spots *spots, unsigned places, qtr_spots *scratch) {
  *scratch = *spots;
  for (unsigned spot = 0; spot < spots->count; spot++) spots->size[spot] = 0;
  spots->count = 0;
  for (unsigned p = 0; p < places; p++) {
    const unsigned old = scratch->spot_of[p];
    unsigned lowest = p;
    for (unsigned i = 0; i < scratch->size[old]; i++)
      if (scratch->place[old][i] < lowest) lowest = scratch->place[old][i];
    put(spots, lowest == p ? spots->count++ : spots->spot_of[lowest], p);
  }
}

/* The paper's limits, too (Fig. 5.3). */
void qtr_spots_default(qtr_spots_config *config) {
  *config = (qtr_spots_config){.made = SETTINGS_MADE, .size = 5, .diameter = 25};
}

int qtr_spots_check(const qtr_spots_config *config) {
  if (config->made != SETTINGS_MADE) return QTR_ERR_ARGUMENT;
  if (config->size > QTR_MAX_SPOT_SIZE) return QTR_ERR_LIMIT;
  if (config->size == 0 || config->diameter == 0 || config->diameter == QTR_NEVER) return QTR_ERR_ARGUMENT;
  return config->likelihood >= 0.0 && config->likelihood <= DBL_MAX ? QTR_OK : QTR_ERR_ARGUMENT;
}

static int check_ground(const qtr_spot_ground *ground, bool by_likelihood) {
  if (ground->places == 0) return QTR_ERR_ARGUMENT;
  if (ground->places > QTR_MAX_PLACES) return QTR_ERR_LIMIT;
  for (unsigned p = 0; by_likelihood && p < ground->places; p++)
    if (!(ground->probability[p] > 0.0 && ground->probability[p] <= DBL_MAX)) return QTR_ERR_WEIGHT;
  return QTR_OK;
}

int qtr_spots_build_sized(qtr_spots *spots, const qtr_spot_ground *ground, const qtr_spots_config *config,
                          qtr_spots *scratch, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  int status = qtr_spots_check(config);
  if (status == QTR_OK) status = check_ground(ground, config->likelihood > 0.0);
  if (status != QTR_OK) return status;
  const clustering c = {ground, config, 1e-9 * config->diameter};
  start_alone(spots, ground->places);
  while (join_closest(&c, spots)) continue;
  unsigned before;
  do { /* places brought closer may let one more spot be emptied */
    before = spots->count;
    empty_spots(&c, spots, scratch);
    while (bring_closer(&c, spots)) continue;
  } while (spots->count < before);
  put_in_order(spots, ground->places, scratch);
  return QTR_OK;
}

/* ---- tours ---- */

/* Steps and worth of the visits in the order of tour->place: sum of P gamma^t, or - P t, t from leaving the node. */
static bool follow(qtr_spot_tour *tour, const qtr_spot_ground *ground, unsigned node, unsigned count) {
  qtr_steps now = 0;
  tour->places = (uint8_t)count;
  tour->worth = 0.0;
  for (unsigned i = 0; i < count; i++) {
    const unsigned place = tour->place[i];
    const qtr_steps steps = way(ground, node, place);
    if (steps == QTR_NEVER) return false;
    now += steps;
    tour->step[i] = now;
    const double visit = qtr_objective_visit(ground->objective, ground->probability[place]);
    tour->worth += qtr_objective_delayed(ground->objective, visit, now, ground->probability[place]);
    node = place;
  }
  return true;
}

static bool are_different(const uint16_t *place, unsigned count) {
  for (unsigned i = 0; i < count; i++)
    for (unsigned j = 0; j < i; j++)
      if (place[i] == place[j]) return false;
  return true;
}

static bool can_be_toured(const qtr_spot_ground *ground, const uint16_t *place, unsigned count) {
  if (count < 1 || count > QTR_MAX_SPOT_SIZE) return false;
  for (unsigned i = 0; i < count; i++)
    if (place[i] >= ground->places) return false;
  /* A tour visits each of the spot's places once: a set of them is a number below 2^count. */
  QTR_ASSERT(are_different(place, count));
  return true;
}

/* Nearest first (section 5.2.4), the lowest place among equals, so that a tour is the same on every machine. */
bool qtr_spot_tour_nearest(qtr_spot_tour *tour, const qtr_spot_ground *ground, unsigned node, const uint16_t *place,
                           unsigned count) {
  if (!can_be_toured(ground, place, count)) return false;
  unsigned here = node;
  for (unsigned i = 0; i < count; i++) tour->place[i] = place[i];
  for (unsigned done = 0; done < count; done++) {
    unsigned next = done;
    for (unsigned i = done + 1; i < count; i++) {
      const qtr_steps steps = way(ground, here, tour->place[i]);
      const qtr_steps least = way(ground, here, tour->place[next]);
      if (steps < least || (steps == least && tour->place[i] < tour->place[next])) next = i;
    }
    const uint16_t nearest = tour->place[next];
    tour->place[next] = tour->place[done];
    tour->place[done] = nearest;
    here = nearest;
  }
  return follow(tour, ground, node, count);
}

/* ---- the best order: from the end of the tour to its start ---- */

typedef struct {
  const qtr_spot_ground *ground;
  const uint16_t *place;
  unsigned count;
  int exit;
  double rest;
  qtr_spot_scratch *scratch;
} touring;

/* What is still to be had once the places of `done` are visited, by a seeker at a node. */
typedef struct {
  double worth;   /* counted from now; -HUGE_VAL: the tour cannot be ended from here */
  qtr_steps left; /* until the tour ends */
  unsigned next;  /* the place to go to, an index */
} prospect;

/* More worth, or as much to within rounding and sooner done: the rest of the game then begins sooner. */
static bool is_better(const prospect *a, const prospect *b) {
  if (!(b->worth > -HUGE_VAL)) return a->worth > -HUGE_VAL;
  const double slack = ROUNDING * fabs(b->worth);
  return a->worth > b->worth + slack || (a->worth >= b->worth - slack && a->left < b->left);
}

/* The likelihood that waits while the seeker is on its way: what is not done, and what comes after the spot. */
static double waiting(const touring *t, unsigned done) {
  double sum = t->rest;
  for (unsigned i = 0; i < t->count; i++)
    if (!(done >> i & 1u)) sum += t->ground->probability[t->place[i]];
  return sum;
}

/* Discounted: gamma^d (P + V), with V what is to be had from there; expected time: V - d (the mass that waits). */
static prospect go(const touring *t, unsigned done, unsigned node, unsigned next) {
  prospect p = {-HUGE_VAL, 0, next};
  const qtr_steps steps = way(t->ground, node, t->place[next]);
  const unsigned after = done | 1u << next;
  const double worth = t->scratch->worth[after][next];
  if (steps == QTR_NEVER || !(worth > -HUGE_VAL)) return p;
  p.left = steps + t->scratch->left[after][next];
  const double visit = qtr_objective_visit(t->ground->objective, t->ground->probability[t->place[next]]);
  p.worth = qtr_objective_delayed(t->ground->objective, visit + worth, steps, waiting(t, done));
  return p;
}

static prospect go_best(const touring *t, unsigned done, unsigned node) {
  prospect best = {-HUGE_VAL, 0, t->count};
  for (unsigned next = 0; next < t->count; next++) {
    if (done >> next & 1u) continue;
    const prospect p = go(t, done, node, next);
    if (is_better(&p, &best)) best = p;
  }
  return best;
}

/* Fill the scratch for every set of places done and the place visited last:
 *
 *   V(S, j) = max over p not in S of delayed(visit(p) + V(S + p, p), d(j, p)),    V(all, j) = visit(rest)
 *
 * A set is a number, and one with a place more is a larger number: from the largest down, all that is needed is
 * there. */
static void look_back(const touring *t) {
  const unsigned all = (1u << t->count) - 1u;
  for (unsigned last = 0; last < t->count; last++) {
    const bool may_end = t->exit == QTR_SPOT_ANY_EXIT || t->exit == (int)last;
    t->scratch->worth[all][last] = may_end ? qtr_objective_visit(t->ground->objective, t->rest) : -HUGE_VAL;
    t->scratch->left[all][last] = 0;
  }
  for (unsigned done = all - 1; done > 0; done--)
    for (unsigned last = 0; last < t->count; last++) {
      if (!(done >> last & 1u)) continue;
      const prospect best = go_best(t, done, t->place[last]);
      t->scratch->worth[done][last] = best.worth;
      t->scratch->left[done][last] = best.left;
    }
}

/* Forwards, by what look_back() found to be had from each place on. */
bool qtr_spot_tour_best(qtr_spot_tour *tour, const qtr_spot_ground *ground, unsigned node, const uint16_t *place,
                        unsigned count, int exit, double rest, qtr_spot_scratch *scratch) {
  if (!can_be_toured(ground, place, count) || exit < QTR_SPOT_ANY_EXIT || exit >= (int)count) return false;
  const touring t = {ground, place, count, exit, rest, scratch};
  unsigned done = 0;
  unsigned here = node;
  look_back(&t);
  for (unsigned i = 0; i < count; i++) {
    const prospect best = go_best(&t, done, here);
    if (!(best.worth > -HUGE_VAL)) return false;
    tour->place[i] = place[best.next];
    done |= 1u << best.next;
    here = place[best.next];
  }
  return follow(tour, ground, node, count);
}
