#include "host/plan/study.h"

#include "host/base/stop.h"
#include "quarter/status.h"

int study_divide(study *s, const options *o, fault *why) {
  const qtr_mission *mission = &s->p.in.mission;
  const qtr_regions_config config = {.max_size = (uint32_t)o->region_size,
                                     .diameter = (uint32_t)o->region_diameter,
                                     .likelihood = o->region_likelihood,
                                     .places = mission->places,
                                     .place = mission->place,
                                     .weight = mission->weight,
                                     .watch = mission->watch};
  const qtr_grid grid = qtr_mission_grid(mission);
  const int status = qtr_regions_build(&s->regions, &grid, &config, &s->regions_scratch);
  if (status == QTR_OK || status == QTR_ERR_STOPPED) return status;
  return fault_set(why, "%s: its regions: %s", o->input, qtr_strerror(status));
}

/* Times between regions are no bounds. */
static int check_setting(const options *o, fault *why) {
  if (!o->by_regions || o->setting == QTR_SETTING_PAPER) return 0;
  return fault_set(why,
                   "--aggregate: regions go with --learner paper alone, for times between regions are no bounds; the "
                   "certified setting takes spots");
}

/* On the ground an aggregate's policy is played by the free rule, whatever the rule that it was learnt by.
 * 0, -1 with *why set, or QTR_ERR_STOPPED. */
static int make_aggregate(study *s, const options *o, fault *why) {
  const qtr_aggregation how = {.rule = s->p.in.mission.rule,
                               .by_spots = o->by_spots,
                               .spots = {(uint8_t)o->spot_size, (qtr_steps)o->spot_diameter, o->spot_likelihood},
                               .spot_order = (uint8_t)o->spot_order,
                               .regions = o->by_regions ? &s->regions : NULL,
                               .region_times = (uint8_t)o->region_times};
  s->p.game.board.rule = QTR_RULE_FREE;
  int status = o->by_regions ? study_divide(s, o, why) : QTR_OK;
  if (status != QTR_OK) return status;
  status = qtr_environment_init(&s->aggregate, &s->p.game, &how, &s->p.field);
  if (status == QTR_OK || status == QTR_ERR_STOPPED) return status;
  return fault_set(why, "%s: %s", o->input, qtr_strerror(status));
}

int study_read(study *s, const options *o, fault *why) {
  return check_setting(o, why) != 0 ? -1 : problem_read(&s->p, o, why);
}

int study_begin(study *s, const options *o, fault *why) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  config.gap = o->gap;
  config.ground_search = !s->measuring;
  config.seed = o->seed;
  config.setting = (uint8_t)o->setting;
  config.exploration = o->exploration;
  config.alpha = o->alpha;
  s->aggregated = o->by_regions || o->by_spots;
  int status = s->aggregated ? make_aggregate(s, o, why) : QTR_OK;
  if (status != QTR_OK && status != QTR_ERR_STOPPED) return -1;
  s->aggregated = s->aggregated && status == QTR_OK;
  /* An aggregate that was not ready in time leaves the true map, and there the mission's own rule. */
  if (!s->aggregated) s->p.game.board.rule = s->p.in.mission.rule;
  status = qtr_environment_init(&s->ground, &s->p.game, NULL, &s->p.field);
  const qtr_environment *aggregate = s->aggregated ? &s->aggregate : NULL;
  if (status == QTR_OK) status = qtr_learner_init(&s->learner, &s->ground, aggregate, &config);
  return status == QTR_OK ? 0 : fault_set(why, "%s: %s", o->input, qtr_strerror(status));
}
