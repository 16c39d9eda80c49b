/* A problem being learnt as the options say: its ground, the aggregate of it if one is asked for, the learner. */
#ifndef QUARTER_HOST_STUDY_H
#define QUARTER_HOST_STUDY_H

#include "host/base/fault.h"
#include "host/plan/problem.h"
#include "options.h"
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

/* Read the input and set its ground up. 0, or -1 with *why set. */
int study_read(study *s, const options *o, fault *why);

/* Divide the map into regions as the options say. 0, or -1 with *why set, or QTR_ERR_STOPPED. */
int study_divide(study *s, const options *o, fault *why);

/* Begin to learn it anew; may be called again with other aggregation options. There is a first plan then, also after a
 * stop: one on the true map, if the aggregate was not ready. 0, or -1 with *why set. */
int study_begin(study *s, const options *o, fault *why);

#endif
