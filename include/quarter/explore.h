/* Action strategies that explore (paper, section 3.1): which of the choices of a state to take, given their Q. */
#ifndef QUARTER_EXPLORE_H
#define QUARTER_EXPLORE_H

#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

enum qtr_exploration {
  QTR_EXPLORE_UNIFORM = 0, /* any choice, all alike; the rate is not used */
  QTR_EXPLORE_EPSILON = 1, /* with probability rate any choice, else the one with the largest Q */
  QTR_EXPLORE_SOFTMAX = 2  /* with probability proportional to exp(Q / rate) */
};

/* The rate in episode n is max(last, first * decay^n). */
typedef struct {
  uint32_t made; /* by qtr_exploration_default() */
  uint8_t kind;  /* enum qtr_exploration */
  double first;  /* epsilon: 0..1; softmax: a temperature in units of Q, above 0 */
  double last;   /* 0 or more; softmax: above 0 */
  double decay;  /* 0..1; 1: the rate stays */
} qtr_exploration_plan;

/* Epsilon-greedy, 0.3 throughout: every choice is tried infinitely often, so Q converges. */
void qtr_exploration_default(qtr_exploration_plan *plan);

/* QTR_OK, or QTR_ERR_ARGUMENT for a plan out of its ranges, or not from its default. */
int qtr_exploration_check(const qtr_exploration_plan *plan);

QTR_C_END

#endif
