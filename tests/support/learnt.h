/* The optimum as episodes have it, which share nothing with lists of routes but the bound's prices. */
#ifndef QUARTER_TESTS_LEARNT_H
#define QUARTER_TESTS_LEARNT_H

#include "support/learning.h"
#include "support/random.h"
#include "unity.h"

static inline double learnt_optimum(const qtr_environment *ground) {
  qtr_learner_config config;
  qtr_learner *learner;
  qtr_certificate certificate;
  learning_by_episodes = true;
  qtr_learner_config_default(&config);
  config.gap = 1e-10;
  TEST_ASSERT_EQUAL_INT(QTR_OK, learner_init(&learner, ground, NULL, &config));
  while (qtr_learner_step(learner) == QTR_LEARNING) {}
  qtr_learner_certificate(learner, &certificate);
  TEST_ASSERT_TRUE_MESSAGE(certificate.certified, case_note);
  return qtr_learner_best(learner)->score.worth;
}

#endif
