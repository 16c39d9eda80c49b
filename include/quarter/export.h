/* The learner's result as the bytes of a policy table (docs/policy-format.md). */
#ifndef QUARTER_EXPORT_H
#define QUARTER_EXPORT_H

#include <stdint.h>

#include "quarter/learner.h"

/* Bytes that the table takes. */
uint32_t qtr_export_size(const qtr_learner *learner);

/* Write the table of the best game found so far to `bytes`, which holds `size` bytes, and open it once to be sure that a
 * robot will. Returns the bytes written, or QTR_ERR_SPACE, or an error of qtr_policy_open(). */
int32_t qtr_export(const qtr_learner *learner, uint8_t *bytes, uint32_t size);

#endif
