/* Certificates against the exact optimum of an independent method, on random missions. */
#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "bench.h"
#include "exact.h"
#include "field/against.h"
#include "field/learn.h"
#include "quarter/random.h"

#define LIMIT 30.0 /* seconds until a mission stays open */
#define TRIES 1000

enum { SIDE_MOST = 40, PLACES_LEAST = 8, PLACES_MOST = 20, SEEKERS_MOST = 4, PRINT_EVERY = 50 };

/* ---- random missions ---- */

static double unit(uint64_t *state) {
  return qtr_splitmix_unit(state);
}

static unsigned in_range(uint64_t *state, unsigned least, unsigned most) {
  return least + (unsigned)(unit(state) * (most - least + 1));
}

static qtr_cell free_cell(const qtr_mission *mission, uint64_t *state) {
  qtr_cell cell;
  do cell = (qtr_cell)in_range(state, 0, qtr_mission_cells(mission) - 1);
  while (mission->cost[cell] == 0);
  return cell;
}

static bool is_place(const qtr_mission *mission, qtr_cell cell) {
  for (unsigned place = 0; place < mission->places; place++)
    if (mission->place[place] == cell) return true;
  return false;
}

static void draw_ground(qtr_mission *mission, uint64_t *state) {
  const double blocked = 0.3 * unit(state);
  const double rough = unit(state) < 0.3 ? 0.3 : 0.0;
  mission->columns = (uint16_t)in_range(state, 8, SIDE_MOST);
  mission->rows = (uint16_t)in_range(state, 8, SIDE_MOST);
  for (unsigned cell = 0; cell < qtr_mission_cells(mission); cell++) {
    mission->cost[cell] = unit(state) >= blocked;
    if (mission->cost[cell] > 0 && unit(state) < rough) mission->cost[cell] = (uint8_t)in_range(state, 2, 9);
  }
}

/* Weights over six powers of ten, gamma from 0.9 to 0.9999; robots set out together or each for itself. */
static void draw(qtr_mission *mission, uint64_t *state) {
  qtr_mission_default(mission);
  draw_ground(mission, state);
  mission->aim.kind = (uint8_t)in_range(state, QTR_DISCOUNTED, QTR_TIME);
  mission->aim.gamma = 1.0 - pow(10.0, -1.0 - 3.0 * unit(state));
  mission->seekers = (uint8_t)in_range(state, 1, SEEKERS_MOST);
  const bool together = unit(state) < 0.5;
  for (unsigned i = 0; i < mission->seekers; i++)
    mission->start[i] = i > 0 && together ? mission->start[0] : free_cell(mission, state);
  const unsigned most = mission->seekers <= 2 ? PLACES_MOST : EXACT_GROUP_PLACES;
  const unsigned places = in_range(state, PLACES_LEAST, most);
  while (mission->places < places) {
    const qtr_cell cell = free_cell(mission, state);
    if (is_place(mission, cell)) continue;
    mission->place[mission->places] = cell;
    mission->weight[mission->places++] = pow(10.0, 6.0 * unit(state));
  }
}

/* ---- against the optimum ---- */

typedef struct {
  unsigned certified, violations;
  double seconds, exact_seconds;
} tally;

static int hold_against(tally *t, const qtr_mission *mission, unsigned seed, double gap, fault *why) {
  static exact_solution solution;
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  config.gap = gap;
  const bench_run r = bench_learn_for(mission, &config, LIMIT);
  const double begin = learn_clock();
  if (exact_solve(&solution, mission, bench_travel(), why) != 0) return -1;
  t->exact_seconds += learn_clock() - begin;
  t->seconds += r.seconds;
  t->certified += r.certificate.certified;
  const char *what = against_optimum(&r.certificate, mission->aim.kind, gap, solution.objective);
  if (what == NULL && r.certificate.certified) return 0;
  t->violations += what != NULL;
  printf("seed %u: %s: %ux%u cells, %u places, %u seekers, %s, gamma %.17g, gap %g: plan %.17g, bound %.17g, optimum "
         "%.17g\n",
         seed, what != NULL ? what : "open", (unsigned)mission->columns, (unsigned)mission->rows,
         (unsigned)mission->places, (unsigned)mission->seekers, bench_objective(mission->aim.kind), mission->aim.gamma,
         gap, r.certificate.objective, r.certificate.bound, solution.objective);
  fflush(stdout);
  return 0;
}

static bool is_playable(const qtr_mission *mission) {
  static qtr_game game;
  return qtr_game_init(&game, mission, bench_travel(), NULL) == QTR_OK;
}

static int try_seed(tally *t, unsigned seed, fault *why) {
  static qtr_mission mission;
  uint64_t state = seed;
  unsigned tries = 0;
  do draw(&mission, &state);
  while (!is_playable(&mission) && ++tries < TRIES);
  return hold_against(t, &mission, seed, unit(&state) < 0.5 ? 1e-5 : 1e-9, why);
}

int bench_certificates(unsigned count, unsigned seed) {
  static fault why;
  tally t = {0};
  for (unsigned i = 0; i < count; i++) {
    if (try_seed(&t, seed + i, &why) != 0) {
      fprintf(stderr, "bench: seed %u: %s\n", seed + i, why.text);
      return why.status;
    }
    if ((i + 1) % PRINT_EVERY == 0 && isatty(STDERR_FILENO)) fprintf(stderr, "%u of %u\n", i + 1, count);
  }
  printf("certificates of %u random missions, %d to %d places, 1 to %d seekers, both objectives: %u violations, %u "
         "certified; %.0f s learning, %.0f s for the optima (target: 0 violations)\n",
         count, PLACES_LEAST, PLACES_MOST, SEEKERS_MOST, t.violations, t.certified, t.seconds, t.exact_seconds);
  return t.violations == 0 ? 0 : 1;
}
