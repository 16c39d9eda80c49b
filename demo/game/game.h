/* A whole game in one process: the world and its robots, talking over LCM in memory. */
#ifndef QUARTER_DEMO_GAME_H
#define QUARTER_DEMO_GAME_H

#include "arena.h"
#include "host/table/table.h"

enum game_strategy { STRATEGY_PLAN, STRATEGY_NEAREST, STRATEGY_INFORMED, STRATEGY_PLAIN };

/* Their names, ended by NULL. */
extern const char *const game_strategies[];

typedef struct {
  double duration, found_at, all_stopped_at; /* seconds; below 0: never */
  int looks_needed;                          /* until one at the mine finds it */
  int mine, scanned, duplicates, collisions, deadlocks;
  double wall_seconds;
  bus_counts counts;
} game_result;

typedef struct {
  const table *t;
  const table *plain; /* of STRATEGY_PLAIN: the table that is played, without the terms of the robots that play it */
  arena_setup arena;
  int strategy;    /* enum game_strategy */
  const char *log; /* LCM log to write; NULL: none */
  void *user;
  void (*watch)(void *user, const arena *a); /* told after every tick; NULL: nobody */
  int (*finish)(void *user, const arena *a, const game_result *result, fault *why); /* at the end; NULL: nobody */
  double speed; /* times real time; 0: as fast as can be */
} game_setup;

/* Plays a game from beginning to end; `interrupted` (may be NULL) ends it before. 0, or -1 with *why set. */
int game_play(const game_setup *setup, game_result *result, const volatile int *interrupted, fault *why);

/* How a game stands, all but wall_seconds. */
void game_tell(const arena *a, const bus *b, game_result *result);

/* Seconds of the world's clock that a step of a table's plan takes; and seconds of the mission in one of that clock's,
 * on which the fastest robot drives a cell: 1 where the mission says nothing of seconds. */
double game_step_seconds(const table *t);
double game_pace(const table *t);

/* Seconds of the world's clock after which a game ends, whatever its robots do. */
double game_limit_seconds(const table *t, const fault_script *faults);

/* Seconds more that a game may take if doors are shut in it: a robot goes to all that is left, and gives each place up
 * twice. */
double game_door_seconds(const table *t, const fault_script *faults);

/* Seconds that a game may take whose robots may have no plan: each of them goes to all places. */
double game_unplanned_seconds(const table *t, const fault_script *faults);

/* A plan's latest visit, in seconds; so all of these. */
double game_plan_seconds(const table *t);

#endif
