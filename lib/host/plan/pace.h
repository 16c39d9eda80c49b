/* How long a step is: a fixed number of seconds, in which every class of robots takes a whole number of steps for a
 * cell. */
#ifndef QUARTER_HOST_PACE_H
#define QUARTER_HOST_PACE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

#define PACE_ROUNDING 0.01         /* of a travel time at most, relative, where the step is chosen here */
#define PACE_STEPS_MOST 1000000000 /* longer times are taken for this */

typedef struct {
  bool stated; /* seconds are stated; else a step is one for want of another, and people are told of steps */
  double seconds_per_step; /* above 0 */
  double rounding;         /* of travel times, relative: the worst class's */
  double end_rounding;     /* of scans, ready times, endurances and the deadline: the worst one's */
  double gamma;            /* the discount a second */
} pace;

/* Choose the step for classes that take `cell_seconds` for a cell of cost 1, and how many of them that is. One time for
 * all is a step; of different ones it is the longest that rounds none by more than PACE_ROUNDING. `step_seconds` above
 * 0 is the step all the same. */
void pace_choose(pace *p, uint32_t *cell_steps, const double *cell_seconds, unsigned classes, double step_seconds);

/* Seconds in whole steps, rounded up and down; what that changes goes into p->end_rounding. */
qtr_steps pace_steps_up(pace *p, double seconds);
qtr_steps pace_steps_down(pace *p, double seconds);

#endif
