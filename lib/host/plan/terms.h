/* The field's terms of an input made what the core plays: seconds and metres made steps. */
#ifndef QUARTER_HOST_TERMS_H
#define QUARTER_HOST_TERMS_H

#include "host/base/fault.h"
#include "host/input/input.h"
#include "host/plan/pace.h"

/* Set the mission's terms by what the input states, once, when its objective and gamma are those to be played for. What
 * a user should know is noted. 0, or -1 with *why set. */
int terms_apply(input *in, pace *p, fault *why);

/* Whether a mission has any of the field's terms. */
bool terms_any(const qtr_mission *mission);

/* Whether they ask what a table for any progress does not know: it takes one class, one look, and neither ready times
 * nor ends; or what one for any start does not: who must be home in time. */
bool terms_depend_on_progress(const qtr_mission *mission);
bool terms_end(const qtr_mission *mission);

/* Whether it has terms that spots cannot take: they take scan times and a deadline. */
bool terms_leave_no_spots(const qtr_mission *mission);

#endif
