/* What a robot is like, as a table with the field's terms says: how fast it drives, where it may, how long a look takes
 * it, when it is ready and how long its battery lasts. The demo's world goes by a clock on which the fastest of a
 * mission's robots drives a cell a second; without such terms all do.
 *
 * A plan counts on the endurance that its mission states. A battery holds a little more: of that reserve robots spend
 * half on wheels that slip and on others in the way, and keep the rest for the way home. */
#ifndef QUARTER_DEMO_BODY_H
#define QUARTER_DEMO_BODY_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/robot.h"

#define BODY_RESERVE 0.05 /* of the endurance: what a robot allows itself beyond it; its battery holds twice that */
#define BODY_TIRELESS INT64_MAX /* as a moment: never */

typedef struct {
  const qtr_policy *policy;
  unsigned self;
  double speed;    /* cells a second on good ground, above 0 up to DRIVER_SPEED */
  double step;     /* microseconds of the world's clock that a step of the plan takes */
  int64_t ready;   /* utime from which it is in the game */
  int64_t back_by; /* utime by which it wants to be home; BODY_TIRELESS: it has no end */
  int64_t empty;   /* utime from which its battery moves it no more; likewise */
} robot_body;

/* Robot `self`'s of a table, which must outlive it. */
robot_body body_of(const qtr_policy *policy, unsigned self);

/* Seconds of the world's clock that a step of a table's plan takes; and seconds of the mission in one of that clock's,
 * 1 where it says nothing of seconds. */
double body_step_seconds(const qtr_policy *policy);
double body_pace(const qtr_policy *policy);

bool body_tires(const robot_body *body);

/* Whether it may visit a place of its table's at all. */
bool body_may_visit(const robot_body *body, unsigned place);

/* Microseconds that a look at a place takes it, and that it drives over ground that costs so many steps to a robot of
 * speed 1. */
int64_t body_scan(const robot_body *body, unsigned place);
int64_t body_travel(const robot_body *body, unsigned ground_steps);

/* Whether it can leave at `utime`, drive so far to a place, look there and be home in time. */
bool body_lasts(const robot_body *body, int64_t utime, unsigned ground_steps, unsigned place);

#endif
