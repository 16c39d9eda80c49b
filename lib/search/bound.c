#include "search/bound.h"

#include <math.h>
#include <stddef.h>

#include "model/rounding.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "search/cuts.h"

#define LEVEL 0.5        /* of the way from the bound to its floor is what a step aims at */
#define LEVELS 8u        /* that are tried for a step */
#define LEAST_DROP 0.01  /* of what there is between the bound and the goal: a step that aims at less is none */
#define LEAST_SHARE 1e-7 /* of the bound itself */
#define PATIENCE 30u     /* steps in a row that may gain less than the least drop */
#define ALWAYS_ROUNDS 3u /* of neighbours, which the search among states gains by; more of them */
#define LEAST_GAIN 0.3   /* where the last one took so much off between the bound and the goal */

static unsigned places_of(const qtr_bound *bound) {
  return bound->game->board.places;
}

static unsigned targets_of(const qtr_bound *bound) {
  return bound->environment->targets.count;
}

static bool fill(qtr_bound *bound, const double *price) {
  /* A play that leaves a target out saves its price: that must not lose it anything. */
  for (unsigned target = 0; target < targets_of(bound); target++)
    QTR_ASSERT(price[target] >= 0.0 || qtr_objective_needs_all(&bound->game->objective));
  return qtr_gains_fill(&bound->gains, price);
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
  if (!fill(bound, price)) return HUGE_VAL;
  for (unsigned target = 0; target < targets_of(bound); target++) {
    upper += price[target];
    visits[target] = 0;
  }
  for (unsigned seeker = 0; seeker < board->seekers; seeker++) upper += qtr_gains_walk(&bound->gains, seeker, visits);
  return upper;
}

/* ---- prices ---- */

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
double qtr_bound_at_once(const qtr_bound *bound) {
  const qtr_board *board = &bound->game->board;
  double upper = qtr_objective_left(&bound->game->objective, 1.0);
  for (unsigned place = 0; place < board->places; place++) {
    qtr_steps soonest = QTR_NEVER;
    for (unsigned i = 0; i < board->seekers; i++) {
      const qtr_steps way = qtr_gains_soonest(&bound->gains, bound->gains.kind_of[i],
                                              (unsigned)board->places + board->start_of[i])[place];
      if (way == QTR_NEVER) continue;
      const qtr_steps when = qtr_board_ready(board, i) + way;
      if (when < soonest && qtr_gains_in_time(&bound->gains, bound->gains.kind_of[i], place, when)) soonest = when;
    }
    if (soonest != QTR_NEVER) upper += qtr_game_worth(bound->game, place, soonest);
  }
  return upper;
}

/* The first cuts, at the prices in force. False: stopped. */
static bool begin_cuts(qtr_bound *bound) {
  const double step[QTR_MAX_PLACES] = {0.0};
  int visits[QTR_MAX_PLACES];
  bound->floor = -HUGE_VAL;
  bound->steps_without_gain = 0;
  qtr_bundle_init(&bound->bundle, targets_of(bound));
  const double upper = evaluate(bound, bound->price, visits);
  if (upper == HUGE_VAL) return false;
  bound->filling = bound->gains.fillings;
  qtr_cuts_add(&bound->bundle, &bound->gains, bound->price, step, upper, visits);
  if (upper < bound->upper) bound->upper = upper;
  return true;
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
  /* Every visit belongs to one target, whose price its seeker pays once. */
  QTR_ASSERT(are_division(&environment->targets, environment->game->board.places));
  bound->environment = environment;
  bound->game = environment->game;
  qtr_gains_init(&bound->gains, block, environment);
  qtr_gains_cut(&bound->gains, price_by_visits(bound, visit));
  bound->shares = environment->aggregated && environment->board.rule == QTR_RULE_PAPER;
  bound->iterations = 0;
  bound->filling = 0;
  bound->rounds = 1;
  bound->upper = bound->upper_before = HUGE_VAL;
  if (bound->shares || !begin_cuts(bound)) bound->upper = qtr_bound_at_once(bound);
}

/* The next prices are to bring the bound down to the goal, as long as the cuts allow that, then half the way to its
 * floor, the least level that they are not known to rule out. False: there is next to nothing left between the two. */
static bool find_step(qtr_bound *bound, double goal, double *step) {
  const double all = bound->upper - goal;
  if (all <= LEAST_SHARE * fabs(goal)) return false;
  if (bound->floor <= goal) {
    bound->floor = goal;
    if (qtr_bundle_step(&bound->bundle, goal, LEAST_DROP * all, step)) return true;
    bound->floor += LEAST_DROP * all;
  }
  for (unsigned i = 0; i < LEVELS; i++) {
    const double drop = LEVEL * (bound->upper - bound->floor);
    if (drop <= LEAST_DROP * all || drop <= LEAST_SHARE * fabs(goal)) return false;
    if (qtr_bundle_step(&bound->bundle, bound->upper - drop, 0.5 * drop, step)) return true;
    bound->floor = bound->upper - drop;
  }
  return false;
}

