/* Visits after a mission's deadline count for nothing: whoever lists them says so, and nobody takes their places for
 * searched. */
#include "support/tool_run.h"

static tool_result r, solved;

/* By hand, at a step a second: place 0 after 2 s, place 1 after 6 s, place 2 after 11 s; the deadline is 8 s. */
static void write_mission(const char *more) {
  char text[600];
  write_file("ground.txt", "............\n");
  snprintf(text, sizeof text,
           "map: ground.txt\ncell_size: 1\nspeed: 1\nobjective: deadline\ndeadline_seconds: 8\n"
           "robots: [{column: 0, row: 0, name: Eve}]\n%s"
           "places: [{column: 2, row: 0, weight: 2}, {column: 6, row: 0, name: Door}, {column: 11, row: 0}]\n",
           more);
  write_file("m.yaml", text);
}

void setUp(void) {
  write_mission("");
  run_tool(&r, "learn m.yaml -q -o m.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
}

void tearDown(void) {
}

static void expect(const char *words, const char *text) {
  run_tool(&r, "%s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, text), r.out);
}

static void test_learn_and_exact_say_the_same(void) {
  static const char *const keys[] = {"found_probability", "objective_value", "deadline_seconds",
                                     "expected_time_by_deadline", "expected_time_by_deadline_seconds"};
  const double values[] = {0.75, 0.75, 8, (2 * 2 + 6) / 3.0, (2 * 2 + 6) / 3.0};
  run_tool(&r, "learn m.yaml --json");
  run_tool(&solved, "exact m.yaml --json");
  for (int i = 0; i < 5; i++) {
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, values[i], json_value(r.out, keys[i]));
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, values[i], json_value(solved.out, keys[i]));
  }
  TEST_ASSERT_TRUE(json_is(r.out, "left_out", "[2]") && json_is(solved.out, "left_out", "[2]"));
  TEST_ASSERT_TRUE(json_is(r.out, "by_deadline", "2") && json_is(solved.out, "by_deadline", "2"));
  expect("learn m.yaml", "(by then found after 3.33333 s)");
  expect("exact m.yaml", "(by then found after 3.33333 s)");
  expect("learn m.yaml", "nobody searches by the deadline: 2\n");
  expect("exact m.yaml", "nobody searches by the deadline: 2\n");
}

static void test_replans_are_held_to_the_deadline(void) {
  expect("learn m.yaml --clear Door --against m.qtr",
         "against m.qtr: probability of a find by the deadline 0.666667, was 0.75\n");
}

static void test_later_visits_are_marked(void) {
  const char *route = "0 (step 2, 2 s) -> Door (step 6, 6 s) -> 2 (step 11, 11 s, after the deadline); 11 m\n";
  expect("learn m.yaml", route);
  expect("inspect m.qtr", route);
  expect("inspect m.qtr --json", "\"by_deadline\": 2");
  expect("simulate m.qtr", "seeker Eve  place 2, after the deadline\n");
  expect("simulate m.qtr", "probability of a find by the deadline 0.75\n");
  expect("simulate m.qtr --json", "\"found_by_deadline\": 0.75");
  expect("compare m.qtr m.qtr", "Eve, step 11, 11 s, after the deadline");
}

static void test_pictures_and_exports_mark_them_too(void) {
  expect("draw m.qtr -o m.svg", "");
  read_text("m.svg", r.out, sizeof r.out);
  TEST_ASSERT_NOT_NULL(strstr(r.out, "searched after the deadline"));
  TEST_ASSERT_NOT_NULL(strstr(r.out, "visit 3, step 11, 11 s, after the deadline"));
  expect("export m.qtr -o m.csv", "1 place after the deadline\n");
  read_text("m.csv", r.out, sizeof r.out);
  TEST_ASSERT_NOT_NULL(strstr(r.out, ",step,seconds,after_deadline,hold_seconds\n"));
  TEST_ASSERT_NOT_NULL(strstr(r.out, ",Door,6,0,6.500000,0.500000,6,6.000000,0,0.000000\n"));
  TEST_ASSERT_NOT_NULL(strstr(r.out, ",2,place 2,11,0,11.500000,0.500000,11,11.000000,1,0.000000\n"));
  expect("export m.qtr --format nav2 -o m-%.yaml", "after the deadline");
  read_text("m-Eve.yaml", r.out, sizeof r.out);
  if (r.out[0] == '\0') read_text("m-0.yaml", r.out, sizeof r.out);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "# step 11, after the deadline, place 2"), r.out);
}

static void test_plans_for_two_deadlines_are_not_compared(void) {
  run_tool(&r, "learn m.yaml --deadline 12 -q -o later.qtr");
  run_tool(&r, "compare m.qtr later.qtr");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "m.qtr finds by 8 s and later.qtr by 12"), r.err);
}

static void test_without_a_deadline_nothing_is_late(void) {
  run_tool(&r, "learn m.yaml --objective time -q -o t.qtr");
  static const char *const commands[] = {"inspect t.qtr --json", "simulate t.qtr", "compare t.qtr t.qtr",
                                         "export t.qtr -o t.csv"};
  for (int i = 0; i < 4; i++) {
    run_tool(&r, "%s", commands[i]);
    TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "deadline"), r.out);
  }
  read_text("t.csv", r.out, sizeof r.out);
  TEST_ASSERT_NULL(strstr(r.out, "deadline"));
}

/* Looks that miss: of P q (1-q)^(m-1) only those that are made in time. */
static void test_looks_after_the_deadline_count_for_nothing(void) {
  write_mission("detection: 0.5\nlooks: 2\nscan_seconds: 1\n");
  run_tool(&r, "learn m.yaml --json");
  run_tool(&solved, "exact m.yaml --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, json_value(solved.out, "found_probability"), json_value(r.out, "found_probability"));
  /* Both looks at place 0, after 3 s and 4 s; or one there and one at the door, after 8 s. */
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.375, json_value(r.out, "found_probability"));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learn_and_exact_say_the_same);
  RUN_TEST(test_replans_are_held_to_the_deadline);
  RUN_TEST(test_later_visits_are_marked);
  RUN_TEST(test_pictures_and_exports_mark_them_too);
  RUN_TEST(test_plans_for_two_deadlines_are_not_compared);
  RUN_TEST(test_without_a_deadline_nothing_is_late);
  RUN_TEST(test_looks_after_the_deadline_count_for_nothing);
  return UNITY_END();
}
