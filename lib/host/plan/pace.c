#include "host/plan/pace.h"

#include <math.h>

/* ---- the step ---- */

static double steps_of(double seconds, double step) {
  return fmax(round(seconds / step), 1.0);
}

/* The step around `about` that is nearest to right for all, relative; and what it is wrong by. */
static double settle(const double *cell_seconds, unsigned classes, double about, double *rounding) {
  double least = HUGE_VAL, most = 0.0;
  for (unsigned i = 0; i < classes; i++) {
    const double rate = steps_of(cell_seconds[i], about) / cell_seconds[i];
    least = fmin(least, rate);
    most = fmax(most, rate);
  }
  *rounding = (most - least) / (most + least);
  return least == most ? cell_seconds[0] / steps_of(cell_seconds[0], about) : 2.0 / (least + most);
}

static double worst_rounding(const double *cell_seconds, unsigned classes, double step) {
  double worst = 0.0;
  for (unsigned i = 0; i < classes; i++)
    worst = fmax(worst, fabs(steps_of(cell_seconds[i], step) * step / cell_seconds[i] - 1.0));
  return worst < 1e-12 ? 0.0 : worst;
}

/* The fastest class takes one step for a cell, or two, and so on: at fifty no time is rounded by more than half a step
 * in fifty. */
static double longest_step(const double *cell_seconds, unsigned classes) {
  double fastest = HUGE_VAL, rounding = 0.0;
  for (unsigned i = 0; i < classes; i++) fastest = fmin(fastest, cell_seconds[i]);
  for (unsigned steps = 1;; steps++) {
    const double step = settle(cell_seconds, classes, fastest / steps, &rounding);
    if (rounding <= PACE_ROUNDING) return step;
  }
}

void pace_choose(pace *p, uint32_t *cell_steps, const double *cell_seconds, unsigned classes, double step_seconds) {
  p->seconds_per_step = step_seconds > 0.0 ? step_seconds : longest_step(cell_seconds, classes);
  p->rounding = worst_rounding(cell_seconds, classes, p->seconds_per_step);
  for (unsigned i = 0; i < classes; i++)
    cell_steps[i] = (uint32_t)fmin(steps_of(cell_seconds[i], p->seconds_per_step), PACE_STEPS_MOST);
}

/* ---- other times ---- */

/* What divides without a rest but for the last bits does so. */
static qtr_steps whole_steps(pace *p, double seconds, double (*whole)(double)) {
  const double exact = seconds / p->seconds_per_step, nearest = round(exact);
  const double steps = fabs(exact - nearest) <= 1e-9 * fmax(exact, 1.0) ? nearest : whole(exact);
  if (steps != nearest || fabs(exact - nearest) > 1e-9 * fmax(exact, 1.0))
    p->end_rounding = fmax(p->end_rounding, fabs(steps / exact - 1.0));
  return (qtr_steps)fmin(steps, PACE_STEPS_MOST);
}

qtr_steps pace_steps_up(pace *p, double seconds) {
  return whole_steps(p, seconds, ceil);
}

qtr_steps pace_steps_down(pace *p, double seconds) {
  return whole_steps(p, seconds, floor);
}
