/* The learner's best game as a policy table: the states that it meets, each with the choice made there. */
#ifndef QUARTER_EXPORT_H
#define QUARTER_EXPORT_H

#include <stdint.h>

#include "quarter/learner.h"

QTR_C_BEGIN

/* Bytes that the table takes; 0 for a game by legs (quarter/game.h), which has none. */
uint32_t qtr_export_size(const qtr_learner *learner);

/* Write it to `bytes`, which holds `size`, as qtr_table_write() does and with what that returns; QTR_ERR_ARGUMENT for a
 * game by legs. */
int32_t qtr_export(qtr_learner *learner, uint8_t *bytes, uint32_t size);

QTR_C_END

#endif
