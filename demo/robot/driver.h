/* Driving: from where a robot is and where it wants to be next, past what its rays see, to the speeds of its wheels.
 *
 * Robots keep right: each cell is left through the right half of its side, so that two that meet in a corridor one cell
 * wide pass one another without knowing of each other. What stands in the way all the same is driven around, to the
 * right if both sides will do.
 */
#ifndef QUARTER_DEMO_DRIVER_H
#define QUARTER_DEMO_DRIVER_H

#include "demo_limits.h"
#include "ground.h"
#include "quarter/field.h"

#define DRIVER_SPEED 1.0 /* cells a second where the ground is good */

/* What a robot knows of its surroundings, in cells. */
typedef struct {
  point at;
  double heading;
  int rays;
  const float *range; /* evenly spread, counter-clockwise from the heading */
  double reach;       /* of the rays: there is nothing up to here where a ray says so */
  double speed;       /* cells a second that it drives where nothing is in the way */
} driver_view;

typedef struct {
  double left, right; /* wheel speeds, cells a second */
} driver_wheels;

/* The point to steer for on the way to the field's target cell, `lane` cells to the right of the cells' middles. */
point driver_aim(const ground *g, const qtr_field *way, qtr_cell target, point at, double lane);

/* Wheel speeds that bring the robot there. */
driver_wheels driver_steer(const driver_view *view, point aim);

#endif
