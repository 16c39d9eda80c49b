/* The benchmarks: what the project promises, measured on the machine at hand and printed beside the target. Nothing
 * here is a test; a slow machine fails nothing. `--clone` also times a fresh clone up to its certified demo policy;
 * `--takeover` measures what robots do for one that is lost, `--instances` learns those of the literature, and nothing
 * else. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench.h"
#include "field/asked.h"
#include "field/compete.h"
#include "field/instances.h"
#include "host/base/clock.h"
#include "host/input/read.h"
#include "support/scattered.h"

#define MAPS_MOST 100

static qtr_mission mission;
static qtr_game game;
static qtr_travel travel;
static qtr_learner_memory memory;
static qtr_environment *ground;
static qtr_learner *learner;
static input reference;

/* ---- measuring ---- */

static void begin_learner(void) {
  const qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(memory);
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  qtr_environment_init(&ground, memory.ground, sizeof memory.ground, &game, NULL, &travel);
  qtr_learner_init(&learner, &blocks, ground, NULL, &config);
}

typedef struct {
  double seconds, episodes;
  qtr_certificate certificate;
} run;

/* Learn a mission to its certificate, elemental tasks included. */
static run learn(const qtr_mission *learnt, double limit) {
  const double begin = clock_seconds();
  run r;
  qtr_game_init(&game, learnt, &travel, NULL);
  begin_learner();
  while (qtr_learner_step(learner) == QTR_LEARNING && clock_seconds() - begin < limit) {}
  qtr_learner_certificate(learner, &r.certificate);
  r.seconds = clock_seconds() - begin;
  r.episodes = (double)r.certificate.episodes;
  return r;
}

qtr_learner *bench_learn(const qtr_mission *learnt, unsigned steps) {
  qtr_game_init(&game, learnt, &travel, NULL);
  begin_learner();
  while (steps > 0 && qtr_learner_step(learner) == QTR_LEARNING) steps--;
  return learner;
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a;
  const double y = *(const double *)b;
  return (x > y) - (x < y);
}

static double median(double *values, int count) {
  qsort(values, (size_t)count, sizeof *values, compare);
  return count % 2 == 1 ? values[count / 2] : 0.5 * (values[count / 2 - 1] + values[count / 2]);
}

/* ---- random maps ---- */

qtr_mission *bench_map(unsigned seed, int side, int places, int seekers, int objective) {
  scattered_make(&mission, &game, &travel, seed, (unsigned)side, (unsigned)places, (unsigned)seekers, objective);
  return &mission;
}

static void bench_random(int side, int places, int seekers, int maps, double limit, const char *target) {
  for (int objective = QTR_DISCOUNTED; objective <= QTR_TIME; objective++) {
    double seconds[MAPS_MOST], episodes[MAPS_MOST], gap[MAPS_MOST];
    int certified = 0;
    unsigned entry_bytes = 0;
    for (int map = 0; map < maps; map++) {
      bench_map((unsigned)map + 1, side, places, seekers, objective);
      const run r = learn(&mission, limit);
      seconds[map] = r.seconds;
      episodes[map] = r.episodes;
      gap[map] = r.certificate.gap;
      certified += r.certificate.certified;
      const unsigned bytes = qtr_learner_entry_bytes(learner);
      entry_bytes = bytes > entry_bytes ? bytes : entry_bytes;
    }
    const double middle = median(seconds, maps); /* and sorted by it */
    printf("%2dx%2d, %2d places, %d seekers, %-10s  %3d/%d certified  median %.4f s, worst %.3f s, %.0f episodes, gap "
           "%.1e; %u bytes an entry%s\n",
           side, side, places, seekers, objective == QTR_TIME ? "time" : "discounted", certified, maps, middle,
           seconds[maps - 1], median(episodes, maps), median(gap, maps), entry_bytes, target);
  }
}

/* ---- the reference ---- */

static double learn_reference(const char *path, int robots, int objective, double *found) {
  const input_options options = {.robots = robots};
  fault why;
  if (input_read(&reference, path, &options, &why) != 0) {
    fprintf(stderr, "%s\n", why.text);
    exit(1);
  }
  reference.mission.aim.kind = (uint8_t)objective;
  const run r = learn(&reference.mission, 60.0);
  *found = r.certificate.certified ? r.certificate.objective : -1.0;
  return r.seconds;
}

