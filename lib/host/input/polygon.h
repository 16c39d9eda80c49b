/* Polygons on the planning grid. */
#ifndef QUARTER_HOST_POLYGON_H
#define QUARTER_HOST_POLYGON_H

#include "host/input/frame.h"

#define POLYGON_CORNERS 4096

typedef struct {
  int corners;
  frame_point corner[POLYGON_CORNERS]; /* in cells; the last one joins the first */
} polygon;

/* Add a corner; one that is where the last one is, is none. False: there are POLYGON_CORNERS already. */
bool polygon_add(polygon *p, frame_point corner);

/* NULL, or what is wrong with the corners and how to mend it, as the end of a sentence ("has 2 corners; ..."). A last
 * corner that repeats the first is dropped. */
#define POLYGON_WRONG 200
const char *polygon_check(polygon *p, char out[POLYGON_WRONG]);

enum polygon_cells {
  POLYGON_CUTS,    /* a part of it, however little, is in it */
  POLYGON_MIDDLES, /* its middle is */
  POLYGON_HOLDS    /* its middle is, and no edge goes through it */
};

/* Set mask[cell] of the polygon's cells, all others being 0; how many they are. It must have passed polygon_check(). */
size_t polygon_mark(uint8_t *mask, const polygon *p, const qtr_mission *mission, enum polygon_cells which);

/* Its area in cells, and that of what lies on the map. */
double polygon_area(const polygon *p);
double polygon_area_on(const polygon *p, const qtr_mission *mission);

#endif
