/* What the benchmarks share. */
#ifndef QUARTER_BENCH_H
#define QUARTER_BENCH_H

#include <stdbool.h>

#include "quarter/learner.h"
#include "quarter/mission.h"

/* A random mission by its seed: a fifth of the cells blocked, all seekers in a corner, one place in three of three
 * times the weight, all in reach. It lasts until the next one. */
qtr_mission *bench_map(unsigned seed, int side, int places, int seekers, int objective);

/* Learn a mission for so many steps at most. The learner lasts until the next one. */
qtr_learner *bench_learn(const qtr_mission *mission, unsigned steps);

/* What taking over for a robot that is lost, or slow, is worth. The exit status. */
int bench_takeover(bool as_json);

#endif
