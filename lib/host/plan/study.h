/* A problem being learnt: its ground, the aggregate of it if one is asked for, the learner. */
#ifndef QUARTER_HOST_STUDY_H
#define QUARTER_HOST_STUDY_H

#include "host/base/fault.h"
#include "host/plan/problem.h"
#include "quarter/environment.h"
#include "quarter/learner.h"
#include "quarter/regions.h"

/* Large: keep it in static storage. */
typedef struct {
  problem p;
  qtr_environment ground, aggregate;
  qtr_regions regions;
  qtr_regions_scratch regions_scratch;
  bool measuring;  /* an aggregate's own best policy is asked for, without search on the ground beside it */
  bool aggregated; /* it is learnt on the aggregate: one was asked for, and made before a stop */
  qtr_learner learner;
} study;

/* Divide the map into regions. 0, or -1 with *why set, or QTR_ERR_STOPPED. */
int study_divide(study *s, const aggregate_config *how, fault *why);

/* Begin to learn the measured problem `s->p` anew; may be called again with other settings. There is a first plan then, also
 * after a stop: one on the true map, if the aggregate was not ready. 0, or -1 with *why set. */
int study_begin(study *s, const plan_config *config, fault *why);

#endif
