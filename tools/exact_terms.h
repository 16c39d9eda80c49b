/* Missions with the field's terms solved exactly: robots of several classes, scan times, looks that miss, ready times,
 * endurance, a deadline, coming home. */
#ifndef QUARTER_TOOLS_EXACT_TERMS_H
#define QUARTER_TOOLS_EXACT_TERMS_H

#include "exact_problem.h"
#include "host/base/fault.h"
#include "quarter/mission.h"
#include "quarter/travel.h"

/* Whether a mission has any of them. */
bool exact_has_terms(const qtr_mission *mission);

/* Whether it is small enough, and under a rule that takes them: 0, or -1 with *why set. */
int exact_check_terms(const qtr_mission *mission, fault *why);

/* Solve for the mission's objective; `travel` is scratch. Looks after the deadline are left out of the routes. 0, or -1
 * with *why set: besides, no memory, too many states, or a mission that cannot be played. */
int exact_solve_terms(exact_solution *solution, const qtr_mission *mission, qtr_travel *travel, fault *why);

#endif
