/* What a table's file holds for people, behind the part that a robot reads (docs/policy-format.md): the mission's
 * name. */
#ifndef QUARTER_NAMES_H
#define QUARTER_NAMES_H

#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

#define QTR_NAME_BYTES 128 /* of a name in UTF-8, and a 0 at its end */

/* Bytes that a name takes; 0 for one that is empty or too long, which is left out. */
uint32_t qtr_names_size(const char *mission);

/* Write as many. */
void qtr_names_write(uint8_t *bytes, const char *mission);

/* Read the name, QTR_NAME_BYTES at most, from all that stands behind the robot's part (policy->size); empty if there is
 * none. QTR_OK, or QTR_ERR_CORRUPT with an empty name if the bytes are damaged. */
int qtr_names_read(char *mission, const uint8_t *bytes, uint32_t size);

QTR_C_END

#endif
