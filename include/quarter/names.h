/* What a table's file holds for people, behind the part that a robot reads (docs/policy-format.md): the mission's
 * name, and where on the globe its map lies. */
#ifndef QUARTER_NAMES_H
#define QUARTER_NAMES_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

#define QTR_NAME_BYTES 128 /* of a name in UTF-8, and a 0 at its end */

#define QTR_GEO_ONE INT64_C(1000000000)  /* units of a degree, and of a radian */
#define QTR_GEO_TURN INT64_C(6283185308) /* a whole turn, rounded up */

/* Where the map frame's origin (x = 0, y = 0) lies on the WGS84 ellipsoid, in units of 1 / QTR_GEO_ONE. */
typedef struct {
  bool given;        /* false: nobody said, and the rest is 0 */
  int64_t latitude;  /* degrees north, -90..90 */
  int64_t longitude; /* degrees east, -180..180 */
  int64_t yaw;       /* radians by which the frame's x axis is turned from east, counter-clockwise, within 2 pi */
} qtr_geo;

/* Bytes that the two take; 0 where there is neither. A name that is empty or too long is left out. */
uint32_t qtr_names_size(const char *mission, const qtr_geo *geo);

/* Write as many. */
void qtr_names_write(uint8_t *bytes, const char *mission, const qtr_geo *geo);

/* Read both, the name into QTR_NAME_BYTES, from all that stands behind the robot's part (policy->size); empty and not
 * given where there are none. QTR_OK, or QTR_ERR_CORRUPT if the bytes are damaged or the origin lies out of its
 * ranges; what was read is worthless then. */
int qtr_names_read(char *mission, qtr_geo *geo, const uint8_t *bytes, uint32_t size);

QTR_C_END

#endif
