#include "game.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "baselines.h"
#include "host/base/clock.h"
#include "looks.h"
#include "sweeper.h"
#include "wiring.h"

/* All that a game needs beside its arena. */
const char *const game_strategies[] = {[STRATEGY_PLAN] = "plan",
                                       [STRATEGY_NEAREST] = "nearest",
                                       [STRATEGY_INFORMED] = "informed",
                                       [STRATEGY_PLAIN] = "plain",
                                       NULL};

typedef struct {
  arena a;
  bus *b;
  qtr_seeker seeker[DEMO_MOST_ROBOTS];
  uint8_t save[DEMO_MOST_ROBOTS][QTR_SAVE_BYTES]; /* of the seekers, in memory that outlasts a reset */
  baseline baseline[DEMO_MOST_ROBOTS];
  sweeper sweeper[DEMO_MOST_ROBOTS];
  robot *crew;
} game;

double game_step_seconds(const table *t) {
  return body_step_seconds(&t->policy);
}

double game_pace(const table *t) {
  return body_pace(&t->policy);
}

/* Who tires may be on its way home until its battery is empty. */
double game_limit_seconds(const table *t, const fault_script *faults) {
  double limit = 4 * game_plan_seconds(t) + game_door_seconds(t, faults);
  for (unsigned i = 0; i < t->policy.board.seekers; i++) {
    const robot_body body = body_of(&t->policy, i);
    if (body_tires(&body) && (double)body.empty / 1e6 > limit) limit = (double)body.empty / 1e6;
  }
  return limit + 120;
}

double game_plan_seconds(const table *t) {
  static table_route routes[QTR_MAX_SEEKERS];
  qtr_steps last = 0;
  table_routes(t, routes);
  for (int i = 0; i < t->policy.board.seekers; i++)
    if (routes[i].places > 0 && routes[i].step[routes[i].places - 1] > last)
      last = routes[i].step[routes[i].places - 1];
  return last * game_step_seconds(t);
}

double game_door_seconds(const table *t, const fault_script *faults) {
  if (faults_count(faults, FAULT_SHUT) == 0) return 0.0;
  return 2 * HOPE_PATIENCE / 1e6 * t->policy.board.places + 4 * t->policy.board.seekers * game_plan_seconds(t);
}

double game_unplanned_seconds(const table *t, const fault_script *faults) {
  return (4 + 4 * t->policy.board.seekers) * game_plan_seconds(t) + 300 + game_door_seconds(t, faults);
}

/* ---- setting up ---- */

static robot_pilot pilot_of(game *g, const game_setup *setup, int i) {
  if (setup->strategy == STRATEGY_PLAN) return robot_pilot_of_plan(&g->seeker[i]);
  return setup->strategy == STRATEGY_PLAIN ? sweeper_pilot(&g->sweeper[i]) : baseline_pilot(&g->baseline[i]);
}

static void start_robot(game *g, const game_setup *setup, int i) {
  const table *played = setup->strategy == STRATEGY_PLAIN ? setup->plain : setup->t;
  robot_init(&g->crew[i], &played->policy, i, setup->arena.clear_all, pilot_of(g, setup, i), wiring_voice(g->b));
  robot_embody(&g->crew[i], &setup->t->policy);
}

static void make_crew(game *g, const game_setup *setup) {
  const int robots = setup->t->policy.board.seekers;
  for (int i = 0; i < robots; i++)
    baseline_init(&g->baseline[i], &setup->t->policy, i, setup->strategy == STRATEGY_INFORMED ? g->baseline : NULL);
  for (int i = 0; i < robots; i++) {
    qtr_seeker_init(&g->seeker[i], &setup->t->policy, (unsigned)i, NULL, setup->arena.run);
    if (setup->strategy == STRATEGY_PLAIN)
      sweeper_init(&g->sweeper[i], &setup->plain->policy, &setup->t->policy, i, setup->arena.run);
    start_robot(g, setup, i);
    wiring_listen(g->b, &g->crew[i]);
  }
}

