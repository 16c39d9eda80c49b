/* What `learn` and `exact` found, as text for people and as JSON. */
#ifndef QUARTER_TOOLS_REPORT_H
#define QUARTER_TOOLS_REPORT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "fit.h"
#include "host/base/fault.h"
#include "host/base/json.h"
#include "host/plan/anywhere.h"
#include "host/plan/problem.h"
#include "host/table/table.h"
#include "options.h"
#include "quarter/learner.h"
#include "replan.h"
#include "routes.h"

typedef struct {
  const char *command; /* "learn" or "exact" */
  const char *ended;   /* why it ended: "certified", "converged", "time limit", "episodes", "interrupted" */
  const options *o;
  const problem *p;
  qtr_certificate certificate;
  uint32_t regions, spots;     /* 0: not aggregated so */
  uint64_t q_entries, q_bytes; /* of the entries, keys and values */
  double seconds;              /* from the travel times to the certificate */
  uint32_t table_bytes;        /* 0: no table was made */
  uint32_t table_records;
  table_route route[QTR_MAX_SEEKERS]; /* places as the mission's */
  route_units units;
  replan before; /* the plan that this one replaces, or is compared with */
  bool anywhere; /* the table is for any start, or any places cleared */
  anywhere_report any;
  fit fit;
} report;

/* Print or write the report as the options say. 0, or -1 with *why set. */
int report_write(const report *r, fault *why);

/* The routes as JSON, by the input's numbers, with the names beside them; and as text, "seeker 0: 3 (step 7) -> Bay 5
 * (12)", a line each, in seconds and metres where the units have them. */
void report_json_routes(json *j, const table_route *routes, const naming *n, const route_units *units);
void report_routes(FILE *out, const table_route *route, const naming *n, const route_units *units);

#endif
