/* The blocks of a learner for the tests, in static storage as firmware has them: one ground, one aggregate, one
 * learner. */
#ifndef QUARTER_TESTS_LEARNING_H
#define QUARTER_TESTS_LEARNING_H

#include "quarter/learner.h"

static qtr_learner_memory learning_memory;

/* Learners list no routes, so that what prices leave open is left to episodes. */
static bool learning_by_episodes;

static inline int ground_init(qtr_environment **ground, const qtr_game *game, qtr_travel *travel) {
  return qtr_environment_init(ground, learning_memory.ground, sizeof learning_memory.ground, game, NULL, travel);
}

static inline int aggregate_init(qtr_environment **aggregate, const qtr_game *game, const qtr_aggregation *how,
                                 qtr_travel *travel) {
  return qtr_environment_init(aggregate, learning_memory.aggregate, sizeof learning_memory.aggregate, game, how,
                              travel);
}

static inline int learner_init(qtr_learner **learner, const qtr_environment *ground, const qtr_environment *aggregate,
                               const qtr_learner_config *config) {
  qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(learning_memory);
  if (learning_by_episodes) blocks.routes = NULL;
  return qtr_learner_init(learner, &blocks, ground, aggregate, config);
}

#endif
