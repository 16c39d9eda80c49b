/* One numbering of the places, the input's, whichever are left out; and notes in text and JSON. */
#include "support/tool_run.h"

/* Place 0 is out of reach, place 1 on an obstacle; what is left are the input's 2 and 3. */
static void write_mission(void) {
  write_file("map.txt", "....\n####\n....\n");
  write_file("mission.yaml", "map: map.txt\nrobots:\n  - {column: 0, row: 2}\nplaces_csv: places.csv\n");
  write_file("places.csv", "column,row,weight\n3,0,9\n2,1,4\n1,2,2\n3,2,5\n");
  write_file("games.csv", "place\n2\n2\n3\n");
}

void setUp(void) {
  write_mission();
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

static void expect_err(const char *text) {
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, text), r.err);
}

static void test_learn_and_exact_name_places_by_the_inputs_numbers(void) {
  run_well("learn mission.yaml --skip-unreachable");
  expect_out("seeker 0: 2 (step 1) -> 3 (step 3)");
  run_well("exact mission.yaml --skip-unreachable");
  expect_out("seeker 0: 2 (step 1) -> 3 (step 3)");
  run_well("learn mission.yaml --skip-unreachable --json -q");
  expect_out("\"places\": [2, 3], \"steps\": [1, 3]");
  expect_out("\"place_numbers\": [2, 3]");
  expect_out("places.csv:3: place 1 stands on an obstacle");
}

static void test_a_table_keeps_the_inputs_numbers(void) {
  run_well("learn mission.yaml --skip-unreachable -o m.qtr");
  expect_err("quarter: note: mission.yaml: left out, for no seeker can reach them: place 0 (places.csv:2)\n");
  run_well("simulate m.qtr");
  expect_out("place 2\n");
  expect_out("place 3\n");
  run_well("simulate m.qtr --target 3 --clear 2");
  expect_out("found at place 3");
  run_well("simulate m.qtr --json");
  expect_out("\"place\": 2");
  run_well("inspect m.qtr");
  expect_out("seeker 0: 2 (step 1) -> 3 (step 3)");
  run_well("inspect m.qtr --json");
  expect_out("\"number\": 3");
  expect_out("\"places\": [2, 3]");
  run_tool(&r, "simulate m.qtr --target 0");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  expect_err("--target: there is no place 0; there are places 2 to 3 but those that were left out");
}

static void test_nothing_left_out_nothing_told(void) {
  write_file("places.csv", "column,row,weight\n1,2,2\n3,2,5\n");
  run_well("learn mission.yaml -o m.qtr");
  TEST_ASSERT_EQUAL_STRING("", r.err);
  run_well("learn mission.yaml --json");
  expect_out("\"place_numbers\": [0, 1]");
  expect_out("\"notes\": []");
}

static void test_belief_takes_and_tells_the_inputs_numbers(void) {
  run_tool(&r, "belief mission.yaml --history games.csv");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  expect_err("places.csv:3: place 1 stands on an obstacle");
  run_well("belief mission.yaml --history games.csv --skip-unreachable");
  expect_out("place 2 (column 1, row 2)");
  expect_out("found 2 times");
  expect_out("place 0 (column 3, row 0)"); /* out of reach, but a place all the same */
  run_well("belief mission.yaml --history games.csv --skip-unreachable --json");
  expect_out("{\"number\": 2, \"column\": 1, \"row\": 2, \"found\": 2,");
  write_file("games.csv", "place\n1\n");
  run_tool(&r, "belief mission.yaml --history games.csv --skip-unreachable");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  expect_err("games.csv:2: place 1 was left out of mission.yaml by --skip-unreachable");
  write_file("games.csv", "place\n4\n");
  run_tool(&r, "belief mission.yaml --history games.csv --skip-unreachable");
  expect_err("its places are 0 to 3");
}

static void test_snap_is_the_same_for_every_command(void) {
  static const char *const lines[] = {
      "learn mission.yaml --skip-unreachable --snap 1", "exact mission.yaml --skip-unreachable --snap 1",
      "tune mission.yaml --episodes 1 -q --skip-unreachable --snap 1",
      "draw mission.yaml -o m.svg --skip-unreachable --snap 1", "belief mission.yaml --history games.csv --snap 1"};
  for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
    run_well(lines[i]);
    expect_err(
        "quarter: note: places.csv:3: place 1 stands on an obstacle, at column 2, row 1; moved to column 2, row 2, "
        "1 cell away\n");
  }
  run_tool(&r, "learn mission.yaml --snap x");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  expect_err("--snap x: not a number of metres");
}

static void test_all_bad_places_are_told_a_line_each_with_status_2(void) {
  write_file("places.csv", "column,row,weight\n0,1,9\n2,1,4\n1,2,2\n7,2,5\n");
  run_tool(&r, "learn mission.yaml -o none.qtr");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  expect_err("quarter: mission.yaml: 3 places are not on a free cell of their own");
  expect_err("\nquarter: places.csv:2: place 0 stands on an obstacle");
  expect_err("\nquarter: places.csv:3: place 1 stands on an obstacle");
  expect_err("\nquarter: places.csv:5: place 3: column 7, row 2 lies outside the map");
}

static void test_a_turned_maps_table_holds_the_turn(void) {
  write_file("m.pgm", "P2 3 1 1 1 1 1\n");
  write_file("m.yaml", "image: m.pgm\nresolution: 1\norigin: [0, 0, 0.5]\nnegate: 0\noccupied_thresh: 0.6\n"
                       "free_thresh: 0.2\n");
  write_file("turned.yaml",
             "map: m.yaml\nrobot_radius: 0\nrobots: [{column: 0, row: 0}]\nplaces: [{x: 1.9, y: 1.6}]\n");
  run_well("learn turned.yaml -o turned.qtr");
  TEST_ASSERT_EQUAL_STRING("", r.err);
  run_well("inspect turned.qtr --json");
  expect_out("\"cell_size\": 1,");
  expect_out("\"yaw\": 0.5");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learn_and_exact_name_places_by_the_inputs_numbers);
  RUN_TEST(test_a_table_keeps_the_inputs_numbers);
  RUN_TEST(test_nothing_left_out_nothing_told);
  RUN_TEST(test_belief_takes_and_tells_the_inputs_numbers);
  RUN_TEST(test_snap_is_the_same_for_every_command);
  RUN_TEST(test_all_bad_places_are_told_a_line_each_with_status_2);
  RUN_TEST(test_a_turned_maps_table_holds_the_turn);
  return UNITY_END();
}
