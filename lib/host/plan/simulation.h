/* A game simulated step by step: k robots, each with an executor of its own over the same table, walk the grid. Nothing
 * passes between them but termination signals. */
#ifndef QUARTER_HOST_SIMULATION_H
#define QUARTER_HOST_SIMULATION_H

#include <stdbool.h>

#include "host/base/fault.h"
#include "host/table/table.h"
#include "quarter/places.h"
#include "quarter/seeker.h"

enum { SIMULATION_NO_TARGET = -1 };

typedef struct {
  int seeker;
  uint32_t wait; /* steps that it starts later */
  double factor; /* 1: it is on time; 2: every move takes it twice as long */
} simulation_late;

typedef struct {
  int seeker;
  uint32_t step; /* from which on it does nothing more */
} simulation_lost;

typedef struct {
  int column, row;
} simulation_start;

/* How the game is to go. */
typedef struct {
  int lates, losts;
  simulation_late late[QTR_MAX_SEEKERS];
  simulation_lost lost[QTR_MAX_SEEKERS];
  int froms; /* seekers put elsewhere than the table says; 0: none */
  simulation_start from[QTR_MAX_SEEKERS];
  qtr_places clear; /* places cleared beforehand */
  int target;       /* place, or SIMULATION_NO_TARGET */
  bool clear_all;   /* go on after the find */
} simulation_config;

typedef struct {
  uint16_t place;
  uint8_t seeker;
  qtr_steps step;
} simulation_visit;

typedef struct {
  int visits; /* first visits, in order of time */
  simulation_visit visit[QTR_MAX_PLACES];
  int duplicates;                       /* visits to places that had been visited before */
  qtr_steps end;                        /* when the last robot stopped */
  qtr_steps found_step;                 /* QTR_NEVER: no target, or not found */
  uint32_t off_table;                   /* choices made off the table, over all robots */
  uint32_t found_signals, done_signals; /* that were sent */
  double value;                         /* discounted, of the first visits */
  double expected_time;                 /* steps; NAN if a place was left unvisited, and robots need not be home */
  double found;                         /* probability of a find, by the deadline where the mission has one */
} simulation;

/* Everybody on time from the table's starts, nothing cleared, no target. */
void simulation_config_default(simulation_config *config);

/* Play a game out, from where the deployment, made of the config, says. 0, or -1 with *why set: something that does not
 * fit the table, or no memory. */
int simulation_run(simulation *s, const table *t, const qtr_deployment *deployment, const simulation_config *config,
                   fault *why);

#endif
