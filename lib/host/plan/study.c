#include "host/plan/study.h"

#include "host/base/stop.h"
#include "quarter/status.h"

int study_divide(study *s, const aggregate_config *how, fault *why) {
  const int status = aggregate_divide(&s->regions, how, &s->p.in.mission, &s->regions_scratch);
  if (status == QTR_OK || status == QTR_ERR_STOPPED) return status;
  return fault_set(why, "%s: its regions: %s", s->p.in.path, qtr_strerror(status));
}

/* The ground has the mission's own rule, but under an aggregate: its policy is played on the ground by the free one, whatever
 * the rule that it was learnt by. */
static void set_ground_rule(study *s) {
  s->p.game.board.rule = s->aggregated ? QTR_RULE_FREE : s->p.in.mission.rule;
}

/* 0, -1 with *why set, or QTR_ERR_STOPPED. */
static int make_aggregate(study *s, const aggregate_config *how, fault *why) {
  const bool by_regions = aggregate_by_regions(how->way);
  qtr_aggregation units = how->units;
  units.rule = s->p.in.mission.rule;
  units.by_spots = aggregate_by_spots(how->way);
  units.regions = by_regions ? &s->regions : NULL;
  int status = by_regions ? study_divide(s, how, why) : QTR_OK;
  if (status != QTR_OK) return status;
  status = qtr_environment_init(&s->aggregate, &s->p.game, &units, &s->p.field);
  if (status == QTR_OK || status == QTR_ERR_STOPPED) return status;
  return fault_set(why, "%s: %s", s->p.in.path, qtr_strerror(status));
}

int study_begin(study *s, const plan_config *config, fault *why) {
  qtr_learner_config learning = config->learner;
  learning.ground_search = !s->measuring;
  s->aggregated = config->aggregate.way != AGGREGATE_NONE;
  set_ground_rule(s);
  int status = s->aggregated ? make_aggregate(s, &config->aggregate, why) : QTR_OK;
  if (status != QTR_OK && status != QTR_ERR_STOPPED) return -1;
  /* An aggregate that was not ready in time leaves the true map. */
  s->aggregated = s->aggregated && status == QTR_OK;
  set_ground_rule(s);
  status = qtr_environment_init(&s->ground, &s->p.game, NULL, &s->p.field);
  const qtr_environment *aggregate = s->aggregated ? &s->aggregate : NULL;
  if (status == QTR_OK) status = qtr_learner_init(&s->learner, &s->ground, aggregate, &learning);
  return status == QTR_OK ? 0 : fault_set(why, "%s: %s", s->p.in.path, qtr_strerror(status));
}
