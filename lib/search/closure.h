/* The metric closure: travel times by way of other places, where that is sooner than the direct way. */
#ifndef QUARTER_SEARCH_CLOSURE_H
#define QUARTER_SEARCH_CLOSURE_H

#include "quarter/config.h"

/* Shorten `steps`, a row of places for each node, the places' own first: Floyd (1962) and Warshall. */
void qtr_closure_fill(qtr_steps *steps, unsigned nodes, unsigned places);

#endif
