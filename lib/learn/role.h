/* Which of the learner's parts a learner plays: what the settings and aggregates differ in, asked in one place. */
#ifndef QUARTER_LEARN_ROLE_H
#define QUARTER_LEARN_ROLE_H

#include "learn/learner.h"

static inline bool learner_is_paper(const qtr_learner *learner) {
  return learner->config.setting == QTR_SETTING_PAPER;
}

static inline bool learner_is_aggregate(const qtr_learner *learner) {
  return learner->environment != learner->ground;
}

/* Whether the result is to be what the setting learns, and nothing found beside it. */
static inline bool learner_learns_alone(const qtr_learner *learner) {
  return learner_is_paper(learner) || (learner_is_aggregate(learner) && !learner->config.ground_search);
}

static inline bool learner_may_go_on(const qtr_learner *learner) {
  return qtr_watch_go_on(&learner->game->mission->watch);
}

#endif
