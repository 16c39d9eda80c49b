/* Seconds and metres beside steps, in all that the tool tells of a plan; nothing of them where no speed is stated. */
#include "support/tool_run.h"

static tool_result r, again;

#define PLACES                                                                                                         \
  "places:\n - {column: 8, row: 0, name: Bay, weight: 3, detection: 0.7, looks: 2}\n"                                  \
  " - {column: 5, row: 2, scan_seconds: 7}\n - {column: 4, row: 3}\n - {column: 8, row: 3, detection: 0.9}\n"

/* One robot or two classes, of 4 m/s and 1 m/s in cells of 2 m: a step is half a second. */
#define CLASSES                                                                                                        \
  "map: ground.txt\ncell_size: 2\nscan_seconds: 10\nclasses:\n  drone: {speed: %s, scan_seconds: 3}\n"                 \
  "  rover: {speed: 1, avoid: [Bay], rough: false}\n"                                                                  \
  "robots:\n - {column: 0, row: 0, class: drone, name: Wing}\n - {column: 0, row: 3, class: rover, "                   \
  "ready_seconds: 4}\n"

void setUp(void) {
  char text[2000];
  write_file("ground.txt", "S........\n..##..~~.\n..##..~~.\n.........\n");
  snprintf(text, sizeof text, CLASSES PLACES, "4");
  write_file("m.yaml", text);
  snprintf(text, sizeof text, CLASSES PLACES, "3.3");
  write_file("slower.yaml", text);
  write_file("plain.yaml", "map: ground.txt\nobjective: time\nplaces: [{column: 2, row: 0}, {column: 0, row: 3}]\n");
  run_tool(&r, "learn m.yaml --objective time -q -o m.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  run_tool(&r, "learn plain.yaml -q -o plain.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
}

void tearDown(void) {
}

static void expect(const char *words, const char *const *texts) {
  run_tool(&r, "%s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  for (; *texts != NULL; texts++) TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, *texts), r.out);
}

#define TEXTS(...)                                                                                                     \
  (const char *const[]) {                                                                                              \
    __VA_ARGS__, NULL                                                                                                  \
  }

static void test_inspect_tells_what_learn_told(void) {
  expect("inspect m.qtr",
         TEXTS("expected time 13.5968 s; bound 13.5968, gap 0%", "\na step is 0.5 s\n",
               "finds the target with probability 0.938333",
               "seeker Wing: Bay (step 14, 7 s) -> Bay (look 2) (step 20, 10 s) -> 3 (step 29, 14.5 s) -> 2 (step 39, "
               "19.5 s); 30 m\n"));
  expect("inspect m.qtr --json",
         TEXTS("\"steps\": [14, 20, 29, 39], \"seconds\": [7, 10, 14.5, 19.5], \"metres\": [16, 16, 22, 30], "
               "\"looks\": [1, 2, 1, 1]",
               "{\"number\": 0, \"name\": \"Bay\", \"look\": 2, \"column\": 8"));
  run_tool(&again, "learn m.yaml --objective time --json");
  static const char *const keys[] = {"expected_time",   "expected_time_seconds", "objective_value",
                                     "objective_bound", "seconds_per_step",      "found_probability"};
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, json_value(again.out, keys[i]), json_value(r.out, keys[i]));
}

static void test_simulate_tells_seconds_beside_steps(void) {
  expect("simulate m.qtr", TEXTS("made by step 46, 23 s,", "\n  step   14         7 s  seeker Wing  place Bay\n",
                                 "expected time 13.5968 s\n"));
  expect("simulate m.qtr --target 3", TEXTS("target found at place 3, step 29, 14.5 s\n"));
  expect("simulate m.qtr --target 3 --json",
         TEXTS("\"found_seconds\": 14.5,", "\"end_seconds\": 14.5,", "\"step\": 14, \"seconds\": 7}",
               "{\"place\": 0, \"name\": \"Bay\", \"look\": 2, "));
}

/* Steps of the two are of other lengths: what is later is so in seconds. */
static void test_compare_counts_in_seconds(void) {
  run_tool(&r, "learn slower.yaml --objective time -q -o slower.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  expect("compare m.qtr slower.qtr", TEXTS("  Bay (look 2)       Wing, step 20, 10 s ", "m.qtr is better by 6.2",
                                           "0 by another robot, 0 sooner, 5 later"));
  run_tool(&r, "compare m.qtr slower.qtr --json");
  TEST_ASSERT_DOUBLE_WITHIN(1e-4, 13.5968, json_value(r.out, "objective_value"));
  TEST_ASSERT_DOUBLE_WITHIN(1e-2, 0.9, json_value(r.out, "difference"));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "\"seconds\": 7}, \"second\""), r.out);
  run_tool(&r, "learn m.yaml -q -o first.qtr");
  run_tool(&r, "learn slower.yaml -q -o second.qtr");
  expect("compare first.qtr second.qtr", TEXTS("first.qtr is better by")); /* one gamma a second, two a step */
}