static int open_game(game *g, const game_setup *setup, fault *why) {
  g->crew = malloc(setup->t->policy.board.seekers * sizeof *g->crew);
  if (g->crew == NULL) return fault_set(why, "no memory for the robots");
  if (bus_open(&g->b, BUS_IN_PROCESS, why) != 0) return -1;
  if (setup->log != NULL && bus_record(g->b, setup->log, why) != 0) return -1;
  if (arena_open(&g->a, setup->t, g->b, &setup->arena, why) != 0) return -1;
  make_crew(g, setup);
  return 0;
}

static void close_game(game *g) {
  arena_close(&g->a);
  bus_close(g->b);
  free(g->crew);
}

/* ---- playing ---- */

static void keep_pace(double begin, double now, double speed) {
  const double ahead = speed > 0.0 ? now / speed - (clock_seconds() - begin) : 0.0;
  if (ahead <= 0.0) return;
  const struct timespec wait = {(time_t)ahead, (long)((ahead - (double)(time_t)ahead) * 1e9)};
  nanosleep(&wait, NULL);
}

/* A robot saves what it knows after each place and each signal, so that between two ticks its save is what it knows
 * now. All else that it had in memory is gone. */
static void cut_power(game *g, int i) {
  qtr_seeker_save(&g->seeker[i], g->save[i], sizeof g->save[i]);
  memset(&g->seeker[i], 0, sizeof g->seeker[i]);
  g->crew[i].off = true;
}

static void restart(game *g, const game_setup *setup, int i) {
  qtr_seeker_restore(&g->seeker[i], &setup->t->policy, (unsigned)i, g->save[i], sizeof g->save[i]);
  start_robot(g, setup, i);
}

static void tend_power(game *g, const game_setup *setup) {
  for (int i = 0; i < g->a.robots; i++) {
    if (g->a.robot[i].off && !g->crew[i].off) cut_power(g, i);
    if (!g->a.robot[i].off && g->crew[i].off) restart(g, setup, i);
  }
}

static void play(game *g, const game_setup *setup, const volatile int *interrupted) {
  const double begin = clock_seconds();
  while (!arena_over(&g->a) && (interrupted == NULL || *interrupted == 0) && !bus_log_failed(g->b)) {
    arena_publish(&g->a);
    bus_drain(g->b);
    arena_advance(&g->a);
    tend_power(g, setup);
    if (setup->watch != NULL) setup->watch(setup->user, &g->a);
    keep_pace(begin, g->a.now, setup->speed);
  }
}

void game_tell(const arena *a, const bus *b, game_result *result) {
  *result = (game_result){.duration = a->now,
                          .found_at = a->found_at,
                          .all_stopped_at = arena_all_stopped_at(a),
                          .mine = a->mine,
                          .looks_needed = a->mine >= 0 && a->setup.truth != NULL
                                              ? looks_needed(a->setup.seed, a->setup.truth->detection[a->mine])
                                              : 1,
                          .duplicates = a->duplicates,
                          .collisions = world_collisions(a->w),
                          .deadlocks = a->deadlocks,
                          .counts = bus_count(b)};
  /* What robots in other processes said, the arena has heard. */
  if (result->counts.sent[KIND_COMMAND] == 0) {
    result->counts.sent[KIND_COMMAND] = a->commands;
    result->counts.sent[KIND_TERMINATE] = a->signals;
  }
  for (int place = 0; place < a->places; place++) result->scanned += a->scanned_by[place] >= 0;
}

int game_play(const game_setup *setup, game_result *result, const volatile int *interrupted, fault *why) {
  game *g = calloc(1, sizeof *g);
  if (g == NULL) return fault_set(why, "no memory for the game");
  const double begin = clock_seconds();
  int status = open_game(g, setup, why);
  if (status == 0) {
    play(g, setup, interrupted);
    game_tell(&g->a, g->b, result);
    result->wall_seconds = clock_seconds() - begin;
    status = bus_end_log(g->b, why);
    if (status == 0 && setup->finish != NULL) status = setup->finish(setup->user, &g->a, result, why);
  }
  close_game(g);
  free(g);
  return status;
}
