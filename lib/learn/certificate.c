#include "learn/certificate.h"

#include <math.h>

#include "learn/role.h"
#include "model/rounding.h"
#include "quarter/status.h"

/* Worths are negative under expected time, and a share of the gap is upwards in both. */
double qtr_certificate_within(const qtr_learner *learner, double share) {
  const double gap = learner->config.gap > QTR_LEAST_GAP ? learner->config.gap : QTR_LEAST_GAP;
  return learner->best.score.worth + share * gap * fabs(learner->best.score.worth);
}

bool qtr_certificate_bounds(double upper, double worth) {
  return upper >= worth - QTR_NEGLIGIBLE * (1.0 + fabs(worth));
}

bool qtr_certificate_closed(const qtr_learner *learner) {
  /* The best game is a policy, and the bound is on every policy. */
  QTR_ASSERT(qtr_certificate_bounds(learner->ground_upper, learner->best.score.worth));
  return learner->ground_upper <= qtr_certificate_within(learner, 1.0);
}

/* On an aggregate its own bound may meet the best game while the ground's does not: then the aggregate has no more to
 * give. */
enum qtr_learning qtr_certificate_verdict(const qtr_learner *learner) {
  if (learner->phase != QTR_PHASE_EPISODES || learner->upper > qtr_certificate_within(learner, 1.0))
    return QTR_LEARNING;
  return qtr_certificate_closed(learner) ? QTR_CERTIFIED : QTR_CONVERGED;
}

/* What is left out, or comes after the deadline, counts for nothing by the rules, and not for being small. */
static bool is_in_time(const qtr_learner *learner, qtr_steps visit) {
  const qtr_objective *objective = &learner->game->objective;
  return visit != QTR_NEVER && (objective->kind != QTR_DEADLINE || visit <= objective->deadline);
}

/* A discounted objective cannot tell plans apart that differ in what lies far off: the certificate says how much of it
 * there is. Places that count for next to nothing: discounted away, or hardly likely. */
static uint16_t count_negligible(const qtr_learner *learner) {
  const qtr_play *best = &learner->best;
  uint16_t count = 0;
  for (unsigned place = 0; place < learner->game->board.places; place++) {
    if (!is_in_time(learner, best->visit[place])) continue;
    count += qtr_objective_neglects(&learner->game->objective, learner->game->probability[place], best->visit[place],
                                    best->score.worth);
  }
  return count;
}

/* The ground's bound; the worth itself where it is above that by no more than two sums may differ that are equal. */
static double upper_of(const qtr_learner *learner, double worth) {
  return learner->ground_upper > worth + QTR_LEAST_GAP * fabs(worth) ? learner->ground_upper : worth;
}

/* (bound - worth) / |worth|, from the ground alone: what an aggregate bounds is its own policies. */
void qtr_learner_certificate(const qtr_learner *learner, qtr_certificate *certificate) {
  const qtr_score *score = &learner->best.score;
  const uint8_t objective = learner->game->objective.kind;
  const double worth = qtr_objective_of_score(objective, score);
  const double upper = upper_of(learner, worth);
  certificate->value = score->value;
  certificate->expected_time = score->expected_time;
  certificate->found = score->found;
  certificate->objective = qtr_objective_figure(objective, worth);
  certificate->bound = qtr_objective_figure(objective, upper);
  certificate->gap = upper > worth ? (upper - worth) / fabs(worth) : 0.0;
  certificate->certified = qtr_certificate_closed(learner);
  certificate->negligible_places = count_negligible(learner);
  certificate->episodes = learner->episodes;
  certificate->updates = learner->updates;
  certificate->max_q = learner_is_paper(learner) ? learner->max_q : learner->upper;
  certificate->price_steps = learner->bound.iterations;
}
