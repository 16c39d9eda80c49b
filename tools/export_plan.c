#include <math.h>
#include <stdlib.h>

#include "export_parts.h"
#include "host/geo/projection.h"

/* ---- one waypoint ---- */

static export_point point_at(const table *t, const waypoint *at) {
  const qtr_frame frame = qtr_policy_frame(&t->policy);
  int64_t x_um, y_um;
  const bool metric = qtr_frame_centre(&frame, &t->policy.grid, at->cell, &x_um, &y_um);
  export_point p = {.column = table_column(t, at->cell),
                    .row = table_row(t, at->cell),
                    .x = metric ? (double)x_um / 1e6 : NAN,
                    .y = metric ? (double)y_um / 1e6 : NAN,
                    .latitude = NAN,
                    .longitude = NAN,
                    .step = at->step,
                    .seconds = table_step_seconds(t) > 0.0 ? at->step * table_step_seconds(t) : NAN,
                    .place = at->place,
                    .late = table_is_late(t, at->step)};
  const double yaw = (double)t->geo.yaw / (double)QTR_GEO_ONE;
  p.east = cos(yaw) * p.x - sin(yaw) * p.y;
  p.north = sin(yaw) * p.x + cos(yaw) * p.y;
  return p;
}

/* The way from a place to itself is its scan. */
static double hold_at(const export_plan *plan, int robot, const export_point *p) {
  const table *t = plan->t;
  if (p->place == WAY_NO_PLACE) return 0.0;
  if (plan->hold >= 0.0) return plan->hold;
  const unsigned place = (unsigned)p->place;
  const qtr_steps scan = qtr_board_steps(&t->policy.board, (unsigned)robot, place, place);
  return scan == 0 ? 0.0 : table_step_seconds(t) > 0.0 ? scan * table_step_seconds(t) : NAN;
}

/* Each looks to the next one; the last, and one that stays where it is, as the one before. */
static void turn(export_way *w) {
  double heading = 0.0;
  for (size_t i = 0; i < w->count; i++) {
    const export_point *here = &w->point[i], *next = i + 1 < w->count ? here + 1 : here;
    if (next->x != here->x || next->y != here->y) heading = atan2(next->y - here->y, next->x - here->x);
    w->point[i].heading = heading;
  }
}

/* ---- one robot, and all ---- */

static int add_way(export_plan *plan, int robot, const table_route *route, bool places_alone, fault *why) {
  way walked;
  if (way_walk(&walked, plan->t, robot, route, why) != 0) return -1;
  if (places_alone)
    way_keep_places(&walked);
  else
    way_keep_corners(&walked);
  export_way *w = &plan->way[plan->ways++];
  *w = (export_way){.robot = robot, .count = walked.count, .places = route->places};
  w->point = malloc(walked.count * sizeof *w->point);
  for (size_t i = 0; w->point != NULL && i < walked.count; i++) w->point[i] = point_at(plan->t, &walked.at[i]);
  way_free(&walked);
  if (w->point == NULL) return fault_set(why, "no memory for the way of robot %d", robot);
  for (size_t i = 0; i < w->count; i++) w->point[i].hold = hold_at(plan, robot, &w->point[i]);
  turn(w);
  return 0;
}

int export_plan_make(export_plan *plan, const table *t, int robot, bool places_alone, fault *why) {
  table_route *routes = calloc(t->policy.board.seekers, sizeof *routes);
  if (routes == NULL) return fault_set(why, "no memory for the routes");
  plan->t = t;
  table_routes(t, routes);
  int status = 0;
  for (int i = 0; i < t->policy.board.seekers && status == 0; i++)
    if (robot < 0 || robot == i) status = add_way(plan, i, &routes[i], places_alone, why);
  free(routes);
  if (status != 0) export_plan_free(plan);
  return status;
}

/* Nine decimals of a degree are a tenth of a millimetre. */
static double rounded(double degrees) {
  return round(degrees * 1e9) / 1e9;
}

static int locate(projection *projected, export_way *w) {
  int status = 0;
  for (size_t i = 0; i < w->count && status == 0; i++) {
    export_point *p = &w->point[i];
    status = projection_to_degrees(projected, p->east, p->north, &p->latitude, &p->longitude);
    p->latitude = rounded(p->latitude);
    p->longitude = rounded(p->longitude);
  }
  return status;
}

int export_plan_locate(export_plan *plan, fault *why) {
  projection *projected = projection_open(&plan->t->geo, why);
  if (projected == NULL) return -1;
  int status = 0;
  for (int i = 0; i < plan->ways && status == 0; i++) status = locate(projected, &plan->way[i]);
  projection_close(projected);
  return status == 0 ? 0 : fault_set(why, "the map lies too far from its geographic origin for degrees");
}

void export_plan_free(export_plan *plan) {
  for (int i = 0; i < plan->ways; i++) free(plan->way[i].point);
  plan->ways = 0;
}