static bool agrees(double found, double exact) {
  return found > exact * (1.0 - 1e-5) && found < exact * (1.0 + 1e-5);
}

static void bench_reference(void) {
  char line[256];
  int cases = 0, agreeing = 0;
  double seconds = 0.0;
  FILE *values = fopen(QUARTER_SOURCE_DIR "/tests/data/reference/values.txt", "r");
  while (values != NULL && fgets(line, sizeof line, values) != NULL) {
    char name[64], path[512];
    int robots;
    double value, time, found_value, found_time;
    if (sscanf(line, "%63s %*d places %*d robots %d value %lf expected_time %lf", name, &robots, &value, &time) != 4)
      continue;
    snprintf(path, sizeof path, QUARTER_SOURCE_DIR "/tests/data/reference/%s", name);
    seconds += learn_reference(path, robots, QTR_DISCOUNTED, &found_value);
    seconds += learn_reference(path, robots, QTR_TIME, &found_time);
    cases++;
    agreeing += agrees(found_value, value) && agrees(found_time, time);
  }
  if (values != NULL) fclose(values);
  printf("reference cases, both objectives: %d of %d certified and equal within 1e-5, %.2f s together (target: 15 of "
         "15, under 10 s)\n",
         agreeing, cases, seconds);
}

/* ---- sizes ---- */

static void bench_entry(int side, int places, int seekers, const char *target) {
  bench_map(1, side, places, seekers, QTR_DISCOUNTED);
  begin_learner();
  printf("a Q entry of %2d places, %d seekers on %dx%d cells: %u bytes %s\n", places, seekers, side, side,
         qtr_learner_entry_bytes(learner), target);
}

/* ---- large maps: in a process of its own, whose memory is then its own ---- */

static void travel_large(void) {
  uint64_t state = 7;
  scattered_draw(&mission, &state, 1024, 64, 4, QTR_DISCOUNTED);
  const double begin = clock_seconds();
  qtr_game_init(&game, &mission, &travel, NULL);
  const double seconds = clock_seconds() - begin;
  struct rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  printf("1024x1024 map, 64 places, all travel times: %.2f s, %ld MB (target: under 3 s, 200 MB)\n", seconds,
         usage.ru_maxrss / 1024);
}

static void bench_large(void) {
  fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    travel_large();
    fflush(stdout);
    _exit(0);
  }
  if (child > 0) waitpid(child, NULL, 0);
}

static void bench_clone(void) {
  fflush(stdout);
  if (system("bash '" QUARTER_SOURCE_DIR "/tests/bench/clone.sh' '" QUARTER_SOURCE_DIR "'") != 0)
    printf("clone to certified policy: failed\n");
}

int main(int argc, char **argv) {
  static fault why;
  bench_asked asked;
  if (bench_ask(&asked, argc, argv, &why) != 0) return bench_fail(&why);
  if (asked.help) return bench_help(stdout);
  if (asked.takeover) return bench_takeover(asked.json);
  if (asked.task != BENCH_NO_TASK) return bench_compete(stdin, stdout, &asked);
  if (asked.instances != NULL) return bench_instances(stdout, &asked);
  bench_large();
  bench_reference();
  bench_random(30, 12, 2, 50, 60.0, "  (target: 0.05 s)");
  bench_random(30, 16, 2, 50, 60.0, "  (target: 0.15 s)");
  bench_random(30, 20, 2, 50, 60.0, "  (target: 0.3 s)");
  bench_random(10, 8, 2, 100, 60.0, "  (target: at most 30 episodes; paper: 30,000)");
  bench_random(30, 26, 2, 20, 10.0, "  (target: 0.1 s, worst 2 s)");
  bench_random(30, 26, 3, 20, 10.0, "  (target: 0.1 s, worst 2 s)");
  bench_random(40, 32, 4, 20, 30.0, "  (target: 1 s, worst 30 s)");
  bench_random(40, 40, 4, 20, 30.0, "  (target: 1 s, worst 30 s)");
  bench_random(40, 60, 8, 20, 60.0, "  (target: half of them within 60 s)");
  bench_entry(30, 20, 2, "(target, host: at most 24)");
  bench_entry(40, 60, 8, "(target, host: at most 24)");
  bench_entry(32, 16, 4, "(target, mcu: at most 16)");
  if (asked.clone) bench_clone();
  return 0;
}
