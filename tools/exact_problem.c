#include "exact_problem.h"

#include <float.h>
#include <math.h>

qtr_steps exact_steps(const exact_problem *problem, int node, int place) {
  int row = problem->seekers + node;
  if (node >= problem->places) {
    row = 0;
    while (problem->start_of[row] != node - problem->places) row++;
  }
  return problem->steps[(size_t)row * (size_t)problem->places + (size_t)place];
}

double exact_discount(const exact_problem *problem, qtr_steps steps) {
  const double discount = pow(problem->gamma, (double)steps);
  return discount > DBL_MIN ? discount : DBL_MIN;
}

double exact_reward(const exact_problem *problem, int place, qtr_steps steps) {
  return QTR_REWARD_SCALE * problem->share[place] * exact_discount(problem, steps > 0 ? steps - 1 : 0);
}
