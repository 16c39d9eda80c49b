/* A problem learnt by Quarter for so many seconds of the processor. */
#ifndef QUARTER_BENCH_LEARN_H
#define QUARTER_BENCH_LEARN_H

#include "field/problem.h"
#include "field/referee.h"
#include "host/base/fault.h"
#include "quarter/learner.h"

#define LEARN_POINTS 256u

typedef struct {
  double seconds; /* of the processor, since the learner's begin */
  qtr_certificate certificate;
} learn_point;

/* {0} is none. */
typedef struct {
  plan_routes best;
  unsigned points; /* in which the plan became better; the last one is the end */
  learn_point point[LEARN_POINTS];
} learnt;

/* Learn until the gap is closed or the seconds are over, in a setting of enum qtr_setting. 0, or -1 with *why set. Drop
 * it in any case. */
int learn_for(learnt *l, problem_case *made, int setting, double gap, double seconds, fault *why);

void learnt_drop(learnt *l);

/* The end of it. */
static inline const learn_point *learnt_end(const learnt *l) {
  return &l->point[l->points - 1];
}

/* Seconds of the processor that this process has taken. */
double learn_clock(void);

#endif
