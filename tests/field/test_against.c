/* What is told of a certificate that claims too much; the optimum is 50, the gap asked for 0.001. */
#include "field/against.h"
#include "unity.h"

void setUp(void) {
}
void tearDown(void) {
}

static const char *judge(int objective, double plan, double bound, bool certified) {
  const qtr_certificate certificate = {.objective = plan, .bound = bound, .certified = certified};
  return against_optimum(&certificate, objective, 1e-3, 50.0);
}

static void test_what_holds_is_no_violation(void) {
  TEST_ASSERT_NULL(judge(QTR_DISCOUNTED, 50.0, 50.0, true));
  TEST_ASSERT_NULL(judge(QTR_DISCOUNTED, 49.96, 50.0, true));
  TEST_ASSERT_NULL(judge(QTR_DISCOUNTED, 40.0, 60.0, false));
  TEST_ASSERT_NULL(judge(QTR_TIME, 50.05, 50.0, true));
  TEST_ASSERT_NULL(judge(QTR_TIME, 60.0, 40.0, false));
}

static void test_a_bound_past_the_optimum_is_told(void) {
  TEST_ASSERT_EQUAL_STRING("the bound is past the optimum", judge(QTR_DISCOUNTED, 40.0, 49.999999, false));
  TEST_ASSERT_EQUAL_STRING("the bound is past the optimum", judge(QTR_TIME, 60.0, 50.000001, false));
}

static void test_a_plan_better_than_the_optimum_is_told(void) {
  TEST_ASSERT_EQUAL_STRING("the plan is better than the optimum", judge(QTR_DISCOUNTED, 50.000001, 60.0, false));
  TEST_ASSERT_EQUAL_STRING("the plan is better than the optimum", judge(QTR_TIME, 49.999999, 40.0, false));
}

static void test_a_certified_plan_worse_than_its_gap_is_told(void) {
  TEST_ASSERT_EQUAL_STRING("the certified plan is not within its gap", judge(QTR_DISCOUNTED, 49.9, 50.0, true));
  TEST_ASSERT_EQUAL_STRING("the certified plan is not within its gap", judge(QTR_TIME, 50.1, 50.0, true));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_holds_is_no_violation);
  RUN_TEST(test_a_bound_past_the_optimum_is_told);
  RUN_TEST(test_a_plan_better_than_the_optimum_is_told);
  RUN_TEST(test_a_certified_plan_worse_than_its_gap_is_told);
  return UNITY_END();
}
