/* A game simulated step by step: k robots, each with an executor of its own over the same table, walk the grid. Nothing
 * passes between them but termination signals. */
#ifndef QUARTER_HOST_SIMULATION_H
#define QUARTER_HOST_SIMULATION_H

#include <stdbool.h>

#include "host/base/fault.h"
#include "host/table/table.h"
#include "options.h"
#include "quarter/seeker.h"

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
  double expected_time;                 /* steps; NAN if a place was left unvisited */
} simulation;

/* Play a game out: robots late or lost, and the target, as the options say. 0, or -1 with *why set: an option that does
 * not fit the table, or no memory. */
int simulation_run(simulation *s, const table *t, const options *o, fault *why);

#endif
