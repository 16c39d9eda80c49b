/* A family's problem, for other solvers to read, for Quarter to learn, and for the referee to judge plans of it. */
#ifndef QUARTER_BENCH_COMPETE_H
#define QUARTER_BENCH_COMPETE_H

#include <stdio.h>

#include "field/asked.h"

/* Do what asked->task is, and print JSON. Plans to judge are read from `in`: a line of looks for each robot, plan after
 * plan. The exit status. */
int bench_compete(FILE *in, FILE *out, const bench_asked *asked);

#endif
