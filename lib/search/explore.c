#include "search/explore.h"

#include "model/rounding.h"
#include "model/settings.h"
#include "quarter/random.h"
#include "quarter/status.h"

/* Watkins and Dayan: Q converges if every choice of every state is taken infinitely often; with a rate that stays it
 * is. */
void qtr_exploration_default(qtr_exploration_plan *plan) {
  plan->made = SETTINGS_MADE;
  plan->kind = QTR_EXPLORE_EPSILON;
  plan->first = 0.3;
  plan->last = 0.3;
  plan->decay = 1.0;
}

static int is_in(double value, double least, double most) {
  return value >= least && value <= most;
}

/* A temperature of 0 would divide by 0, a share of random choices is at most 1. */
int qtr_exploration_check(const qtr_exploration_plan *plan) {
  const double least = plan->kind == QTR_EXPLORE_SOFTMAX ? 1e-9 : 0.0;
  const double most = plan->kind == QTR_EXPLORE_EPSILON ? 1.0 : 1e9;
  if (plan->made != SETTINGS_MADE) return QTR_ERR_ARGUMENT;
  if (plan->kind > QTR_EXPLORE_SOFTMAX || !is_in(plan->decay, 0.0, 1.0)) return QTR_ERR_ARGUMENT;
  return is_in(plan->first, least, most) && is_in(plan->last, least, most) ? QTR_OK : QTR_ERR_ARGUMENT;
}

int qtr_explorer_init(qtr_explorer *explorer, const qtr_exploration_plan *plan, uint64_t seed) {
  const int status = qtr_exploration_check(plan);
  if (status != QTR_OK) return status;
  explorer->plan = *plan;
  explorer->rate = plan->first;
  explorer->random = seed;
  return QTR_OK;
}

static double draw(qtr_explorer *explorer) {
  return qtr_splitmix_unit(&explorer->random);
}

/* drawn < 1 as a double, but times a count it may round up to the count. */
static unsigned draw_below(qtr_explorer *explorer, unsigned count) {
  const unsigned drawn = (unsigned)(draw(explorer) * (double)count);
  return drawn < count ? drawn : count - 1;
}

/* The first of equals, so that a run repeats. */
static unsigned largest(const double *q, unsigned count) {
  unsigned best = 0;
  for (unsigned i = 1; i < count; i++)
    if (q[i] > q[best]) best = i;
  return best;
}

/* exp(x) for x <= 0, by multiplication alone: exp() differs in its last bit between C libraries, and a run must repeat.
 * exp(x) = exp(x / 1024)^1024, the inner one by its series; the relative error is below 1e-11. */
static double exp_of(double x) {
  if (x < -700.0) return 0.0;
  const double y = x / 1024.0;
  double term = 1.0;
  double sum = 1.0;
  for (int n = 1; n <= 10; n++) {
    term *= y / (double)n;
    sum += term;
  }
  for (int n = 0; n < 10; n++) sum *= sum;
  return sum;
}

/* P(i) = exp(Q_i / T) / sum over j of exp(Q_j / T). With the largest Q taken off each nothing overflows, and the shares
 * stay the same. */
static unsigned pick_softmax(qtr_explorer *explorer, const double *q, unsigned count) {
  const double top = q[largest(q, count)];
  double sum = 0.0;
  for (unsigned i = 0; i < count; i++) sum += exp_of((q[i] - top) / explorer->rate);
  /* The largest Q counts for exp(0) = 1, so some choice is always taken. */
  QTR_ASSERT(sum >= 1.0);
  double left = draw(explorer) * sum;
  for (unsigned i = 0; i + 1 < count; i++) {
    left -= exp_of((q[i] - top) / explorer->rate);
    if (left < 0.0) return i;
  }
  return count - 1;
}

/* Q-learning converges whatever the strategy, if it takes every choice of every state again and again (paper, section
 * 3.1). */
unsigned qtr_explorer_pick(qtr_explorer *explorer, const double *q, unsigned count) {
  if (count == 0) return 0;
  switch (explorer->plan.kind) {
  case QTR_EXPLORE_EPSILON: return draw(explorer) < explorer->rate ? draw_below(explorer, count) : largest(q, count);
  case QTR_EXPLORE_SOFTMAX: return pick_softmax(explorer, q, count);
  default: return draw_below(explorer, count);
  }
}

/* rate(n) = max(last, first decay^n), a product at a time. */
void qtr_explorer_next(qtr_explorer *explorer) {
  explorer->rate *= explorer->plan.decay;
  if (explorer->rate < explorer->plan.last) explorer->rate = explorer->plan.last;
}
