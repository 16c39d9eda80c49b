#include "quarter/bound.h"

#include <stddef.h>

#define LEAST_POWER 1e-250
#define SCALE_FIRST 2.0 /* of Polyak's step; 2 is the most for which it converges */
#define SCALE_LEAST 0.005
#define SCALE_SHRINK 0.7
#define PATIENCE 12u /* steps without gain before the scale shrinks */
#define HORIZON 2u   /* slots reach so many times as far as the last visit of the play known */

static unsigned places_of(const qtr_bound *bound) {
  return bound->game->board.places;
}

static const qtr_steps *travel_from(const qtr_bound *bound, unsigned node) {
  return bound->travel + (size_t)node * places_of(bound);
}

/* ---- the walks of one seeker ---- */

/* What a walk from place or start `from` collects that comes to `place` in `slot`: it may not go straight back. */
static double gain_in(const qtr_bound *bound, unsigned from, unsigned place, uint32_t slot) {
  if (slot >= bound->slots) return bound->late[place];
  const qtr_gain *gain = &bound->gain[(size_t)slot * places_of(bound) + place];
  return gain->to == from ? gain->second : gain->best;
}

static double gain_at(const qtr_bound *bound, unsigned from, unsigned place, qtr_steps when) {
  return gain_in(bound, from, place, bound->slot_steps == 1 ? when : when / bound->slot_steps);
}

/* All that is left, collected at once at the first step past the last slot. */
static void fill_late(qtr_bound *bound, const double *price) {
  const unsigned places = places_of(bound);
  const qtr_steps end = bound->slots * bound->slot_steps;
  double all = 0.0;
  for (unsigned place = 0; place < places; place++) {
    const double net = qtr_game_worth(bound->game, place, end) - price[place];
    all += net > 0.0 ? net : 0.0;
  }
  for (unsigned place = 0; place < places; place++) {
    const double net = qtr_game_worth(bound->game, place, end) - price[place];
    bound->late[place] = all + (net > 0.0 ? 0.0 : net);
  }
}

static void fill_gain(qtr_bound *bound, uint32_t slot, unsigned at, double net) {
  const unsigned places = places_of(bound);
  const uint32_t *apart = bound->slots_apart + (size_t)at * places;
  qtr_gain *gain = &bound->gain[(size_t)slot * places + at];
  double best = 0.0;
  double second = 0.0;
  uint16_t to = QTR_STAND_DOWN;
  uint16_t other = QTR_STAND_DOWN;
  for (unsigned place = 0; place < places; place++) {
    if (place == at || apart[place] == QTR_NEVER) continue;
    const double on = gain_in(bound, at, place, slot + apart[place]);
    if (on <= second) continue;
    if (on > best) {
      second = best;
      other = to;
      best = on;
      to = (uint16_t)place;
    } else {
      second = on;
      other = (uint16_t)place;
    }
  }
  gain->best = net + best;
  gain->second = net + second;
  gain->to = to;
  gain->other = other;
}

static void fill_gains(qtr_bound *bound, const double *price) {
  fill_late(bound, price);
  for (uint32_t slot = bound->slots; slot-- > 0;) {
    for (unsigned place = 0; place < places_of(bound); place++) {
      const double worth = qtr_game_worth(bound->game, place, slot * bound->slot_steps);
      fill_gain(bound, slot, place, worth - price[place]);
    }
  }
}

/* The first place of the best walk from a start; QTR_STAND_DOWN if staying is best. */
static uint16_t first_of_walk(const qtr_bound *bound, unsigned start_node, double *collected) {
  const qtr_steps *travel = travel_from(bound, start_node);
  uint16_t first = QTR_STAND_DOWN;
  *collected = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++) {
    if (travel[place] == QTR_NEVER) continue;
    const double gain = gain_at(bound, start_node, place, travel[place]);
    if (gain <= *collected) continue;
    *collected = gain;
    first = (uint16_t)place;
  }
  return first;
}

static void count_walk(const qtr_bound *bound, unsigned start_node, uint16_t first, int *visits) {
  unsigned from = start_node;
  uint16_t at = first;
  qtr_steps now = 0;
  while (at != QTR_STAND_DOWN) {
    visits[at]++;
    now += travel_from(bound, from)[at];
    const uint32_t slot = now / bound->slot_steps;
    if (slot >= bound->slots) return;
    now = slot * bound->slot_steps;
    const qtr_gain *gain = &bound->gain[(size_t)slot * places_of(bound) + at];
    const uint16_t next = gain->to == from ? gain->other : gain->to;
    from = at;
    at = next;
  }
}

