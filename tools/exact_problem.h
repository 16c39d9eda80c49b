/* What the two exact solvers share: the problem and its solution in plain numbers, and nothing of how one comes to the
 * other. */
#ifndef QUARTER_TOOLS_EXACT_PROBLEM_H
#define QUARTER_TOOLS_EXACT_PROBLEM_H

#include <stdbool.h>

#include "quarter/mission.h"

/* Places that the solvers take: for one or two seekers, for more, and under the paper's rule. */
enum { EXACT_PAIR_PLACES = 22, EXACT_GROUP_PLACES = 18, EXACT_PAPER_PLACES = 20 };

typedef struct {
  double objective;            /* the optimum in the objective's own unit: one of the three below */
  double value;                /* discounted value of the optimal routes */
  double expected_time;        /* steps, of the same routes; where they are not played for it, given that they find */
  double found_probability;    /* that a look on the routes finds what is there */
  int negligible;              /* visits that make up less than QTR_NEGLIGIBLE of the objective each: sums that they are
                               lost in do not tell their best order */
  int length[QTR_MAX_SEEKERS]; /* places on each seeker's route */
  uint16_t route[QTR_MAX_SEEKERS][QTR_MAX_PLACES]; /* in the order of the visits */
  qtr_steps step[QTR_MAX_SEEKERS][QTR_MAX_PLACES]; /* when */
  uint8_t look[QTR_MAX_SEEKERS][QTR_MAX_PLACES];   /* the how many-th look at the place it is, from 1 */
} exact_solution;

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

#endif
