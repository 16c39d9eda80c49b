/* What the formats of `quarter export` share. Private to export_*.c and command_export.c. */
#ifndef QUARTER_TOOLS_EXPORT_PARTS_H
#define QUARTER_TOOLS_EXPORT_PARTS_H

#include <stdbool.h>
#include <stdio.h>

#include "host/base/fault.h"
#include "host/table/table.h"
#include "host/table/way.h"

/* A waypoint: the start, a corner, or a place that the robot goes to. */
typedef struct {
  unsigned column, row;       /* on the map that the table was learnt on */
  double x, y;                /* metres in the map frame; NAN where the map has none */
  double east, north;         /* metres from the geographic origin; those of the map frame where there is none */
  double latitude, longitude; /* degrees; NAN where they were not asked for */
  double heading; /* radians in the map frame, counter-clockwise from x: to the next point, at the last as before */
  qtr_steps step; /* of arrival */
  double seconds; /* the same; NAN where the table does not say how long a step is */
  double hold;    /* seconds to stay at it: at a place, for the scan; NAN where they are not known */
  int place;      /* of the table; WAY_NO_PLACE */
  bool late;      /* it comes after the mission's deadline */
} export_point;

typedef struct {
  int robot;
  size_t count;
  export_point *point;
  int places; /* that it visits */
} export_way;

typedef struct {
  const table *t;
  int ways; /* of one robot, or of all */
  export_way way[QTR_MAX_SEEKERS];
  const char *source; /* the table's file, for people */
  double altitude;    /* metres above home to fly at; 0: on the ground */
  double hold;        /* seconds to stay at every place; below 0: as long as each one's scan takes */
} export_plan;

/* MAVLink's numbers of commands and of the frame that its formats use. */
enum { MAV_WAYPOINT = 16, MAV_TAKEOFF = 22, MAV_RELATIVE_ALTITUDE = 3 };

/* What a format's points are in. */
enum export_unit { EXPORT_CELLS, EXPORT_METRES, EXPORT_DEGREES };

typedef struct {
  const char *name;
  const char *ending;    /* of files that are taken for it; NULL: none are */
  enum export_unit unit; /* without which it cannot be written */
  bool one_robot;        /* a file holds one robot's way */
  void (*write)(FILE *out, const export_plan *plan);
} export_format;

/* Ended by one without a name. */
extern const export_format export_formats[];

/* ---- export_plan.c ---- */

/* The ways of robot `robot`, or of all where it is -1, in cells, and in metres where the map has them; the corners left
 * out with `places_alone`. 0 with the plan to be freed, or -1 with *why set. */
int export_plan_make(export_plan *plan, const table *t, int robot, bool places_alone, fault *why);

/* Add degrees; the table has a geographic origin. 0, or -1 with *why set. */
int export_plan_locate(export_plan *plan, fault *why);

void export_plan_free(export_plan *plan);

/* The first point to go to: behind the start, unless that is a place. */
static inline size_t export_first(const export_way *w) {
  return w->point[0].place == WAY_NO_PLACE ? 1 : 0;
}

/* ---- the formats ---- */

void export_csv(FILE *out, const export_plan *plan);
void export_geojson(FILE *out, const export_plan *plan);
void export_gpx(FILE *out, const export_plan *plan);
void export_moos(FILE *out, const export_plan *plan);
void export_nav2(FILE *out, const export_plan *plan);
void export_qgc_plan(FILE *out, const export_plan *plan);
void export_qgc_wpl(FILE *out, const export_plan *plan);

#endif
