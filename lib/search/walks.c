#include <math.h>

#include "model/rounding.h"
#include "quarter/status.h"
#include "search/gains.h"
#include "search/rows.h"

#define WATCH_SLOTS 32u /* filled from one asking of the watch to the next */
#define LISTED 4u       /* ways on, the best, that are ranked for all memories of a place at once */

/* What the tour begun at `place` is worth, net of its price: sum of worth(p_i, t + s_i) - lambda, s_i the step of its
 * visit i. */
static double net_worth(const qtr_gains *gains, const double *price, unsigned place, qtr_steps when) {
  const qtr_tour *tour = gains_tour_at(gains, place);
  double worth = -price[tour->target];
  for (unsigned i = 0; i < tour->places; i++)
    worth += qtr_game_worth(gains->game, tour->place[i], when + tour->step[i]);
  return worth;
}

/* What a target is worth at most from some step on: all of its places at once. */
static double target_worth(const qtr_gains *gains, unsigned target, qtr_steps when) {
  const qtr_targets *targets = &gains->environment->targets;
  double worth = 0.0;
  for (unsigned i = 0; i < qtr_targets_size(targets, target); i++)
    worth += qtr_game_worth(gains->game, qtr_targets_place(targets, target, i), when);
  return worth;
}

/* Of several looks at a place, filled one after the other, the best with each memory. */
static void keep_best_look(const qtr_gains *gains, unsigned kind, uint32_t slot, unsigned look) {
  const unsigned first = qtr_looks_first(&gains->looks, look);
  const uint32_t memories = gains_best_ahead(gains, first);
  const double *gain = gains_row(gains, kind, slot) + gains->entry[look];
  double *best = gains_row(gains, kind, slot) + gains->entry[first] - memories;
  for (uint32_t memory = 0; memory < memories; memory++)
    if (look == first || gain[memory] > best[memory]) best[memory] = gain[memory];
}

/* All that is left, collected at once at the first step past the last slot. From there on a real walk visits each
 * target once at most, and not before: the sum of what is above 0 bounds it. Its first target it cannot refuse any
 * more. */
static void fill_late(qtr_gains *gains, const double *price) {
  const qtr_steps end = gains->slots * gains->slot_steps;
  double all = 0.0;
  for (unsigned target = 0; target < gains_targets(gains); target++) {
    const double net = target_worth(gains, target, end) - price[target];
    all += net > 0.0 ? net : 0.0;
  }
  for (unsigned kind = 0; kind < gains->kinds; kind++) {
    double *row = gains_row(gains, kind, gains->slots);
    row[0] = -HUGE_VAL;
    for (unsigned place = 0; place < gains_places(gains); place++) {
      const unsigned target = gains_target_of(gains, place);
      const double net = target_worth(gains, target, end) - price[target];
      const double late = all + (net > 0.0 ? 0.0 : net) + qtr_gains_go_home(gains, kind, QTR_STAND_DOWN, end);
      for (unsigned memory = 0; memory < qtr_near_memories(&gains->near, target); memory++)
        row[gains->entry[place] + memory] = late;
      if (late > row[0]) row[0] = late;
      keep_best_look(gains, kind, gains->slots, place);
    }
  }
}

/* ---- ways on from a place at a slot ---- */

/* The best ways on, best first, of a walk that remembers nothing but where it is; more memory is never worth more. */
typedef struct {
  double value[LISTED];
  uint16_t way[LISTED];
  unsigned count;
  double unlisted; /* the most that any other is worth */
} ways_on;

/* Where a walk stands, a kind's at a place at a slot, and what lies before it. */
typedef struct {
  const double *now; /* the slot's row */
  uint32_t slots_left;
  const qtr_gains_way *ways; /* to first looks, the nearest first */
} outlook;

static outlook look_out(const qtr_gains *gains, unsigned kind, uint32_t slot, unsigned place) {
  return (outlook){gains_row(gains, kind, slot), gains->slots - slot, gains_ways_from(gains, kind, place)};
}

/* The row that a way leads to, or comes behind. */
static inline const double *row_at(const qtr_gains *gains, const outlook *from, const qtr_gains_way *way) {
  return from->now + (size_t)(way->slots < from->slots_left ? way->slots : from->slots_left) * gains->row;
}

/* What a walk collects that goes a way, and stands there so many entries on in the row. */
static inline double follow(const qtr_gains *gains, const outlook *from, const qtr_gains_way *way, uint32_t entry) {
  const double *in = row_at(gains, from, way) + entry;
  if (way->share == 0.0f || way->slots >= from->slots_left) return *in;
  return *in + (double)way->share * (in[gains->row] - *in);
}

