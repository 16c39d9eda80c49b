/* The benchmarks: what the project promises, measured on the machine at hand and printed beside the target. Nothing
 * here is a test; a slow machine fails nothing. `--clone` also times a fresh clone up to its certified demo policy;
 * `--row` and `--certificates` measure what is named, `--takeover` what robots do for one that is lost, `--instances`
 * learns those of the literature, and nothing else. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "field/asked.h"
#include "field/compete.h"
#include "field/instances.h"
#include "host/input/read.h"

static input reference;

/* ---- random maps ---- */

static void bench_random(int side, int places, int seekers, int maps, double limit, const char *target) {
  for (int objective = QTR_DISCOUNTED; objective <= QTR_TIME; objective++) {
    double seconds[BENCH_MAPS_MOST], episodes[BENCH_MAPS_MOST], gap[BENCH_MAPS_MOST];
    int certified = 0;
    unsigned entry_bytes = 0;
    for (int map = 0; map < maps; map++) {
      const bench_run r = bench_learn_for(bench_map((unsigned)map + 1, side, places, seekers, objective), NULL, limit);
      seconds[map] = r.seconds;
      episodes[map] = r.episodes;
      gap[map] = r.certificate.gap;
      certified += r.certificate.certified;
      const unsigned bytes = qtr_learner_entry_bytes(bench_learner());
      entry_bytes = bytes > entry_bytes ? bytes : entry_bytes;
    }
    const double middle = bench_median(seconds, (unsigned)maps); /* and sorted by it */
    printf("%2dx%2d, %2d places, %d seekers, %-10s  %3d/%d certified  median %.4f s, worst %.3f s, %.0f episodes, gap "
           "%.1e; %u bytes an entry%s\n",
           side, side, places, seekers, bench_objective(objective), certified, maps, middle, seconds[maps - 1],
           bench_median(episodes, (unsigned)maps), bench_median(gap, (unsigned)maps), entry_bytes, target);
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
  const bench_run r = bench_learn_for(&reference.mission, NULL, 60.0);
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

/* ---- all ---- */

static void bench_clone(void) {
  fflush(stdout);
  if (system("bash '" QUARTER_SOURCE_DIR "/tests/bench/clone.sh' '" QUARTER_SOURCE_DIR "'") != 0)
    printf("clone to certified policy: failed\n");
}

/* A row that is asked for alone. */
static int bench_row(int row) {
  switch (row) {
  case BENCH_MEMORY: bench_memory(); break;
  case BENCH_TERMS: bench_terms(); break;
  case BENCH_HORIZON: bench_horizon(); break;
  case BENCH_PAPER_SPEED: bench_exploring(); break;
  default: return bench_plans();
  }
  return 0;
}

/* All that takes seconds. */
static void bench_all(void) {
  bench_memory();
  bench_reference();
  bench_random(30, 12, 2, 50, 60.0, "  (target: 0.05 s)");
  bench_random(30, 16, 2, 50, 60.0, "  (target: 0.15 s)");
  bench_random(30, 20, 2, 50, 60.0, "  (target: 0.3 s)");
  bench_random(10, 8, 2, 100, 60.0, "  (target: at most 30 episodes; paper: 30,000)");
  bench_random(30, 26, 2, 20, 10.0, "  (target: 0.1 s, worst 2 s)");
  bench_random(30, 26, 3, 20, 10.0, "  (target: 0.1 s, worst 2 s)");
  bench_random(40, 32, 4, 20, 30.0, "  (target: 1 s, worst 30 s)");
  bench_random(40, 40, 4, 20, 30.0, "  (target: 1 s, worst 30 s)");
  bench_random(40, 50, 4, 20, 30.0, "  (target: median gap 0.2 % at 30 s)");
  bench_random(40, 60, 5, 20, 30.0, "  (target: median gap 0.2 % at 30 s)");
  bench_random(40, 60, 8, 20, 60.0, "  (target: half of them within 60 s)");
  bench_terms();
  bench_horizon();
}

int main(int argc, char **argv) {
  static fault why;
  bench_asked asked;
  if (bench_ask(&asked, argc, argv, &why) != 0) return bench_fail(&why);
  if (asked.help) return bench_help(stdout);
  if (asked.takeover) return bench_takeover(asked.json);
  if (asked.task != BENCH_NO_TASK) return bench_compete(stdin, stdout, &asked);
  if (asked.instances != NULL) return bench_instances(stdout, &asked);
  if (asked.certificates > 0) return bench_certificates(asked.certificates, asked.family.seed);
  if (asked.row != BENCH_NO_ROW) return bench_row(asked.row);
  bench_all();
  if (asked.clone) bench_clone();
  return 0;
}
