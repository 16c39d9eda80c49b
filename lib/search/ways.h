/* The ways that walks (search/gains.h) go by, from each place to all others. */
#ifndef QUARTER_SEARCH_WAYS_H
#define QUARTER_SEARCH_WAYS_H

#include <stdint.h>

#include "quarter/config.h"
#include "search/rows.h"

/* Steps from the start of the tour at `place` to the start of the next target's; QTR_NEVER: there is no way. */
qtr_steps qtr_ways_apart(const qtr_gains *gains, unsigned kind, unsigned place, unsigned target);

/* How far a step lies, `into` (0 to slot_steps - 1) a slot, on the line to the next one: 0..1; with a clock always
 * 0. */
double qtr_ways_share(const qtr_gains *gains, uint32_t slot, qtr_steps into);

/* Measure all of them in slots, once these are cut and entries laid. */
void qtr_ways_measure(qtr_gains *gains);

#endif
