/* Times and what objectives come to, for people: in seconds where it is said how long a step is, else in steps. */
#ifndef QUARTER_TOOLS_FIGURES_H
#define QUARTER_TOOLS_FIGURES_H

#include <stdbool.h>
#include <stdint.h>

#include "host/base/count.h"
#include "host/base/json.h"
#include "quarter/config.h"

/* `step_seconds` is 0 where nobody says. */

/* "12.5 steps", or "6.25 s" */
count_text figures_time(double steps, double step_seconds);

/* "step 14", or "step 14, 7 s" */
count_text figures_moment(qtr_steps step, double step_seconds);

/* ", after the deadline" of what is late, else nothing. */
const char *figures_late(bool late);

/* "4 places", or, where some are looked at again, "4 places (5 looks)". */
count_text figures_places(unsigned places, unsigned looks);

/* An objective's figure, whose times are in steps: "12.5 steps", "6.25 s", "8.15523" */
count_text figures_told(uint8_t objective, double figure, double step_seconds);

/* By what such a figure is multiplied to be in its own unit: a step's seconds for a time, else 1. */
double figures_unit(uint8_t objective, double step_seconds);

/* The member `key`, steps as seconds; none where nobody says. */
void figures_json_seconds(json *j, const char *key, double steps, double step_seconds);

#endif
