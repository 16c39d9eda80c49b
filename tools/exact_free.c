/* The free rule. Seekers hinder one another only by what they leave over: any division of the places, each seeker
 * visiting its share in any order, is a game that the rule allows, and standing down is an empty share. So the optimum
 * is the best division:
 *
 * - tail(n, S): the best that one seeker at node n can make of visiting just the places S, by dynamic programming over
 *   subsets (Held and Karp 1962);
 * - a group of seekers makes of S the best over T within S of what one part of it makes of T and the other of S \ T.
 *   The whole group is asked for the set of all places alone, so two seekers cost 2^h and more cost 3^h.
 */
#include "exact_free.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PAIR_PLACES = EXACT_PAIR_PLACES, NODES = PAIR_PLACES + QTR_MAX_SEEKERS, GROUPS = 4 * QTR_MAX_SEEKERS };

/* A visit of place q from node n while S is still to be visited is worth
 * gain[q][n] + keep[q][n] * (what follows at q) - delay[q][n] * (likelihood of S). */
typedef struct {
  double gain[PAIR_PLACES][NODES], keep[PAIR_PLACES][NODES], delay[PAIR_PLACES][NODES];
} leg_table;

/* One seeker from a start (left < 0), or two groups together. */
typedef struct {
  int left, right, start;
  double *value; /* for each set; NULL until it is needed */
} team;

typedef struct {
  const exact_problem *problem;
  exact_solution *solution;
  leg_table legs;
  int nodes;
  uint32_t sets;
  double *tail; /* of (set, node) */
  team group[GROUPS];
  int groups;
  int given[QTR_MAX_SEEKERS]; /* seekers of each start that have their places */
} subset_solver;

static void set_leg(subset_solver *solver, int place, int node) {
  const exact_problem *problem = solver->problem;
  const qtr_steps steps = exact_steps(problem, node, place);
  const bool never = steps == QTR_NEVER;
  double gain = never ? -INFINITY : 0, keep = 1, delay = never ? 0 : (double)steps;
  if (problem->discounted) {
    gain = never ? -INFINITY : exact_reward(problem, place, steps);
    keep = exact_discount(problem, steps);
    delay = 0;
  }
  solver->legs.gain[place][node] = gain;
  solver->legs.keep[place][node] = keep;
  solver->legs.delay[place][node] = delay;
}

static double likelihood(const exact_problem *problem, uint32_t set) {
  double sum = 0;
  for (int p = 0; p < problem->places; p++)
    if ((set >> p) & 1) sum += problem->share[p];
  return sum;
}

static void fill_tail(subset_solver *solver, uint32_t set) {
  const size_t nodes = (size_t)solver->nodes;
  double *row = solver->tail + set * nodes;
  for (size_t n = 0; n < nodes; n++) row[n] = set == 0 ? 0 : -INFINITY;
  const double mass = likelihood(solver->problem, set);
  for (int q = 0; q < solver->problem->places; q++) {
    const uint32_t bit = (uint32_t)1 << q;
    if ((set & bit) == 0) continue;
    const double after = solver->tail[(set ^ bit) * nodes + (size_t)q];
    const double *gain = solver->legs.gain[q], *keep = solver->legs.keep[q], *delay = solver->legs.delay[q];
    for (size_t n = 0; n < nodes; n++) {
      const double value = gain[n] + keep[n] * after - delay[n] * mass;
      row[n] = value > row[n] ? value : row[n];
    }
  }
}

/* ---- groups ---- */

static int add_group(subset_solver *solver, int left, int right, int start) {
  solver->group[solver->groups] = (team){.left = left, .right = right, .start = start};
  return solver->groups++;
}

/* All seekers of one start, by repeated doubling: their shares are interchangeable. */
static int add_start(subset_solver *solver, int start) {
  int seekers = 0, all = -1, doubled = add_group(solver, -1, -1, start);
  for (int i = 0; i < solver->problem->seekers; i++) seekers += solver->problem->start_of[i] == start;
  for (;; seekers /= 2) {
    if (seekers % 2 == 1) all = all < 0 ? doubled : add_group(solver, all, doubled, -1);
    if (seekers == 1) return all;
    doubled = add_group(solver, doubled, doubled, -1);
  }
}

static double best_division(const double *left, const double *right, uint32_t set, uint32_t *share) {
  /* Of two equal groups the first may be given the lowest place. */
  const uint32_t fixed = left == right ? set & (~set + 1) : 0, open = set ^ fixed;
  double best = -INFINITY;
  *share = fixed;
  for (uint32_t part = open;; part = (part - 1) & open) {
    const double value = left[part | fixed] + right[open ^ part];
    if (value > best) {
      best = value;
      *share = part | fixed;
    }
    if (part == 0) return best;
  }
}

