#include "search/gains.h"

#include <math.h>

#include "model/rounding.h"
#include "quarter/status.h"
#include "robot/board.h"

#define WATCH_SLOTS 32u /* filled from one asking of the watch to the next */
#define HORIZON 2u      /* slots reach so many times as far as the last visit of the play known */

static unsigned places_of(const qtr_gains *gains) {
  return gains->game->board.places;
}

static unsigned targets_of(const qtr_gains *gains) {
  return gains->environment->targets.count;
}

static unsigned nodes_of(const qtr_gains *gains) {
  return places_of(gains) + gains->game->board.starts;
}

static uint32_t *apart_from(const qtr_gains *gains, unsigned kind, unsigned place) {
  return gains->slots_apart + ((size_t)kind * places_of(gains) + place) * targets_of(gains);
}

static qtr_gain *gains_in(const qtr_gains *gains, unsigned kind, uint32_t slot) {
  return gains->gain + ((size_t)kind * gains->slots + slot) * places_of(gains);
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

/* The steps that slots are to reach: beyond the deadline nothing is worth anything, and that is what counts there. */
static uint64_t horizon_of(const qtr_gains *gains, qtr_steps last_visit) {
  const qtr_objective *objective = &gains->game->objective;
  uint64_t horizon = (uint64_t)last_visit * HORIZON + gains->environment->board.keys.longest + 2;
  if (horizon > QTR_NEVER / 2) horizon = QTR_NEVER / 2;
  if (objective->kind == QTR_DEADLINE && horizon > objective->deadline) horizon = (uint64_t)objective->deadline + 1;
  return horizon;
}

/* Slots as short as the horizon allows, but never longer than the shortest way between two targets: a walk must move on
 * in time. */
void qtr_gains_cut(qtr_gains *gains, qtr_steps last_visit) {
  const qtr_steps shortest = shortest_apart(gains);
  /* Places lie on different cells, and each step takes one of time; so do looks at one place. */
  QTR_ASSERT(shortest > 0);
  const uint64_t horizon = horizon_of(gains, last_visit);
  uint64_t steps = (horizon + QTR_BOUND_SLOTS - 1) / QTR_BOUND_SLOTS;
  if (steps > shortest) steps = shortest;
  const uint64_t slots = (horizon + steps - 1) / steps;
  gains->slot_steps = (qtr_steps)steps;
  gains->slots = (uint32_t)(slots < QTR_BOUND_SLOTS ? slots : QTR_BOUND_SLOTS);
  for (unsigned kind = 0; kind < gains->kinds; kind++) {
    for (unsigned place = 0; place < places_of(gains); place++) {
      for (unsigned target = 0; target < targets_of(gains); target++) {
        const qtr_steps apart = steps_apart(gains, kind, place, target);
        apart_from(gains, kind, place)[target] = apart == QTR_NEVER ? QTR_NEVER : apart / gains->slot_steps;
      }
    }
  }
}

/* ---- set-up ---- */

/* The board's kinds by their order. */
static unsigned list_kinds(const qtr_board *board, uint8_t *kind_of, uint8_t *first_of_kind) {
  unsigned kinds = 0;
  for (unsigned i = 0; i < board->seekers; i++) {
    unsigned kind = 0;
    while (kind < kinds && board->keys.kind[first_of_kind[kind]] != board->keys.kind[i]) kind++;
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
         (QTR_BOUND_SLOTS * sizeof(qtr_gain) + sizeof(double) + sizeof(qtr_steps) * (places + game->board.starts) +
          sizeof(uint32_t) * places);
}

/* The widest first, so that all are aligned. */
static void lay_out(qtr_gains *gains, void *block) {
  const size_t all = (size_t)gains->kinds * places_of(gains);
  gains->gain = block;
  gains->late = (double *)(gains->gain + QTR_BOUND_SLOTS * all);
  gains->travel = (qtr_steps *)(gains->late + all);
  gains->slots_apart = gains->travel + all * nodes_of(gains);
}

static void unpack_travel(qtr_gains *gains) {
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    for (unsigned node = 0; node < nodes_of(gains); node++)
      for (unsigned place = 0; place < places_of(gains); place++)
        qtr_gains_travel(gains, kind, node)[place] =
            qtr_board_steps(&gains->game->board, seeker_of(gains, kind), node, place);
}

void qtr_gains_init(qtr_gains *gains, void *block, const qtr_environment *environment) {
  /* Times that are estimates bound nothing: regions have no prices. */
  QTR_ASSERT(qtr_sight_is_exact(&environment->sight));
  gains->environment = environment;
  gains->game = environment->game;
  gains->kinds = (uint8_t)list_kinds(&gains->game->board, gains->kind_of, gains->first_of);
  lay_out(gains, block);
  unpack_travel(gains);
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
      gains->late[(size_t)kind * places_of(gains) + place] =
          all + (net > 0.0 ? 0.0 : net) + qtr_gains_go_home(gains, kind, QTR_STAND_DOWN, end);
    }
  }
}

