/* Names of places and robots, from the mission to each report, picture and option. */
#include "support/tool_run.h"

void setUp(void) {
  write_file("names.txt", "S...\n....\n");
  write_file("names.yaml", "map: names.txt\nname: Trial\n"
                           "robots: [{column: 0, row: 0, name: Alpha}, {column: 0, row: 1}]\n"
                           "places: [{column: 3, row: 0, name: \"A&B\", weight: 3}, {column: 3, row: 1}, "
                           "{column: 1, row: 1, name: Bay 3}]\n");
}

void tearDown(void) {
}

static tool_result r;

static void run_well(const char *words) {
  run_tool(&r, "%s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
}

static void expect_out(const char *text) {
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, text), r.out);
}

static void refuse(const char *words, const char *text) {
  run_tool(&r, "%s", words);
  TEST_ASSERT_EQUAL_INT(2, r.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, text), r.err);
}

static void test_reports_call_places_and_robots_by_name(void) {
  run_well("learn names.yaml -o n.qtr");
  expect_out("seeker Alpha: A&B (step 3)");
  expect_out("seeker 1: Bay 3 (step 1) -> 1 (step 3)");
  run_well("inspect n.qtr");
  expect_out("seeker 1: Bay 3 (step 1) -> 1 (step 3)");
  run_well("inspect n.qtr --json");
  expect_out("\"name\": \"Trial\"");
  expect_out("{\"seeker\": 0, \"name\": \"Alpha\", \"places\": [0], \"names\": [\"A&B\"], \"steps\": [3]}");
  expect_out("{\"seeker\": 1, \"places\": [2, 1], \"names\": [\"Bay 3\", \"1\"]");
  run_well("simulate n.qtr");
  expect_out("seeker Alpha  place A&B\n");
  run_well("simulate n.qtr --json");
  expect_out("\"place\": 2, \"name\": \"Bay 3\"");
  run_well("exact names.yaml");
  expect_out("seeker 1: Bay 3 (step 1)");
}

static void test_exported_ways_bear_names(void) {
  run_well("learn names.yaml -q -o n.qtr");
  run_well("export n.qtr --format csv -o -");
  expect_out("\n0,Alpha,1,0,A&B,3,0,");
  expect_out("\n1,robot 1,1,2,Bay 3,1,1,");
  run_well("export n.qtr --robot Alpha -o 'ways-%.csv' --json");
  expect_out("\"file\": \"ways-Alpha.csv\"");
  run_well("export n.qtr -o 'ways-%.csv' --json");
  expect_out("\"file\": \"ways-1.csv\"");
  refuse("export n.qtr --robot Alpa -o ways.csv", "did you mean 'Alpha'?");
}

static void test_robots_whose_names_make_one_file_are_refused(void) {
  write_file("alike.yaml", "map: names.txt\nrobots: [{column: 0, row: 0, name: a/b}, {column: 0, row: 1, name: a_b}]\n"
                           "places: [{column: 3, row: 0}]\n");
  run_well("learn alike.yaml -q -o a.qtr");
  refuse("export a.qtr -o 'two-%.csv'", "two robots");
}

static void test_pictures_bear_names(void) {
  run_well("learn names.yaml -q -o n.qtr");
  run_well("draw n.qtr -o -");
  expect_out("<title>place A&amp;B, likelihood");
  expect_out("Bay 3");
  expect_out("Alpha: 1 place");
}

static void test_options_take_names(void) {
  run_well("learn names.yaml -q -o n.qtr");
  run_well("simulate n.qtr --clear 'Bay 3,A&B' --lost Alpha@0");
  expect_out("seeker 1  place 1\n");
  TEST_ASSERT_NULL_MESSAGE(strstr(r.out, "place Bay 3"), r.out);
  run_well("simulate n.qtr --target 'Bay 3' --late Alpha:+5");
  expect_out("target found at place Bay 3");
  refuse("simulate n.qtr --target Bya3", "--target: there is no place Bya3");
  refuse("simulate n.qtr --clear 'Bay 4'", "--clear: there is no place Bay 4; did you mean 'Bay 3'?");
  refuse("simulate n.qtr --lost alpha@3", "--lost: there is no robot alpha; did you mean 'Alpha'?");
}

static void test_beliefs_keep_names(void) {
  char text[400];
  write_file("games.csv", "place,found\n\"Bay 3\",1\nA&B,0\n1,1\n");
  run_well("belief names.yaml --history games.csv -o after.csv");
  read_text("after.csv", text, sizeof text);
  TEST_ASSERT_EQUAL_STRING_LEN("column,row,weight,name\n3,0,", text, 27);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, ",A&B\n"), text);
  write_file("after.yaml", "map: names.txt\nrobots: [{column: 0, row: 0}]\nplaces_csv: after.csv\n");
  run_well("learn after.yaml");
  expect_out("Bay 3");
  write_file("games.csv", "place\nBay 4\n");
  refuse("belief names.yaml --history games.csv -o after.csv", "the place \"Bay 4\" is not a number or a name");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_reports_call_places_and_robots_by_name);
  RUN_TEST(test_exported_ways_bear_names);
  RUN_TEST(test_robots_whose_names_make_one_file_are_refused);
  RUN_TEST(test_pictures_bear_names);
  RUN_TEST(test_options_take_names);
  RUN_TEST(test_beliefs_keep_names);
  return UNITY_END();
}
