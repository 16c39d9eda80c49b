#include "search/gains.h"

#include <math.h>

#include "model/rounding.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "search/closure.h"

#define WATCH_SLOTS 32u /* filled from one asking of the watch to the next */
#define FINE_SLOTS 512u /* as many are enough where nothing depends on the clock */
#define LISTED 8u       /* ways on, the best, that are ranked for all memories of a place at once */

static unsigned places_of(const qtr_gains *gains) {
  return gains->game->board.places;
}

static unsigned targets_of(const qtr_gains *gains) {
  return gains->environment->targets.count;
}

static unsigned nodes_of(const qtr_gains *gains) {
  return places_of(gains) + gains->game->board.starts;
}

static qtr_gains_way *ways_from(const qtr_gains *gains, unsigned kind, unsigned place) {
  return gains->way + ((size_t)kind * places_of(gains) + place) * targets_of(gains);
}

static double *gains_in(const qtr_gains *gains, unsigned kind, uint32_t slot) {
  return gains->gain + ((size_t)kind * (gains->slots + 1) + slot) * gains->row;
}

/* What is known of a kind is known of its first seeker. */
static unsigned seeker_of(const qtr_gains *gains, unsigned kind) {
  return gains->first_of[kind];
}

bool qtr_gains_before_end(const qtr_gains *gains, unsigned kind, unsigned exit, qtr_steps when) {
  const unsigned seeker = seeker_of(gains, kind);
  return (uint64_t)when + qtr_game_way_home(gains->game, seeker, exit) <= qtr_board_end(&gains->game->board, seeker);
}

/* What going home from a node costs a seeker of a kind that is free there at step `when`. */
double qtr_gains_go_home(const qtr_gains *gains, unsigned kind, unsigned node, qtr_steps when) {
  if (gains->game->objective.terms.home_weight == 0.0) return 0.0;
  return qtr_objective_leave(&gains->game->objective,
                             when + qtr_game_way_home(gains->game, seeker_of(gains, kind), node));
}

/* The first place of a target's tour from a node; QTR_STAND_DOWN if there is no way. */
static uint16_t first_of(const qtr_gains *gains, unsigned node, unsigned target) {
  return qtr_targets_first(&gains->environment->targets, node, target);
}

static unsigned target_of(const qtr_gains *gains, unsigned place) {
  return qtr_targets_of(&gains->environment->targets, place);
}

static const qtr_tour *tour_at(const qtr_gains *gains, unsigned place) {
  return qtr_targets_tour(&gains->environment->targets, place);
}

/* The target that a node belongs to; starts belong to none. */
static unsigned target_at(const qtr_gains *gains, unsigned node) {
  return node < places_of(gains) ? target_of(gains, node) : QTR_STAND_DOWN;
}

/* Steps from the start of the tour at `place` to the start of the next target's. */
static qtr_steps steps_apart(const qtr_gains *gains, unsigned kind, unsigned place, unsigned target) {
  const qtr_tour *tour = tour_at(gains, place);
  if (tour->places == 0 || tour->target == target) return QTR_NEVER;
  const uint16_t last = tour->place[tour->places - 1];
  const uint16_t first = first_of(gains, last, target);
  if (first == QTR_STAND_DOWN || qtr_gains_travel(gains, kind, last)[first] == QTR_NEVER) return QTR_NEVER;
  return tour->step[tour->places - 1] + qtr_gains_travel(gains, kind, last)[first];
}

static qtr_steps shortest_apart(const qtr_gains *gains) {
  qtr_steps shortest = QTR_NEVER;
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    for (unsigned place = 0; place < places_of(gains); place++)
      for (unsigned target = 0; target < targets_of(gains); target++)
        if (steps_apart(gains, kind, place, target) < shortest) shortest = steps_apart(gains, kind, place, target);
  return shortest;
}

/* The steps that slots are to reach, a quarter further than the last visit of the play known: beyond the deadline
 * nothing is worth anything, and that is what counts there. */
static uint64_t horizon_of(const qtr_gains *gains, qtr_steps last_visit) {
  const qtr_objective *objective = &gains->game->objective;
  uint64_t horizon = (uint64_t)last_visit * 5 / 4 + gains->environment->board.keys.longest + 2;
  if (horizon > QTR_NEVER / 2) horizon = QTR_NEVER / 2;
  if (objective->kind == QTR_DEADLINE && horizon > objective->deadline) horizon = (uint64_t)objective->deadline + 1;
  return horizon;
}

/* ---- slots ---- */

