#include "search/bound.h"

#include <math.h>
#include <stddef.h>

#include "model/rounding.h"
#include "quarter/status.h"
#include "robot/board.h"

#define SCALE_FIRST 2.0 /* of Polyak's step; 2 is the most for which it converges */
#define SCALE_LEAST 0.005
#define SCALE_SHRINK 0.7
#define PATIENCE 12u /* steps without gain before the scale shrinks */

static unsigned places_of(const qtr_bound *bound) {
  return bound->game->board.places;
}

static unsigned targets_of(const qtr_bound *bound) {
  return bound->environment->targets.count;
}

/* The bound under `price`, HUGE_VAL if stopped; adds up how often the seekers' best walks visit each target.
 *
 *   L(lambda) = sum of lambda + sum over seekers of C(start)
 *
 * is at least what any play earns: what seeker i collects there is a walk, so it is no more than C(its start) + the
 * prices of the targets that it is first at; and these prices, over all seekers, are no more than the sum of lambda. */
static double evaluate(qtr_bound *bound, const double *price, int *visits) {
  const qtr_board *board = &bound->game->board;
  double upper = qtr_objective_left(&bound->game->objective, 1.0);
  if (!qtr_gains_fill(&bound->gains, price)) return HUGE_VAL;
  for (unsigned target = 0; target < targets_of(bound); target++) {
    /* A play that leaves a target out saves its price: that must not lose it anything. */
    QTR_ASSERT(price[target] >= 0.0 || qtr_objective_needs_all(&bound->game->objective));
    upper += price[target];
    visits[target] = 0;
  }
  for (unsigned seeker = 0; seeker < board->seekers; seeker++) upper += qtr_gains_walk(&bound->gains, seeker, visits);
  return upper;
}

/* ---- prices ---- */

/* Subgradient steps wander off: back to where the bound was least, to go on by shorter ones. */
static void restart_from_best(qtr_bound *bound) {
  for (unsigned target = 0; target < targets_of(bound); target++) bound->trial[target] = bound->price[target];
}

/* The prices that the targets would fetch in a known play: under them its own routes collect 0 net, which is a start to
 * tune from. Returns the last visit, which the horizon goes by. */
static qtr_steps price_by_visits(qtr_bound *bound, const qtr_steps *visit) {
  qtr_steps last = 0;
  for (unsigned target = 0; target < targets_of(bound); target++) bound->price[target] = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++) {
    if (visit[place] == QTR_NEVER) continue;
    const double worth = qtr_game_worth(bound->game, place, visit[place]);
    bound->price[qtr_targets_of(&bound->environment->targets, place)] += worth;
    if (visit[place] > last) last = visit[place];
  }
  return last;
}

/* The bound without prices: each place reached by whoever is first there, all at once, and nobody's way home
 * counted. */
