/* The plan of a mission: the policy table that the robots run, learnt on the spot or read from a file. */
#ifndef QUARTER_DEMO_PLAN_H
#define QUARTER_DEMO_PLAN_H

#include "demo_limits.h"
#include "host/base/fault.h"
#include "host/table/table.h"

/* What the world knows of the mission's own places, and a table does not say: how likely the mine is at each, and how
 * likely a look finds it there. */
typedef struct {
  double likelihood[QTR_MAX_PLACES]; /* sum 1 */
  double detection[QTR_MAX_PLACES];
} plan_truth;

/* By place of the table, of which several may be looks at one of the mission's: of those the first in number is the
 * first in time. */
typedef struct {
  table t;
  char name[DEMO_NAME_SIZE];         /* of the mission */
  int places;                        /* the mission's own */
  plan_truth truth;                  /* of them */
  double likelihood[QTR_MAX_PLACES]; /* that this very look finds it */
  table_route routes[QTR_MAX_SEEKERS];
  int territory[QTR_MAX_PLACES];  /* seeker whose route holds the place; -1: nobody's */
  qtr_steps step[QTR_MAX_PLACES]; /* of the planned visit, its scan over; QTR_NEVER: none */
  double expected_step;           /* of the find */
  double last_step;               /* at which what is not found counts, where robots tire; else below 0 */
  int negligible;                 /* places that count for too little to have their order certified */
} plan;

/* Read the mission that a plan is to be made of. `robots` 0: as it says. 0, or -1 with *why set. */
int plan_read(const char *mission, int robots, fault *why);

/* Learn its plan, for at most `seconds`, or read it from `table_path` (NULL: learn), which must be a table of this very
 * mission. `save` (NULL: nowhere) names a file to write the table to. 0, or -1 with *why set and nothing to free; its
 * status is EXIT_STOPPED, here and above, if a signal that stop.h catches came before there was a plan. */
int plan_make(plan *p, const char *table_path, double seconds, const char *save, fault *why);
void plan_free(plan *p);

/* The n-th look, from 1, at one of the mission's own places, as a place of the table; -1: there is none. */
int plan_look(const plan *p, int place, int n);

/* The planned step of the n-th look at a place; QTR_NEVER: it is not planned. */
qtr_steps plan_look_step(const plan *p, int place, int n);

/* The mission as if all its robots were alike and never tired, and its sensors perfect: a table for comparison, learnt
 * for at most `seconds`. The plan is made. 0, or -1 with *why set and nothing to free. */
int plan_make_plain(table *t, const plan *p, int robots, double seconds, fault *why);

/* P(found by step), if all goes as planned. */
double plan_found_by(const plan *p, double step);

#endif