/* How far `into` a slot lies on the line to the next one. Worth is linear in gamma^t, whose first step is different: a
 * place visited at step 0 is worth as much as at step 1. */
double qtr_gains_share(const qtr_gains *gains, uint32_t slot, qtr_steps into) {
  if (gains->clocked || into == 0) return 0.0;
  if (gains->game->objective.kind == QTR_TIME) return (double)into / (double)gains->slot_steps;
  return slot == 0 ? 0.0 : (1.0 - qtr_objective_power(&gains->game->objective, into)) / gains->slot_fall;
}

/* As a float that is not above it: less of the line is more of the bound. */
static float share_below(double share) {
  const float nearest = (float)share;
  return (double)nearest > share ? nextafterf(nearest, 0.0f) : nearest;
}

/* Slots as long as the horizon asks for, but never longer than the shortest way between two targets, or a walk would
 * not move on in time. */
static void cut_slots(qtr_gains *gains, qtr_steps last_visit) {
  const qtr_steps shortest = shortest_apart(gains);
  /* Places lie on different cells, and each step takes one of time; so do looks at one place. */
  QTR_ASSERT(shortest > 0);
  const uint64_t horizon = horizon_of(gains, last_visit);
  const uint64_t wanted = gains->clocked || QTR_BOUND_SLOTS < FINE_SLOTS ? QTR_BOUND_SLOTS : FINE_SLOTS;
  uint64_t steps = (horizon + wanted - 1) / wanted;
  if (steps > shortest) steps = shortest;
  const uint64_t slots = (horizon + steps - 1) / steps;
  gains->slot_steps = (qtr_steps)steps;
  gains->slots = (uint32_t)(slots < QTR_BOUND_SLOTS ? slots : QTR_BOUND_SLOTS);
  gains->slot_fall = 1.0 - qtr_objective_power(&gains->game->objective, gains->slot_steps);
}

/* ---- memories ---- */

/* There and back, by the kind that is the fastest. */
static uint64_t steps_around(const qtr_gains *gains, unsigned target, unsigned other) {
  uint64_t least = QTR_NEVER;
  for (unsigned kind = 0; kind < gains->kinds; kind++) {
    const qtr_steps there = steps_apart(gains, kind, qtr_targets_place(&gains->environment->targets, target, 0), other);
    const qtr_steps back = steps_apart(gains, kind, qtr_targets_place(&gains->environment->targets, other, 0), target);
    if (there != QTR_NEVER && back != QTR_NEVER && (uint64_t)there + back < least) least = (uint64_t)there + back;
  }
  return least;
}

/* The nearest target that is no neighbour yet; QTR_STAND_DOWN if there is none. */
static unsigned next_neighbour(const qtr_gains *gains, unsigned target) {
  unsigned nearest = QTR_STAND_DOWN;
  uint64_t least = QTR_NEVER;
  for (unsigned other = 0; other < targets_of(gains); other++) {
    if (other == target || qtr_near_bit(&gains->near, target, other) != 0) continue;
    const uint64_t steps = steps_around(gains, target, other);
    if (steps >= least) continue;
    least = steps;
    nearest = other;
  }
  return nearest;
}

static uint32_t gains_a_slot(const qtr_gains *gains) {
  uint32_t row = 0;
  for (unsigned place = 0; place < places_of(gains); place++)
    row += qtr_near_memories(&gains->near, target_of(gains, place));
  return row;
}

static uint64_t room_of(const qtr_gains *gains) {
  return (uint64_t)QTR_BOUND_SLOTS * QTR_GAINS_PER_SLOT * places_of(gains) / (gains->slots + 1);
}

/* One neighbour more for each target, as far as there is room: each doubles what is kept of its target. */
static bool add_neighbours(qtr_gains *gains) {
  uint64_t row = gains_a_slot(gains);
  const uint64_t room = room_of(gains);
  bool added = false;
  for (unsigned target = 0; target < targets_of(gains); target++) {
    const uint64_t more =
        (uint64_t)qtr_near_memories(&gains->near, target) * qtr_targets_size(&gains->environment->targets, target);
    const unsigned neighbour = next_neighbour(gains, target);
    if (neighbour == QTR_STAND_DOWN || row + more > room) continue;
    if (!qtr_near_add(&gains->near, target, neighbour)) continue;
    row += more;
    added = true;
  }
  return added;
}

static void lay_entries(qtr_gains *gains) {
  gains->row = 0;
  for (unsigned place = 0; place < places_of(gains); place++) {
    gains->entry[place] = gains->row;
    gains->row += qtr_near_memories(&gains->near, target_of(gains, place));
  }
}

