#include "host/plan/plan_config.h"

#include <string.h>

#define MADE 0x504C414Eu

void plan_config_default(plan_config *config) {
  memset(config, 0, sizeof *config);
  config->made = MADE;
  config->aim.kind = PLAN_AS_STATED;
  config->rule = PLAN_AS_STATED;
  qtr_learner_config_default(&config->learner);
  aggregate_default(&config->aggregate);
  config->table_limit = 4.0;
}

int plan_config_check(const plan_config *config, fault *why) {
  if (config->made != MADE) return fault_set(why, "the plan's settings did not come from plan_config_default()");
  if (config->deadline_seconds > 0.0 && config->aim.kind != PLAN_AS_STATED && config->aim.kind != QTR_DEADLINE)
    return fault_set(why, "--deadline is the deadline objective's, and --objective asks for another; leave one out");
  /* Times between regions are no bounds. */
  if (!aggregate_by_regions(config->aggregate.way) || config->learner.setting == QTR_SETTING_PAPER) return 0;
  return fault_set(why,
                   "--aggregate: regions go with --learner paper alone, for times between regions are no bounds; the "
                   "certified setting takes spots");
}
