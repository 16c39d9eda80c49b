/* quarter check: all faults of a mission at once. */
#include "support/tool_run.h"

static tool_result r;

void setUp(void) {
  write_file("check.txt", "S..#\n....\n");
}

void tearDown(void) {
}

static void check(const char *mission, int status) {
  write_file("check.yaml", mission);
  run_tool(&r, "check check.yaml");
  TEST_ASSERT_EQUAL_INT_MESSAGE(status, r.status, r.err);
}

static void test_a_sound_mission_has_no_faults(void) {
  check("map: check.txt\nplaces: [{column: 1, row: 1}]\n", 0);
  TEST_ASSERT_EQUAL_STRING("check.yaml: no faults: 7 free cells, 1 place, 1 robot\n", r.out);
  TEST_ASSERT_EQUAL_STRING("", r.err);
}

static void test_faults_of_all_keys_places_and_lines_are_told_at_once(void) {
  write_file("check.csv", "x,y,weight\n1,1\n2.5,0.5,nan\n1.5,9,1\n");
  check("mpa: a\nmap: check.txt\ngamma: 2\nobjective: fast\n"
        "robots:\n - {column: 0, row: 0}\n - {column: 0, rwo: 1}\n"
        "places:\n - {column: 1, row: 0, weight: -1, poa: 3}\n - {x: one, y: 1}\n - {column: 3, row: 0, name: B}\n"
        " - {column: 1, row: 1, name: B}\nplaces_csv: check.csv\ncleared: [Nowhere]\n",
        2);
  static const char *const wanted[] = {"check.yaml:1: unknown key 'mpa'",
                                       "check.yaml:3: 'gamma' is 2",
                                       "check.yaml:4: 'objective' is \"fast\"",
                                       "check.yaml:7: unknown key 'rwo' of robot 1",
                                       "check.yaml:9: place 0 has both 'weight' and 'poa'",
                                       "check.yaml:10: 'x' is \"one\"",
                                       "check.yaml:12: a second place is called 'B'",
                                       "check.csv:2: the line has 2 fields",
                                       "check.csv:3:9: 'weight' is \"nan\"",
                                       "check.yaml:11: place B stands on an obstacle",
                                       "check.csv:4: place 1: x 1.5, y 9 lies outside"};
  for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++)
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, wanted[i]), wanted[i]);
  TEST_ASSERT_NULL_MESSAGE(strstr(r.err, "Nowhere"), r.err); /* hangs on places that could not be read */
  TEST_ASSERT_EQUAL_STRING("check.yaml: 12 faults\n", r.out);
}

/* Without a map nothing can be said of where places lie, but of their keys. */
static void test_without_a_map_the_rest_is_read_all_the_same(void) {
  check("map: none.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 1, weight: 0}, {column: 2, row: 1}]\n",
        2);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "none.txt: no such file"), r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "'weight' is 0"), r.err);
  TEST_ASSERT_EQUAL_STRING("check.yaml: 2 faults\n", r.out);
}

static void test_what_the_game_itself_forbids_is_a_fault_too(void) {
  write_file("check.txt", "S#.\n.#.\n");
  check("map: check.txt\nplaces: [{column: 2, row: 1, name: Far}]\n", 2);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "no seeker can reach place Far"), r.err);
}

static void test_json_has_file_line_and_column(void) {
  write_file("check.csv", "x,y,weight\n2.5,0.5,nan\n");
  write_file("check.yaml", "map: check.txt\nplaces_csv: check.csv\nrule: none\n");
  run_tool(&r, "check check.yaml --json");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  TEST_ASSERT_EQUAL_STRING("", r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "\"sound\": false"), r.out);
  TEST_ASSERT_NOT_NULL_MESSAGE(
      strstr(r.out, "{\"file\": \"check.csv\", \"line\": 2, \"column\": 9, \"text\": \"'weight' is \\\"nan\\\""),
      r.out);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "{\"file\": \"check.yaml\", \"line\": 3, \"text\": \"'rule'"), r.out);
  write_file("check.yaml", "map: check.txt\nplaces: [{column: 1, row: 1}]\n");
  run_tool(&r, "check check.yaml --json");
  TEST_ASSERT_EQUAL_INT(0, r.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "\"faults\": []"), r.out);
}

/* The other commands still end at the first. */
static void test_learning_tells_the_first_fault_alone(void) {
  write_file("check.yaml", "mpa: a\nmap: check.txt\ngamma: 2\n");
  run_tool(&r, "learn check.yaml");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  TEST_ASSERT_EQUAL_PTR_MESSAGE(r.err + strlen(r.err) - 1, strchr(r.err, '\n'), r.err);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_sound_mission_has_no_faults);
  RUN_TEST(test_faults_of_all_keys_places_and_lines_are_told_at_once);
  RUN_TEST(test_without_a_map_the_rest_is_read_all_the_same);
  RUN_TEST(test_what_the_game_itself_forbids_is_a_fault_too);
  RUN_TEST(test_json_has_file_line_and_column);
  RUN_TEST(test_learning_tells_the_first_fault_alone);
  return UNITY_END();
}