static qtr_gains_way way_between(const qtr_gains *gains, unsigned kind, unsigned place, unsigned target) {
  const qtr_steps apart = steps_apart(gains, kind, place, target);
  qtr_gains_way way = {QTR_NEVER, 0.0f, 0};
  if (apart == QTR_NEVER) return way;
  way.slots = apart / gains->slot_steps;
  way.share = share_below(qtr_gains_share(gains, way.slots, apart % gains->slot_steps));
  way.entry = gains->entry[first_of(gains, qtr_tour_exit(tour_at(gains, place)), target)] +
              qtr_near_bit(&gains->near, target, target_of(gains, place));
  return way;
}

static void measure_ways(qtr_gains *gains) {
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    for (unsigned place = 0; place < places_of(gains); place++)
      for (unsigned target = 0; target < targets_of(gains); target++)
        ways_from(gains, kind, place)[target] = way_between(gains, kind, place, target);
}

bool qtr_gains_remember_more(qtr_gains *gains) {
  if (!add_neighbours(gains)) return false;
  lay_entries(gains);
  measure_ways(gains);
  return true;
}

void qtr_gains_cut(qtr_gains *gains, qtr_steps last_visit) {
  cut_slots(gains, last_visit);
  add_neighbours(gains);
  lay_entries(gains);
  measure_ways(gains);
}

/* ---- set-up ---- */

/* The board's kinds by their order. */
static unsigned list_kinds(const qtr_board *board, uint8_t *kind_of, uint8_t *first_of_kind) {
  unsigned kinds = 0;
  for (unsigned i = 0; i < board->seekers; i++) {
    unsigned kind = 0;
    while (kind < kinds && kind_of_seeker(&board->keys, first_of_kind[kind]) != kind_of_seeker(&board->keys, i)) kind++;
    if (kind == kinds) first_of_kind[kinds++] = (uint8_t)i;
    kind_of[i] = (uint8_t)kind;
  }
  return kinds;
}

size_t qtr_gains_bytes(const qtr_game *game) {
  uint8_t kind_of[QTR_MAX_SEEKERS];
  uint8_t first_of_kind[QTR_MAX_SEEKERS];
  const size_t kinds = list_kinds(&game->board, kind_of, first_of_kind);
  const size_t places = game->board.places;
  return kinds * places *
             (QTR_BOUND_SLOTS * QTR_GAINS_PER_SLOT * sizeof(double) + sizeof(qtr_gains_way) * places +
              (game->by_legs ? 2 : 1) * sizeof(qtr_steps) * (places + game->board.starts)) +
         places * places * sizeof(qtr_memory);
}

/* The widest first, so that all are aligned. */
static void lay_out(qtr_gains *gains, void *block) {
  const size_t all = (size_t)gains->kinds * places_of(gains);
  gains->gain = block;
  gains->way = (qtr_gains_way *)(gains->gain + QTR_BOUND_SLOTS * QTR_GAINS_PER_SLOT * all);
  gains->travel = (qtr_steps *)(gains->way + all * places_of(gains));
  gains->soonest = gains->game->by_legs ? gains->travel + all * nodes_of(gains) : gains->travel;
  qtr_near_init(&gains->near, (qtr_memory *)(gains->soonest + all * nodes_of(gains)), targets_of(gains));
}

static void unpack_travel(qtr_gains *gains) {
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    for (unsigned node = 0; node < nodes_of(gains); node++)
      for (unsigned place = 0; place < places_of(gains); place++)
        qtr_gains_travel(gains, kind, node)[place] =
            qtr_board_steps(&gains->game->board, seeker_of(gains, kind), node, place);
}

static void find_soonest(qtr_gains *gains) {
  const size_t all = (size_t)gains->kinds * places_of(gains) * nodes_of(gains);
  if (!gains->game->by_legs) return;
  for (size_t i = 0; i < all; i++) gains->soonest[i] = gains->travel[i];
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    qtr_closure_fill(gains->soonest + (size_t)kind * nodes_of(gains) * places_of(gains), nodes_of(gains),
                     places_of(gains));
}

void qtr_gains_init(qtr_gains *gains, void *block, const qtr_environment *environment) {
  /* Times that are estimates bound nothing: regions have no prices. */
  QTR_ASSERT(qtr_sight_is_exact(&environment->sight));
  gains->environment = environment;
  gains->game = environment->game;
  gains->charge = NULL;
  gains->kinds = (uint8_t)list_kinds(&gains->game->board, gains->kind_of, gains->first_of);
  gains->clocked = gains->game->board.terms.end != NULL || gains->game->objective.kind == QTR_DEADLINE;
  lay_out(gains, block);
  unpack_travel(gains);
  find_soonest(gains);
}

