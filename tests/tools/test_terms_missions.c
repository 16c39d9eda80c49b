/* Missions with the terms of the field, in seconds and metres, through the tool: learnt against exact, and refused. */
#include "support/tool_run.h"

#include <math.h>
#include <unistd.h>

#define MAP "map: ground.txt\ncell_size: 2\n"
#define PLACES                                                                                                         \
  "places:\n - {column: 8, row: 0, name: Bay, weight: 3, detection: 0.7, looks: 2}\n"                                  \
  " - {column: 5, row: 2, scan_seconds: 7}\n - {column: 4, row: 3}\n - {column: 8, row: 3, detection: 0.9}\n"
#define CLASSES                                                                                                        \
  "scan_seconds: 10\nclasses:\n  drone: {speed: 4, scan_seconds: 3%s}\n  rover: {speed: 1, avoid: [Bay], rough: "      \
  "false%s}\n"
#define ROBOTS                                                                                                         \
  "robots:\n - {column: 0, row: 0, class: drone, name: Wing}\n - {column: 0, row: 3, class: rover, ready_seconds: "    \
  "4}\n"
#define ONE "robots: [{column: 0, row: 0}]\n"

static tool_result learnt, solved;

void setUp(void) {
  write_file("ground.txt", "S........\n..##..~~.\n..##..~~.\n.........\n");
}
void tearDown(void) {
}

static void write_mission(const char *drone, const char *rover, const char *more) {
  char text[2000];
  snprintf(text, sizeof text, MAP CLASSES ROBOTS PLACES "%s", drone, rover, more);
  write_file("m.yaml", text);
}

static void check_like_exact(const char *options) {
  run_tool(&learnt, "learn m.yaml %s --json", options);
  run_tool(&solved, "exact m.yaml %s --json", options);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, solved.status, solved.err);
  TEST_ASSERT_TRUE_MESSAGE(json_is(learnt.out, "certified", "true"), options);
  static const char *const keys[] = {"objective_value", "objective_bound", "seconds_per_step"};
  for (int i = 0; i < 3; i++) {
    const double wanted = json_value(solved.out, keys[i]);
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-5 * fabs(wanted), wanted, json_value(learnt.out, keys[i]), keys[i]);
  }
}

static void test_two_classes_with_scans_and_looks_are_learnt_as_exact_solves_them(void) {
  write_mission("", "", "objective: time\n");
  check_like_exact("");
  TEST_ASSERT_EQUAL_DOUBLE(0.5, json_value(learnt.out, "seconds_per_step"));
  TEST_ASSERT_EQUAL_DOUBLE(0.5 * json_value(learnt.out, "expected_time"), json_value(learnt.out, "objective_value"));
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, json_value(solved.out, "found_probability"),
                            json_value(learnt.out, "found_probability"));
  check_like_exact("--objective discounted");
  TEST_ASSERT_EQUAL_DOUBLE(0.99, json_value(learnt.out, "gamma"));
  check_like_exact("--deadline 15");
  TEST_ASSERT_EQUAL_DOUBLE(json_value(learnt.out, "found_probability"), json_value(learnt.out, "objective_value"));
}

static void test_endurance_and_coming_home(void) {
  write_mission(", endurance_seconds: 20", ", endurance_seconds: 60", "objective: time\n");
  check_like_exact("");
  check_like_exact("--objective discounted");
  write_mission("", "", "objective: time\nhome_weight: 2\n");
  check_like_exact("");
  run_tool(&learnt, "learn m.yaml --objective discounted --json");
  TEST_ASSERT_NOT_NULL(strstr(learnt.err, "home_weight counts under --objective time alone"));
}

static void test_routes_are_told_in_seconds_metres_and_looks(void) {
  write_mission("", "", "objective: time\n");
  run_tool(&learnt, "learn m.yaml --json");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.out,
                                      "\"places\": [0, 0, 3, 2], \"names\": [\"Bay\", \"Bay\", \"3\", \"2\"], "
                                      "\"steps\": [14, 20, 29, 39], \"seconds\": [7, 10, 14.5, 19.5], "
                                      "\"metres\": [16, 16, 22, 30], \"looks\": [1, 2, 1, 1]"),
                               learnt.out);
  run_tool(&learnt, "learn m.yaml");
  TEST_ASSERT_NOT_NULL(strstr(learnt.out, "expected time 13.5968 s, bound 13.5968 ("));
  TEST_ASSERT_NOT_NULL(strstr(learnt.out, "seeker Wing: Bay (step 14, 7 s) -> Bay (step 20, 10 s)"));
  TEST_ASSERT_NOT_NULL(strstr(learnt.out, "finds the target with probability 0.938333\na step is 0.5 s\n"));
}