static double upper_at_once(const qtr_bound *bound) {
  const qtr_board *board = &bound->game->board;
  double upper = qtr_objective_left(&bound->game->objective, 1.0);
  for (unsigned place = 0; place < board->places; place++) {
    qtr_steps soonest = QTR_NEVER;
    for (unsigned i = 0; i < board->seekers; i++) {
      const qtr_steps way =
          qtr_gains_travel(&bound->gains, bound->gains.kind_of[i], (unsigned)board->places + board->start_of[i])[place];
      if (way == QTR_NEVER) continue;
      const qtr_steps when = qtr_board_ready(board, i) + way;
      if (when < soonest && qtr_gains_in_time(&bound->gains, bound->gains.kind_of[i], place, when)) soonest = when;
    }
    if (soonest != QTR_NEVER) upper += qtr_game_worth(bound->game, place, soonest);
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

void qtr_bound_init(qtr_bound *bound, void *block, const qtr_environment *environment, const qtr_steps *visit) {
  int visits[QTR_MAX_PLACES];
  /* Every visit belongs to one target, whose price its seeker pays once. */
  QTR_ASSERT(are_division(&environment->targets, environment->game->board.places));
  bound->environment = environment;
  bound->game = environment->game;
  qtr_gains_init(&bound->gains, block, environment);
  qtr_gains_cut(&bound->gains, price_by_visits(bound, visit));
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
  return qtr_gains_fill(&bound->gains, bound->price);
}

/* ---- states ---- */

/* Of the loops below the innermost: both sets at once, and the target, one of the environment's, is not checked. */
static inline bool is_free(const qtr_situation *after, unsigned target) {
  const unsigned w = target / 32;
  return ((after->joint.visited.word[w] | after->joint.bound.word[w]) >> (target % 32) & 1u) == 0;
}

/* The most that one seeker can collect from its next free moment on, its first step going to a free target. Further
 * ones are not checked: C knows no state. */
static double collect_on(const qtr_bound *bound, const qtr_situation *after, unsigned seeker) {
  const unsigned kind = bound->gains.kind_of[seeker];
  const unsigned node = qtr_environment_exit(bound->environment, after, seeker);
  const qtr_steps when = after->joint.now + after->joint.remaining[seeker];
  const qtr_steps *travel = qtr_gains_travel(&bound->gains, kind, node);
  const qtr_gains_view view = qtr_gains_of(&bound->gains, kind);
  const unsigned here = node < places_of(bound) ? qtr_targets_of(&bound->environment->targets, node) : QTR_STAND_DOWN;
  double best = qtr_gains_go_home(&bound->gains, kind, node, when);
  for (unsigned target = 0; target < targets_of(bound); target++) {
    if (!is_free(after, target)) continue;
    const uint16_t first = qtr_targets_first(&bound->environment->targets, node, target);
    if (first == QTR_STAND_DOWN || travel[first] == QTR_NEVER) continue;
    const double gain = qtr_gains_at(&view, here, first, when + travel[first]);
    if (gain > best) best = gain;
  }
  return best;
}

/* When the first of the seekers can be at a place, and home from there in time. */
static qtr_steps soonest(const qtr_bound *bound, const qtr_situation *after, unsigned place) {
  const qtr_joint *joint = &after->joint;
  qtr_steps least = QTR_NEVER;
  for (unsigned i = 0; i < bound->game->board.seekers; i++) {
    if (joint->node[i] == QTR_STAND_DOWN) continue;
    const unsigned kind = bound->gains.kind_of[i];
    const unsigned node = qtr_environment_exit(bound->environment, after, i);
    const qtr_steps way = node == place ? 0 : qtr_gains_travel(&bound->gains, kind, node)[place];
    if (way == QTR_NEVER || joint->now + joint->remaining[i] + way >= least) continue;
    if (qtr_gains_in_time(&bound->gains, kind, place, joint->now + joint->remaining[i] + way))
      least = joint->now + joint->remaining[i] + way;
  }
  return least;
}

/* The visits that a seeker is on its way to. Under the paper's rule another one may be there first. */
static double worth_of_tour(const qtr_bound *bound, const qtr_situation *after, unsigned seeker) {
  const qtr_tour *tour = qtr_targets_tour(&bound->environment->targets, after->at[seeker]);
  double worth = 0.0;
  for (unsigned i = 0; i < tour->places; i++) {
    const qtr_steps left = qtr_environment_visit(bound->environment, after, seeker, i);
    if (left == 0) continue;
    qtr_steps when = after->joint.now + left;
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
    if (after->joint.remaining[i] == 0 || after->at[i] >= places_of(bound)) continue;
    if (qtr_places_has(&counted, after->joint.node[i])) continue;
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
    if (after->joint.node[i] != QTR_STAND_DOWN) upper += collect_on(bound, after, i);
  return upper;
}

/* The plain bound: every free place reached by whoever gets there soonest, all at once. */
static double bound_all_at_once(const qtr_bound *bound, const qtr_situation *after) {
  double upper = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++) {
    if (!is_free(after, qtr_targets_of(&bound->environment->targets, place))) continue;
    const qtr_steps when = soonest(bound, after, place);
    if (when != QTR_NEVER) upper += qtr_game_worth(bound->game, place, when);
  }
  for (unsigned i = 0; i < bound->game->board.seekers; i++)
    if (after->joint.node[i] != QTR_STAND_DOWN)
      upper += qtr_gains_go_home(&bound->gains, bound->gains.kind_of[i], QTR_STAND_DOWN,
                                 after->joint.now + after->joint.remaining[i]);
  return upper;
}

/* Each of the two is loose where the other one is not: the prices let walks repeat targets, the plain bound lets a
 * seeker be at all places at once. The lesser of two bounds is one. */
double qtr_bound_state(const qtr_bound *bound, const qtr_situation *after) {
  const double prices = bound_by_prices(bound, after);
  const double plain = bound_all_at_once(bound, after);
  const qtr_objective *objective = &bound->game->objective;
  const double upper = worth_under_way(bound, after) + (prices < plain ? prices : plain) +
                       qtr_objective_left(objective, after->unvisited);
  return qtr_objective_from_now(objective, upper, after->joint.now, after->unvisited,
                                qtr_game_seekers_out(bound->game, &after->joint));
}
