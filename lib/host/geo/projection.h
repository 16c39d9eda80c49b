/* Metres around a point of the globe and degrees (WGS84): azimuthal equidistant, so that distance and direction from
 * the origin are true. PROJ is behind it, and only here; it is loaded when the first projection is opened. */
#ifndef QUARTER_HOST_PROJECTION_H
#define QUARTER_HOST_PROJECTION_H

#include "host/base/fault.h"
#include "quarter/names.h"

typedef struct projection projection;

/* A projection about an origin that is given, its yaw left aside. NULL with *why set: what must be installed, where
 * PROJ was not there when Quarter was built or is not there now. */
projection *projection_open(const qtr_geo *origin, fault *why);

/* 0, or -1 for a point that is not on the globe. */
int projection_to_degrees(projection *p, double east, double north, double *latitude, double *longitude);
int projection_to_metres(projection *p, double latitude, double longitude, double *east, double *north);

void projection_close(projection *p); /* NULL is none */

#endif
