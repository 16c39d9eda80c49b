#include "quarter/objective.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "model/rounding.h"
#include "quarter/status.h"

/* Where gamma^t comes to its end as a double, all that is left counts as found now. */
#define LEAST_DIVISOR 1e-250

/* ---- aims ---- */

void qtr_aim_default(qtr_aim *aim) {
  aim->kind = QTR_DISCOUNTED;
  aim->gamma = 0.99;
  aim->deadline = 0;
  aim->home_weight = 0.0;
}

int qtr_aim_check(const qtr_aim *aim) {
  if (aim->kind >= QTR_OBJECTIVES || !(aim->gamma > 0.0 && aim->gamma < 1.0)) return QTR_ERR_ARGUMENT;
  if (aim->kind == QTR_DEADLINE && aim->deadline == QTR_NEVER) return QTR_ERR_ARGUMENT;
  if (!(aim->home_weight >= 0.0 && aim->home_weight <= DBL_MAX / QTR_MAX_PLACES)) return QTR_ERR_ARGUMENT;
  return aim->home_weight > 0.0 && aim->kind != QTR_TIME ? QTR_ERR_ARGUMENT : QTR_OK;
}

void qtr_aim_undiscount(qtr_aim *aim) {
  aim->kind = QTR_TIME;
}

/* ---- the worth of visits ---- */

