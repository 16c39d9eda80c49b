#include "host/plan/study.h"

#include "host/base/stop.h"
#include "quarter/status.h"

int study_divide(study *s, const plan_aggregation *how, fault *why) {
  const qtr_mission *mission = &s->p.in.mission;
  const qtr_regions_config config = {.max_size = (uint32_t)how->region_size,
                                     .diameter = (uint32_t)how->region_diameter,
                                     .likelihood = how->region_likelihood,
                                     .places = mission->places,
                                     .place = mission->place,
                                     .weight = mission->weight,
                                     .watch = mission->watch};
  const qtr_grid grid = qtr_mission_grid(mission);
  const int status = qtr_regions_build(&s->regions, &grid, &config, &s->regions_scratch);
  if (status == QTR_OK || status == QTR_ERR_STOPPED) return status;
  return fault_set(why, "%s: its regions: %s", s->p.in.path, qtr_strerror(status));
}

/* The ground has the mission's own rule, but under an aggregate: its policy is played on the ground by the free one, whatever
 * the rule that it was learnt by. */
static void set_ground_rule(study *s) {
  s->p.game.board.rule = s->aggregated ? QTR_RULE_FREE : s->p.in.mission.rule;
}

/* 0, -1 with *why set, or QTR_ERR_STOPPED. */
static int make_aggregate(study *s, const plan_aggregation *how, fault *why) {
  const qtr_aggregation units = {
      .rule = s->p.in.mission.rule,
      .by_spots = how->by_spots,
      .spots = {(uint8_t)how->spot_size, (qtr_steps)how->spot_diameter, how->spot_likelihood},
      .spot_order = (uint8_t)how->spot_order,
      .regions = how->by_regions ? &s->regions : NULL,
      .region_times = (uint8_t)how->region_times};
  int status = how->by_regions ? study_divide(s, how, why) : QTR_OK;
  if (status != QTR_OK) return status;
  status = qtr_environment_init(&s->aggregate, &s->p.game, &units, &s->p.field);
  if (status == QTR_OK || status == QTR_ERR_STOPPED) return status;
  return fault_set(why, "%s: %s", s->p.in.path, qtr_strerror(status));
}

int study_begin(study *s, const plan_config *config, fault *why) {
  qtr_learner_config learning = config->learner;
  learning.ground_search = !s->measuring;
  s->aggregated = config->aggregation.by_regions || config->aggregation.by_spots;
  set_ground_rule(s);
  int status = s->aggregated ? make_aggregate(s, &config->aggregation, why) : QTR_OK;
  if (status != QTR_OK && status != QTR_ERR_STOPPED) return -1;
  /* An aggregate that was not ready in time leaves the true map. */
  s->aggregated = s->aggregated && status == QTR_OK;
  set_ground_rule(s);
  status = qtr_environment_init(&s->ground, &s->p.game, NULL, &s->p.field);
  const qtr_environment *aggregate = s->aggregated ? &s->aggregate : NULL;
  if (status == QTR_OK) status = qtr_learner_init(&s->learner, &s->ground, aggregate, &learning);
  return status == QTR_OK ? 0 : fault_set(why, "%s: %s", s->p.in.path, qtr_strerror(status));
}
