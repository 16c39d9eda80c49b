/* The exact optimum by dynamic programming, over subsets or over the states of the joint game, with transitions of its
 * own: it shares only the grid and the search for travel times with the core, so that it can find the core's faults. */
#ifndef QUARTER_TOOLS_EXACT_H
#define QUARTER_TOOLS_EXACT_H

#include "exact_problem.h"
#include "host/base/fault.h"
#include "quarter/mission.h"
#include "quarter/travel.h"

/* Whether the mission is small enough to be solved: 0, or -1 with *fault set. */
int exact_check(const qtr_mission *mission, fault *fault);

/* Solve for the mission's objective and rule, whatever terms it has; `travel` is scratch. Under the paper's rule a
 * seeker may arrive at a place that another has visited meanwhile: routes list first visits only. 0, or -1 with *fault
 * set: too many places for the memory or time that this takes, no memory, or what cannot be played. */
int exact_solve(exact_solution *solution, const qtr_mission *mission, qtr_travel *travel, fault *fault);

/* The same for a mission without the field's terms whose travel times are known: `steps` is (seekers + places) x
 * places, row i < seekers from seeker i's start, row seekers + p from place p; QTR_NEVER where there is no way. */
int exact_solve_plain(exact_solution *solution, const qtr_mission *mission, const qtr_steps *steps, fault *fault);

#endif
