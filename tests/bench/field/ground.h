/* The ground of a family: cells, and nobody on them yet. */
#ifndef QUARTER_BENCH_GROUND_H
#define QUARTER_BENCH_GROUND_H

#include <stdint.h>

#include "host/base/fault.h"
#include "quarter/mission.h"

/* Columns, rows and cells of a mission, by an enum family. 0, or -1 with *why set. */
int ground_draw(qtr_mission *mission, int family, uint32_t side, uint64_t *state, fault *why);

#endif