static void test_places_that_nobody_has_the_endurance_for_are_named(void) {
  write_mission(", endurance_seconds: 20", ", endurance_seconds: 30", "objective: time\n");
  check_like_exact("");
  TEST_ASSERT_TRUE(json_is(learnt.out, "left_out", "[1]"));
  run_tool(&learnt, "learn m.yaml");
  TEST_ASSERT_NOT_NULL(strstr(learnt.out, "nobody searches 1\n"));
}

static void test_rounding_is_told(void) {
  write_file("m.yaml", MAP "classes: {a: {speed: 1}, b: {speed: 2.99}}\nscan_seconds: 1\nrobots: [{column: 0, row: 0, "
                           "class: a}, {column: 0, row: 0, class: b}]\n" PLACES);
  run_tool(&learnt, "learn m.yaml");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.out, "which rounds travel times by up to 0.17 %"), learnt.out);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, "round scan times and the like by up to"), learnt.err);
}

/* With none of the terms what is printed is what was. */
static void test_missions_without_terms_are_told_in_steps(void) {
  run_tool(&learnt, "learn ground.txt --json");
  TEST_ASSERT_EQUAL_INT(2, learnt.status);
  write_file("m.yaml", "map: ground.txt\nobjective: time\nplaces: [{column: 2, row: 0}, {column: 0, row: 3}]\n");
  run_tool(&learnt, "learn m.yaml");
  char *took = strstr(learnt.out, "Q entries");
  TEST_ASSERT_NOT_NULL(took);
  TEST_ASSERT_NOT_NULL(
      strstr(learnt.out, "certified optimal; expected time 4.5 steps, bound 4.5 (discounted value 9.6"));
  TEST_ASSERT_NOT_NULL(strstr(learnt.out, "\n  seeker 0: 0 (step 2) -> 1 (step 7)\n"));
  TEST_ASSERT_NULL(strstr(learnt.out, "a step is"));
  run_tool(&learnt, "learn m.yaml --json");
  TEST_ASSERT_EQUAL_DOUBLE(1.0, json_value(learnt.out, "seconds_per_step"));
  TEST_ASSERT_EQUAL_DOUBLE(1.0, json_value(learnt.out, "found_probability"));
  TEST_ASSERT_EQUAL_DOUBLE(4.5, json_value(learnt.out, "objective_value"));
  TEST_ASSERT_NULL(strstr(learnt.out, "\"metres\""));
}

/* ---- what is refused: one line, status 2 ---- */

static void refuse(const char *mission, const char *options, const char *what, const char *mend) {
  write_file("m.yaml", mission);
  run_tool(&learnt, "learn m.yaml %s -o none.qtr --json=none.json --curve none.csv", options);
  TEST_ASSERT_TRUE_MESSAGE(access("none.qtr", F_OK) != 0 && access("none.json", F_OK) != 0, options);
  TEST_ASSERT_TRUE_MESSAGE(access("none.csv", F_OK) != 0, options);
  TEST_ASSERT_EQUAL_INT_MESSAGE(2, learnt.status, learnt.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, "quarter: m.yaml"), learnt.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, what), learnt.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, mend), learnt.err);
  TEST_ASSERT_EQUAL_STRING("", learnt.out);
}

