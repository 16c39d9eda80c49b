/* How much memory a process has taken that does one thing: each is a process of its own, and they come first, before
 * this one has any; and what an entry of the Q-table takes. */
#include <stdio.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench.h"
#include "field/families.h"
#include "field/learn.h"
#include "support/scattered.h"

enum { MAPS = 5 };

/* Kilobytes that it has taken at most; -1: it came to no end. */
static long in_own_process(void (*work)(unsigned map, int objective), unsigned map, int objective) {
  long kilobytes = -1;
  int ends[2];
  if (pipe(ends) != 0) return -1;
  fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    struct rusage usage;
    work(map, objective);
    fflush(stdout);
    getrusage(RUSAGE_SELF, &usage);
    _exit(write(ends[1], &usage.ru_maxrss, sizeof usage.ru_maxrss) < 0);
  }
  close(ends[1]);
  if (child > 0 && read(ends[0], &kilobytes, sizeof kilobytes) != sizeof kilobytes) kilobytes = -1;
  close(ends[0]);
  if (child > 0) waitpid(child, NULL, 0);
  return kilobytes;
}

/* ---- all travel times of a large map ---- */

static void measure_large(unsigned map, int objective) {
  static qtr_mission mission;
  static qtr_game game;
  uint64_t state = map;
  scattered_draw(&mission, &state, 1024, 64, 4, objective);
  const double begin = learn_clock();
  qtr_game_init(&game, &mission, bench_travel(), NULL);
  printf("1024x1024 map, 64 places, all travel times: %.2f s, ", learn_clock() - begin);
}

static void bench_large(void) {
  const long kilobytes = in_own_process(measure_large, 7, QTR_DISCOUNTED);
  printf("%ld MB (target: under 3 s, 200 MB)\n", kilobytes / 1024);
}

/* ---- a mission learnt as `quarter learn` does it, in blocks that grow ---- */

static void learn_growing(unsigned map, int objective) {
  const family_wish wish = {.family = FAMILY_SCATTER,
                            .seed = map + 1,
                            .side = 40,
                            .places = 60,
                            .robots = 8,
                            .looks = 1,
                            .classes = 1,
                            .stretch = 1,
                            .objective = objective,
                            .gamma = 0.99};
  problem_case made;
  learnt l = {0};
  fault why;
  if (problem_of_family(&made, &wish, &why) != 0 || learn_for(&l, &made, QTR_SETTING_CERTIFIED, 1e-5, 60.0, &why) != 0)
    fprintf(stderr, "bench: %s\n", why.text);
}

static void bench_growing(void) {
  for (int objective = QTR_DISCOUNTED; objective <= QTR_TIME; objective++) {
    double megabytes[MAPS];
    for (unsigned map = 0; map < MAPS; map++)
      megabytes[map] = (double)in_own_process(learn_growing, map, objective) / 1024.0;
    const double middle = bench_median(megabytes, MAPS);
    printf("memory of the whole process, 60 places, 8 seekers on 40x40 cells, %-10s  median %.0f MB, worst %.0f MB of "
           "%d maps (target: 64 MB)\n",
           bench_objective(objective), middle, megabytes[MAPS - 1], MAPS);
  }
}

/* ---- the Q-table ---- */

static void bench_entry(int side, int places, int seekers, const char *target) {
  const qtr_learner *learner = bench_learn(bench_map(1, side, places, seekers, QTR_DISCOUNTED), 0);
  printf("a Q entry of %2d places, %d seekers on %dx%d cells: %u bytes %s\n", places, seekers, side, side,
         qtr_learner_entry_bytes(learner), target);
}

void bench_memory(void) {
  bench_large();
  bench_growing();
  bench_entry(30, 20, 2, "(target, host: at most 24)");
  bench_entry(40, 40, 4, "(target, host: at most 16)");
  bench_entry(40, 60, 8, "(target, host: at most 24)");
  bench_entry(32, 16, 4, "(target, mcu: at most 16)");
}