static void test_pictures_tell_seconds(void) {
  run_tool(&r, "draw m.qtr -o m.svg");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  read_text("m.svg", r.out, sizeof r.out);
  static const char *const texts[] = {"4 looks, last at step 39, 19.5 s",
                                      ">13.5968 s<",
                                      ">0.5 s<",
                                      ">Bay<",
                                      ">1st x2<",
                                      ", seeker 0, visit 1, step 14, 7 s, seeker 0, visit 2, step 20, 10 s<",
                                      "up to 3 times as long"};
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, texts[i]), texts[i]);
}

static void test_curves_have_columns_of_seconds(void) {
  run_tool(&r, "learn m.yaml --objective time -q --curve c.csv");
  read_text("c.csv", r.out, sizeof r.out);
  TEST_ASSERT_NOT_NULL(strstr(r.out, ",q_entries,expected_time_seconds,bound_seconds\n"));
  TEST_ASSERT_NOT_NULL(strstr(r.out, ",13.5968028,13.5968028\n"));
  run_tool(&r, "learn m.yaml -q --curve c.csv");
  read_text("c.csv", r.out, sizeof r.out);
  TEST_ASSERT_NOT_NULL(strstr(r.out, ",q_entries,expected_time_seconds\n"));
}

static void test_tune_tries_what_the_terms_leave(void) {
  expect("tune m.yaml --objective time",
         TEXTS("bound 13.5968 for any policy", "a step is 0.5 s: figures are in seconds", "the best of 1 try"));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "there are no spots with classes"), r.err);
  expect("tune m.yaml --objective time --learner paper --episodes 50", TEXTS("the best of 1 try"));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "there are no regions with the field's terms"), r.err);
}

/* A second look where the robot stands is a waypoint of its own, with a time of its own. */
static void test_each_look_is_a_waypoint(void) {
  expect("export m.qtr -o w.csv", TEXTS("39 steps, 19.5 s"));
  read_text("w.csv", r.out, sizeof r.out);
  TEST_ASSERT_NOT_NULL(strstr(r.out, "0,Wing,1,0,Bay,8,0,17.000000,7.000000,14,7.000000,3.000000\n"
                                     "0,Wing,2,0,Bay,8,0,17.000000,7.000000,20,10.000000,3.000000\n"));
}

static void test_later_looks_are_no_places_that_are_gone(void) {
  expect("learn m.yaml --objective time --against m.qtr",
         TEXTS("against m.qtr: expected time 13.5968 s, was 13.5968\n"));
  TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "gone"), r.out);
  run_tool(&r, "learn m.yaml --objective time -o m.qtr");
  TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "against"), r.out);
}

/* Classes, scans, looks and ready times are in the table: what is left is learnt with all of them. */
static void test_the_rest_of_a_table_with_terms_is_weighed(void) {
  run_tool(&r, "learn m.yaml --objective time --clear 2 --json");
  const double seconds = json_value(r.out, "objective_value");
  run_tool(&r, "simulate m.qtr --clear 2 --json");
  TEST_ASSERT_DOUBLE_WITHIN(1e-4, seconds, json_value(json_text(r.out, "learnt_anew"), "objective_value"));
  run_tool(&r, "simulate m.qtr --clear Bay");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "3 of 5 looks made"), r.out); /* both looks at Bay are cleared */
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, " s by their rule, "), r.out);
  TEST_ASSERT_EQUAL_INT(0, r.status);
}

