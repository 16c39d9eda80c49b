/* What is to be planned, and how: the settings of everything between an input and its table. */
#ifndef QUARTER_HOST_PLAN_CONFIG_H
#define QUARTER_HOST_PLAN_CONFIG_H

#include <stdbool.h>
#include <stdint.h>

#include "host/base/fault.h"
#include "host/input/input.h"
#include "host/plan/aggregate.h"
#include "quarter/learner.h"

enum { PLAN_AS_STATED = 255 }; /* of an objective or a rule: as the input says */

typedef struct {
  uint32_t made;           /* by plan_config_default(): settings that were not are refused */
  input_options reading;   /* cell size, number of robots, what may be moved or left out */
  qtr_aim aim;             /* of kind PLAN_AS_STATED: the input's; and so with gamma 0 its gamma */
  double deadline_seconds; /* above 0: find by then, whatever the input says; 0: as it says */
  int rule;                /* enum qtr_rule, or PLAN_AS_STATED */
  qtr_learner_config learner;
  aggregate_config aggregate; /* what the learner plays on, beside the true map */
  bool any_starts;            /* the table is to answer for starts in any region, */
  uint32_t start_regions;     /* of so many at most; 0: as many as the limits allow */
  bool any_cleared;           /* for any set of places cleared beforehand, */
  double table_limit;         /* and may then take so many megabytes; what takes more is refused before it is learnt */
  bool quiet;                 /* no progress on the terminal */
} plan_config;

/* Everything as the input says, learnt in the certified setting on the true map; tables of 4 MB at most. Regions are of
 * 25 cells and 15 steps, spots of 5 places and 25 steps, should they be asked for. */
void plan_config_default(plan_config *config);

/* Whether the settings go together; what concerns a single part, that part refuses. 0, or -1 with *why set. */
int plan_config_check(const plan_config *config, fault *why);

#endif
