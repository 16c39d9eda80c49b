/* The plan of a mission: the policy table that the robots run, learnt on the spot or read from a file. */
#ifndef QUARTER_DEMO_PLAN_H
#define QUARTER_DEMO_PLAN_H

#include "demo_limits.h"
#include "host/base/fault.h"
#include "host/table/table.h"

typedef struct {
  table t;
  char name[DEMO_NAME_SIZE]; /* of the mission */
  double likelihood[QTR_MAX_PLACES];
  table_route routes[QTR_MAX_SEEKERS];
  int territory[QTR_MAX_PLACES];  /* seeker whose route holds the place; -1: nobody's */
  qtr_steps step[QTR_MAX_PLACES]; /* of the planned visit; QTR_NEVER: none */
  double expected_step;           /* of the find */
  int negligible;                 /* places that count for too little to have their order certified */
} plan;

/* Read the mission that a plan is to be made of. `robots` 0: as it says. 0, or -1 with *why set. */
int plan_read(const char *mission, int robots, fault *why);

/* Learn its plan, for at most `seconds`, or read it from `table_path` (NULL: learn), which must be a table of this very
 * mission. `save` (NULL: nowhere) names a file to write the table to. 0, or -1 with *why set and nothing to free; its
 * status is EXIT_STOPPED, here and above, if a signal that stop.h catches came before there was a plan. */
int plan_make(plan *p, const char *table_path, double seconds, const char *save, fault *why);
void plan_free(plan *p);

/* P(found by step), if all goes as planned. */
double plan_found_by(const plan *p, double step);

#endif
