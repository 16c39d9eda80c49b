#include "search/gains.h"

#include <math.h>

#include "model/rounding.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "search/closure.h"
#include "search/rows.h"

#define FINE_SLOTS 512u  /* as many are enough where nothing depends on the clock */
#define SHORT_TUNING 24u /* places: prices of no more than that are tuned in a few steps */
#define LONG_ROUTE 10u   /* places a seeker */

static unsigned nodes_of(const qtr_gains *gains) {
  return gains_places(gains) + gains->game->board.starts;
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

static qtr_steps shortest_apart(const qtr_gains *gains) {
  qtr_steps shortest = QTR_NEVER;
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    for (unsigned place = 0; place < gains_places(gains); place++)
      for (unsigned target = 0; target < gains_targets(gains); target++)
        if (qtr_ways_apart(gains, kind, place, target) < shortest)
          shortest = qtr_ways_apart(gains, kind, place, target);
  return shortest;
}

/* The steps that slots are to reach, a quarter further than the last visit of the play known: beyond the deadline
 * nothing is worth anything, and that is what counts there. Where ways home count or run out, a leg further: what is
 * past the last slot is taken for collected by whoever is nearest home. */
static uint64_t horizon_of(const qtr_gains *gains, qtr_steps last_visit) {
  const qtr_objective *objective = &gains->game->objective;
  uint64_t horizon = (uint64_t)last_visit * 5 / 4 + 2;
  if (gains->game->board.terms.end != NULL || objective->terms.home_weight != 0.0)
    horizon += gains->environment->board.keys.longest;
  if (horizon > QTR_NEVER / 2) horizon = QTR_NEVER / 2;
  if (objective->kind == QTR_DEADLINE && horizon > objective->deadline) horizon = (uint64_t)objective->deadline + 1;
  return horizon;
}

/* ---- slots ---- */

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
    const qtr_steps there =
        qtr_ways_apart(gains, kind, qtr_targets_place(&gains->environment->targets, target, 0), other);
    const qtr_steps back =
        qtr_ways_apart(gains, kind, qtr_targets_place(&gains->environment->targets, other, 0), target);
    if (there != QTR_NEVER && back != QTR_NEVER && (uint64_t)there + back < least) least = (uint64_t)there + back;
  }
  return least;
}

/* The nearest target that is no neighbour yet; QTR_STAND_DOWN if there is none. Looks at one place are none of each
 * other's. */
static unsigned next_neighbour(const qtr_gains *gains, unsigned target) {
  unsigned nearest = QTR_STAND_DOWN;
  uint64_t least = QTR_NEVER;
  for (unsigned other = 0; other < gains_targets(gains); other++) {
    if (qtr_looks_first(&gains->looks, other) == qtr_looks_first(&gains->looks, target)) continue;
    if (qtr_near_bit(&gains->near, target, other) != 0) continue;
    const uint64_t steps = steps_around(gains, target, other);
    if (steps >= least) continue;
    least = steps;
    nearest = other;
  }
  return nearest;
}

static uint32_t gains_a_slot(const qtr_gains *gains) {
  uint32_t row = 1;
  for (unsigned place = 0; place < gains_places(gains); place++)
    row += gains_best_ahead(gains, gains_target_of(gains, place)) +
           qtr_near_memories(&gains->near, gains_target_of(gains, place));
  return row;
}

static uint64_t room_of(const qtr_gains *gains) {
  return (uint64_t)QTR_BOUND_SLOTS * QTR_GAINS_PER_SLOT * gains_places(gains) / (gains->slots + 1);
}

/* Gains that a memory of a target takes in a slot: for each of its places, or of the looks at one and the best. */
static unsigned gains_a_memory(const qtr_gains *gains, unsigned first) {
  unsigned count = qtr_targets_size(&gains->environment->targets, first) + qtr_looks_are_several(&gains->looks, first);
  for (unsigned look = qtr_looks_next(&gains->looks, first); look != QTR_STAND_DOWN;
       look = qtr_looks_next(&gains->looks, look))
    count++;
  return count;
}

/* Looks at one place have the same neighbours. False: there is no room. */
static bool add_neighbour(qtr_gains *gains, unsigned first, unsigned neighbour, uint64_t *row) {
  const uint64_t more = (uint64_t)qtr_near_memories(&gains->near, first) * gains_a_memory(gains, first);
  if (*row + more > room_of(gains) || gains->near.count[first] == QTR_NEAR_MOST) return false;
  for (unsigned look = first; look != QTR_STAND_DOWN; look = qtr_looks_next(&gains->looks, look))
    qtr_near_add(&gains->near, look, neighbour);
  *row += more;
  return true;
}