static void test_ends_before_anything_can_be_searched(void) {
  refuse(MAP ONE PLACES "scan_seconds: 1\nspeed: 2\nobjective: deadline\ndeadline_seconds: 3\n", "",
         "the nearest, place 2 (m.yaml:7), is searched after 8 s, and the deadline is 3 s", "a later deadline_seconds");
  refuse(MAP ONE PLACES "speed: 2\nscan_seconds: 1\n", "--deadline 3", "and the deadline is 3 s", "--deadline");
  refuse(MAP PLACES "classes: {a: {speed: 2, scan_seconds: 1, endurance_seconds: 10}}\nrobots: [{column: 0, row: 0, "
                    "class: a}]\n",
         "", "the nearest, place 2 (m.yaml:6), takes it 15 s there and back, and its endurance is 10 s",
         "raise endurance_seconds");
  refuse(MAP ONE PLACES, "--objective deadline", "none is given", "deadline_seconds: 600");
  /* What there is is told as it was stated, not as it is rounded: steps are of 2 s. */
  refuse(MAP ONE "speed: 1\nobjective: deadline\ndeadline_seconds: 0.5\nplaces: [{column: 2, row: 0}]\n", "",
         "is searched after 4 s, and the deadline is 0.5 s", "a later deadline_seconds");
}

static void test_one_robot_that_can_search_nothing_is_warned_of(void) {
  write_mission("", ", endurance_seconds: 20", "");
  run_tool(&learnt, "learn m.yaml --json");
  TEST_ASSERT_EQUAL_INT(0, learnt.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, "seeker 1 (m.yaml:9) can search no place: the nearest, place 2"),
                               learnt.err);
  write_mission("", "", "");
  run_tool(&learnt, "learn m.yaml --json");
  TEST_ASSERT_EQUAL_STRING("", learnt.err);
}

static void test_looks_that_are_of_no_use_are_told(void) {
  write_file("m.yaml", MAP ONE "looks: 2\nscan_seconds: 1\nplaces: [{column: 2, row: 0}, {column: 3, row: 0}]\n");
  run_tool(&learnt, "learn m.yaml --json");
  TEST_ASSERT_EQUAL_INT(0, learnt.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, "the first finds all that is there"), learnt.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, "detection: 0.8"), learnt.err);
}

static void test_a_finer_step_is_proposed_in_round_figures(void) {
  write_file("m.yaml", MAP ONE "speed: 1\nscan_seconds: 3\nplaces: [{column: 2, row: 0}]\n");
  run_tool(&learnt, "learn m.yaml");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, "\"step_seconds: 0.05\" is finer"), learnt.err);
}

static void test_a_class_of_nobody_is_warned_of(void) {
  write_file("m.yaml", MAP ONE PLACES "classes: {drone: {speed: 3}}\nscan_seconds: 1\n");
  run_tool(&learnt, "learn m.yaml --json");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(learnt.err, "m.yaml:9: no robot is of class drone; give one \"class: drone\""),
                               learnt.err);
  TEST_ASSERT_EQUAL_DOUBLE(1.0, json_value(learnt.out, "seconds_per_step"));
}

static void test_what_cannot_be_played(void) {
  refuse(MAP PLACES
         "objective: time\nscan_seconds: 1\nclasses: {a: {endurance_seconds: 900}}\nrobots: [{column: 0, row: "
         "0, class: a}, {column: 0, row: 0}]\n",
         "", "all robots have endurance or none has: seeker 0 (m.yaml:11) has, seeker 1 (m.yaml:11) has not",
         "another objective");
  refuse(MAP ONE PLACES, "", "place Bay (m.yaml:5) is looked at 2 times, and a look at it takes some robots no time",
         "give scan_seconds");
  refuse(MAP ONE PLACES "rule: paper\nscan_seconds: 1\n", "", "the paper's rule takes no classes", "rule: free");
  refuse(MAP PLACES "scan_seconds: 1\nclasses: {a: {rough: false}}\nrobots: [{column: 6, row: 1, class: a}]\n", "",
         "seeker 0 (m.yaml:10) starts on rough ground, which class a may not enter", "rough: true");
  refuse(MAP ONE
         "scan_seconds: 1\ndetection: 0.1\nlooks: 255\nplaces: [{column: 1, row: 0}, {column: 2, row: 0}, {column: "
         "3, row: 0}, {column: 4, row: 0}, {column: 5, row: 0}]\n",
         "", "5 places with their looks are 1275", "QTR_MAX_PLACES");
  refuse(MAP ONE PLACES "scan_seconds: 1\nspeed: 0.0001\n", "", "takes 20000 s for a cell of 2 m", "mend its speed");
}