static void test_late_and_lost_are_told_in_seconds_too(void) {
  expect("simulate m.qtr --late Wing:+10s --json", TEXTS("\"seconds\": 17}"));
  run_tool(&again, "simulate m.qtr --late Wing:+20 --json");
  TEST_ASSERT_EQUAL_STRING(again.out, r.out);
  run_tool(&r, "simulate m.qtr --lost Wing@10.2s --json");
  run_tool(&again, "simulate m.qtr --lost Wing@21 --json");
  TEST_ASSERT_EQUAL_STRING(again.out, r.out);
  run_tool(&r, "simulate plain.qtr --late 0:+10s");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "does not say how long a step is; give steps"), r.err);
}

/* Places that nobody has the endurance for count as found when all must be home, for both. */
static void test_simulate_and_learn_agree_on_places_that_nobody_searches(void) {
  write_file("tired.yaml", "map: ground.txt\ncell_size: 2\nspeed: 1\nobjective: time\n"
                           "classes: {k: {endurance_seconds: 24}}\nrobots: [{column: 0, row: 0, class: k}]\n"
                           "places: [{column: 2, row: 0}, {column: 0, row: 3, weight: 2}, {column: 8, row: 3}]\n");
  run_tool(&again, "learn tired.yaml -o tired.qtr --json");
  TEST_ASSERT_TRUE_MESSAGE(json_is(again.out, "left_out", "[2]"), again.out);
  run_tool(&r, "simulate tired.qtr --json");
  TEST_ASSERT_EQUAL_INT(4, r.status);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, json_value(again.out, "expected_time"), json_value(r.out, "expected_time"));
}

static void test_looks_are_counted_apart_from_places(void) {
  expect("inspect m.qtr", TEXTS("4 places (5 looks), 2 robots"));
  expect("compare m.qtr m.qtr", TEXTS("2 robots, 4 places (5 looks)"));
  expect("simulate m.qtr", TEXTS("m.qtr: 5 of 5 looks made by step 46, 23 s, 0 made again"));
}

/* To the byte as before there were any. */
static void test_without_a_speed_there_are_no_seconds(void) {
  static const char *const commands[] = {"inspect plain.qtr", "simulate plain.qtr", "compare plain.qtr plain.qtr",
                                         "simulate plain.qtr --target 0"};
  for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
    run_tool(&r, "%s", commands[i]);
    TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "a step is"), r.out);
    run_tool(&r, "%s --json", commands[i]);
    TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "seconds"), r.out);
    TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "metres"), r.out);
  }
  expect("simulate plain.qtr",
         TEXTS("visited by step 7, 0 visited", "\n  step    2  seeker 0  place 0\n", "expected time 4.5 steps\n"));
  run_tool(&r, "learn plain.yaml -q --curve c.csv");
  read_text("c.csv", r.out, sizeof r.out);
  TEST_ASSERT_NOT_NULL(strstr(r.out, ",updates,q_entries\n"));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_inspect_tells_what_learn_told);
  RUN_TEST(test_simulate_tells_seconds_beside_steps);
  RUN_TEST(test_compare_counts_in_seconds);
  RUN_TEST(test_pictures_tell_seconds);
  RUN_TEST(test_curves_have_columns_of_seconds);
  RUN_TEST(test_tune_tries_what_the_terms_leave);
  RUN_TEST(test_each_look_is_a_waypoint);
  RUN_TEST(test_later_looks_are_no_places_that_are_gone);
  RUN_TEST(test_the_rest_of_a_table_with_terms_is_weighed);
  RUN_TEST(test_simulate_and_learn_agree_on_places_that_nobody_searches);
  RUN_TEST(test_late_and_lost_are_told_in_seconds_too);
  RUN_TEST(test_looks_are_counted_apart_from_places);
  RUN_TEST(test_without_a_speed_there_are_no_seconds);
  return UNITY_END();
}