/* C(t, j) with the tour that it begins: net(j, t) + max(0, max over p of C(t + d(j, p), p)), d from tour's start to
 * start. A tour that leaves no time to go home is none. */
static void fill_gain(qtr_gains *gains, unsigned kind, uint32_t slot, unsigned place, double net) {
  const qtr_tour *tour = tour_at(gains, place);
  const qtr_gains_view view = qtr_gains_of(gains, kind);
  const unsigned targets = targets_of(gains);
  const uint16_t exit = qtr_tour_exit(tour);
  const uint32_t *apart = apart_from(gains, kind, place);
  const uint16_t *first = &gains->environment->targets.first[(size_t)exit * targets];
  const uint16_t here = tour->target;
  const qtr_steps when = slot * gains->slot_steps;
  qtr_gain *gain = &gains_in(gains, kind, slot)[place];
  uint16_t to = QTR_STAND_DOWN;
  uint16_t other = QTR_STAND_DOWN;
  if (!qtr_gains_in_time(gains, kind, exit, when + qtr_tour_length(tour))) {
    *gain = (qtr_gain){-HUGE_VAL, -HUGE_VAL, to, other};
    return;
  }
  double best = qtr_gains_go_home(gains, kind, exit, when + qtr_tour_length(tour));
  double second = best;
  for (unsigned target = 0; target < targets; target++) {
    if (apart[target] == QTR_NEVER) continue;
    /* Walks move on in time: C(t, p) needs later slots alone, and those have been filled. */
    QTR_ASSERT(apart[target] > 0);
    const double on = qtr_gains_in_slot(&view, here, first[target], slot + apart[target]);
    if (on <= second) continue;
    if (on > best) {
      second = best;
      other = to;
      best = on;
      to = (uint16_t)target;
    } else {
      second = on;
      other = (uint16_t)target;
    }
  }
  gain->best = net + best;
  gain->second = net + second;
  gain->to = to;
  gain->other = other;
}

/* Backwards in time, for each slot rests on later ones alone. False: stopped, and the gains are those of no prices. */
bool qtr_gains_fill(qtr_gains *gains, const double *price) {
  fill_late(gains, price);
  for (uint32_t slot = gains->slots; slot-- > 0;) {
    if (slot % WATCH_SLOTS == 0 && !qtr_watch_go_on(&gains->game->mission->watch)) return false;
    for (unsigned place = 0; place < places_of(gains); place++) {
      if (tour_at(gains, place)->places == 0) continue;
      const double net = net_worth(gains, price, place, slot * gains->slot_steps);
      for (unsigned kind = 0; kind < gains->kinds; kind++) fill_gain(gains, kind, slot, place, net);
    }
  }
  return true;
}

/* The first target of the best walk of a seeker from its start; QTR_STAND_DOWN if staying is best. */
static uint16_t first_of_walk(const qtr_gains *gains, unsigned seeker, unsigned start_node, double *collected) {
  const unsigned kind = gains->kind_of[seeker];
  const qtr_steps *travel = qtr_gains_travel(gains, kind, start_node);
  const qtr_steps ready = qtr_board_ready(&gains->game->board, seeker);
  const qtr_gains_view view = qtr_gains_of(gains, kind);
  uint16_t best = QTR_STAND_DOWN;
  *collected = qtr_gains_go_home(gains, kind, start_node, ready);
  for (unsigned target = 0; target < targets_of(gains); target++) {
    const uint16_t first = first_of(gains, start_node, target);
    if (first == QTR_STAND_DOWN || travel[first] == QTR_NEVER) continue;
    const double gain = qtr_gains_at(&view, QTR_STAND_DOWN, first, ready + travel[first]);
    if (gain <= *collected) continue;
    *collected = gain;
    best = (uint16_t)target;
  }
  return best;
}

/* The walk that C stands for, followed forwards: what the prices are tuned by. */
double qtr_gains_walk(const qtr_gains *gains, unsigned seeker, int *visits) {
  const qtr_board *board = &gains->game->board;
  const unsigned kind = gains->kind_of[seeker];
  unsigned node = (unsigned)board->places + board->start_of[seeker];
  unsigned from = QTR_STAND_DOWN;
  uint32_t slot = 0;
  double collected;
  uint16_t target = first_of_walk(gains, seeker, node, &collected);
  while (target != QTR_STAND_DOWN) {
    const uint16_t first = first_of(gains, node, target);
    visits[target]++;
    slot = from == QTR_STAND_DOWN
               ? (qtr_board_ready(board, seeker) + qtr_gains_travel(gains, kind, node)[first]) / gains->slot_steps
               : slot + apart_from(gains, kind, from)[target];
    if (slot >= gains->slots) break;
    const qtr_tour *tour = tour_at(gains, first);
    const qtr_gain *gain = &gains_in(gains, kind, slot)[first];
    const unsigned before = target_at(gains, node);
    node = tour->place[tour->places - 1];
    from = first;
    target = before != QTR_STAND_DOWN && gain->to == before ? gain->other : gain->to;
  }
  return collected;
}
