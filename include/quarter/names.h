/* What a table's file holds for people, behind the part that a robot reads (docs/policy-format.md): the names of the
 * mission, its places and its seekers, and where on the globe its map lies. */
#ifndef QUARTER_NAMES_H
#define QUARTER_NAMES_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

#define QTR_NAME_BYTES 128 /* of a name in UTF-8, and a 0 at its end */

#define QTR_SITE_NAME_BYTES 64 /* of a place's or a seeker's, likewise */

/* Names in UTF-8; empty: it has none, and goes by its number. */
typedef struct {
  char mission[QTR_NAME_BYTES];
  char place[QTR_MAX_PLACES][QTR_SITE_NAME_BYTES]; /* as the table numbers them */
  char seeker[QTR_MAX_SEEKERS][QTR_SITE_NAME_BYTES];
} qtr_names;

#define QTR_GEO_ONE INT64_C(1000000000)  /* units of a degree, and of a radian */
#define QTR_GEO_TURN INT64_C(6283185308) /* a whole turn, rounded up */

/* Where the map frame's origin (x = 0, y = 0) lies on the WGS84 ellipsoid, in units of 1 / QTR_GEO_ONE. */
typedef struct {
  bool given;        /* false: nobody said, and the rest is 0 */
  int64_t latitude;  /* degrees north, -90..90 */
  int64_t longitude; /* degrees east, -180..180 */
  int64_t yaw;       /* radians by which the frame's x axis is turned from east, counter-clockwise, within 2 pi */
} qtr_geo;

/* Bytes that they take; 0 where there is nothing to keep. A name that fills its array has no end: it is left out. */
uint32_t qtr_names_size(const qtr_names *names, const qtr_geo *geo);

/* Write as many. */
void qtr_names_write(uint8_t *bytes, const qtr_names *names, const qtr_geo *geo);

/* Read both from all that stands behind the robot's part (policy->size); empty and not given where there are none.
 * QTR_OK, or QTR_ERR_CORRUPT if the bytes are damaged, the origin lies out of its ranges, or a name is of a place or
 * seeker that this build cannot hold; what was read is worthless then. */
int qtr_names_read(qtr_names *names, qtr_geo *geo, const uint8_t *bytes, uint32_t size);

QTR_C_END

#endif
