/* What plans lack after a short time, against the best that a long run knows. */
#include <math.h>
#include <stdio.h>

#include "bench.h"
#include "field/asked.h"
#include "field/families.h"
#include "field/learn.h"

enum { SIZES = 4, SEEDS = 5, TIMES = 3 };

#define GAP 1e-5
#define EQUAL 1e-9 /* relative: what adding up in another order may come to */

static const struct size {
  uint32_t places, robots, side;
  double gamma;
} sizes[SIZES] = {{12, 2, 30, 0.99}, {26, 3, 30, 0.99}, {60, 5, 40, 0.99}, {128, 8, 60, 0.998}};

static const double times[TIMES] = {1.0, 10.0, 60.0}; /* the last one is what the others are held against */

/* Of one size and objective. */
typedef struct {
  unsigned problems, equal[TIMES - 1], certified;
  double worst[TIMES - 1];
} tally;

/* What a problem's plan is worth after each of the times. A certified one is not learnt again. */
static int learn(double *found, bool *certified, const family_wish *wish, fault *why) {
  problem_case made;
  int status = problem_of_family(&made, wish, why);
  *certified = false;
  for (unsigned i = 0; status == 0 && i < TIMES; i++) {
    learnt l = {0};
    if (*certified) {
      found[i] = found[i - 1];
      continue;
    }
    status = learn_for(&l, &made, QTR_SETTING_CERTIFIED, GAP, times[i], why);
    if (status == 0) found[i] = learnt_end(&l)->certificate.objective;
    if (status == 0) *certified = learnt_end(&l)->certificate.certified;
    learnt_drop(&l);
  }
  problem_drop(&made);
  return status;
}

static void count(tally *t, const double *found, bool certified, bool by_time) {
  double best = found[0];
  for (unsigned i = 1; i < TIMES; i++) best = by_time ? fmin(best, found[i]) : fmax(best, found[i]);
  t->problems++;
  t->certified += certified;
  for (unsigned i = 0; i < TIMES - 1; i++) {
    const double loss = fabs(found[i] - best) / fabs(best);
    t->equal[i] += loss <= EQUAL;
    t->worst[i] = fmax(t->worst[i], loss);
  }
}

static int measure(tally *all, const struct size *size, int objective, fault *why) {
  tally t = {0};
  for (uint32_t seed = 1; seed <= SEEDS; seed++) {
    double found[TIMES];
    bool certified;
    const family_wish wish = {FAMILY_SCATTER, seed,       size->side, size->places, size->robots, 1, 1, 1,
                              objective,      size->gamma};
    if (learn(found, &certified, &wish, why) != 0) return -1;
    count(&t, found, certified, objective == QTR_TIME);
    count(all, found, certified, objective == QTR_TIME);
  }
  printf("%3u places, %u seekers, %-10s", size->places, size->robots, bench_objective(objective));
  for (unsigned i = 0; i < TIMES - 1; i++)
    printf("  after %2.0f s %u/%u lack nothing, worst %.4f %%;", times[i], t.equal[i], t.problems, 100 * t.worst[i]);
  printf("  %u certified within %.0f s\n", t.certified, times[TIMES - 1]);
  fflush(stdout);
  return 0;
}

int bench_plans(void) {
  static fault why;
  tally all = {0};
  for (unsigned i = 0; i < SIZES; i++)
    for (int objective = QTR_DISCOUNTED; objective <= QTR_TIME; objective++)
      if (measure(&all, &sizes[i], objective, &why) != 0) return bench_fail(&why);
  printf(
      "plans of all sizes, against the best of %.0f s: after 10 s %.0f %% lack nothing, worst %.4f %% (target: 95 %%, "
      "0.2 %%); after 1 s %.0f %%, worst %.4f %%\n",
      times[TIMES - 1], 100.0 * all.equal[1] / all.problems, 100 * all.worst[1], 100.0 * all.equal[0] / all.problems,
      100 * all.worst[0]);
  return 0;
}
