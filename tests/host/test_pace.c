/* Seconds made steps, and discounts to powers. */
#include "host/plan/pace.h"

#include <math.h>

#include "host/plan/power.h"
#include "support/random.h"
#include "unity.h"

static pace p;
static uint32_t steps[8];

void setUp(void) {
  p = (pace){.stated = true};
}

void tearDown(void) {
}

static void choose(unsigned classes, const double *seconds, double step_seconds) {
  pace_choose(&p, steps, seconds, classes, step_seconds);
}

static void test_one_speed_is_a_step_a_cell(void) {
  choose(2, (double[]){0.1 / 0.3, 0.1 / 0.3}, 0.0);
  TEST_ASSERT_EQUAL_DOUBLE(0.1 / 0.3, p.seconds_per_step);
  TEST_ASSERT_EQUAL_UINT32(1, steps[0]);
  TEST_ASSERT_EQUAL_UINT32(1, steps[1]);
  TEST_ASSERT_EQUAL_DOUBLE(0.0, p.rounding);
}

static void test_speeds_in_whole_ratios_are_not_rounded(void) {
  choose(3, (double[]){0.5, 2.0, 0.75}, 0.0);
  TEST_ASSERT_EQUAL_DOUBLE(0.25, p.seconds_per_step);
  TEST_ASSERT_EQUAL_UINT32(2, steps[0]);
  TEST_ASSERT_EQUAL_UINT32(8, steps[1]);
  TEST_ASSERT_EQUAL_UINT32(3, steps[2]);
  TEST_ASSERT_EQUAL_DOUBLE(0.0, p.rounding);
}

/* 1 : 3.02 is 1 : 3 within one per cent, between the two. */
static void test_what_is_nearly_whole_is_rounded_evenly(void) {
  choose(2, (double[]){1.0, 3.02}, 0.0);
  TEST_ASSERT_EQUAL_UINT32(1, steps[0]);
  TEST_ASSERT_EQUAL_UINT32(3, steps[1]);
  TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0.0033, p.rounding);
}

static void test_no_speeds_are_rounded_by_more_than_a_hundredth(void) {
  test_random random = random_case(__func__, 7);
  for (int round = 0; round < 20000; round++) {
    double seconds[8];
    const unsigned classes = 2 + random_below(&random, 7);
    for (unsigned i = 0; i < classes; i++) seconds[i] = exp(random_unit(&random) * 8.0 - 4.0);
    choose(classes, seconds, 0.0);
    TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(PACE_ROUNDING * (1.0 + 1e-9), p.rounding);
    for (unsigned i = 0; i < classes; i++)
      TEST_ASSERT_LESS_OR_EQUAL_DOUBLE(p.rounding + 1e-9, fabs(steps[i] * p.seconds_per_step / seconds[i] - 1.0));
  }
}

static void test_a_step_that_is_asked_for_is_taken(void) {
  choose(2, (double[]){1.0, 0.25}, 0.7);
  TEST_ASSERT_EQUAL_DOUBLE(0.7, p.seconds_per_step);
  TEST_ASSERT_EQUAL_UINT32(1, steps[0]);
  TEST_ASSERT_EQUAL_UINT32(1, steps[1]);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1.8, p.rounding);
}

static void test_scans_are_rounded_up_and_ends_down(void) {
  choose(1, (double[]){0.1}, 0.0);
  TEST_ASSERT_EQUAL_UINT32(3, pace_steps_up(&p, 0.3));
  TEST_ASSERT_EQUAL_UINT32(3, pace_steps_down(&p, 0.3));
  TEST_ASSERT_EQUAL_UINT32(0, pace_steps_up(&p, 0.0));
  TEST_ASSERT_EQUAL_DOUBLE(0.0, p.end_rounding);
  TEST_ASSERT_EQUAL_UINT32(13, pace_steps_up(&p, 1.25));
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.04, p.end_rounding);
  TEST_ASSERT_EQUAL_UINT32(12, pace_steps_down(&p, 1.25));
  TEST_ASSERT_EQUAL_UINT32(1, pace_steps_up(&p, 0.001));
  TEST_ASSERT_EQUAL_UINT32(PACE_STEPS_MOST, pace_steps_down(&p, 1e12));
}

static void test_powers_are_those_of_the_c_library(void) {
  test_random random = random_case(__func__, 11);
  for (int round = 0; round < 20000; round++) {
    const double base = round % 2 == 0 ? random_unit(&random) : 1.0 - random_unit(&random) / 100.0;
    const double exponent = random_unit(&random) * (round % 3 == 0 ? 1.0 : 20.0);
    const double wanted = pow(base, exponent);
    TEST_ASSERT_DOUBLE_WITHIN(1e-14 * wanted, wanted, power_of(base, exponent));
  }
}

static void test_the_first_power_is_exact(void) {
  test_random random = random_case(__func__, 13);
  for (int round = 0; round < 1000; round++) {
    const double base = random_unit(&random);
    TEST_ASSERT_EQUAL_DOUBLE(base, power_of(base, 1.0));
    TEST_ASSERT_EQUAL_DOUBLE(base * base, power_of(base, 2.0));
    TEST_ASSERT_EQUAL_DOUBLE(sqrt(base), power_of(base, 0.5));
    TEST_ASSERT_EQUAL_DOUBLE(1.0, power_of(base, 0.0));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_one_speed_is_a_step_a_cell);
  RUN_TEST(test_speeds_in_whole_ratios_are_not_rounded);
  RUN_TEST(test_what_is_nearly_whole_is_rounded_evenly);
  RUN_TEST(test_no_speeds_are_rounded_by_more_than_a_hundredth);
  RUN_TEST(test_a_step_that_is_asked_for_is_taken);
  RUN_TEST(test_scans_are_rounded_up_and_ends_down);
  RUN_TEST(test_powers_are_those_of_the_c_library);
  RUN_TEST(test_the_first_power_is_exact);
  return UNITY_END();
}
