#include "search/bound.h"

#include <math.h>
#include <stddef.h>

#include "model/rounding.h"
#include "quarter/status.h"

#define SCALE_FIRST 2.0 /* of Polyak's step; 2 is the most for which it converges */
#define SCALE_LEAST 0.005
#define SCALE_SHRINK 0.7
#define PATIENCE 12u    /* steps without gain before the scale shrinks */
#define WATCH_SLOTS 32u /* filled from one asking of the watch to the next */
#define HORIZON 2u      /* slots reach so many times as far as the last visit of the play known */

static unsigned places_of(const qtr_bound *bound) {
  return bound->game->board.places;
}

static unsigned targets_of(const qtr_bound *bound) {
  return bound->environment->targets.count;
}

static const qtr_steps *travel_from(const qtr_bound *bound, unsigned node) {
  return bound->travel + (size_t)node * places_of(bound);
}

/* The first place of a target's tour from a node; QTR_STAND_DOWN if there is no way. */
static uint16_t first_of(const qtr_bound *bound, unsigned node, unsigned target) {
  return qtr_targets_first(&bound->environment->targets, node, target);
}

static unsigned target_of(const qtr_bound *bound, unsigned place) {
  return qtr_targets_of(&bound->environment->targets, place);
}

static const qtr_tour *tour_at(const qtr_bound *bound, unsigned place) {
  return qtr_targets_tour(&bound->environment->targets, place);
}

/* The target that a node belongs to; starts belong to none. */
static unsigned target_at(const qtr_bound *bound, unsigned node) {
  return node < places_of(bound) ? target_of(bound, node) : QTR_STAND_DOWN;
}

/* ---- the walks of one seeker ---- */

/* What a walk from target `from` collects that begins the tour at `place` in `slot`: it may not go straight back. Walks
 * may repeat targets, which real ones cannot, and the worst of that is to and fro between two: with the best way on and
 * the best one to another target kept, C is known for every `from` at no more work than for none. */
static double gain_in(const qtr_bound *bound, unsigned from, unsigned place, uint32_t slot) {
  if (slot >= bound->slots) return bound->late[place];
  const qtr_gain *gain = &bound->gain[(size_t)slot * places_of(bound) + place];
  return gain->to == from ? gain->second : gain->best;
}

/* A slot is known by its first step, when its walks can collect most: worth never rises with time. */
static double gain_at(const qtr_bound *bound, unsigned from, unsigned place, qtr_steps when) {
  return gain_in(bound, from, place, bound->slot_steps == 1 ? when : when / bound->slot_steps);
}

/* What the tour begun at `place` is worth, net of its price: sum of worth(p_i, t + s_i) - lambda, s_i the step of its
 * visit i. */
static double net_worth(const qtr_bound *bound, const double *price, unsigned place, qtr_steps when) {
  const qtr_tour *tour = tour_at(bound, place);
  double worth = -price[tour->target];
  for (unsigned i = 0; i < tour->places; i++)
    worth += qtr_game_worth(bound->game, tour->place[i], when + tour->step[i]);
  return worth;
}

/* What a target is worth at most from some step on: all of its places at once. */
static double target_worth(const qtr_bound *bound, unsigned target, qtr_steps when) {
  const qtr_targets *targets = &bound->environment->targets;
  double worth = 0.0;
  for (unsigned i = 0; i < qtr_targets_size(targets, target); i++)
    worth += qtr_game_worth(bound->game, qtr_targets_place(targets, target, i), when);
  return worth;
}

/* All that is left, collected at once at the first step past the last slot. From there on a real walk visits each
 * target once at most, and not before: the sum of what is above 0 bounds it. Its first target it cannot refuse any
 * more. */
static void fill_late(qtr_bound *bound, const double *price) {
  const qtr_steps end = bound->slots * bound->slot_steps;
  double all = 0.0;
  for (unsigned target = 0; target < targets_of(bound); target++) {
    const double net = target_worth(bound, target, end) - price[target];
    all += net > 0.0 ? net : 0.0;
  }
  for (unsigned place = 0; place < places_of(bound); place++) {
    const unsigned target = target_of(bound, place);
    const double net = target_worth(bound, target, end) - price[target];
    bound->late[place] = all + (net > 0.0 ? 0.0 : net);
  }
}

