#include "quarter/objective.h"

/* Where gamma^t comes to its end as a double, all that is left counts as found now. */
#define LEAST_DIVISOR 1e-250

bool qtr_objective_is(uint8_t kind, double gamma) {
  return kind < QTR_OBJECTIVES && gamma > 0.0 && gamma < 1.0;
}

/* By multiplication alone: pow() differs between C libraries, and a run must repeat bit for bit. */
void qtr_objective_init(qtr_objective *objective, uint8_t kind, double gamma) {
  objective->kind = kind;
  objective->power[0] = 1.0;
  for (unsigned n = 1; n < QTR_OBJECTIVE_POWERS; n++) objective->power[n] = objective->power[n - 1] * gamma;
}

/* gamma^n = gamma^(n mod N) * (gamma^N)^(n div N), the second by squaring. */
double qtr_objective_far_power(const qtr_objective *objective, qtr_steps n) {
  double power = objective->power[n % QTR_OBJECTIVE_POWERS];
  double square = objective->power[QTR_OBJECTIVE_POWERS - 1] * objective->power[1];
  for (n /= QTR_OBJECTIVE_POWERS; n > 0; n /= 2) {
    if (n % 2 == 1) power *= square;
    square *= square;
  }
  return power;
}

bool qtr_objective_needs_all(const qtr_objective *objective) {
  return objective->kind == QTR_TIME;
}

bool qtr_objective_tells(const qtr_objective *objective, qtr_steps steps) {
  if (objective->kind == QTR_TIME || steps == 0) return true;
  return qtr_objective_power(objective, steps - 1) >= QTR_OBJECTIVE_LEAST_POWER;
}

double qtr_objective_visit(const qtr_objective *objective, double probability) {
  return objective->kind == QTR_TIME ? 0.0 : probability;
}

/* Discounted, what comes later is less by gamma^steps; under expected time each step costs the likelihood that waits. */
double qtr_objective_delayed(const qtr_objective *objective, double worth, qtr_steps steps, double waiting) {
  if (objective->kind == QTR_TIME) return worth - (double)steps * waiting;
  return qtr_objective_power(objective, steps) * worth;
}

/* Discounted, rewards counted from now are those counted from the start over gamma^now; under expected time, -P (t - now) =
 * -P t + P now, for each place left. */
double qtr_objective_from_now(const qtr_objective *objective, double worth, qtr_steps now, double unvisited) {
  if (objective->kind == QTR_TIME) return worth + (double)now * unvisited;
  const double power = qtr_objective_power(objective, now);
  return power > LEAST_DIVISOR ? worth / power : QTR_REWARD_SCALE * unvisited;
}

void qtr_objective_wait(const qtr_objective *objective, qtr_outcome *outcome, double unvisited, qtr_steps passed) {
  if (objective->kind == QTR_TIME) outcome->reward -= (double)passed * unvisited;
}

void qtr_objective_collect(const qtr_objective *objective, qtr_outcome *outcome, double probability, qtr_steps offset,
                           qtr_steps passed) {
  if (objective->kind == QTR_TIME)
    outcome->reward += probability * (double)(passed - offset);
  else
    outcome->reward += outcome->discount * qtr_objective_power(objective, offset - 1) * QTR_REWARD_SCALE * probability;
}

void qtr_objective_pass(const qtr_objective *objective, qtr_outcome *outcome, qtr_steps passed) {
  if (objective->kind != QTR_TIME) outcome->discount *= qtr_objective_power(objective, passed);
}

double qtr_objective_figure(const qtr_objective *objective, double worth) {
  return objective->kind == QTR_TIME ? -worth : worth;
}

double qtr_objective_of_score(const qtr_objective *objective, const qtr_score *score) {
  return objective->kind == QTR_TIME ? -score->expected_time : score->value;
}

bool qtr_score_is_better(const qtr_score *score, const qtr_score *than) {
  if (score->worth != than->worth) return score->worth > than->worth;
  return score->expected_time < than->expected_time;
}
