/* GeoJSON, RFC 7946: a line a robot, with the steps of its points, and a point a place and start. */
#include <math.h>

#include "export_parts.h"
#include "host/base/json.h"

static void put_position(json *j, const char *key, const export_point *p) {
  json_flat_array(j, key);
  json_number(j, NULL, p->longitude);
  json_number(j, NULL, p->latitude);
  json_end_array(j);
}

static void begin_feature(json *j, const char *kind) {
  json_object(j, NULL);
  json_string(j, "type", "Feature");
  json_object(j, "geometry");
  json_string(j, "type", kind);
}

static void begin_properties(json *j, const table *t, const export_way *w, const char *name) {
  json_end_object(j);
  json_object(j, "properties");
  json_string(j, "name", name);
  json_integer(j, "robot", w->robot);
  json_string(j, "robot_name", table_robot_name(t, w->robot).text);
}

static void end_feature(json *j) {
  json_end_object(j);
  json_end_object(j);
}

static void put_line(json *j, const table *t, const export_way *w) {
  if (w->count < 2) return; /* a line of one point is none */
  begin_feature(j, "LineString");
  json_array(j, "coordinates");
  for (size_t i = 0; i < w->count; i++) put_position(j, NULL, &w->point[i]);
  json_end_array(j);
  begin_properties(j, t, w, table_robot_name(t, w->robot).text);
  json_flat_array(j, "steps");
  for (size_t i = 0; i < w->count; i++) json_natural(j, NULL, w->point[i].step);
  json_end_array(j);
  end_feature(j);
}

static void put_place(json *j, const table *t, const export_way *w, size_t i) {
  const export_point *p = &w->point[i];
  const bool is_place = p->place != WAY_NO_PLACE;
  begin_feature(j, "Point");
  put_position(j, "coordinates", p);
  begin_properties(j, t, w, is_place ? table_place_name(t, (unsigned)p->place).text : "start");
  if (is_place) json_integer(j, "place", t->number[p->place]);
  if (is_place) json_number(j, "likelihood", table_probability(t, (unsigned)p->place));
  json_natural(j, "step", p->step);
  if (!isnan(p->seconds)) json_number(j, "seconds", p->seconds);
  if (is_place && !isnan(p->hold)) json_number(j, "hold_seconds", p->hold);
  if (t->claim.deadline > 0) json_bool(j, "after_deadline", p->late);
  end_feature(j);
}

void export_geojson(FILE *out, const export_plan *plan) {
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "type", "FeatureCollection");
  json_array(&j, "features");
  for (int i = 0; i < plan->ways; i++) {
    const export_way *w = &plan->way[i];
    put_line(&j, plan->t, w);
    for (size_t at = 0; at < w->count; at++)
      if (at == 0 || w->point[at].place != WAY_NO_PLACE) put_place(&j, plan->t, w, at);
  }
  json_end_array(&j);
  json_end_object(&j);
}