static void test_what_is_not_for_terms(void) {
  const char *mission = MAP ONE PLACES "scan_seconds: 1\n";
  refuse(mission, "--aggregate spots", "spots no classes, looks", "leave it out");
  refuse(mission, "--aggregate regions --learner paper", "regions take none of the field's terms", "leave it out");
  refuse(mission, "--cleared any", "--cleared any takes no classes", "leave them out");
  run_tool(&learnt, "learn m.yaml --deadline 9 --objective time");
  TEST_ASSERT_EQUAL_INT(2, learnt.status);
  TEST_ASSERT_NOT_NULL(strstr(learnt.err, "--deadline is the deadline objective's"));
}

/* What the table holds is played as it was planned. */
static void test_table_of_a_mission_with_terms_is_written_and_played(void) {
  static const char *const terms[] = {"scan_seconds: 1\n", "detection: 0.9\nlooks: 2\nscan_seconds: 1\n",
                                      "step_seconds: 0.5\n", "objective: time\nhome_weight: 1\n",
                                      "objective: deadline\ndeadline_seconds: 60\n"};
  for (int i = 0; i < 5; i++) {
    char text[400];
    snprintf(text, sizeof text, MAP ONE "places: [{column: 2, row: 0}]\n%s", terms[i]);
    write_file("m.yaml", text);
    run_tool(&learnt, "learn m.yaml -o t.qtr --json");
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
    run_tool(&learnt, "inspect t.qtr --json");
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
    run_tool(&learnt, "simulate t.qtr --json");
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
  }
}

/* Metres over speed, and scans: what a step rounds is less than 1 % of a way, and less than a step a scan. */
static void test_seconds_of_routes_are_those_of_metres_and_scans(void) {
  write_file("m.yaml", MAP "scan_seconds: 10\nclasses: {a: {speed: 1.3}, b: {speed: 4, scan_seconds: 3}}\nrobots: "
                           "[{column: 0, row: 0, class: a}, {column: 0, row: 3, class: b}]\nplaces:\n"
                           " - {column: 4, row: 0}\n - {column: 8, row: 0}\n - {column: 4, row: 3}\n"
                           " - {column: 8, row: 3}\n - {column: 2, row: 3}\n");
  run_tool(&learnt, "learn m.yaml --objective time --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
  const double step = json_value(learnt.out, "seconds_per_step"), speeds[] = {1.3, 4.0}, scans[] = {10.0, 3.0};
  const char *at = learnt.out;
  int seen = 0;
  for (int robot = 0; robot < 2; robot++) {
    const char *seconds = strstr(at, "\"seconds\": [") + 11, *metres = strstr(at, "\"metres\": [") + 10;
    for (int i = 1; *metres != ']'; i++, seen++) {
      char *end;
      const double took = strtod(seconds + 1, &end), way = strtod(metres + 1, (char **)&metres) / speeds[robot];
      seconds = end;
      TEST_ASSERT_DOUBLE_WITHIN(0.01 * way + i * step + 1e-9, way + i * scans[robot], took);
    }
    at = metres;
  }
  TEST_ASSERT_EQUAL_INT(5, seen);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_two_classes_with_scans_and_looks_are_learnt_as_exact_solves_them);
  RUN_TEST(test_endurance_and_coming_home);
  RUN_TEST(test_routes_are_told_in_seconds_metres_and_looks);
  RUN_TEST(test_places_that_nobody_has_the_endurance_for_are_named);
  RUN_TEST(test_rounding_is_told);
  RUN_TEST(test_missions_without_terms_are_told_in_steps);
  RUN_TEST(test_ends_before_anything_can_be_searched);
  RUN_TEST(test_one_robot_that_can_search_nothing_is_warned_of);
  RUN_TEST(test_looks_that_are_of_no_use_are_told);
  RUN_TEST(test_a_finer_step_is_proposed_in_round_figures);
  RUN_TEST(test_a_class_of_nobody_is_warned_of);
  RUN_TEST(test_what_cannot_be_played);
  RUN_TEST(test_what_is_not_for_terms);
  RUN_TEST(test_table_of_a_mission_with_terms_is_written_and_played);
  RUN_TEST(test_seconds_of_routes_are_those_of_metres_and_scans);
  return UNITY_END();
}