/* C(t, j) with the tour that it begins: net(j, t) + max(0, max over p of C(t + d(j, p), p)), d from tour's start to
 * start. */
static void fill_gain(qtr_bound *bound, uint32_t slot, unsigned place, double net) {
  const qtr_tour *tour = tour_at(bound, place);
  const unsigned targets = targets_of(bound);
  const uint16_t exit = qtr_tour_exit(tour);
  const uint32_t *apart = bound->slots_apart + (size_t)place * targets;
  const uint16_t here = tour->target;
  qtr_gain *gain = &bound->gain[(size_t)slot * places_of(bound) + place];
  double best = 0.0;
  double second = 0.0;
  uint16_t to = QTR_STAND_DOWN;
  uint16_t other = QTR_STAND_DOWN;
  for (unsigned target = 0; target < targets; target++) {
    if (apart[target] == QTR_NEVER) continue;
    /* Walks move on in time: C(t, p) needs later slots alone, and those have been filled. */
    QTR_ASSERT(apart[target] > 0);
    const double on = gain_in(bound, here, first_of(bound, exit, target), slot + apart[target]);
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
static bool fill_gains(qtr_bound *bound, const double *price) {
  fill_late(bound, price);
  for (uint32_t slot = bound->slots; slot-- > 0;) {
    if (slot % WATCH_SLOTS == 0 && !qtr_watch_go_on(&bound->game->mission->watch)) return false;
    for (unsigned place = 0; place < places_of(bound); place++)
      if (tour_at(bound, place)->places > 0)
        fill_gain(bound, slot, place, net_worth(bound, price, place, slot * bound->slot_steps));
  }
  return true;
}

/* The first target of the best walk from a start; QTR_STAND_DOWN if staying is best. */
static uint16_t first_of_walk(const qtr_bound *bound, unsigned start_node, double *collected) {
  const qtr_steps *travel = travel_from(bound, start_node);
  uint16_t best = QTR_STAND_DOWN;
  *collected = 0.0;
  for (unsigned target = 0; target < targets_of(bound); target++) {
    const uint16_t first = first_of(bound, start_node, target);
    if (first == QTR_STAND_DOWN) continue;
    const double gain = gain_at(bound, QTR_STAND_DOWN, first, travel[first]);
    if (gain <= *collected) continue;
    *collected = gain;
    best = (uint16_t)target;
  }
  return best;
}

/* The walk that C stands for, followed forwards: what the prices are tuned by. */
static void count_walk(const qtr_bound *bound, unsigned start_node, uint16_t target, int *visits) {
  unsigned node = start_node;
  unsigned from = QTR_STAND_DOWN;
  uint32_t slot = 0;
  while (target != QTR_STAND_DOWN) {
    const uint16_t first = first_of(bound, node, target);
    visits[target]++;
    slot = from == QTR_STAND_DOWN ? travel_from(bound, node)[first] / bound->slot_steps
                                  : slot + bound->slots_apart[(size_t)from * targets_of(bound) + target];
    if (slot >= bound->slots) return;
    const qtr_tour *tour = tour_at(bound, first);
    const qtr_gain *gain = &bound->gain[(size_t)slot * places_of(bound) + first];
    const unsigned before = target_at(bound, node);
    node = tour->place[tour->places - 1];
    from = first;
    target = before != QTR_STAND_DOWN && gain->to == before ? gain->other : gain->to;
  }
}

/* The bound under `price`, HUGE_VAL if stopped; adds up how often the seekers' best walks visit each target.
 *
 *   L(lambda) = sum of lambda + sum over seekers of C(start)
 *
 * is at least what any play earns: what seeker i collects there is a walk, so it is no more than C(its start) + the
 * prices of the targets that it is first at; and these prices, over all seekers, are no more than the sum of lambda. */
static double evaluate(qtr_bound *bound, const double *price, int *visits) {
  const qtr_board *board = &bound->game->board;
  double upper = 0.0;
  if (!fill_gains(bound, price)) return HUGE_VAL;
  for (unsigned target = 0; target < targets_of(bound); target++) {
    /* A play that leaves a target out saves its price: that must not lose it anything. */
    QTR_ASSERT(price[target] >= 0.0 || qtr_objective_needs_all(&bound->game->objective));
    upper += price[target];
    visits[target] = 0;
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

/* Subgradient steps wander off: back to where the bound was least, to go on by shorter ones. */
static void restart_from_best(qtr_bound *bound) {
  for (unsigned target = 0; target < targets_of(bound); target++) bound->trial[target] = bound->price[target];
}

/* Steps from the start of the tour at `place` to the start of the next target's. */
static qtr_steps steps_apart(const qtr_bound *bound, unsigned place, unsigned target) {
  const qtr_tour *tour = tour_at(bound, place);
  if (tour->places == 0 || tour->target == target) return QTR_NEVER;
  const uint16_t last = tour->place[tour->places - 1];
  const uint16_t first = first_of(bound, last, target);
  return first == QTR_STAND_DOWN ? QTR_NEVER : tour->step[tour->places - 1] + travel_from(bound, last)[first];
}

/* Slots as short as the horizon allows, but never longer than the shortest way between two targets: a walk must move on
 * in time. */
static void cut_time(qtr_bound *bound, qtr_steps last_visit) {
  const unsigned places = places_of(bound);
  const unsigned targets = targets_of(bound);
  qtr_steps shortest = QTR_NEVER;
  for (unsigned place = 0; place < places; place++)
    for (unsigned target = 0; target < targets; target++)
      if (steps_apart(bound, place, target) < shortest) shortest = steps_apart(bound, place, target);
  /* Places lie on different cells, and each step takes one of time. */
  QTR_ASSERT(shortest > 0);
  uint64_t horizon = (uint64_t)last_visit * HORIZON + bound->environment->board.keys.longest + 2;
  if (horizon > QTR_NEVER / 2) horizon = QTR_NEVER / 2;
  uint64_t steps = (horizon + QTR_BOUND_SLOTS - 1) / QTR_BOUND_SLOTS;
  if (steps > shortest) steps = shortest;
  const uint64_t slots = (horizon + steps - 1) / steps;
  bound->slot_steps = (qtr_steps)steps;
  bound->slots = (uint32_t)(slots < QTR_BOUND_SLOTS ? slots : QTR_BOUND_SLOTS);
  for (unsigned place = 0; place < places; place++) {
    for (unsigned target = 0; target < targets; target++) {
      const qtr_steps apart = steps_apart(bound, place, target);
      bound->slots_apart[(size_t)place * targets + target] = apart == QTR_NEVER ? QTR_NEVER : apart / bound->slot_steps;
    }
  }
}

/* The prices that the targets would fetch in a known play: under them its own routes collect 0 net, which is a start to
 * tune from. Returns the last visit, which the horizon goes by. */
static qtr_steps price_by_visits(qtr_bound *bound, const qtr_steps *visit) {
  qtr_steps last = 0;
  for (unsigned target = 0; target < targets_of(bound); target++) bound->price[target] = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++) {
    bound->price[target_of(bound, place)] += qtr_game_worth(bound->game, place, visit[place]);
    if (visit[place] > last) last = visit[place];
  }
  return last;
}

/* The bound without prices: each place reached by whoever is nearest to it, all at once. */
static double upper_at_once(const qtr_bound *bound) {
  const qtr_board *board = &bound->game->board;
  double upper = 0.0;
  for (unsigned place = 0; place < board->places; place++) {
    qtr_steps soonest = QTR_NEVER;
    for (unsigned start = 0; start < board->starts; start++)
      if (travel_from(bound, (unsigned)board->places + start)[place] < soonest)
        soonest = travel_from(bound, (unsigned)board->places + start)[place];
    upper += qtr_game_worth(bound->game, place, soonest);
  }
  return upper;
}

/* Whether the targets divide the places among themselves. */
static bool are_division(const qtr_targets *targets, unsigned places) {
  unsigned listed = 0;
  for (unsigned target = 0; target < targets->count; target++)
    for (unsigned i = 0; i < qtr_targets_size(targets, target); i++, listed++)
      if (qtr_targets_of(targets, qtr_targets_place(targets, target, i)) != target) return false;
  return listed == places;
}

size_t qtr_bound_bytes(const qtr_game *game) {
  return (size_t)QTR_BOUND_SLOTS * game->board.places * sizeof(qtr_gain);
}

void qtr_bound_init(qtr_bound *bound, qtr_gain *gain, const qtr_environment *environment, const qtr_steps *visit) {
  const qtr_board *board = &environment->game->board;
  int visits[QTR_MAX_PLACES];
  /* Every visit belongs to one target, whose price its seeker pays once. */
  QTR_ASSERT(are_division(&environment->targets, board->places));
  /* Times that are estimates bound nothing: regions have no prices. */
  QTR_ASSERT(qtr_sight_is_exact(&environment->sight));
  bound->environment = environment;
  bound->game = environment->game;
  bound->gain = gain;
  for (unsigned node = 0; node < (unsigned)board->places + board->starts; node++)
    for (unsigned place = 0; place < board->places; place++)
      bound->travel[(size_t)node * board->places + place] = qtr_board_steps(board, QTR_ANY_SEEKER, node, place);
  cut_time(bound, price_by_visits(bound, visit));
  bound->scale = SCALE_FIRST;
  bound->iterations = 0;
  bound->steps_without_gain = 0;
  restart_from_best(bound);
  bound->upper = evaluate(bound, bound->price, visits);
  if (bound->upper == HUGE_VAL) bound->upper = upper_at_once(bound);
}

static void keep_trial(qtr_bound *bound, double upper) {
  bound->upper = upper;
  for (unsigned target = 0; target < targets_of(bound); target++) bound->price[target] = bound->trial[target];
}

/* Polyak's step: as far as would reach the goal if the bound fell on as it falls here. L is convex and piecewise linear
 * in lambda, and g = 1 - visits is a subgradient: were the goal its least value, lambda - scale (L - goal) / |g|^2 g
 * would be nearer to where that is, for a scale below 2. With g = 0 the walks are a play, and L but for what slots add
 * what it earns. */
static bool move_trial(qtr_bound *bound, double upper, double goal, const int *visits) {
  double square = 0.0;
  for (unsigned target = 0; target < targets_of(bound); target++)
    square += (double)((visits[target] - 1) * (visits[target] - 1));
  if (square == 0.0) return false;
  const double step = bound->scale * (upper - goal) / square;
  for (unsigned target = 0; target < targets_of(bound); target++) {
    bound->trial[target] += step * (double)(visits[target] - 1);
    if (bound->trial[target] < 0.0 && !qtr_objective_needs_all(&bound->game->objective)) bound->trial[target] = 0.0;
  }
  return true;
}

bool qtr_bound_improve(qtr_bound *bound, double goal) {
  int visits[QTR_MAX_PLACES];
  const double upper = evaluate(bound, bound->trial, visits);
  if (upper == HUGE_VAL) return true;
  bound->iterations++;
  /* Less than a thousandth of the way to the goal is no gain: or the steps would never end. */
  const bool gained = upper < bound->upper - 1e-3 * (bound->upper - goal);
  if (upper < bound->upper) keep_trial(bound, upper);
  if (gained) {
    bound->steps_without_gain = 0;
  } else if (++bound->steps_without_gain >= PATIENCE) {
    bound->steps_without_gain = 0;
    bound->scale *= SCALE_SHRINK;
    restart_from_best(bound);
    if (evaluate(bound, bound->trial, visits) == HUGE_VAL) return true;
  }
  return upper > goal && bound->scale >= SCALE_LEAST && move_trial(bound, upper, goal, visits);
}

bool qtr_bound_settle(qtr_bound *bound) {
  return fill_gains(bound, bound->price);
}

/* ---- states ---- */

/* Of the loops below the innermost: both sets at once, and the target, one of the environment's, is not checked. */
static inline bool is_free(const qtr_situation *after, unsigned target) {
  const unsigned w = target / 32;
  return ((after->joint.visited.word[w] | after->joint.bound.word[w]) >> (target % 32) & 1u) == 0;
}

/* The most that one seeker can collect from its next free moment on, its first step going to a free target. Further
 * ones are not checked: C knows no state. */
static double collect_on(const qtr_bound *bound, const qtr_situation *after, unsigned node, qtr_steps when) {
  const qtr_steps *travel = travel_from(bound, node);
  const unsigned here = target_at(bound, node);
  double best = 0.0;
  for (unsigned target = 0; target < targets_of(bound); target++) {
    if (!is_free(after, target)) continue;
    const uint16_t first = first_of(bound, node, target);
    if (first == QTR_STAND_DOWN) continue;
    const double gain = gain_at(bound, here, first, when + travel[first]);
    if (gain > best) best = gain;
  }
  return best;
}

/* When the first of the seekers can be at a place. */
static qtr_steps soonest(const qtr_bound *bound, const qtr_situation *after, unsigned place) {
  const qtr_joint *joint = &after->joint;
  qtr_steps least = QTR_NEVER;
  for (unsigned i = 0; i < bound->game->board.seekers; i++) {
    if (joint->node[i] == QTR_STAND_DOWN) continue;
    const unsigned node = qtr_environment_exit(bound->environment, after, i);
    const qtr_steps way = node == place ? 0 : travel_from(bound, node)[place];
    if (way != QTR_NEVER && after->now + joint->remaining[i] + way < least)
      least = after->now + joint->remaining[i] + way;
  }
  return least;
}

/* The visits that a seeker is on its way to. Under the paper's rule another one may be there first. */
static double worth_of_tour(const qtr_bound *bound, const qtr_situation *after, unsigned seeker) {
  const qtr_tour *tour = tour_at(bound, after->at[seeker]);
  double worth = 0.0;
  for (unsigned i = 0; i < tour->places; i++) {
    const qtr_steps left = qtr_environment_visit(bound->environment, after, seeker, i);
    if (left == 0) continue;
    qtr_steps when = after->now + left;
    if (bound->environment->board.rule == QTR_RULE_PAPER && soonest(bound, after, tour->place[i]) < when)
      when = soonest(bound, after, tour->place[i]);
    worth += qtr_game_worth(bound->game, tour->place[i], when);
  }
  return worth;
}

/* Visits under way, each target once though several seekers may be bound for it. */
static double worth_under_way(const qtr_bound *bound, const qtr_situation *after) {
  qtr_places counted = after->joint.visited;
  double worth = 0.0;
  for (unsigned i = 0; i < bound->game->board.seekers; i++) {
    if (after->joint.remaining[i] == 0 || qtr_places_has(&counted, after->joint.node[i])) continue;
    qtr_places_add(&counted, after->joint.node[i]);
    worth += worth_of_tour(bound, after, i);
  }
  return worth;
}

/* sum of lambda over the free targets + sum over seekers of C at their arrival: L(lambda) of the game that is left, by
 * the same proof. */
static double bound_by_prices(const qtr_bound *bound, const qtr_situation *after) {
  double upper = 0.0;
  for (unsigned target = 0; target < targets_of(bound); target++)
    if (is_free(after, target)) upper += bound->price[target];
  for (unsigned i = 0; i < bound->game->board.seekers; i++)
    if (after->joint.node[i] != QTR_STAND_DOWN)
      upper += collect_on(bound, after, qtr_environment_exit(bound->environment, after, i),
                          after->now + after->joint.remaining[i]);
  return upper;
}

/* The plain bound: every free place reached by whoever gets there soonest, all at once. */
static double bound_all_at_once(const qtr_bound *bound, const qtr_situation *after) {
  double upper = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++) {
    if (!is_free(after, target_of(bound, place))) continue;
    const qtr_steps when = soonest(bound, after, place);
    if (when != QTR_NEVER) upper += qtr_game_worth(bound->game, place, when);
  }
  return upper;
}

/* Each of the two is loose where the other one is not: the prices let walks repeat targets, the plain bound lets a
 * seeker be at all places at once. The lesser of two bounds is one. */
double qtr_bound_state(const qtr_bound *bound, const qtr_situation *after) {
  const double prices = bound_by_prices(bound, after);
  const double plain = bound_all_at_once(bound, after);
  const double upper = worth_under_way(bound, after) + (prices < plain ? prices : plain);
  return qtr_objective_from_now(&bound->game->objective, upper, after->now, after->unvisited);
}
