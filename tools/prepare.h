/* What a command does before it works on an input. */
#ifndef QUARTER_TOOLS_PREPARE_H
#define QUARTER_TOOLS_PREPARE_H

#include "host/base/fault.h"
#include "host/plan/problem.h"
#include "options.h"

/* Read the input, look at the outputs' names, and only then measure travel times, which may take long. 0, or -1 with
 * *why set. */
int prepare_problem(problem *p, const options *o, fault *why);

/* All but the travel times. */
int prepare_load(problem *p, const options *o, fault *why);

#endif
