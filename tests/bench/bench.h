/* What the benchmarks share: random maps, one mission learnt at a time, and the measures themselves, a file each. */
#ifndef QUARTER_BENCH_H
#define QUARTER_BENCH_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/learner.h"
#include "quarter/mission.h"

#define BENCH_MAPS_MOST 100

/* ---- maps ---- */

/* A random mission by its seed: a fifth of the cells blocked, all seekers in a corner, one place in three of three
 * times the weight, all in reach. It lasts until the next one. */
qtr_mission *bench_map(unsigned seed, int side, int places, int seekers, int objective);

/* "discounted" or "time". */
const char *bench_objective(int objective);

/* ---- learning ---- */

/* Learn a mission for so many steps at most. The learner lasts until the next one. */
qtr_learner *bench_learn(const qtr_mission *mission, unsigned steps);

typedef struct {
  double seconds, episodes; /* seconds of the processor */
  qtr_certificate certificate;
} bench_run;

/* Learn a mission to its certificate, elemental tasks included, for so many seconds at most; `config` NULL: the
 * default. A mission that cannot be played ends the program. The learner lasts until the next one; so do its game and
 * the travel times, which are scratch. */
bench_run bench_learn_for(const qtr_mission *mission, const qtr_learner_config *config, double seconds);
qtr_learner *bench_learner(void);
const qtr_game *bench_game(void);
qtr_travel *bench_travel(void);

/* Sorts them. */
double bench_median(double *values, unsigned count);

/* ---- measures ---- */

/* What taking over for a robot that is lost, or slow, is worth. The exit status. */
int bench_takeover(bool as_json);

/* Memory of processes of their own, and of entries of the Q-table. Comes first. */
void bench_memory(void);

/* What looks that miss and endurance cost. */
void bench_terms(void);

/* What a longer horizon costs. */
void bench_horizon(void);

/* How fast the paper's setting learns, and what of it the Q-table's misses of the processor's caches take. */
void bench_exploring(void);

/* What a plan lacks after 1 s and 10 s. The exit status. */
int bench_plans(void);

/* Certificates against the exact optimum, on so many random missions from this seed on. The exit status. */
int bench_certificates(unsigned count, unsigned seed);

#endif