static inline void list_way(ways_on *on, double value, unsigned way) {
  unsigned i = on->count < LISTED ? on->count++ : LISTED - 1;
  for (; i > 0 && on->value[i - 1] < value; i--) {
    on->value[i] = on->value[i - 1];
    on->way[i] = on->way[i - 1];
  }
  on->value[i] = value;
  on->way[i] = (uint16_t)way;
  if (on->count == LISTED) on->unlisted = on->value[LISTED - 1];
}

/* What a move is charged at least, to whichever look. */
static double least_charge(const qtr_gains *gains, unsigned from, unsigned first) {
  double least = HUGE_VAL;
  for (unsigned look = first; look != QTR_STAND_DOWN; look = qtr_looks_next(&gains->looks, look))
    if (qtr_gains_charge_of(gains, from, look) < least) least = qtr_gains_charge_of(gains, from, look);
  return least;
}

/* To other places that are worth more than `least`, by the best look at each. Ways further than one whose slot is worth
 * no more to anybody, from then on and anywhere, are not looked at. */
static void list_ways(const qtr_gains *gains, const outlook *from, unsigned place, double least, ways_on *on) {
  on->count = 0;
  on->unlisted = least;
  for (unsigned i = 0; i < gains->looks.firsts; i++) {
    const qtr_gains_way *way = &from->ways[i];
    if (way->slots == QTR_NO_WAY || row_at(gains, from, way)[0] <= on->unlisted) return;
    /* Walks move on in time: C(t, p) needs later slots alone, and those have been filled. */
    QTR_ASSERT(way->slots > 0);
    double value = follow(gains, from, way, way->entry);
    if (gains->charge != NULL) value -= least_charge(gains, gains_target_of(gains, place), way->target);
    if (value > on->unlisted) list_way(on, value, i);
  }
}

/* ---- the best of them, with each memory ---- */

/* What a walk at a place collects on at most, and what it remembers where it goes, for each memory that it may have. */
typedef struct {
  unsigned memories;
  double most[1u << QTR_NEAR_MOST];
  qtr_memory then[1u << QTR_NEAR_MOST];
} ahead;

/* Whether some memories are known to collect less. */
static bool is_any_below(const ahead *on, double value) {
  for (unsigned memory = 0; memory < on->memories; memory++)
    if (on->most[memory] < value) return true;
  return false;
}

/* Memories change alike on the way to each look at a place. */
static void move_memories(const qtr_gains *gains, unsigned here, unsigned target, ahead *on) {
  on->then[0] = qtr_near_mark(&gains->near, target, here);
  for (unsigned i = 0; 1u << i < on->memories; i++) {
    const qtr_memory mark = qtr_near_mark(&gains->near, target, gains->near.near[here][i]);
    for (unsigned memory = 0; memory < 1u << i; memory++) on->then[1u << i | memory] = on->then[memory] | mark;
  }
}

/* By way of `way`, whose gains stand at `entry` of a slot, with a memory that holds some of `with`, if that is any, and
 * none of `without`. */
static void go_on(const qtr_gains *gains, const outlook *from, const qtr_gains_way *way, uint32_t entry, double charge,
                  qtr_memory with, qtr_memory without, ahead *on) {
  for (unsigned memory = 0; memory < on->memories; memory++) {
    if ((memory & without) != 0 || (with != 0 && (memory & with) == 0)) continue;
    const double value = follow(gains, from, way, entry + on->then[memory]) - charge;
    if (value > on->most[memory]) on->most[memory] = value;
  }
}

/* To a target, or to whichever look at a place: where none is remembered, to the best one. */
static void go_on_to(const qtr_gains *gains, const outlook *from, unsigned here, const qtr_gains_way *way, ahead *on) {
  const unsigned first = way->target;
  const uint32_t best = gains_best_ahead(gains, first);
  qtr_memory known = 0;
  if (way->slots == QTR_NO_WAY) return;
  move_memories(gains, here, first, on);
  uint32_t entry = way->entry - on->then[0];
  if (best != 0 && gains->charge == NULL) {
    for (unsigned look = first; look != QTR_STAND_DOWN; look = qtr_looks_next(&gains->looks, look))
      known |= qtr_near_bit(&gains->near, here, look);
    go_on(gains, from, way, entry, 0.0, 0, known, on);
    if (known == 0) return;
  }
  entry += best;
  for (unsigned look = first; look != QTR_STAND_DOWN; look = qtr_looks_next(&gains->looks, look)) {
    if (look != first) entry = gains->entry[look];
    go_on(gains, from, way, entry, qtr_gains_charge_of(gains, here, look), known,
          qtr_near_bit(&gains->near, here, look), on);
  }
}

