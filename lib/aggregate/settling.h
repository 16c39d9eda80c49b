/* Bettering a division: cells go to the representatives that are nearer, and leftovers to their neighbours. */
#ifndef QUARTER_AGGREGATE_SETTLING_H
#define QUARTER_AGGREGATE_SETTLING_H

#include "aggregate/division.h"

/* Cells go to the nearer of two representatives. */
void qtr_division_exchange(const qtr_division *d);

/* The cells of small regions are given to their neighbours, where all of them can be. */
void qtr_division_dissolve(const qtr_division *d);

#endif
