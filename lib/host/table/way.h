/* The way that a robot walks by a table, in nominal time. */
#ifndef QUARTER_HOST_WAY_H
#define QUARTER_HOST_WAY_H

#include <stddef.h>

#include "host/table/table.h"

#define WAY_NO_PLACE (-1)

typedef struct {
  qtr_cell cell;  /* of the table's grid */
  qtr_steps step; /* of arrival; at a place, of the end of its scan */
  int place;      /* of the table, where the robot goes to one; WAY_NO_PLACE: it passes through */
} waypoint;

typedef struct {
  waypoint *at;
  size_t count; /* 1 or more: the start is the first */
} way;

/* Every cell that a seeker enters on its route, one after another, and where it visits several places of one cell, or
 * looks again, that cell once for each. 0 with *w to be freed, or -1 with *why set. */
int way_walk(way *w, const table *t, int seeker, const table_route *route, fault *why);

/* Leave the start, the places and the corners: from one of them to the next the robot goes straight along a row or a
 * column. */
void way_keep_corners(way *w);

/* Leave the start and the places. */
void way_keep_places(way *w);

void way_free(way *w);

#endif
