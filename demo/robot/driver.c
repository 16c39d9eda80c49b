#include "driver.h"

#include <math.h>
#include <stdbool.h>

#define PI 3.14159265358979323846
#define MARGIN 0.03 /* cells of air on either side of the body */
#define AHEAD 0.25  /* cells beyond a cell's side that are aimed for */
#define LOOK 0.6    /* cells that should be free ahead */
#define TURN 5.0    /* radians a second for each radian off the way */
#define FASTEST_TURN 6.0
#define CREEP 0.12 /* of the speed, where it is tight: who stands still never gets out of anybody's way */

/* ---- where to ---- */

point driver_aim(const ground *g, const qtr_field *way, qtr_cell target, point at, double lane) {
  const qtr_cell here = ground_cell(g, at);
  const point goal = ground_centre(g, target);
  if (here == QTR_NO_CELL || here == target) return goal;
  const qtr_cell next = qtr_field_next(way, &g->grid, here);
  if (next == QTR_NO_CELL || next == here) return goal;
  const point from = ground_centre(g, here);
  const point to = ground_centre(g, next);
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  /* Right of (dx, dy) is (dy, -dx). */
  return (point){from.x + (0.5 + AHEAD) * dx + lane * dy, from.y + (0.5 + AHEAD) * dy - lane * dx};
}

/* ---- past what ---- */

/* A heading comes from outside and may be any finite number: no loop over turns. */
static double wrap(double angle) {
  return remainder(angle, 2 * PI);
}

/* How far the robot can go in a direction, relative to its heading, before it touches what a ray has seen. */
static double clearance(const driver_view *view, double direction) {
  const double broad = DEMO_RADIUS + MARGIN;
  double least = view->reach;
  for (int ray = 0; ray < view->rays; ray++) {
    const double range = (double)view->range[ray];
    if (range >= view->reach) continue;
    const double off = wrap(2 * PI * ray / view->rays - direction);
    const double ahead = range * cos(off);
    const double aside = fabs(range * sin(off));
    if (ahead <= 0.0 || aside >= broad) continue;
    const double free = ahead - sqrt(broad * broad - aside * aside);
    if (free < least) least = free;
  }
  return least > 0.0 ? least : 0.0;
}

/* The way off the straight line counts, more to the left than to the right; so does what is in the way. */
static double cost_of(const driver_view *view, double direction, double wanted, double need) {
  const double off = wrap(direction - wanted);
  const double free = clearance(view, direction);
  return fabs(off) + (off > 0.0 ? 0.1 * off : 0.0) + (free < need ? 3.0 * (need - free) / need : 0.0);
}

static double choose_direction(const driver_view *view, double wanted, double need) {
  double best = wanted;
  double least = cost_of(view, wanted, wanted, need);
  for (int ray = 0; ray < view->rays; ray++) {
    const double direction = wrap(2 * PI * ray / view->rays);
    const double cost = cost_of(view, direction, wanted, need);
    if (cost >= least) continue;
    least = cost;
    best = direction;
  }
  return best;
}

/* ---- wheels ---- */

driver_wheels driver_steer(const driver_view *view, point aim) {
  const double dx = aim.x - view->at.x;
  const double dy = aim.y - view->at.y;
  const double away = hypot(dx, dy);
  const double need = away < LOOK ? away : LOOK;
  const double wanted = wrap(atan2(dy, dx) - view->heading);
  const double off = need > 0.02 ? choose_direction(view, wanted, need) : wanted;
  const double free = clearance(view, off);
  const double facing = cos(off) > 0.0 ? cos(off) : 0.0;
  double speed = view->speed * facing * facing;
  if (free < 0.3) speed *= CREEP + (1.0 - CREEP) * free / 0.3;
  double turn = TURN * off;
  turn = turn > FASTEST_TURN ? FASTEST_TURN : turn < -FASTEST_TURN ? -FASTEST_TURN : turn;
  return (driver_wheels){speed - turn * DEMO_AXLE / 2, speed + turn * DEMO_AXLE / 2};
}
