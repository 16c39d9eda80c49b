/* The same game once more by robots without a plan, blind and nearest first, to be shown beside the planned one: the
 * same mine, the same faults. It is kept in a bounded size: a long game is sampled less often than a short one. */
#ifndef QUARTER_DEMO_GHOST_H
#define QUARTER_DEMO_GHOST_H

#include "game.h"

#define GHOST_SAMPLES 400 /* of each robot, at most */
#define GHOST_TICK 0.2    /* seconds between samples of a game that is short enough */

typedef struct {
  int32_t x, y; /* hundredths of a cell, y down from the top */
} ghost_sample;

typedef struct {
  double at; /* seconds */
  int place;
} ghost_scan;

typedef struct {
  int robots;
  double tick; /* seconds between samples */
  double next; /* seconds: of the next one */
  int samples; /* of each robot */
  ghost_sample track[DEMO_MOST_ROBOTS][GHOST_SAMPLES];
  int scans; /* the first of each place, and later ones that a plan would have there, in the order of their times */
  ghost_scan scan[QTR_MAX_PLACES];
  int duplicates;     /* scans of what had been scanned */
  double duration;    /* seconds */
  double finished_at; /* seconds until the find; if none stops it, until all places were scanned; below 0: never */
} ghost;

/* Play it to its finish. `setup` is the planned game's. 0, or -1 with *why set. */
int ghost_play(ghost *g, const table *t, const arena_setup *setup, const volatile int *interrupted, fault *why);

#endif