static int fill_group(subset_solver *solver, int index, fault *why) {
  team *group = &solver->group[index];
  if (group->value != NULL) return 0;
  if (group->left >= 0 && fill_group(solver, group->left, why) != 0) return -1;
  if (group->right >= 0 && fill_group(solver, group->right, why) != 0) return -1;
  group->value = malloc(solver->sets * sizeof *group->value);
  if (group->value == NULL) return fault_set(why, "exact: out of memory; use `quarter learn`");
  const size_t node = (size_t)(solver->problem->places + group->start);
  for (uint32_t set = 0; set < solver->sets; set++) {
    uint32_t share;
    group->value[set] = group->left < 0 ? solver->tail[set * (size_t)solver->nodes + node]
                                        : best_division(solver->group[group->left].value,
                                                        solver->group[group->right].value, set, &share);
  }
  return 0;
}

/* ---- routes ---- */

static int best_next(const subset_solver *solver, uint32_t set, int node) {
  const double mass = likelihood(solver->problem, set);
  double best = -INFINITY;
  int next = -1;
  for (int q = 0; q < solver->problem->places; q++) {
    if (((set >> q) & 1) == 0) continue;
    const double after = solver->tail[(set ^ (uint32_t)1 << q) * (size_t)solver->nodes + (size_t)q];
    const double value =
        solver->legs.gain[q][node] + solver->legs.keep[q][node] * after - solver->legs.delay[q][node] * mass;
    if (value > best) {
      best = value;
      next = q;
    }
  }
  return next;
}

static void give_places(subset_solver *solver, int start, uint32_t set) {
  exact_solution *solution = solver->solution;
  int seeker = 0, earlier = solver->given[start]++;
  while (solver->problem->start_of[seeker] != start || earlier-- > 0) seeker++;
  int node = solver->problem->places + start;
  qtr_steps now = 0;
  while (set != 0) {
    const int place = best_next(solver, set, node);
    const int visit = solution->length[seeker]++;
    now += exact_steps(solver->problem, node, place);
    solution->route[seeker][visit] = (uint16_t)place;
    solution->step[seeker][visit] = now;
    set ^= (uint32_t)1 << place;
    node = place;
  }
}

static void divide(subset_solver *solver, int index, uint32_t set) {
  const team *group = &solver->group[index];
  uint32_t share;
  if (group->left < 0) {
    give_places(solver, group->start, set);
    return;
  }
  best_division(solver->group[group->left].value, solver->group[group->right].value, set, &share);
  divide(solver, group->left, share);
  divide(solver, group->right, set ^ share);
}

/* ---- */

static int solve(subset_solver *solver, fault *why) {
  const uint32_t all = solver->sets - 1;
  for (int q = 0; q < solver->problem->places; q++)
    for (int n = 0; n < solver->nodes; n++) set_leg(solver, q, n);
  for (uint32_t set = 0; set < solver->sets; set++) fill_tail(solver, set);
  int root = -1;
  for (int s = 0; s < solver->problem->starts; s++) {
    const int added = add_start(solver, s);
    root = root < 0 ? added : add_group(solver, root, added, -1);
  }
  const team *whole = &solver->group[root];
  double value = solver->tail[all * (size_t)solver->nodes + (size_t)solver->problem->places];
  if (whole->left >= 0) {
    uint32_t share;
    if (fill_group(solver, whole->left, why) != 0 || fill_group(solver, whole->right, why) != 0) return -1;
    value = best_division(solver->group[whole->left].value, solver->group[whole->right].value, all, &share);
  }
  if (value == -INFINITY) return fault_set(why, "exact: no routes reach every place; remove the places cut off");
  divide(solver, root, all);
  return 0;
}

int exact_solve_free(exact_solution *solution, const exact_problem *problem, fault *why) {
  subset_solver *solver = calloc(1, sizeof *solver);
  int status = -1;
  if (solver != NULL) {
    solver->problem = problem;
    solver->solution = solution;
    solver->nodes = problem->places + problem->starts;
    solver->sets = (uint32_t)1 << problem->places;
    solver->tail = malloc(solver->sets * (size_t)solver->nodes * sizeof *solver->tail);
  }
  if (solver == NULL || solver->tail == NULL)
    fault_set(why, "exact: out of memory with %d places; use `quarter learn`", problem->places);
  else
    status = solve(solver, why);
  for (int g = 0; solver != NULL && g < solver->groups; g++) free(solver->group[g].value);
  if (solver != NULL) free(solver->tail);
  free(solver);
  return status;
}
