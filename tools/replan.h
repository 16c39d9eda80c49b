/* What a new plan changes against an older one of the same mission. */
#ifndef QUARTER_TOOLS_REPLAN_H
#define QUARTER_TOOLS_REPLAN_H

#include <stdbool.h>
#include <stdio.h>

#include "host/base/fault.h"
#include "host/base/json.h"
#include "host/plan/problem.h"
#include "host/table/table.h"
#include "quarter/learner.h"

/* The older plan. */
typedef struct {
  const char *path; /* NULL: there is none */
  bool asked;       /* for: else there is nothing to say of a plan that is the same */
  table t;
  table_route route[QTR_MAX_SEEKERS];
  double expected_time, expected_seconds;
} replan;

/* Read the table at `path`; or, where that is NULL, the one at `output` that is about to be replaced, if there is one.
 * 0, or -1 with *why set: `path` is no table. */
int replan_begin(replan *c, const char *path, const char *output, fault *why);

/* Text and the member "against", of the new plan's routes; nothing where there is no older one. */
void replan_write(FILE *out, const replan *c, const naming *n, const table_route *routes,
                  const qtr_certificate *certificate, const problem *p);
void replan_json(json *j, const replan *c, const naming *n, const table_route *routes);

#endif
