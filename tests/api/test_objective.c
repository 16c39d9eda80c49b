/* What people are told of an objective, and what a mission may be played for, by hand. */
#include <math.h>
#include <string.h>

#include "quarter/claim.h"
#include "quarter/objective.h"
#include "quarter/status.h"
#include "unity.h"

void setUp(void) {
}

void tearDown(void) {
}

static void test_default_aim_is_the_papers(void) {
  qtr_aim aim;
  qtr_aim_default(&aim);
  TEST_ASSERT_EQUAL_UINT8(QTR_DISCOUNTED, aim.kind);
  TEST_ASSERT_EQUAL_DOUBLE(0.99, aim.gamma);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_aim_check(&aim));
}

static void test_aims_out_of_range_are_refused(void) {
  const qtr_aim wrong[] = {
      {QTR_OBJECTIVES, 0.9, 0, 0.0}, {UINT8_MAX, 0.9, 0, 0.0},           {QTR_TIME, 0.0, 0, 0.0},
      {QTR_TIME, 1.0, 0, 0.0},       {QTR_DISCOUNTED, -0.5, 0, 0.0},     {QTR_DISCOUNTED, (double)NAN, 0, 0.0},
      {QTR_DISCOUNTED, 1.5, 0, 0.0}, {QTR_DISCOUNTED, HUGE_VAL, 0, 0.0}, {QTR_DEADLINE, 0.9, QTR_NEVER, 0.0},
      {QTR_TIME, 0.9, 0, -1.0},      {QTR_TIME, 0.9, 0, (double)NAN},    {QTR_TIME, 0.9, 0, HUGE_VAL},
      {QTR_DISCOUNTED, 0.9, 0, 1.0}, {QTR_DEADLINE, 0.9, 5, 1.0}};
  for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
    TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_aim_check(&wrong[i]));
}

static void test_every_objective_has_its_words(void) {
  TEST_ASSERT_NULL(qtr_objective_names[QTR_OBJECTIVES]);
  for (uint8_t kind = 0; kind < QTR_OBJECTIVES; kind++) {
    const qtr_objective_words *words = qtr_objective_in_words(kind);
    TEST_ASSERT_NOT_NULL(qtr_objective_names[kind]);
    TEST_ASSERT_TRUE(strlen(words->figure) > 0 && strlen(words->goal) > 0 && strlen(words->limit) > 0);
    TEST_ASSERT_TRUE(words->beside < QTR_OBJECTIVES && words->beside != kind);
  }
}

/* Two rooms know how many objectives there are, for a robot has no floating point. */
static void test_tables_know_the_objectives_that_there_are(void) {
  for (unsigned kind = 0; kind <= UINT8_MAX; kind++)
    TEST_ASSERT_EQUAL(kind < QTR_OBJECTIVES, qtr_claim_knows((uint8_t)kind));
}

static void test_less_time_is_better_and_more_value(void) {
  TEST_ASSERT_TRUE(qtr_objective_is_better(QTR_TIME, 3.0, 4.0));
  TEST_ASSERT_FALSE(qtr_objective_is_better(QTR_TIME, 4.0, 4.0));
  TEST_ASSERT_TRUE(qtr_objective_is_better(QTR_DISCOUNTED, 4.0, 3.0));
  TEST_ASSERT_FALSE(qtr_objective_is_better(QTR_DISCOUNTED, 4.0, 4.0));
}

static void test_figures_are_those_of_the_score(void) {
  const qtr_score score = {.value = 7.5, .expected_time = 12.0};
  TEST_ASSERT_EQUAL_DOUBLE(7.5, qtr_objective_figure(QTR_DISCOUNTED, qtr_objective_of_score(QTR_DISCOUNTED, &score)));
  TEST_ASSERT_EQUAL_DOUBLE(-12.0, qtr_objective_of_score(QTR_TIME, &score));
  TEST_ASSERT_EQUAL_DOUBLE(12.0, qtr_objective_figure(QTR_TIME, qtr_objective_of_score(QTR_TIME, &score)));
}

static void test_gap_is_relative_to_the_figure(void) {
  TEST_ASSERT_EQUAL_DOUBLE(0.25, qtr_objective_gap(QTR_DISCOUNTED, 4.0, 5.0));
  TEST_ASSERT_EQUAL_DOUBLE(0.25, qtr_objective_gap(QTR_TIME, 4.0, 3.0));
  TEST_ASSERT_EQUAL_DOUBLE(0.0, qtr_objective_gap(QTR_DISCOUNTED, 5.0, 4.0));
  TEST_ASSERT_EQUAL_DOUBLE(0.0, qtr_objective_gap(QTR_TIME, 3.0, 4.0));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_default_aim_is_the_papers);
  RUN_TEST(test_aims_out_of_range_are_refused);
  RUN_TEST(test_every_objective_has_its_words);
  RUN_TEST(test_tables_know_the_objectives_that_there_are);
  RUN_TEST(test_less_time_is_better_and_more_value);
  RUN_TEST(test_figures_are_those_of_the_score);
  RUN_TEST(test_gap_is_relative_to_the_figure);
  return UNITY_END();
}