/* The bound under `price`; adds up how often the seekers' best walks visit each place. */
static double evaluate(qtr_bound *bound, const double *price, int *visits) {
  const qtr_board *board = &bound->game->board;
  double upper = 0.0;
  fill_gains(bound, price);
  for (unsigned place = 0; place < board->places; place++) {
    upper += price[place];
    visits[place] = 0;
  }
  for (unsigned seeker = 0; seeker < board->seekers; seeker++) {
    const unsigned node = (unsigned)board->places + board->start_of[seeker];
    double collected;
    count_walk(bound, node, first_of_walk(bound, node, &collected), visits);
    upper += collected;
  }
  return upper;
}

/* ---- prices ---- */

/* Slots as short as the horizon allows, but never longer than the shortest way between two places: a walk must move on
 * in time. */
static void cut_time(qtr_bound *bound, qtr_steps last_visit) {
  const qtr_board *board = &bound->game->board;
  qtr_steps shortest = QTR_NEVER;
  for (unsigned from = 0; from < board->places; from++)
    for (unsigned to = 0; to < board->places; to++)
      if (from != to && travel_from(bound, from)[to] < shortest) shortest = travel_from(bound, from)[to];
  const uint64_t horizon = (uint64_t)last_visit * HORIZON + board->longest + 2;
  uint64_t steps = (horizon + QTR_BOUND_SLOTS - 1) / QTR_BOUND_SLOTS;
  if (steps > shortest) steps = shortest;
  const uint64_t slots = (horizon + steps - 1) / steps;
  bound->slot_steps = (qtr_steps)steps;
  bound->slots = (uint32_t)(slots < QTR_BOUND_SLOTS ? slots : QTR_BOUND_SLOTS);
}

static void measure_slots(qtr_bound *bound) {
  const qtr_board *board = &bound->game->board;
  const size_t pairs = (size_t)(board->places + board->starts) * board->places;
  for (size_t i = 0; i < pairs; i++)
    bound->slots_apart[i] = bound->travel[i] == QTR_NEVER ? QTR_NEVER : bound->travel[i] / bound->slot_steps;
}

void qtr_bound_init(qtr_bound *bound, const qtr_game *game, const qtr_steps *visit) {
  const qtr_board *board = &game->board;
  qtr_steps last = 0;
  bound->game = game;
  for (unsigned node = 0; node < (unsigned)board->places + board->starts; node++)
    for (unsigned place = 0; place < board->places; place++)
      bound->travel[(size_t)node * board->places + place] = qtr_board_steps(board, node, place);
  for (unsigned place = 0; place < board->places; place++) {
    bound->trial[place] = qtr_game_worth(game, place, visit[place]);
    bound->price[place] = bound->trial[place];
    if (visit[place] > last) last = visit[place];
  }
  cut_time(bound, last);
  measure_slots(bound);
  bound->scale = SCALE_FIRST;
  bound->iterations = 0;
  bound->steps_without_gain = 0;
  int visits[QTR_MAX_PLACES];
  bound->upper = evaluate(bound, bound->price, visits);
}

static void keep_trial(qtr_bound *bound, double upper) {
  bound->upper = upper;
  for (unsigned place = 0; place < places_of(bound); place++) bound->price[place] = bound->trial[place];
}

static void restart_from_best(qtr_bound *bound) {
  for (unsigned place = 0; place < places_of(bound); place++) bound->trial[place] = bound->price[place];
}

/* Polyak's step: as far as would reach the target if the bound fell on as it falls here. */
static bool move_trial(qtr_bound *bound, double upper, double target, const int *visits) {
  double square = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++)
    square += (double)((visits[place] - 1) * (visits[place] - 1));
  if (square == 0.0) return false;
  const double step = bound->scale * (upper - target) / square;
  for (unsigned place = 0; place < places_of(bound); place++) {
    bound->trial[place] += step * (double)(visits[place] - 1);
    if (bound->game->mission->objective == QTR_DISCOUNTED && bound->trial[place] < 0.0) bound->trial[place] = 0.0;
  }
  return true;
}

