/* A mission planned anew once some of it is done: what is learnt is the rest, and what changes is said. */
#include "support/tool_run.h"

void setUp(void) {
  write_file("replan.txt", "S...\n....\n");
  write_file("replan.yaml", "map: replan.txt\n"
                            "robots: [{column: 0, row: 0, name: Alpha}, {column: 0, row: 1}]\n"
                            "places: [{column: 3, row: 0, name: Far, weight: 3}, {column: 3, row: 1}, "
                            "{column: 1, row: 1, name: Near}]\n");
  write_file("rest.yaml", "map: replan.txt\n"
                          "robots: [{column: 0, row: 0, name: Alpha}, {column: 0, row: 1}]\n"
                          "places: [{column: 3, row: 0, name: Far, weight: 3}, {column: 3, row: 1}]\n");
  remove("plan.qtr");
}

void tearDown(void) {
}

static tool_result r, other;

static void run_well(const char *words) {
  run_tool(&r, "%s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
}

static void expect_out(const char *text) {
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, text), r.out);
}

static void test_the_rest_is_worth_what_a_mission_of_the_rest_alone_is(void) {
  run_tool(&other, "exact rest.yaml --json");
  run_well("learn replan.yaml --clear Near --json");
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, json_value(other.out, "expected_time"), json_value(r.out, "expected_time"));
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, json_value(other.out, "value"), json_value(r.out, "value"));
  expect_out("\"cleared\": [2]");
  expect_out("\"place_numbers\": [0, 1]");
}

static void test_what_changes_is_told_when_a_plan_is_replaced(void) {
  run_well("learn replan.yaml -o plan.qtr");
  TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "against"), r.out);
  run_well("learn replan.yaml -o plan.qtr");
  TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "against"), r.out);
  run_well("learn replan.yaml --clear Near --without robot:1 --add 1.5,1.5,2,Dock -o plan.qtr");
  expect_out("against plan.qtr: expected time 2.5 steps, was 2.6\n  gone: Near\n  new: Dock\n  another robot: 1 (1 -> "
             "Alpha)\n");
  run_well("inspect plan.qtr");
  expect_out("seeker Alpha: Dock (step 1) -> Far (step 3) -> 1 (step 4)");
}

/* A table that is damaged, or of a version of its own, is replaced like any file. */
static void test_a_plan_that_cannot_be_read_is_replaced_without_a_word(void) {
  write_file("plan.qtr", "QTRPdamaged");
  run_well("learn replan.yaml -o plan.qtr");
  TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "against"), r.out);
  run_well("inspect plan.qtr -q");
}

/* A table for the whole mission has no answers for the rest of it, and says so. */
static void test_a_game_off_the_table_says_so_and_what_helps(void) {
  run_well("learn replan.yaml -q -o plan.qtr");
  run_well("simulate plan.qtr --clear Near");
  expect_out("off the table");
  expect_out("quarter learn MISSION --clear 'Near'\n");
  run_well("learn replan.yaml -q --cleared any -o plan.qtr");
  run_well("simulate plan.qtr --clear Near");
  TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "quarter learn"), r.out);
}

/* What learning anew would bring is what it brings. */
static void test_a_game_off_the_table_tells_what_the_rest_learnt_anew_is_worth(void) {
  static const char *const objectives[] = {"time", "discounted"};
  for (int i = 0; i < 2; i++) {
    char words[100];
    snprintf(words, sizeof words, "learn replan.yaml --objective %s -q -o plan.qtr", objectives[i]);
    run_well(words);
    snprintf(words, sizeof words, "learn replan.yaml --objective %s --clear Near --json", objectives[i]);
    run_well(words);
    const double worth = json_value(r.out, "objective_value"), time = json_value(r.out, "expected_time");
    run_well("simulate plan.qtr --clear Near --json");
    const char *rule = json_text(r.out, "by_rule"), *anew = json_text(r.out, "learnt_anew");
    TEST_ASSERT_DOUBLE_WITHIN(1e-5 * worth, worth, json_value(anew, "objective_value"));
    TEST_ASSERT_DOUBLE_WITHIN(1e-5 * time, time, json_value(anew, "expected_time"));
    TEST_ASSERT_DOUBLE_WITHIN(1e-5 * time, json_value(r.out, "expected_time"), json_value(rule, "expected_time"));
    TEST_ASSERT_TRUE(json_is(anew, "certified", "true"));
    if (i == 1) /* of the rest, as the rest learnt anew is */
      TEST_ASSERT_DOUBLE_WITHIN(1e-6, json_value(r.out, "value"), json_value(rule, "objective_value"));
    run_well("simulate plan.qtr --clear Near");
    expect_out(" by their rule, ");
    expect_out(" learnt anew");
  }
}

static void test_a_plan_is_compared_with_any_other(void) {
  run_well("learn replan.yaml -q -o plan.qtr");
  run_well("learn rest.yaml --against plan.qtr --json");
  expect_out("\"file\": \"plan.qtr\"");
  expect_out("{\"place\": 2, \"name\": \"Near\"}");
  run_well("learn replan.yaml --against plan.qtr -o plan.qtr");
  run_tool(&r, "learn replan.yaml --against replan.txt");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "not a Quarter policy table"), r.err);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_rest_is_worth_what_a_mission_of_the_rest_alone_is);
  RUN_TEST(test_what_changes_is_told_when_a_plan_is_replaced);
  RUN_TEST(test_a_plan_that_cannot_be_read_is_replaced_without_a_word);
  RUN_TEST(test_a_game_off_the_table_says_so_and_what_helps);
  RUN_TEST(test_a_game_off_the_table_tells_what_the_rest_learnt_anew_is_worth);
  RUN_TEST(test_a_plan_is_compared_with_any_other);
  return UNITY_END();
}
