/* A game on record: where every robot was, ten times a second, and all that happened; written as a web page that plays
 * it. */
#ifndef QUARTER_DEMO_RECORD_H
#define QUARTER_DEMO_RECORD_H

#include <stdio.h>

#include "ghost.h"
#include "host/base/json.h"
#include "plan.h"

#define RECORD_TICK 0.1 /* seconds between samples */

typedef struct {
  int32_t x, y;    /* hundredths of a cell, y down from the top */
  int16_t heading; /* hundredths of a radian */
} record_sample;

typedef struct {
  const plan *p;
  int robots;
  size_t samples, room; /* of each robot */
  record_sample *track[DEMO_MOST_ROBOTS];
  uint64_t *said; /* signals that robots had sent one another by then */
  double next;    /* seconds */
  bool full;      /* there was no memory for more */
  ghost *ghost;   /* the same game without a plan; NULL: none */
} record;

void record_begin(record *r, const plan *p);
void record_free(record *r);

/* Look at the arena: called after every tick, a game's `watch`. */
void record_watch(void *r, const arena *a);

/* Play the same game without a plan, to be shown beside this one. Of one that is interrupted nothing is kept. 0, or -1
 * with *why set. */
int record_add_ghost(record *r, const arena_setup *setup, const volatile int *interrupted, fault *why);

/* What is known of a game before it begins. */
typedef struct {
  uint64_t seed;
  bool clear_all;
  int mine; /* place; below 0: none, or unknown */
} record_head;

/* The whole game as JSON (docs/replay-format.md); and all but what happened, for a page that follows it. */
void record_json(FILE *out, const record *r, const arena *a, const game_result *result);
void record_hello(FILE *out, const plan *p, const record_head *head);

/* Parts of it: an event, as an object; how the game came out, as the member "result". */
void record_event(FILE *out, const plan *p, const arena_event *e);
void record_result(json *j, const plan *p, const game_result *result);

/* Write the page that plays the game. 0, or -1 with *why set. */
int record_page(const char *path, const record *r, const arena *a, const game_result *result, fault *why);

/* The page for a game that is followed live. */
void record_live_page(FILE *out);

#endif
