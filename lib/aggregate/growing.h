/* Growing regions until the ground is covered. */
#ifndef QUARTER_AGGREGATE_GROWING_H
#define QUARTER_AGGREGATE_GROWING_H

#include "aggregate/division.h"

/* Cover all free cells by regions. QTR_OK, QTR_ERR_LIMIT for more regions than the build holds, or QTR_ERR_STOPPED. */
int qtr_division_grow(const qtr_division *d);

#endif