/* The ways listed, best first, as long as they are worth more than what is known; then all, where that is less than
 * what is not listed. */
static void go_on_by(const qtr_gains *gains, const outlook *from, unsigned here, const ways_on *listed, ahead *on) {
  for (unsigned i = 0; i < listed->count; i++) {
    if (!is_any_below(on, listed->value[i])) return;
    go_on_to(gains, from, here, &from->ways[listed->way[i]], on);
  }
  if (!is_any_below(on, listed->unlisted)) return;
  for (unsigned i = 0; i < gains->looks.firsts; i++) {
    const qtr_gains_way *way = &from->ways[i];
    if (way->slots == QTR_NO_WAY || !is_any_below(on, row_at(gains, from, way)[0])) return;
    go_on_to(gains, from, here, way, on);
  }
}

/* C(t, j, memory) with the tour that it begins: net(j, t) + max(0, max over p of C(t + d(j, p), p, memory there)), d
 * from tour's start to start. A tour that leaves no time to go home is none. */
static void fill_gains(const qtr_gains *gains, unsigned kind, uint32_t slot, unsigned place, const outlook *from,
                       const ways_on *listed, double home, double net) {
  const unsigned here = gains_target_of(gains, place);
  double *row = gains_row(gains, kind, slot);
  double *gain = row + gains->entry[place];
  ahead on;
  on.memories = qtr_near_memories(&gains->near, here);
  for (unsigned memory = 0; memory < on.memories; memory++) on.most[memory] = home;
  if (qtr_looks_next(&gains->looks, place) != QTR_STAND_DOWN)
    go_on_to(gains, from, here, gains_way_to_next(gains, kind, place), &on);
  go_on_by(gains, from, here, listed, &on);
  for (unsigned memory = 0; memory < on.memories; memory++) gain[memory] = net + on.most[memory];
  if (gain[0] > row[0]) row[0] = gain[0];
}

static void fill_with_none(const qtr_gains *gains, unsigned kind, uint32_t slot, unsigned place) {
  double *gain = gains_row(gains, kind, slot) + gains->entry[place];
  for (unsigned memory = 0; memory < qtr_near_memories(&gains->near, gains_target_of(gains, place)); memory++)
    gain[memory] = -HUGE_VAL;
}

/* All looks at a place. The ways on are ranked for all of them at once, where none is charged more than another: later
 * ones remember more, and more memory is never worth more. */
static void fill_looks(const qtr_gains *gains, unsigned kind, uint32_t slot, unsigned first, const double *price) {
  const qtr_tour *tour = gains_tour_at(gains, first);
  const qtr_steps when = slot * gains->slot_steps;
  const qtr_steps done = when + qtr_tour_length(tour);
  const bool in_time = qtr_gains_in_time(gains, kind, qtr_tour_exit(tour), done);
  const double home = qtr_gains_go_home(gains, kind, qtr_tour_exit(tour), done);
  ways_on listed = {.count = 0};
  for (unsigned look = first; look != QTR_STAND_DOWN; look = qtr_looks_next(&gains->looks, look)) {
    const outlook from = look_out(gains, kind, slot, look);
    if (look == first || gains->charge != NULL) list_ways(gains, &from, look, home, &listed);
    if (in_time)
      fill_gains(gains, kind, slot, look, &from, &listed, home, net_worth(gains, price, look, when));
    else
      fill_with_none(gains, kind, slot, look);
    keep_best_look(gains, kind, slot, look);
  }
}

/* The most from a slot on is no less than that of the next. */
static void begin_slot(const qtr_gains *gains, uint32_t slot) {
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    gains_row(gains, kind, slot)[0] = gains_row(gains, kind, slot + 1)[0];
}

/* Backwards in time, for each slot rests on later ones alone. False: stopped, and the gains are those of no prices. */
bool qtr_gains_fill(qtr_gains *gains, const double *price) {
  gains->fillings++;
  fill_late(gains, price);
  for (uint32_t slot = gains->slots; slot-- > 0;) {
    if (slot % WATCH_SLOTS == 0 && !qtr_watch_go_on(&gains->game->mission->watch)) return false;
    begin_slot(gains, slot);
    for (unsigned place = 0; place < gains_places(gains); place++) {
      if (gains_tour_at(gains, place)->places == 0 || qtr_looks_before(&gains->looks, place) != QTR_STAND_DOWN)
        continue;
      for (unsigned kind = 0; kind < gains->kinds; kind++) fill_looks(gains, kind, slot, place, price);
    }
  }
  return true;
}

