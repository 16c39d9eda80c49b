/* What the tool calls optimal, and what it does not: where sums of doubles tell plans apart no longer, it says so. */
#include "support/tool_run.h"

enum { SPAN = 2301 };

static tool_result result;
static char corridor[SPAN + 2];

static void draw(const int *cells, int places, const char *name) {
  memset(corridor, '.', SPAN);
  corridor[0] = 'S';
  for (int place = 0; place < places; place++) corridor[cells[place]] = (char)('1' + place);
  corridor[SPAN] = '\n';
  write_file(name, corridor);
}

void setUp(void) {
  draw((int[]){1150, 1380, 1610, 1955, 2300}, 5, "far.txt");
  draw((int[]){1, 1150, 1380, 1610, 1955, 2300}, 6, "near.txt");
}

void tearDown(void) {
}

static void test_discount_that_leaves_nothing_is_refused_with_gamma_distance_and_mend(void) {
  static const char *const commands[] = {"learn", "exact"};
  for (int i = 0; i < 2; i++) {
    run_tool(&result, "%s far.txt --robots 2 --gamma 0.5", commands[i]);
    TEST_ASSERT_EQUAL_INT(2, result.status);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "gamma 0.5 "), result.err);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "place 0 (far.txt:1:1151), is 1150 steps away"), result.err);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "such as 0.992, or --objective time"), result.err);
  }
}

static void test_mends_that_the_refusal_names_work(void) {
  run_tool(&result, "learn far.txt --robots 2 --gamma 0.992");
  TEST_ASSERT_EQUAL_INT(0, result.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.out, "certified optimal"), result.out);
  run_tool(&result, "learn far.txt --robots 2 --gamma 0.5 --objective time");
  TEST_ASSERT_EQUAL_INT(0, result.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.out, "certified optimal"), result.out);
}

static void test_plan_is_not_called_optimal_whose_order_the_sum_does_not_show(void) {
  static const char *const commands[] = {"learn", "exact"};
  for (int i = 0; i < 2; i++) {
    run_tool(&result, "%s near.txt --robots 2 --gamma 0.5", commands[i]);
    TEST_ASSERT_EQUAL_INT(0, result.status);
    TEST_ASSERT_NULL_MESSAGE(strstr(result.out, "certified optimal"), result.out);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.out, "5 of 6 places"), result.out);
    run_tool(&result, "%s near.txt --robots 2 --gamma 0.5 --json", commands[i]);
    TEST_ASSERT_EQUAL_DOUBLE(5.0, json_value(result.out, "negligible_places"));
  }
}

static void test_what_is_discounted_away_is_ordered_by_expected_time(void) {
  run_tool(&result, "learn near.txt --robots 2 --objective time --json");
  const double least = json_value(result.out, "expected_time");
  run_tool(&result, "learn near.txt --robots 2 --gamma 0.5 --json");
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, least, json_value(result.out, "expected_time"));
}

static void test_where_every_place_counts_learn_and_exact_call_the_same_value_optimal(void) {
  run_tool(&result, "exact near.txt --robots 2 --gamma 0.999 --json");
  const double value = json_value(result.out, "value");
  run_tool(&result, "learn near.txt --robots 2 --gamma 0.999 --gap 0");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.out, "certified optimal"), result.out);
  run_tool(&result, "learn near.txt --robots 2 --gamma 0.999 --gap 0 --json");
  TEST_ASSERT_DOUBLE_WITHIN(1e-9 * value, value, json_value(result.out, "value"));
}

static void test_gap_of_zero_is_certified(void) {
  static const char *const gaps[] = {"0", "1e-9", "1e-7"};
  for (int number = 1; number <= 15; number++) {
    for (int i = 0; i < 3; i++) {
      run_tool(&result, "learn '%s/tests/data/reference/case%02d.txt' --gap %s --json", QUARTER_SOURCE_DIR, number,
               gaps[i]);
      TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
      TEST_ASSERT_TRUE_MESSAGE(json_is(result.out, "certified", "true"), result.out);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_discount_that_leaves_nothing_is_refused_with_gamma_distance_and_mend);
  RUN_TEST(test_mends_that_the_refusal_names_work);
  RUN_TEST(test_plan_is_not_called_optimal_whose_order_the_sum_does_not_show);
  RUN_TEST(test_what_is_discounted_away_is_ordered_by_expected_time);
  RUN_TEST(test_where_every_place_counts_learn_and_exact_call_the_same_value_optimal);
  RUN_TEST(test_gap_of_zero_is_certified);
  return UNITY_END();
}