static void put_on_trial(qtr_bound *bound, double *step) {
  const bool either_sign = qtr_objective_needs_all(&bound->game->objective);
  for (unsigned target = 0; target < targets_of(bound); target++) {
    const double price = bound->price[target] + step[target];
    bound->trial[target] = price < 0.0 && !either_sign ? 0.0 : price;
    step[target] = bound->trial[target] - bound->price[target];
  }
}

static void keep_trial(qtr_bound *bound, double upper, const double *step) {
  bound->upper = upper;
  bound->filling = bound->gains.fillings;
  for (unsigned target = 0; target < targets_of(bound); target++) bound->price[target] = bound->trial[target];
  qtr_bundle_move(&bound->bundle, step);
}

/* Where prices do no more, walks are to remember more. Under the same prices the bound is then no higher; the cuts are
 * void, for what they say is of the old one. */
static bool remember_more(qtr_bound *bound, double goal) {
  const bool gained = bound->upper - goal < (1.0 - LEAST_GAIN) * (bound->upper_before - goal);
  if (bound->upper <= goal || (bound->rounds >= ALWAYS_ROUNDS && !gained)) return false;
  if (!qtr_gains_remember_more(&bound->gains)) return false;
  bound->rounds++;
  bound->upper_before = bound->upper;
  begin_cuts(bound); /* stopped: the next step begins them */
  return true;
}

bool qtr_bound_improve(qtr_bound *bound, double goal) {
  double step[QTR_MAX_PLACES];
  int visits[QTR_MAX_PLACES];
  if (bound->shares) return false;
  if (bound->steps_without_gain == PATIENCE || !find_step(bound, goal, step)) return remember_more(bound, goal);
  put_on_trial(bound, step);
  const double upper = evaluate(bound, bound->trial, visits);
  if (upper == HUGE_VAL) return true;
  bound->iterations++;
  bound->steps_without_gain++;
  if (upper < bound->upper - LEAST_DROP * (bound->upper - goal)) bound->steps_without_gain = 0;
  qtr_cuts_add(&bound->bundle, &bound->gains, bound->trial, step, upper, visits);
  if (upper < bound->upper) keep_trial(bound, upper, step);
  return bound->upper > goal;
}

bool qtr_bound_settle(qtr_bound *bound) {
  if (bound->shares || (bound->filling != 0 && bound->filling == bound->gains.fillings)) return true;
  if (!fill(bound, bound->price)) return false;
  bound->filling = bound->gains.fillings;
  return true;
}

/* ---- states ---- */

/* Of the loops below the innermost: both sets at once, and the target, one of the environment's, is not checked. */
static inline bool is_free(const qtr_situation *after, unsigned target) {
  const unsigned w = target / 32;
  return ((after->joint.visited.word[w] | after->joint.bound.word[w]) >> (target % 32) & 1u) == 0;
}

/* A seeker that is still in the game: where it is free next, and when. */
typedef struct {
  unsigned kind, node;
  qtr_steps when;
  const qtr_steps *travel;  /* from there */
  const qtr_steps *soonest; /* the same by way of other places */
} free_seeker;

typedef struct {
  unsigned count;
  free_seeker seeker[QTR_MAX_SEEKERS];
} crew;

static void muster(crew *in, const qtr_bound *bound, const qtr_situation *after) {
  in->count = 0;
  for (unsigned i = 0; i < bound->game->board.seekers; i++) {
    if (after->joint.node[i] == QTR_STAND_DOWN) continue;
    free_seeker *seeker = &in->seeker[in->count++];
    seeker->kind = bound->gains.kind_of[i];
    seeker->node = qtr_environment_exit(bound->environment, after, i);
    seeker->when = after->joint.now + after->joint.remaining[i];
    seeker->travel = qtr_gains_travel(&bound->gains, seeker->kind, seeker->node);
    seeker->soonest = qtr_gains_soonest(&bound->gains, seeker->kind, seeker->node);
  }
}

/* The most that one seeker can collect from its next free moment on, its first step going to a free target. Further
 * ones are not checked: C knows no state. */
static double collect_on(const qtr_bound *bound, const qtr_situation *after, const free_seeker *seeker,
                         const qtr_memory *memory) {
  double best = qtr_gains_go_home(&bound->gains, seeker->kind, seeker->node, seeker->when);
  for (unsigned target = 0; target < targets_of(bound); target++) {
    if (!is_free(after, target)) continue;
    const uint16_t first = qtr_targets_first(&bound->environment->targets, seeker->node, target);
    if (first == QTR_STAND_DOWN || seeker->travel[first] == QTR_NEVER) continue;
    const double gain =
        qtr_gains_at(&bound->gains, seeker->kind, first, memory[target], seeker->when + seeker->travel[first]);
    if (gain > best) best = gain;
  }
  return best;
}

