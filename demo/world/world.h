/* The physical world: robots on wheels among walls, on ground that may be slow, over mines. Seen from above, free of
 * gravity, in cells (ground.h). world.c is the only file that includes Box2D.
 *
 * Robots are round, with two wheels. What the wheels are told becomes motion through noise, slip and limited grip. The
 * same seed and the same commands give the same run, bit for bit.
 */
#ifndef QUARTER_DEMO_WORLD_H
#define QUARTER_DEMO_WORLD_H

#include <stdbool.h>
#include <stdint.h>

#include "demo_limits.h"
#include "ground.h"
#include "quarter/policy.h"

#define WORLD_STEP (1.0 / 60.0) /* seconds */
#define WORLD_WHEEL_NOISE 0.05  /* standard deviation of a wheel's speed, relative */

typedef struct world world;

typedef struct {
  point at;
  double heading; /* radians, counter-clockwise from x */
} world_pose;

/* The world of a policy table's map, its robots on its start cells. NULL if there is no memory. */
world *world_new(const qtr_policy *policy, uint64_t seed);
void world_free(world *w);

/* Advance by WORLD_STEP. */
void world_step(world *w);

/* Wheel speeds, in cells a second, from now on. */
void world_drive(world *w, int robot, double left, double right);

world_pose world_pose_of(const world *w, int robot);

/* Distances that `count` rays reach, evenly spread counter-clockwise from the heading; DEMO_EYE_RANGE where nothing
 * is. */
void world_look(const world *w, int robot, float *range, int count);

/* ---- faults ---- */

void world_stop_wheels(world *w, int robot, bool stopped); /* stuck, or lost: the body stays in the way */
void world_slip(world *w, int robot, double share);        /* of its speed that the wheels lose, at random, 0..1 */

/* Make a wall of a cell, for good. False, with nothing done, while a robot is in it or reaches into it. */
bool world_shut(world *w, qtr_cell cell);

/* Times that two robots ran into one another. */
int world_collisions(const world *w);

#endif