void qtr_gains_charge(qtr_gains *gains, const double *charge) {
  gains->charge = charge;
}

/* ---- the walks of one seeker ---- */

/* What the tour begun at `place` is worth, net of its price: sum of worth(p_i, t + s_i) - lambda, s_i the step of its
 * visit i. */
static double net_worth(const qtr_gains *gains, const double *price, unsigned place, qtr_steps when) {
  const qtr_tour *tour = tour_at(gains, place);
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

/* All that is left, collected at once at the first step past the last slot. From there on a real walk visits each
 * target once at most, and not before: the sum of what is above 0 bounds it. Its first target it cannot refuse any
 * more. */
static void fill_late(qtr_gains *gains, const double *price) {
  const qtr_steps end = gains->slots * gains->slot_steps;
  double all = 0.0;
  for (unsigned target = 0; target < targets_of(gains); target++) {
    const double net = target_worth(gains, target, end) - price[target];
    all += net > 0.0 ? net : 0.0;
  }
  for (unsigned kind = 0; kind < gains->kinds; kind++) {
    for (unsigned place = 0; place < places_of(gains); place++) {
      const unsigned target = target_of(gains, place);
      const double net = target_worth(gains, target, end) - price[target];
      const double late = all + (net > 0.0 ? 0.0 : net) + qtr_gains_go_home(gains, kind, QTR_STAND_DOWN, end);
      for (unsigned memory = 0; memory < qtr_near_memories(&gains->near, target); memory++)
        gains_in(gains, kind, gains->slots)[gains->entry[place] + memory] = late;
    }
  }
}

/* ---- ways on from a place at a slot ---- */

/* The best ways on, best first, of a walk that remembers nothing; more memory is never worth more. */
typedef struct {
  double value[LISTED];
  uint16_t target[LISTED];
  unsigned count;
  double unlisted; /* the most that any other is worth */
} ways_on;

/* What a walk at a slot collects that goes a way, and stands there so many entries on. */
static inline double follow(const qtr_gains *gains, const double *now, uint32_t slots_left, const qtr_gains_way *way,
                            uint32_t entry) {
  const uint32_t then = way->slots < slots_left ? way->slots : slots_left;
  const double *in = now + (size_t)then * gains->row + entry;
  if (way->share == 0.0f || then == slots_left) return *in;
  return *in + (double)way->share * (in[gains->row] - *in);
}

static void list_way(ways_on *on, double value, unsigned target) {
  unsigned i = on->count;
  if (on->count == LISTED) {
    const double dropped = value > on->value[LISTED - 1] ? on->value[LISTED - 1] : value;
    if (dropped > on->unlisted) on->unlisted = dropped;
    if (dropped == value) return;
    i--;
  } else {
    on->count++;
  }
  for (; i > 0 && on->value[i - 1] < value; i--) {
    on->value[i] = on->value[i - 1];
    on->target[i] = on->target[i - 1];
  }
  on->value[i] = value;
  on->target[i] = (uint16_t)target;
}

static void list_ways(const qtr_gains *gains, unsigned kind, uint32_t slot, unsigned place, double least, ways_on *on) {
  const qtr_gains_way *ways = ways_from(gains, kind, place);
  const double *now = gains_in(gains, kind, slot);
  const uint32_t slots_left = gains->slots - slot;
  on->count = 0;
  on->unlisted = least;
  for (unsigned target = 0; target < targets_of(gains); target++) {
    if (ways[target].slots == QTR_NEVER) continue;
    /* Walks move on in time: C(t, p) needs later slots alone, and those have been filled. */
    QTR_ASSERT(ways[target].slots > 0);
    const double value = follow(gains, now, slots_left, &ways[target], ways[target].entry) -
                         qtr_gains_charge_of(gains, target_of(gains, place), target);
    if (value > least) list_way(on, value, target);
  }
}

/* What a walk with a memory at `place` collects that goes on to `target`; -HUGE_VAL if it has been there, as far as it
 * remembers. */
static double go_on(const qtr_gains *gains, unsigned kind, uint32_t slot, unsigned place, qtr_memory memory,
                    unsigned target) {
  const unsigned here = target_of(gains, place);
  const qtr_gains_way *way = &ways_from(gains, kind, place)[target];
  if (way->slots == QTR_NEVER || (qtr_near_bit(&gains->near, here, target) & memory) != 0) return -HUGE_VAL;
  const qtr_memory then = qtr_near_move(&gains->near, here, memory, target);
  return follow(gains, gains_in(gains, kind, slot), gains->slots - slot, way,
                way->entry + then - qtr_near_bit(&gains->near, target, here)) -
         qtr_gains_charge_of(gains, here, target);
}

/* The most that any way on is worth with a memory, and no less than `best`. */
static double best_on(const qtr_gains *gains, unsigned kind, uint32_t slot, unsigned place, qtr_memory memory,
                      const ways_on *on, double best) {
  for (unsigned i = 0; i < on->count && on->value[i] > best; i++) {
    const double value = go_on(gains, kind, slot, place, memory, on->target[i]);
    if (value > best) best = value;
  }
  if (on->unlisted <= best) return best;
  for (unsigned target = 0; target < targets_of(gains); target++) {
    const double value = go_on(gains, kind, slot, place, memory, target);
    if (value > best) best = value;
  }
  return best;
}

/* C(t, j, memory) with the tour that it begins: net(j, t) + max(0, max over p of C(t + d(j, p), p, memory there)), d
 * from tour's start to start. A tour that leaves no time to go home is none. */
static void fill_gains(qtr_gains *gains, unsigned kind, uint32_t slot, unsigned place, double net) {
  const qtr_tour *tour = tour_at(gains, place);
  const unsigned memories = qtr_near_memories(&gains->near, tour->target);
  const qtr_steps done = slot * gains->slot_steps + qtr_tour_length(tour);
  double *gain = gains_in(gains, kind, slot) + gains->entry[place];
  ways_on on;
  if (!qtr_gains_in_time(gains, kind, qtr_tour_exit(tour), done)) {
    for (unsigned memory = 0; memory < memories; memory++) gain[memory] = -HUGE_VAL;
    return;
  }
  const double home = qtr_gains_go_home(gains, kind, qtr_tour_exit(tour), done);
  list_ways(gains, kind, slot, place, home, &on);
  for (unsigned memory = 0; memory < memories; memory++)
    gain[memory] = net + best_on(gains, kind, slot, place, (qtr_memory)memory, &on, home);
}

/* Backwards in time, for each slot rests on later ones alone. False: stopped, and the gains are those of no prices. */
bool qtr_gains_fill(qtr_gains *gains, const double *price) {
  fill_late(gains, price);
  for (uint32_t slot = gains->slots; slot-- > 0;) {
    if (slot % WATCH_SLOTS == 0 && !qtr_watch_go_on(&gains->game->mission->watch)) return false;
    for (unsigned place = 0; place < places_of(gains); place++) {
      if (tour_at(gains, place)->places == 0) continue;
      const double net = net_worth(gains, price, place, slot * gains->slot_steps);
      for (unsigned kind = 0; kind < gains->kinds; kind++) fill_gains(gains, kind, slot, place, net);
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

/* Go to where most can be collected, and say what; QTR_STAND_DOWN: it stays, which is best. */
static unsigned walk_on(const qtr_gains *gains, unsigned kind, walker *at, double *collected) {
  const qtr_steps *travel = qtr_gains_travel(gains, kind, at->node);
  const unsigned here = target_at(gains, at->node);
  unsigned best = QTR_STAND_DOWN;
  walker then = *at;
  *collected = qtr_gains_go_home(gains, kind, at->node, at->when);
  for (unsigned target = 0; target < targets_of(gains); target++) {
    const uint16_t first = first_of(gains, at->node, target);
    if (target == here || first == QTR_STAND_DOWN || travel[first] == QTR_NEVER) continue;
    if (here != QTR_STAND_DOWN && (qtr_near_bit(&gains->near, here, target) & at->memory) != 0) continue;
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

double qtr_gains_walk(const qtr_gains *gains, unsigned seeker, int *visits) {
  const qtr_board *board = &gains->game->board;
  const unsigned kind = gains->kind_of[seeker];
  walker at = {(unsigned)board->places + board->start_of[seeker], qtr_board_ready(board, seeker), 0};
  double all, rest;
  unsigned target = walk_on(gains, kind, &at, &all);
  while (target != QTR_STAND_DOWN) {
    visits[target]++;
    if (at.when / gains->slot_steps >= gains->slots) break;
    const qtr_tour *tour = tour_at(gains, at.node);
    at.node = qtr_tour_exit(tour);
    at.when += qtr_tour_length(tour);
    target = walk_on(gains, kind, &at, &rest);
  }
  return all;
}
