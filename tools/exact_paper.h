/* The paper's rule solved exactly. */
#ifndef QUARTER_TOOLS_EXACT_PAPER_H
#define QUARTER_TOOLS_EXACT_PAPER_H

#include "exact_problem.h"
#include "host/base/fault.h"

/* Fills in length, route and step. 0, or -1 with *why set. */
int exact_solve_paper(exact_solution *solution, const exact_problem *problem, fault *why);

#endif
