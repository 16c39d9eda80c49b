/* QGroundControl's plan file, version 1: simple items. The way begins with a take-off where the robot flies. */
#include <math.h>

#include "export_parts.h"
#include "host/base/json.h"

/* MAVLink's numbers of an autopilot and of vehicles. */
enum { PX4 = 12, QUADROTOR = 2, ROVER = 10 };

static void put_item(json *j, const export_plan *plan, const export_point *p, size_t index, bool rises) {
  json_object(j, NULL);
  json_string(j, "type", "SimpleItem");
  json_null(j, "AMSLAltAboveTerrain");
  json_number(j, "Altitude", plan->altitude);
  json_integer(j, "AltitudeMode", 1);
  json_bool(j, "autoContinue", true);
  json_integer(j, "command", rises ? MAV_TAKEOFF : MAV_WAYPOINT);
  json_natural(j, "doJumpId", index + 1);
  json_integer(j, "frame", MAV_RELATIVE_ALTITUDE);
  json_flat_array(j, "params");
  json_number(j, NULL, rises || isnan(p->hold) ? 0.0 : p->hold);
  json_number(j, NULL, 0.0);
  json_number(j, NULL, 0.0);
  json_null(j, NULL);
  json_number(j, NULL, p->latitude);
  json_number(j, NULL, p->longitude);
  json_number(j, NULL, plan->altitude);
  json_end_array(j);
  json_end_object(j);
}

/* Metres a second that the robot's times are for; 5, which QGroundControl takes, where the table does not say. */
static double speed_of(const table *t, int robot) {
  const qtr_frame frame = qtr_policy_frame(&t->policy);
  const double cell_us =
      (double)t->claim.step_time_us * qtr_claim_cell_steps(&t->policy, t->policy.board.class_of[robot]);
  return cell_us > 0.0 ? frame.cell_size_um / cell_us : 5.0;
}

static void put_mission(json *j, const export_plan *plan, const export_way *w) {
  json_object(j, "mission");
  json_number(j, "cruiseSpeed", speed_of(plan->t, w->robot));
  json_number(j, "hoverSpeed", speed_of(plan->t, w->robot));
  json_integer(j, "firmwareType", PX4);
  json_integer(j, "vehicleType", plan->altitude > 0.0 ? QUADROTOR : ROVER);
  json_integer(j, "globalPlanAltitudeMode", 1);
  json_flat_array(j, "plannedHomePosition");
  json_number(j, NULL, w->point[0].latitude);
  json_number(j, NULL, w->point[0].longitude);
  json_number(j, NULL, 0.0);
  json_end_array(j);
  json_array(j, "items");
  const bool flies = plan->altitude > 0.0;
  size_t index = 0;
  if (flies) put_item(j, plan, &w->point[0], index++, true);
  for (size_t i = flies ? export_first(w) : 0; i < w->count; i++) put_item(j, plan, &w->point[i], index++, false);
  json_end_array(j);
  json_integer(j, "version", 2);
  json_end_object(j);
}

static void put_empty(json *j, const char *key, const char *first, const char *second) {
  json_object(j, key);
  json_flat_array(j, first);
  json_end_array(j);
  if (second != NULL) {
    json_flat_array(j, second);
    json_end_array(j);
  }
  json_integer(j, "version", 2);
  json_end_object(j);
}

void export_qgc_plan(FILE *out, const export_plan *plan) {
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "fileType", "Plan");
  json_string(&j, "groundStation", "QGroundControl");
  json_integer(&j, "version", 1);
  put_mission(&j, plan, &plan->way[0]);
  put_empty(&j, "geoFence", "circles", "polygons");
  put_empty(&j, "rallyPoints", "points", NULL);
  json_end_object(&j);
}
