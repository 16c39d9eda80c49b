#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "field/learn.h"
#include "support/scattered.h"

static qtr_mission mission;
static qtr_game game;
static qtr_travel travel;
static qtr_learner_memory memory;
static qtr_environment *ground;
static qtr_learner *learner;

/* ---- maps ---- */

qtr_mission *bench_map(unsigned seed, int side, int places, int seekers, int objective) {
  scattered_make(&mission, &game, &travel, seed, (unsigned)side, (unsigned)places, (unsigned)seekers, objective);
  return &mission;
}

const char *bench_objective(int objective) {
  return objective == QTR_TIME ? "time" : "discounted";
}

/* ---- learning ---- */

static void need(int status) {
  if (status == QTR_OK) return;
  fprintf(stderr, "bench: %s\n", qtr_strerror(status));
  exit(1);
}

static void begin_learner(const qtr_mission *learnt, const qtr_learner_config *config) {
  const qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(memory);
  qtr_learner_config standard;
  qtr_learner_config_default(&standard);
  need(qtr_game_init(&game, learnt, &travel, NULL));
  need(qtr_environment_init(&ground, memory.ground, sizeof memory.ground, &game, NULL, &travel));
  need(qtr_learner_init(&learner, &blocks, ground, NULL, config != NULL ? config : &standard));
}

qtr_learner *bench_learn(const qtr_mission *learnt, unsigned steps) {
  begin_learner(learnt, NULL);
  while (steps > 0 && qtr_learner_step(learner) == QTR_LEARNING) steps--;
  return learner;
}

bench_run bench_learn_for(const qtr_mission *learnt, const qtr_learner_config *config, double seconds) {
  const double begin = learn_clock();
  bench_run r;
  begin_learner(learnt, config);
  while (qtr_learner_step(learner) == QTR_LEARNING && learn_clock() - begin < seconds) {}
  qtr_learner_certificate(learner, &r.certificate);
  r.seconds = learn_clock() - begin;
  r.episodes = (double)r.certificate.episodes;
  return r;
}

qtr_learner *bench_learner(void) {
  return learner;
}

const qtr_game *bench_game(void) {
  return &game;
}

qtr_travel *bench_travel(void) {
  return &travel;
}

/* ---- figures ---- */

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a;
  const double y = *(const double *)b;
  return (x > y) - (x < y);
}

double bench_median(double *values, unsigned count) {
  qsort(values, count, sizeof *values, compare);
  return count % 2 == 1 ? values[count / 2] : 0.5 * (values[count / 2 - 1] + values[count / 2]);
}