/* When the first of the seekers can be at a place, and home from there in time. */
static qtr_steps soonest(const qtr_bound *bound, const crew *in, unsigned place) {
  qtr_steps least = QTR_NEVER;
  for (unsigned i = 0; i < in->count; i++) {
    const free_seeker *seeker = &in->seeker[i];
    const qtr_steps way = seeker->node == place ? 0 : seeker->soonest[place];
    if (way == QTR_NEVER || seeker->when + way >= least) continue;
    if (qtr_gains_in_time(&bound->gains, seeker->kind, place, seeker->when + way)) least = seeker->when + way;
  }
  return least;
}

/* The visits that seekers are on their way to, all of the target of one of them. Under the paper's rule another one may
 * be there first. */
static double worth_of_tour(const qtr_bound *bound, const qtr_situation *after, const crew *in, unsigned seeker) {
  const qtr_tour *tour = qtr_targets_tour(&bound->environment->targets, after->at[seeker]);
  double worth = 0.0;
  for (unsigned i = 0; i < tour->places; i++) {
    const qtr_steps left = qtr_environment_visit(bound->environment, after, seeker, i);
    if (left == 0) continue;
    qtr_steps when = after->joint.now + left;
    if (bound->environment->board.rule == QTR_RULE_PAPER && soonest(bound, in, tour->place[i]) < when)
      when = soonest(bound, in, tour->place[i]);
    worth += qtr_game_worth(bound->game, tour->place[i], when);
  }
  return worth;
}

/* Visits under way, each target once though several seekers may be bound for it. */
static double worth_under_way(const qtr_bound *bound, const qtr_situation *after, const crew *in) {
  qtr_places counted = after->joint.visited;
  double worth = 0.0;
  for (unsigned i = 0; i < bound->game->board.seekers; i++) {
    if (after->joint.remaining[i] == 0 || after->at[i] >= places_of(bound)) continue;
    if (qtr_places_has(&counted, after->joint.node[i])) continue;
    qtr_places_add(&counted, after->joint.node[i]);
    worth += worth_of_tour(bound, after, in, i);
  }
  return worth;
}

/* sum of lambda over the free targets + sum over seekers of C at their arrival: L(lambda) of the game that is left, by
 * the same proof. */
static double bound_by_prices(const qtr_bound *bound, const qtr_situation *after, const crew *in) {
  qtr_memory memory[QTR_MAX_PLACES];
  double upper = 0.0;
  for (unsigned target = 0; target < targets_of(bound); target++) {
    if (!is_free(after, target)) continue;
    upper += bound->price[target];
    memory[target] = qtr_near_of(&bound->gains.near, target, &after->joint.visited, &after->joint.bound);
  }
  for (unsigned i = 0; i < in->count; i++) upper += collect_on(bound, after, &in->seeker[i], memory);
  return upper;
}

/* The plain bound: every free place reached by whoever gets there soonest, all at once. */
static double bound_all_at_once(const qtr_bound *bound, const qtr_situation *after, const crew *in) {
  double upper = 0.0;
  for (unsigned place = 0; place < places_of(bound); place++) {
    if (!is_free(after, qtr_targets_of(&bound->environment->targets, place))) continue;
    const qtr_steps when = soonest(bound, in, place);
    if (when != QTR_NEVER) upper += qtr_game_worth(bound->game, place, when);
  }
  for (unsigned i = 0; i < in->count; i++)
    upper += qtr_gains_go_home(&bound->gains, in->seeker[i].kind, QTR_STAND_DOWN, in->seeker[i].when);
  return upper;
}

/* Each of the two is loose where the other one is not: the prices let walks repeat targets, the plain bound lets a
 * seeker be at all places at once. The lesser of two bounds is one. */
double qtr_bound_state(const qtr_bound *bound, const qtr_situation *after) {
  crew in;
  muster(&in, bound, after);
  const double prices = bound->shares ? HUGE_VAL : bound_by_prices(bound, after, &in);
  const double plain = bound_all_at_once(bound, after, &in);
  const qtr_objective *objective = &bound->game->objective;
  const double upper = worth_under_way(bound, after, &in) + (prices < plain ? prices : plain) +
                       qtr_objective_left(objective, after->unvisited);
  return qtr_objective_from_now(objective, upper, after->joint.now, after->unvisited,
                                qtr_game_seekers_out(bound->game, &after->joint));
}
