/* The plain-text mission file of QGroundControl, Mission Planner and MAVProxy, version 110. Its first item is home:
 * where the robot starts. */
#include <math.h>

#include "export_parts.h"

static void put_item(FILE *out, const export_plan *plan, const export_point *p, size_t index, int command) {
  const double hold = index == 0 || command != MAV_WAYPOINT || isnan(p->hold) ? 0.0 : p->hold;
  fprintf(out, "%zu\t%d\t%d\t%d\t%.3f\t0\t0\t0\t%.9f\t%.9f\t%.3f\t1\n", index, index == 0, MAV_RELATIVE_ALTITUDE,
          command, hold, p->latitude, p->longitude, plan->altitude);
}

void export_qgc_wpl(FILE *out, const export_plan *plan) {
  const export_way *w = &plan->way[0];
  size_t index = 0;
  fputs("QGC WPL 110\n", out);
  put_item(out, plan, &w->point[0], index++, MAV_WAYPOINT);
  if (plan->altitude > 0.0) put_item(out, plan, &w->point[0], index++, MAV_TAKEOFF);
  for (size_t i = export_first(w); i < w->count; i++) put_item(out, plan, &w->point[i], index++, MAV_WAYPOINT);
}
