/* The instances of the literature, learnt. */
#ifndef QUARTER_BENCH_INSTANCES_H
#define QUARTER_BENCH_INSTANCES_H

#include <stdio.h>

#include "field/asked.h"

/* Learn what asked->instances names, each for asked->time_limit, and print a list. The exit status. */
int bench_instances(FILE *out, const bench_asked *asked);

#endif