/* One neighbour more for each target, as far as there is room: each doubles what is kept of its target. */
static bool add_neighbours(qtr_gains *gains) {
  uint64_t row = gains_a_slot(gains);
  bool added = false;
  for (unsigned target = 0; target < gains->looks.firsts; target++) {
    const unsigned neighbour = next_neighbour(gains, target);
    if (neighbour != QTR_STAND_DOWN && add_neighbour(gains, target, neighbour, &row)) added = true;
  }
  return added;
}

static void lay_entries(qtr_gains *gains) {
  gains->row = 1;
  for (unsigned place = 0; place < gains_places(gains); place++) {
    const unsigned target = gains_target_of(gains, place);
    gains->entry[place] = gains->row + gains_best_ahead(gains, target);
    gains->row = gains->entry[place] + qtr_near_memories(&gains->near, target);
  }
}

bool qtr_gains_remember_more(qtr_gains *gains) {
  if (!add_neighbours(gains)) return false;
  gains->fillings++;
  lay_entries(gains);
  qtr_ways_measure(gains);
  return true;
}

/* To begin with. On long routes walks turn back more often, and more steps of the prices pay for what more neighbours
 * take. Of looks each is a neighbour of its own. */
static unsigned first_neighbours(const qtr_gains *gains) {
  const unsigned places = gains_places(gains);
  if (qtr_looks_in_use(&gains->looks)) return places > SHORT_TUNING ? 3 : 2;
  return places > SHORT_TUNING && places >= LONG_ROUTE * gains->game->board.seekers ? 2 : 1;
}

void qtr_gains_cut(qtr_gains *gains, qtr_steps last_visit) {
  cut_slots(gains, last_visit);
  for (unsigned count = first_neighbours(gains); count > 0; count--) add_neighbours(gains);
  lay_entries(gains);
  qtr_ways_measure(gains);
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
  const size_t all = (size_t)gains->kinds * gains_places(gains);
  gains->gain = block;
  gains->way = (qtr_gains_way *)(gains->gain + QTR_BOUND_SLOTS * QTR_GAINS_PER_SLOT * all);
  gains->travel = (qtr_steps *)(gains->way + all * gains_places(gains));
  gains->soonest = gains->game->by_legs ? gains->travel + all * nodes_of(gains) : gains->travel;
  qtr_near_init(&gains->near, (qtr_memory *)(gains->soonest + all * nodes_of(gains)), &gains->looks);
}

static void unpack_travel(qtr_gains *gains) {
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    for (unsigned node = 0; node < nodes_of(gains); node++)
      for (unsigned place = 0; place < gains_places(gains); place++)
        qtr_gains_travel(gains, kind, node)[place] =
            qtr_board_steps(&gains->game->board, seeker_of(gains, kind), node, place);
}

static void find_soonest(qtr_gains *gains) {
  const size_t all = (size_t)gains->kinds * gains_places(gains) * nodes_of(gains);
  if (!gains->game->by_legs) return;
  for (size_t i = 0; i < all; i++) gains->soonest[i] = gains->travel[i];
  for (unsigned kind = 0; kind < gains->kinds; kind++)
    qtr_closure_fill(gains->soonest + (size_t)kind * nodes_of(gains) * gains_places(gains), nodes_of(gains),
                     gains_places(gains));
}

void qtr_gains_init(qtr_gains *gains, void *block, const qtr_environment *environment) {
  /* Times that are estimates bound nothing: regions have no prices. */
  QTR_ASSERT(qtr_sight_is_exact(&environment->sight));
  gains->environment = environment;
  gains->game = environment->game;
  gains->charge = NULL;
  gains->fillings = 0;
  gains->kinds = (uint8_t)list_kinds(&gains->game->board, gains->kind_of, gains->first_of);
  qtr_looks_init(&gains->looks, environment);
  gains->clocked = gains->game->board.terms.end != NULL || gains->game->objective.kind == QTR_DEADLINE;
  lay_out(gains, block);
  unpack_travel(gains);
  find_soonest(gains);
}

void qtr_gains_charge(qtr_gains *gains, const double *charge) {
  gains->charge = charge;
  gains->fillings++;
}
