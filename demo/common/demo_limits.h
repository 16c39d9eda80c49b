/* What the demo holds and what its robots are like, once for all its parts. Not "limits.h": on an include path that
 * would stand in for the C library's. */
#ifndef QUARTER_DEMO_LIMITS_H
#define QUARTER_DEMO_LIMITS_H

#include <stdint.h>

#include "quarter/config.h"

/* ---- how many: as the messages of lcmtypes/ have it ---- */

#define DEMO_MOST_ROBOTS 16
#define DEMO_MOST_PLACES 128
#define DEMO_RAYS 24 /* of a robot's range finder */

_Static_assert(DEMO_MOST_ROBOTS <= QTR_MAX_SEEKERS, "--robots offers what a table can be learnt for");
_Static_assert(DEMO_MOST_PLACES <= QTR_MAX_PLACES, "--mine offers what a table can hold");
_Static_assert(DEMO_MOST_ROBOTS <= INT8_MAX, "a place's scanner, or -1, is a byte");

#define DEMO_NAME_SIZE 128 /* bytes of a mission's name, with its NUL */

/* ---- a robot: lengths in hundredths of a cell, so that they can be held against one another here ---- */

enum {
  DEMO_RADIUS_100 = 12,
  DEMO_AXLE_100 = 20,
  DEMO_LANE_100 = 20,
  DEMO_MINE_RANGE_100 = 36,
  DEMO_EYE_RANGE_100 = 150,
  DEMO_EYE_TRUST_100 = 145
};

_Static_assert(DEMO_AXLE_100 <= 2 * DEMO_RADIUS_100, "the wheels are under the body");
_Static_assert(DEMO_LANE_100 > DEMO_RADIUS_100, "two that keep right pass one another");
_Static_assert(DEMO_LANE_100 + DEMO_RADIUS_100 <= 50, "and do so in a corridor of one cell");
_Static_assert(DEMO_MINE_RANGE_100 > 2 * DEMO_RADIUS_100, "a mine is seen past another robot's body");
_Static_assert(DEMO_EYE_TRUST_100 < DEMO_EYE_RANGE_100, "a ray that reaches nothing is told from one that does");

#define DEMO_RADIUS (DEMO_RADIUS_100 / 100.0)         /* cells: of its body */
#define DEMO_AXLE (DEMO_AXLE_100 / 100.0)             /* cells between its wheels */
#define DEMO_LANE (DEMO_LANE_100 / 100.0)             /* cells that it keeps to the right of a cell's middle */
#define DEMO_MINE_RANGE (DEMO_MINE_RANGE_100 / 100.0) /* cells from its middle at which its sensor sees a mine */
#define DEMO_EYE_RANGE (DEMO_EYE_RANGE_100 / 100.0)   /* cells that its rays reach */
#define DEMO_EYE_TRUST (DEMO_EYE_TRUST_100 / 100.0)   /* cells: what it sees beyond it does not look at */

#endif