bool qtr_bound_improve(qtr_bound *bound, double target) {
  int visits[QTR_MAX_PLACES];
  const double upper = evaluate(bound, bound->trial, visits);
  bound->iterations++;
  /* Less than a thousandth of the way to the target is no gain: or the steps would never end. */
  const bool gained = upper < bound->upper - 1e-3 * (bound->upper - target);
  if (upper < bound->upper) keep_trial(bound, upper);
  if (gained) {
    bound->steps_without_gain = 0;
  } else if (++bound->steps_without_gain >= PATIENCE) {
    bound->steps_without_gain = 0;
    bound->scale *= SCALE_SHRINK;
    restart_from_best(bound);
    evaluate(bound, bound->trial, visits);
  }
  return upper > target && bound->scale >= SCALE_LEAST && move_trial(bound, upper, target, visits);
}

void qtr_bound_settle(qtr_bound *bound) {
  fill_gains(bound, bound->price);
}

/* ---- states ---- */

static bool is_free_place(const qtr_joint *after, unsigned place) {
  return !qtr_places_has(&after->visited, place) && !qtr_places_has(&after->bound, place);
}

/* The most that one seeker can collect from its next free moment on, its first step going to a free place. */
static double collect_on(const qtr_bound *bound, const qtr_joint *after, unsigned node, qtr_steps when) {
  const qtr_steps *travel = travel_from(bound, node);
  double best = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++) {
    if (travel[place] == QTR_NEVER || !is_free_place(after, place)) continue;
    const double gain = gain_at(bound, node, place, when + travel[place]);
    if (gain > best) best = gain;
  }
  return best;
}

/* When the first of the seekers can be at a place. */
static qtr_steps soonest(const qtr_bound *bound, const qtr_joint *after, unsigned place, qtr_steps now) {
  qtr_steps least = QTR_NEVER;
  for (unsigned i = 0; i < bound->game->board.seekers; i++) {
    if (after->node[i] == QTR_STAND_DOWN) continue;
    const qtr_steps way = after->node[i] == place ? 0 : travel_from(bound, after->node[i])[place];
    if (way != QTR_NEVER && now + after->remaining[i] + way < least) least = now + after->remaining[i] + way;
  }
  return least;
}

/* Visits under way. Under the paper's rule another seeker may come before the one that is bound for the place. */
static double worth_under_way(const qtr_bound *bound, const qtr_joint *after, qtr_steps now) {
  const qtr_board *board = &bound->game->board;
  double worth = 0.0;
  for (unsigned i = 0; i < board->seekers && board->rule == QTR_RULE_FREE; i++)
    if (after->remaining[i] > 0) worth += qtr_game_worth(bound->game, after->node[i], now + after->remaining[i]);
  for (unsigned place = 0; place < board->places && board->rule == QTR_RULE_PAPER; place++)
    if (qtr_places_has(&after->bound, place))
      worth += qtr_game_worth(bound->game, place, soonest(bound, after, place, now));
  return worth;
}

static double bound_by_prices(const qtr_bound *bound, const qtr_joint *after, qtr_steps now) {
  double upper = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++)
    if (is_free_place(after, place)) upper += bound->price[place];
  for (unsigned i = 0; i < bound->game->board.seekers; i++)
    if (after->node[i] != QTR_STAND_DOWN)
      upper += collect_on(bound, after, after->node[i], now + after->remaining[i]);
  return upper;
}

/* The plain bound: every free place reached by whoever gets there soonest, all at once. */
static double bound_all_at_once(const qtr_bound *bound, const qtr_joint *after, qtr_steps now) {
  double upper = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++) {
    if (!is_free_place(after, place)) continue;
    const qtr_steps when = soonest(bound, after, place, now);
    if (when != QTR_NEVER) upper += qtr_game_worth(bound->game, place, when);
  }
  return upper;
}

double qtr_bound_state(const qtr_bound *bound, const qtr_joint *after, qtr_steps now, double unvisited) {
  const double prices = bound_by_prices(bound, after, now);
  const double plain = bound_all_at_once(bound, after, now);
  const double upper = worth_under_way(bound, after, now) + (prices < plain ? prices : plain);
  if (bound->game->mission->objective == QTR_TIME) return upper + (double)now * unvisited;
  /* Where gamma^t comes to its end as a double, all that is left counts as found now. */
  const double power = qtr_game_power(bound->game, now);
  return power > LEAST_POWER ? upper / power : QTR_REWARD_SCALE * unvisited;
}
