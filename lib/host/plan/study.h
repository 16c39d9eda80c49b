/* A problem being learnt: its ground, the aggregate of it if one is asked for, the learner. */
#ifndef QUARTER_HOST_STUDY_H
#define QUARTER_HOST_STUDY_H

#include "host/base/fault.h"
#include "host/base/memory.h"
#include "host/plan/problem.h"
#include "quarter/environment.h"
#include "quarter/learner.h"
#include "quarter/regions.h"

/* Large: take it by study_take(). */
typedef struct {
  problem p;
  qtr_regions *regions; /* NULL: the map was never divided */
  qtr_environment *ground, *aggregate;
  qtr_learner *learner;
  bool measuring;  /* an aggregate's own best policy is asked for, without search on the ground beside it */
  bool aggregated; /* it is learnt on the aggregate: one was asked for, and made before a stop */
  bool cramped;    /* there was no memory for a larger Q-table: it refuses what it cannot hold */
  memory_block ground_block, aggregate_block, work, table, routes; /* in which these stand */
} study;

/* A study with no problem yet, for study_drop(). NULL with *why set. */
study *study_take(fault *why);
void study_drop(study *s); /* NULL does nothing */

/* Divide the map into regions. 0, or -1 with *why set, or QTR_ERR_STOPPED. */
int study_divide(study *s, const aggregate_config *how, fault *why);

/* Begin to learn the measured problem `s->p` anew; may be called again with other settings. There is a first plan then,
 * also after a stop: one on the true map, if the aggregate was not ready. 0, or -1 with *why set. */
int study_begin(study *s, const plan_config *config, fault *why);

/* Learn a little more (qtr_learner_step()). The Q-table is given more memory ahead of what the step can learn; where
 * there is none left, learning goes on with what it has, as it does with a table that is full by the build's sizes:
 * what is proven stays so, and the gap closes slower. */
enum qtr_learning study_step(study *s);

#endif