/* By multiplication alone: pow() differs between C libraries, and a run must repeat bit for bit. */
void qtr_objective_init(qtr_objective *objective, const qtr_aim *aim, const qtr_objective_terms *terms) {
  /* Worth falls with time for 0 < gamma < 1 alone (Eq. 3.1), and every bound rests on that. */
  QTR_ASSERT(qtr_aim_check(aim) == QTR_OK);
  objective->kind = aim->kind;
  objective->deadline = aim->deadline;
  objective->terms = terms != NULL ? *terms : (qtr_objective_terms){.findable = 1.0};
  objective->scale = (aim->kind == QTR_DISCOUNTED ? QTR_REWARD_SCALE : 1.0) * objective->terms.findable;
  objective->time_end = aim->kind == QTR_TIME ? (double)objective->terms.end : 0.0;
  objective->power[0] = 1.0;
  for (unsigned n = 1; n < QTR_OBJECTIVE_POWERS; n++) objective->power[n] = objective->power[n - 1] * aim->gamma;
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

/* -P t is worth less than 0, so leaving a place out would be a gain: under expected time it is no play, but where an
 * end makes it cost T_end. */
bool qtr_objective_needs_all(const qtr_objective *objective) {
  return objective->kind == QTR_TIME && objective->terms.end == 0;
}

/* Expected time never fades; a place at 0 steps or 1 has gamma^0 of it left. */
bool qtr_objective_tells(const qtr_objective *objective, qtr_steps steps) {
  if (objective->kind != QTR_DISCOUNTED || steps == 0) return true;
  return qtr_objective_power(objective, steps - 1) >= QTR_OBJECTIVE_LEAST_POWER;
}

/* A place on a start cell, too, depends on the order under expected time: it would count if it came a step later. What
 * comes too late for a deadline counts for nothing in any order. */
bool qtr_objective_neglects(const qtr_objective *objective, double probability, qtr_steps when, double worth) {
  const double steps = (double)(when > 0 ? when : 1);
  const double counts =
      objective->kind == QTR_TIME ? probability * steps : qtr_objective_worth(objective, probability, when);
  return counts < QTR_NEGLIGIBLE * fabs(worth);
}

void qtr_objective_score(const qtr_objective *objective, qtr_score *score, const double *probability,
                         const qtr_steps *visit, unsigned places, uint64_t home) {
  double left_out = 0.0;
  double late = 0.0;
  score->value = 0.0;
  score->expected_time = 0.0;
  for (unsigned place = 0; place < places; place++) {
    if (visit[place] == QTR_NEVER) {
      left_out += probability[place];
      continue;
    }
    score->value += qtr_objective_discounted(objective, probability[place], visit[place]);
    score->expected_time += probability[place] * (double)visit[place];
    if (objective->kind == QTR_DEADLINE && visit[place] > objective->deadline) late += probability[place];
  }
  score->expected_time += left_out * (double)objective->terms.end + objective->terms.home_weight * (double)home;
  score->found = objective->terms.findable * (1.0 - left_out - late);
  /* w times a mean of powers of gamma, each at most 1, over the places. */
  QTR_ASSERT(score->value >= 0.0 && score->value <= QTR_REWARD_SCALE * (1.0 + QTR_NEGLIGIBLE));
  score->worth = qtr_objective_of_score(objective->kind, score);
}

/* ---- worth from some moment on ---- */

/* After its deadline a game brings nothing more, and after the last end nobody who has one does anything. With an end,
 * what can still be done depends on when it is, under each objective. */
qtr_steps qtr_objective_last_clock(const qtr_objective *objective) {
  const qtr_steps deadline = objective->kind == QTR_DEADLINE ? objective->deadline + 1 : 0;
  return objective->terms.end > deadline ? objective->terms.end : deadline;
}

/* Discounted, what is visited at the game's start counts as if it came a step later (Eq. 4.2). Where a seeker is ready
 * at step now > 0 it does not: gamma^(now-1) is gamma^-1 from there. */
double qtr_objective_at_once(const qtr_objective *objective, double probability, qtr_steps now) {
  if (objective->kind == QTR_DEADLINE) return qtr_objective_worth(objective, probability, now);
  if (objective->kind == QTR_TIME) return 0.0;
  const double worth = qtr_objective_worth(objective, probability, 0);
  return now > 0 ? worth / objective->power[1] : worth;
}

double qtr_objective_visit(const qtr_objective *objective, double probability) {
  return objective->kind == QTR_DISCOUNTED ? probability : 0.0;
}

/* Discounted, what comes later is less by gamma^steps; under expected time each step costs the likelihood that
 * waits. */
double qtr_objective_delayed(const qtr_objective *objective, double worth, qtr_steps steps, double waiting) {
  if (objective->kind != QTR_DISCOUNTED) return worth - (double)steps * waiting;
  return qtr_objective_power(objective, steps) * worth;
}

/* What each step costs under expected time: the likelihood that waits, and so much for each seeker to come home. */
static double waiting(const qtr_objective *objective, double unvisited, unsigned seekers) {
  return unvisited + objective->terms.home_weight * (double)seekers;
}

/* Discounted, rewards counted from now are those counted from the start over gamma^now; under expected time, -P (t -
 * now) = -P t + P now, for each place left. A deadline counts visits, whenever they are. */
double qtr_objective_from_now(const qtr_objective *objective, double worth, qtr_steps now, double unvisited,
                              unsigned seekers) {
  if (objective->kind == QTR_TIME) return worth + (double)now * waiting(objective, unvisited, seekers);
  if (objective->kind == QTR_DEADLINE) return worth;
  const double power = qtr_objective_power(objective, now);
  return power > LEAST_DIVISOR ? worth / power : objective->scale * unvisited;
}

void qtr_objective_begin(qtr_outcome *outcome, qtr_steps now) {
  outcome->reward = 0.0;
  outcome->discount = 1.0;
  outcome->now = now;
}

/* Expected time as a backup sees it: W(s,a) = tau (unvisited mass) + W(s'), negated; who is visited within the stretch
 * waits no longer than until then. */
void qtr_objective_wait(const qtr_objective *objective, qtr_outcome *outcome, double unvisited, unsigned seekers,
                        qtr_steps passed) {
  if (objective->kind == QTR_TIME) outcome->reward -= (double)passed * waiting(objective, unvisited, seekers);
}

void qtr_objective_collect(const qtr_objective *objective, qtr_outcome *outcome, double probability, qtr_steps offset,
                           qtr_steps passed) {
  /* A visit lies within its stretch, gamma^(offset-1) of Eq. 4.7: at the stretch's start it was counted before. */
  QTR_ASSERT(offset > 0 && offset <= passed);
  if (objective->kind == QTR_TIME)
    outcome->reward += probability * (double)(passed - offset);
  else if (objective->kind == QTR_DEADLINE)
    outcome->reward += qtr_objective_worth(objective, probability, outcome->now + offset);
  else
    outcome->reward += outcome->discount * qtr_objective_power(objective, offset - 1) * objective->scale * probability;
}

void qtr_objective_pass(const qtr_objective *objective, qtr_outcome *outcome, qtr_steps passed) {
  if (objective->kind == QTR_DISCOUNTED) outcome->discount *= qtr_objective_power(objective, passed);
  outcome->now += passed;
}

double qtr_objective_leave(const qtr_objective *objective, qtr_steps steps) {
  return -objective->terms.home_weight * (double)steps;
}

void qtr_objective_end(const qtr_objective *objective, qtr_outcome *outcome, double unvisited) {
  const double left = objective->time_end - (double)outcome->now;
  if (left > 0.0) outcome->reward -= unvisited * left;
}

/* ---- what people are told ---- */

const char *const qtr_objective_names[] = {
    [QTR_DISCOUNTED] = "discounted", [QTR_TIME] = "time", [QTR_DEADLINE] = "deadline", NULL};

static const qtr_objective_words words[] = {
    [QTR_DISCOUNTED] = {"discounted value", "discounted value", "no more value than", NULL, QTR_TIME,
                        .less_is_better = false, .fades = true},
    [QTR_TIME] = {"expected time", "least expected time", "no less time than", "step", QTR_DISCOUNTED,
                  .less_is_better = true, .fades = false},
    [QTR_DEADLINE] = {"probability of a find by the deadline", "greatest probability of a find by the deadline",
                      "no greater probability than", NULL, QTR_TIME, .less_is_better = false, .fades = false}};

const qtr_objective_words *qtr_objective_in_words(uint8_t kind) {
  QTR_ASSERT(kind < QTR_OBJECTIVES); /* as missions and tables are checked for */
  return &words[kind];
}

double qtr_objective_of_score(uint8_t kind, const qtr_score *score) {
  if (kind == QTR_DEADLINE) return score->found;
  return kind == QTR_TIME ? -score->expected_time : score->value;
}

double qtr_objective_figure(uint8_t kind, double worth) {
  return words[kind].less_is_better ? -worth : worth;
}

bool qtr_objective_is_better(uint8_t kind, double figure, double than) {
  return words[kind].less_is_better ? figure < than : figure > than;
}

double qtr_objective_gap(uint8_t kind, double figure, double bound) {
  return qtr_objective_is_better(kind, bound, figure) ? fabs(bound - figure) / figure : 0.0;
}

bool qtr_score_is_better(const qtr_score *score, const qtr_score *than) {
  if (score->worth != than->worth) return score->worth > than->worth;
  return score->expected_time < than->expected_time;
}
