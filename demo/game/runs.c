#include "runs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/clock.h"
#include "host/plan/progress.h"
#include "rng.h"

static int compare_doubles(const void *a, const void *b) {
  const double x = *(const double *)a;
  const double y = *(const double *)b;
  return (x > y) - (x < y);
}

double runs_quantile(const runs_figures *f, double share) {
  if (f->found == 0) return NAN;
  const int at = (int)(share * f->found);
  return f->found_at[at < f->found ? at : f->found - 1];
}

void runs_free(runs_figures *f) {
  free(f->found_at);
  free(f->by_seed);
  free(f->visits);
}

void runs_draw_loss(fault_script *script, const plan *p, uint64_t seed) {
  rng dice;
  rng_seed(&dice, seed ^ 0x51554152544552u);
  const int robot = (int)(rng_next(&dice) % p->t.policy.board.seekers);
  const double at = rng_unit(&dice) * game_plan_seconds(&p->t);
  faults_add(script, (fault_event){at, FAULT_LOST, robot, 0.0, 0});
}

static int count_visits(void *user, const arena *a, const game_result *result, fault *why) {
  runs_figures *f = user;
  (void)result;
  (void)why;
  for (int robot = 0; robot < a->robots; robot++)
    for (int place = 0; place < a->places; place++)
      if (qtr_places_has(&a->robot[robot].scanned, (unsigned)place)) f->visits[place]++;
  return 0;
}

/* The time that counts: of what is not found the end; not a number where there is none. */
static double counted_as(const runs_figures *f, double seconds) {
  return seconds >= 0.0 ? seconds : f->end >= 0.0 ? f->end : NAN;
}

static void add_times(runs_figures *f, const plan *p, const game_result *r) {
  const qtr_steps step = plan_look_step(p, r->mine, r->looks_needed);
  const double found = r->found_at >= 0.0 ? game_pace(&p->t) * r->found_at : -1.0;
  const double planned = step != QTR_NEVER ? game_pace(&p->t) * step * game_step_seconds(&p->t) : -1.0;
  f->by_seed[f->games - 1] = found >= 0.0 ? found : NAN;
  if (found >= 0.0) f->found_at[f->found++] = found;
  if (r->mine < 0 || isnan(counted_as(f, found))) return;
  f->timed++;
  f->mean += counted_as(f, found);
  if (!isnan(counted_as(f, planned))) f->planned_mean += counted_as(f, planned);
}

static void add(runs_figures *f, const plan *p, const game_result *r, uint64_t seed) {
  f->games++;
  if ((r->found_at < 0.0 && r->mine >= 0 && f->end < 0.0) || r->deadlocks > 0) {
    if (f->odd < RUNS_ODD) f->odd_seed[f->odd] = seed;
    f->odd++;
  }
  add_times(f, p, r);
  f->deadlocked += r->deadlocks > 0;
  f->deadlocks += (uint64_t)r->deadlocks;
  f->scanned += (uint64_t)r->scanned;
  f->duplicates += (uint64_t)r->duplicates;
  f->collisions += (uint64_t)r->collisions;
  f->simulated += game_pace(&p->t) * r->duration;
  f->wall += r->wall_seconds;
  for (int kind = 0; kind < KINDS; kind++) f->sent[kind] += r->counts.sent[kind];
}

static void finish(runs_figures *f, const plan *p) {
  f->mean = f->timed > 0 ? f->mean / f->timed : NAN;
  f->planned_mean = f->timed > 0 ? f->planned_mean / f->timed : NAN;
  f->expected = game_pace(&p->t) * p->expected_step * game_step_seconds(&p->t);
  qsort(f->found_at, (size_t)f->found, sizeof *f->found_at, compare_doubles);
}

static int play_one(runs_figures *f, const plan *p, const game_setup *setup, uint64_t seed, bool lose_one, fault *why) {
  static const fault_script none = {0};
  fault_script faults = setup->arena.faults != NULL ? *setup->arena.faults : none;
  game_setup one = *setup;
  game_result result;
  one.arena.seed = seed;
  one.arena.faults = &faults;
  one.user = f;
  one.finish = count_visits;
  if (lose_one) runs_draw_loss(&faults, p, seed);
  if (game_play(&one, &result, NULL, why) != 0) return -1;
  add(f, p, &result, seed);
  return 0;
}

static int begin_figures(runs_figures *f, const plan *p, int games, fault *why) {
  memset(f, 0, sizeof *f);
  f->found_at = calloc((size_t)games, sizeof *f->found_at);
  f->by_seed = calloc((size_t)games, sizeof *f->by_seed);
  f->visits = calloc((size_t)p->places, sizeof *f->visits);
  f->end = p->last_step >= 0.0 ? game_pace(&p->t) * p->last_step * game_step_seconds(&p->t) : -1.0;
  if (f->found_at != NULL && f->by_seed != NULL && f->visits != NULL) return 0;
  return fault_set(why, "no memory for %d games", games);
}

int runs_play(runs_figures *f, const plan *p, const game_setup *setup, int games, bool lose_one,
              const volatile int *interrupted, bool quiet, fault *why) {
  const double begin = clock_seconds();
  if (begin_figures(f, p, games, why) != 0) return -1;
  for (int i = 0; i < games && (interrupted == NULL || *interrupted == 0); i++) {
    if (play_one(f, p, setup, setup->arena.seed + (uint64_t)i, lose_one, why) != 0) return -1;
    if (progress_wanted(quiet) && i % 10 == 9)
      fprintf(stderr, "\r\033[Kgame %d of %d  left %.0f s", i + 1, games,
              (clock_seconds() - begin) / (i + 1) * (games - i - 1));
  }
  if (progress_wanted(quiet)) fprintf(stderr, "\r\033[K");
  finish(f, p);
  return 0;
}
