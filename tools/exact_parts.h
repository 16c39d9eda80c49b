/* What the two exact solvers share: the problem in plain numbers, and nothing of how it is solved. Private to exact*.c. */
#ifndef QUARTER_TOOLS_EXACT_PARTS_H
#define QUARTER_TOOLS_EXACT_PARTS_H

#include <stdbool.h>

#include "exact.h"

/* Places that the solvers take: for one or two seekers, for more, and under the paper's rule. */
enum { EXACT_PAIR_PLACES = 22, EXACT_GROUP_PLACES = 18, EXACT_PAPER_PLACES = 20 };

typedef struct {
  int places, seekers, starts; /* starts: distinct start cells, numbered as the seekers first name them */
  int start_of[QTR_MAX_SEEKERS];
  bool discounted;              /* else the expected time */
  double gamma;                 /* the discount a step */
  double share[QTR_MAX_PLACES]; /* weights normalised to sum 1 */
  const qtr_steps *steps;       /* see exact_solve() */
} exact_problem;

/* Nodes: places 0..places-1, then the distinct starts. Steps from a node to a place, QTR_NEVER for no way. */
qtr_steps exact_steps(const exact_problem *problem, int node, int place);

/* gamma to a power; at least the least positive double, so that the product with minus infinity is never a NaN. */
double exact_discount(const exact_problem *problem, qtr_steps steps);

/* Reward of a first visit this many steps after the moment that it is discounted to. */
double exact_reward(const exact_problem *problem, int place, qtr_steps steps);

/* The solvers fill in length, route and step. 0, or -1 with *why set. */
int exact_solve_free(exact_solution *solution, const exact_problem *problem, fault *why);
int exact_solve_paper(exact_solution *solution, const exact_problem *problem, fault *why);

#endif
