#include "ghost.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A ghost while it is played. */
typedef struct {
  ghost *g;
  const volatile int *interrupted; /* NULL: never */
  volatile int over;
} haunting;

/* ---- taking it down ---- */

/* What is full keeps every other sample, and from now on takes them half as often. */
static void thin_out(ghost *g) {
  for (int robot = 0; robot < g->robots; robot++)
    for (int i = 0; 2 * i < g->samples; i++) g->track[robot][i] = g->track[robot][2 * i];
  g->samples = (g->samples + 1) / 2;
  g->tick *= 2.0;
  g->next = g->samples * g->tick;
}

static void take_samples(ghost *g, const arena *a) {
  if (a->now + 1e-9 < g->next) return;
  if (g->samples == GHOST_SAMPLES) {
    thin_out(g);
    if (a->now + 1e-9 < g->next) return;
  }
  for (int robot = 0; robot < g->robots; robot++) {
    const point at = world_pose_of(a->w, robot).at;
    g->track[robot][g->samples] =
        (ghost_sample){(int32_t)lround(100 * at.x), (int32_t)lround(100 * (a->g.grid.rows - at.y))};
  }
  g->samples++;
  g->next = g->samples * g->tick;
}

/* ---- its end ---- */

static bool all_scanned(const arena *a) {
  return a->counted == a->t->policy.board.places;
}

/* Where a find ends the search it is the finish; else the last scan is. */
static double finished_at(const arena *a) {
  if (!a->setup.clear_all && a->mine >= 0) return a->found_at;
  if (!all_scanned(a)) return -1.0;
  return a->look_at[a->counted - 1];
}

/* Robots without a plan go on for long after their last new place: that is of no interest. */
static void watch(void *user, const arena *a) {
  haunting *h = user;
  take_samples(h->g, a);
  if (finished_at(a) >= 0.0 || (h->interrupted != NULL && *h->interrupted != 0)) h->over = 1;
}

static int compare_scans(const void *a, const void *b) {
  const ghost_scan *x = a;
  const ghost_scan *y = b;
  return x->at != y->at ? (x->at > y->at) - (x->at < y->at) : x->place - y->place;
}

static int finish(void *user, const arena *a, const game_result *result, fault *why) {
  haunting *h = user;
  ghost *g = h->g;
  (void)why;
  for (int i = 0; i < a->counted; i++) g->scan[g->scans++] = (ghost_scan){a->look_at[i], a->look_place[i]};
  qsort(g->scan, (size_t)g->scans, sizeof *g->scan, compare_scans);
  g->duplicates = a->duplicates;
  g->duration = result->duration;
  g->finished_at = finished_at(a);
  return 0;
}

int ghost_play(ghost *g, const table *t, const arena_setup *setup, const volatile int *interrupted, fault *why) {
  haunting h = {.g = g, .interrupted = interrupted};
  game_result result;
  game_setup game = {
      .t = t, .strategy = STRATEGY_NEAREST, .arena = *setup, .user = &h, .watch = watch, .finish = finish};
  game.arena.time_limit = game_unplanned_seconds(t, setup->faults);
  memset(g, 0, sizeof *g);
  g->robots = t->policy.board.seekers;
  g->tick = GHOST_TICK;
  return game_play(&game, &result, &h.over, why);
}
