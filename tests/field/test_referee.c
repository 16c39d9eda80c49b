/* The referee: sums worked out by hand, and plans that are none. */
#include <math.h>
#include <string.h>

#include "field/referee.h"
#include "unity.h"

/* Looks 0, 1, 2 at places 0, 1, 2 of weights 1, 2 and 1; look 3 is the second one at place 1. Node 4 is the start.
 * Robot 0 is of class 0, robot 1 of class 1, which takes twice as long. */
enum { LOOKS = 4, NODES = 5, CLASSES = 2 };
static unsigned place_of[LOOKS] = {0, 1, 2, 1};
static double weight[3] = {1.0, 2.0, 1.0};
static double detection[3] = {1.0, 0.5, 1.0};
static unsigned class_of[2] = {0, 1}, start_of[2] = {0, 0};
static uint32_t steps[CLASSES][NODES][LOOKS], home[2][LOOKS] = {{5, 6, 7, 6}, {10, 12, 14, 12}};
static plain_problem plain;
static verdict v;

void setUp(void) {
  static const uint32_t base[NODES][LOOKS] = {{0, 2, 3, 2}, {2, 0, 4, 1}, {3, 4, 0, 4}, {2, 1, 4, 0}, {5, 6, 7, 6}};
  for (unsigned c = 0; c < CLASSES; c++)
    for (unsigned node = 0; node < NODES; node++)
      for (unsigned look = 0; look < LOOKS; look++) steps[c][node][look] = base[node][look] * (c + 1);
  plain = (plain_problem){.looks = LOOKS,
                          .starts = 1,
                          .robots = 2,
                          .classes = CLASSES,
                          .place_of = place_of,
                          .weight = weight,
                          .detection = detection,
                          .places = 3,
                          .class_of = class_of,
                          .start_of = start_of,
                          .steps = &steps[0][0][0],
                          .by_time = true,
                          .gamma = 0.9};
}

void tearDown(void) {
}

static void judge(unsigned first, unsigned second, unsigned *look) {
  unsigned length[2] = {first, second};
  const plan_routes routes = {length, look};
  referee_judge(&v, &plain, &routes);
}

/* Robot 0: place 0 at 5, place 1 at 7 and once more at 8; robot 1: place 2 at 14. Of all that can be found, which is
 * 1 + 2 (1/2 + 1/4) + 1 = 3.5, the shares are 1, 1, 0.5 and 1: (5 + 7 + 4 + 14) / 3.5. */
static void test_expected_time_and_value_are_sums_over_the_looks(void) {
  judge(3, 1, (unsigned[]){0, 1, 3, 2});
  TEST_ASSERT_TRUE_MESSAGE(v.legal, v.fault);
  TEST_ASSERT_TRUE(v.complete);
  TEST_ASSERT_EQUAL_UINT64(5 + 7 + 8 + 14, v.arrivals);
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, 30.0 / 3.5, v.expected_time);
  const double value = 10.0 * (pow(0.9, 4) + pow(0.9, 6) + 0.5 * pow(0.9, 7) + pow(0.9, 13)) / 4.0;
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, value, v.value);
}

/* Look 3 is made at 6 and look 1 at 7: the earlier one counts as the first. */
static void test_looks_count_in_the_order_in_which_they_are_made(void) {
  judge(4, 0, (unsigned[]){3, 1, 0, 2});
  TEST_ASSERT_TRUE_MESSAGE(v.legal, v.fault);
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, (6.0 + 0.5 * 7.0 + 9.0 + 12.0) / 3.5, v.expected_time);
}

/* A visit at step 0 is worth as much as at step 1. */
static void test_nothing_is_gained_by_standing_on_a_place(void) {
  steps[0][4][0] = 0;
  judge(1, 0, (unsigned[]){0});
  TEST_ASSERT_FALSE(v.complete);
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, 10.0 / 4.0, v.value);
}

/* From place 2 robot 1 is home at 14 + 14; robot 0, from place 1, at 8 + 6. */
static void test_way_home_counts_by_its_weight(void) {
  plain.home = &home[0][0];
  plain.home_weight = 2.0;
  judge(3, 1, (unsigned[]){0, 1, 3, 2});
  TEST_ASSERT_EQUAL_UINT64(5 + 7 + 8 + 14 + 28 + 14, v.arrivals);
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, (30.0 + 2.0 * (28 + 14)) / 3.5, v.expected_time);
  judge(4, 0, (unsigned[]){0, 1, 3, 2}); /* who never leaves is at home */
  TEST_ASSERT_EQUAL_UINT64(5 + 7 + 8 + 12 + 12 + 7, v.arrivals);
}

static void expect_refusal(unsigned first, unsigned second, unsigned *look, const char *fault) {
  judge(first, second, look);
  TEST_ASSERT_FALSE(v.legal);
  TEST_ASSERT_EQUAL_STRING(fault, v.fault);
}

static void test_what_is_no_plan_is_refused(void) {
  expect_refusal(2, 2, (unsigned[]){0, 1, 2, 0}, "robot 1 makes a look once more, number 0");
  expect_refusal(1, 0, (unsigned[]){4}, "robot 0 makes a look that there is not, 4");
  steps[1][4][2] = PROBLEM_NO_WAY;
  expect_refusal(3, 1, (unsigned[]){0, 1, 3, 2}, "robot 1 has no way to look 2");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_expected_time_and_value_are_sums_over_the_looks);
  RUN_TEST(test_looks_count_in_the_order_in_which_they_are_made);
  RUN_TEST(test_nothing_is_gained_by_standing_on_a_place);
  RUN_TEST(test_way_home_counts_by_its_weight);
  RUN_TEST(test_what_is_no_plan_is_refused);
  return UNITY_END();
}
