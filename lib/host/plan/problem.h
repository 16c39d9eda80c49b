/* An input made ready to learn on: read, overridden from the command line, its elemental tasks solved. */
#ifndef QUARTER_HOST_PROBLEM_H
#define QUARTER_HOST_PROBLEM_H

#include "host/base/fault.h"
#include "host/input/input.h"
#include "options.h"
#include "quarter/game.h"

/* Large: keep it in static storage. */
typedef struct {
  input in;
  qtr_game game;
  qtr_field field;
  double travel_seconds; /* that the elemental tasks took */
} problem;

/* Read the options' input and set its game up. Places that no seeker can reach are an error that names them, or are
 * left out under --skip-unreachable. The input's notes are printed. 0, or -1 with *why set. */
int problem_read(problem *p, const options *o, fault *why);

/* Its two halves: all but the travel times, with the outputs' names looked at; and those. */
int problem_load(problem *p, const options *o, fault *why);
int problem_measure(problem *p, const options *o, fault *why);

/* Free cells of the map. */
uint32_t problem_free_cells(const problem *p);

#endif
