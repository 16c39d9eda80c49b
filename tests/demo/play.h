/* Games for the tests: missions by name or drawn, their plans, and how a game went, tick by tick if need be. */
#ifndef QUARTER_TESTS_DEMO_PLAY_H
#define QUARTER_TESTS_DEMO_PLAY_H

#include <math.h>
#include <string.h>

#include "game.h"
#include "plan.h"
#include "support/random.h"
#include "support/tool_run.h"

/* More than any learning here takes: each ends by its certificate or by its number of games, never by the clock, so
 * that a test plays the same games on every machine. */
#define PLAY_LEARN_LIMIT 1e4

static plan play_plan;
static game_result play_result;
static arena play_arena; /* as it was at the end; its world is gone */
static fault play_why;

static inline int play_make(const char *mission, const char *table, int robots, const char *save) {
  plan_free(&play_plan);
  memset(&play_plan, 0, sizeof play_plan);
  memset(&play_why, 0, sizeof play_why);
  return plan_read(mission, robots, &play_why) == 0 ? plan_make(&play_plan, table, PLAY_LEARN_LIMIT, save, &play_why)
                                                    : -1;
}

/* The plan of a mission file. */
static inline void play_prepare(const char *mission, int robots) {
  const int status = play_make(mission, NULL, robots, NULL);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, play_why.text);
}

/* The plan of one of the demo's missions, after some games of learning: the tool counts them. */
static inline void play_prepare_named(const char *name) {
  static tool_result run;
  char mission[300];
  snprintf(mission, sizeof mission, "%s/demo/missions/%s/mission.yaml", QUARTER_SOURCE_DIR, name);
  run_tool(&run, "learn '%s' --episodes 50 -q -o named.qtr", mission);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, run.status, run.err);
  const int status = play_make(mission, "named.qtr", 0, NULL);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, play_why.text);
}

/* The plan of a drawing: rows separated by '/', '#' blocked, '~' slow, S a robot, 1..9 a place. */
static inline void play_prepare_drawn(const char *rows, int robots) {
  char text[2000];
  snprintf(text, sizeof text, "%s\n", rows);
  for (char *c = text; *c != '\0'; c++)
    if (*c == '/') *c = '\n';
  write_file("drawn.txt", text);
  play_prepare("drawn.txt", robots);
}

static inline game_setup play_setup(uint64_t seed) {
  return (game_setup){.t = &play_plan.t,
                      .arena = {.seed = seed,
                                .mine = -1,
                                .time_limit = 8 * game_plan_seconds(&play_plan.t) + 120,
                                .truth = &play_plan.truth}};
}

static inline int play_keep(void *user, const arena *a, const game_result *result, fault *why) {
  (void)user;
  (void)result;
  (void)why;
  play_arena = *a;
  return 0;
}

/* Play to the end; the result and the arena are kept. */
static inline void play(game_setup setup) {
  setup.finish = play_keep;
  const int status = game_play(&setup, &play_result, NULL, &play_why);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, play_why.text);
  const size_t length = strlen(case_note);
  snprintf(case_note + length, sizeof case_note - length, "; mine %d, found %.2f, stopped %.2f of %.2f s",
           play_result.mine, play_result.found_at, play_result.all_stopped_at, play_result.duration);
}

static inline int play_territories_done(void) {
  int done = 0;
  for (int i = 0; i < play_arena.robots; i++) done += play_arena.done[i];
  return done;
}

#endif