/* ---- the walk that C stands for, followed forwards: what the prices are tuned by ---- */

typedef struct {
  unsigned node;
  qtr_steps when;
  qtr_memory memory;
} walker;

/* The target that a node belongs to; starts belong to none. */
static unsigned target_at(const qtr_gains *gains, unsigned node) {
  return node < gains_places(gains) ? gains_target_of(gains, node) : QTR_STAND_DOWN;
}

/* Not to targets in `but`, if that is any; and as far as it remembers it has neither been there, nor taken a look that
 * follows. */
static bool may_go(const qtr_gains *gains, unsigned here, qtr_memory memory, const qtr_places *but, unsigned target) {
  if (target == here || (but != NULL && qtr_places_has(but, target))) return false;
  if (here == QTR_STAND_DOWN) return true;
  return (qtr_near_bit(&gains->near, here, target) & memory) == 0 && !qtr_looks_is_before(&gains->looks, target, here);
}

/* Go to where most can be collected, and say what; QTR_STAND_DOWN: it stays, which is best. */
static unsigned walk_on(const qtr_gains *gains, unsigned kind, const qtr_places *but, walker *at, double *collected) {
  const qtr_steps *travel = qtr_gains_travel(gains, kind, at->node);
  const unsigned here = target_at(gains, at->node);
  unsigned best = QTR_STAND_DOWN;
  walker then = *at;
  *collected = qtr_gains_go_home(gains, kind, at->node, at->when);
  for (unsigned target = 0; target < gains_targets(gains); target++) {
    const uint16_t first = gains_first_of(gains, at->node, target);
    if (first == QTR_STAND_DOWN || travel[first] == QTR_NEVER) continue;
    if (!may_go(gains, here, at->memory, but, target)) continue;
    const qtr_memory memory = here == QTR_STAND_DOWN ? 0 : qtr_near_move(&gains->near, here, at->memory, target);
    double gain = qtr_gains_at(gains, kind, first, memory, at->when + travel[first]);
    if (here != QTR_STAND_DOWN) gain -= qtr_gains_charge_of(gains, here, target);
    if (gain <= *collected) continue;
    *collected = gain;
    best = target;
    then = (walker){first, at->when + travel[first], memory};
  }
  *at = then;
  return best;
}

static walker begin_walk(const qtr_gains *gains, unsigned seeker) {
  const qtr_board *board = &gains->game->board;
  return (walker){(unsigned)board->places + board->start_of[seeker], qtr_board_ready(board, seeker), 0};
}

static bool is_late(const qtr_gains *gains, const walker *at) {
  return at->when / gains->slot_steps >= gains->slots;
}

static void walk_tour(const qtr_gains *gains, walker *at) {
  const qtr_tour *tour = gains_tour_at(gains, at->node);
  at->node = qtr_tour_exit(tour);
  at->when += qtr_tour_length(tour);
}

double qtr_gains_walk(const qtr_gains *gains, unsigned seeker, int *visits) {
  const unsigned kind = gains->kind_of[seeker];
  walker at = begin_walk(gains, seeker);
  double all, rest;
  unsigned target = walk_on(gains, kind, NULL, &at, &all);
  while (target != QTR_STAND_DOWN) {
    visits[target]++;
    if (is_late(gains, &at)) break;
    walk_tour(gains, &at);
    target = walk_on(gains, kind, NULL, &at, &rest);
  }
  return all;
}

double qtr_gains_walk_but(const qtr_gains *gains, unsigned seeker, const qtr_places *but, const double *price,
                          int *visits) {
  const unsigned kind = gains->kind_of[seeker];
  walker at = begin_walk(gains, seeker);
  double all = 0.0;
  double rest;
  unsigned before = QTR_STAND_DOWN;
  unsigned target = walk_on(gains, kind, but, &at, &rest);
  while (target != QTR_STAND_DOWN) {
    visits[target]++;
    all += net_worth(gains, price, at.node, at.when);
    if (before != QTR_STAND_DOWN) all -= qtr_gains_charge_of(gains, before, target);
    before = target;
    const bool late = is_late(gains, &at);
    walk_tour(gains, &at);
    if (late) break;
    target = walk_on(gains, kind, but, &at, &rest);
  }
  return all + qtr_gains_go_home(gains, kind, at.node, at.when);
}
