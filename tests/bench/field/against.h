/* What a certificate claims against the exact optimum. */
#ifndef QUARTER_BENCH_AGAINST_H
#define QUARTER_BENCH_AGAINST_H

#include "quarter/learner.h"

/* A bound is never past the optimum, a plan never better than it, and a certified one never worse by more than its gap,
 * the one that was asked for. Under QTR_TIME less is better. NULL: all of that holds; else what does not. */
const char *against_optimum(const qtr_certificate *certificate, int objective, double gap, double optimum);

#endif
