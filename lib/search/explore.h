/* Exploration by its plan: the state of a strategy, and the choices that it makes. */
#ifndef QUARTER_SEARCH_EXPLORE_H
#define QUARTER_SEARCH_EXPLORE_H

#include <stdint.h>

#include "quarter/explore.h"

typedef struct {
  qtr_exploration_plan plan;
  double rate;
  uint64_t random;
} qtr_explorer;

/* QTR_OK, or what qtr_exploration_check() says of the plan. The same seed explores in the same way, bit for bit. */
int qtr_explorer_init(qtr_explorer *explorer, const qtr_exploration_plan *plan, uint64_t seed);

/* The index of the choice to take among `count`, 1 or more, with these Q. 0 for none. */
unsigned qtr_explorer_pick(qtr_explorer *explorer, const double *q, unsigned count);

/* An episode is over: the rate goes on. */
void qtr_explorer_next(qtr_explorer *explorer);

#endif
