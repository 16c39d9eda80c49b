/* Many seeded games of one mission, in figures. Seconds are the mission's own. */
#ifndef QUARTER_DEMO_RUNS_H
#define QUARTER_DEMO_RUNS_H

#include <stdio.h>

#include "game.h"
#include "plan.h"

#define RUNS_ODD 20

typedef struct {
  int games, found, deadlocked; /* deadlocked: games with a robot that made no way for long */
  int timed;                    /* games whose time counts: found, or not found where there is an end */
  double *found_at;             /* seconds, of the games in which it was found, in rising order */
  double *by_seed;              /* seconds, of each game; not a number: not found */
  double end;                   /* seconds: as this much counts what is not found, where robots tire; below 0: not */
  double mean, planned_mean;    /* seconds, not a number if nothing counts; planned: of the same mines */
  double expected;              /* seconds: the plan's expected time to find */
  uint64_t scanned, duplicates, collisions, deadlocks;
  double simulated, wall; /* seconds in all */
  uint64_t sent[KINDS];
  uint64_t *visits;            /* of each place */
  int odd;                     /* games to look into: not found, or with a deadlock */
  uint64_t odd_seed[RUNS_ODD]; /* the first of them */
} runs_figures;

/* One robot lost at a moment of the plan's time, both drawn by the seed: a fault for the script. */
void runs_draw_loss(fault_script *script, const plan *p, uint64_t seed);

/* Play `games` games with seeds from setup->arena.seed on. With `lose_one` a robot, drawn by the seed, is lost at a
 * moment drawn from the plan's time. 0, or -1 with *why set. Ends early if interrupted. */
int runs_play(runs_figures *f, const plan *p, const game_setup *setup, int games, bool lose_one,
              const volatile int *interrupted, bool quiet, fault *why);
void runs_free(runs_figures *f);

/* The time by which this share of the finds had happened; not a number if nothing was found. */
double runs_quantile(const runs_figures *f, double share);

#endif
