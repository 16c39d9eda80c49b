/* What a new user gets wrong, and what is said: one line that names the file or the word, the fault and the mend. */
#include "support/tool_run.h"

static tool_result r;

void setUp(void) {
  write_file("a.txt", "S..1\n....\n");
}

void tearDown(void) {
}

/* Refused with status 2, nothing on standard output and one line that holds all of these. */
static void expect_refusal(const char *words, const char *where, const char *what, const char *mend) {
  run_tool(&r, "%s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(2, r.status, words);
  TEST_ASSERT_EQUAL_STRING_MESSAGE("", r.out, words);
  TEST_ASSERT_EQUAL_STRING_LEN_MESSAGE("quarter: ", r.err, 9, r.err);
  TEST_ASSERT_EQUAL_PTR_MESSAGE(r.err + strlen(r.err) - 1, strchr(r.err, '\n'), r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, where), r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, what), r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, mend), r.err);
  TEST_ASSERT_NULL_MESSAGE(strstr(r.err, "quarter: quarter"), r.err);
}

static void test_slips_in_a_mission(void) {
  static const char *const slips[][4] = {
      {"robots:\n  - [1, 10]\n", "m.yaml:3", "robot 0 is a list",
       "write {column: 1, row: 10}, or in metres {x: 1, y: 10}"},
      {"places: [[3, 0, 2]]\n", "m.yaml:2", "place 0 is a list", "write {column: 1, row: 10}"},
      {"robots:\n\t- {column: 0, row: 0}\n", "m.yaml:3", "indented by a tab", "use blanks"},
      {"robots:\n  - column: 0\n  \trow: 0\n", "m.yaml:4", "indented by a tab", "use blanks"},
      {"robots: 2\n", "m.yaml:2", "'robots' is not a list", "--robots K"},
      {"robots: [{x: 0,5, y: 1}]\n", "m.yaml:2", "robot 0 has a number without a key", "0.5 and not 0,5"},
      {"gamma: \"0,99\"\n", "m.yaml:2", "'gamma' is \"0,99\", which has a comma", "give a number"},
      {"robots: [{x: 0.5 y: 0.5}]\n", "m.yaml:2", "not valid YAML", "mend the line"},
      {"places: [{column: 3, row: 0, wieght: 2}]\n", "m.yaml:2", "unknown key 'wieght'", "did you mean 'weight'?"},
      {"places:\n", "m.yaml:2", "'places' is not a list", "places: [{x: 0.5"},
      {"objective: fastest\n", "m.yaml:2", "'objective' is \"fastest\"", "discounted, time and deadline"},
      {"places_csv: none.csv\n", "none.csv", "no such file", "named by m.yaml:2"}};
  for (size_t i = 0; i < sizeof slips / sizeof slips[0]; i++) {
    char mission[300];
    snprintf(mission, sizeof mission, "map: a.txt\n%s", slips[i][0]);
    write_file("m.yaml", mission);
    expect_refusal("learn m.yaml", slips[i][1], slips[i][2], slips[i][3]);
  }
}

static void test_slips_in_a_csv(void) {
  static const char *const slips[][4] = {
      {"x;y,weight\n1;2;3\n", "p.csv:1", "has 'x' and lacks 'y'", "add that column"},
      {"1,2,3\n", "p.csv:1", "is not the header", "write it above the places"},
      {"lat,lon,weight\n48.1,11.5,1\n", "p.csv:1", "latitudes and longitudes are not read", "metres in the map frame"},
      {"x,y,weight\n1,5,0,5,3\n", "p.csv:2", "has 5 fields", "not 3"},
      {"x,y,weight\n1.5,0.5,0\n", "p.csv:2", "'weight' is 0", "a likelihood in any unit above 0"},
      {"x,y,weight\n1.5,0.5,\n", "p.csv:2", "'weight' has no value", "give a number"}};
  write_file("m.yaml", "map: a.txt\nplaces_csv: p.csv\n");
  for (size_t i = 0; i < sizeof slips / sizeof slips[0]; i++) {
    write_file("p.csv", slips[i][0]);
    expect_refusal("learn m.yaml", slips[i][1], slips[i][2], slips[i][3]);
  }
  write_file("p.csv", "X,Y,Weight\n3.5,1.5,1\n");
  run_tool(&r, "learn m.yaml");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
}

static void test_slips_on_the_command_line(void) {
  run_tool(&r, "learn a.txt -q -o a.qtr");
  static const char *const slips[][4] = {
      {"learn a.txt --gapp 0.1", "learn: ", "no such option '--gapp'", "did you mean --gap?"},
      {"learn a.txt --gapp=0.1", "'--gapp=0.1'", "no such option", "did you mean --gap?"},
      {"learn a.txt --quite", "'--quite'", "no such option", "did you mean --quiet?"},
      {"learn a.txt --zzz", "'--zzz'", "no such option", "'quarter learn --help' shows"},
      {"learn a.txt -x", "'-x'", "no such option", "'quarter learn --help' shows"},
      {"learn a.txt --gap", "'--gap'", "no value after", "'quarter learn --help' shows"},
      {"learn a.txt --quiet=1", "'--quiet=1'", "a value that is not wanted", "'quarter learn --help' shows"},
      {"learn", "learn: ", "name an input", "'quarter learn --help' shows how"},
      {"learn a.txt b.txt", "learn: ", "one input at a time", "'b.txt'"},
      {"learn a.txt --json=", "--json", "is empty", "name"},
      {"lern a.txt", "'lern'", "there is no command", "did you mean 'learn'?"},
      {"--verison", "'--verison'", "there is no command", "did you mean '--version'?"},
      {"fly a.txt", "'fly'", "there is no command", "'quarter --help' lists them"},
      {"draw a.txt", "draw: ", "say where to", "-o FILE.svg"},
      {"draw a.txt -o a.jpg", "-o a.jpg", "is SVG, PNG or PDF", "name it a.png"},
      {"draw a.txt -o b/a.TIF", "-o b/a.TIF", "is SVG, PNG or PDF", "name it b/a.png"},
      {"belief a.txt", "belief: ", "name the games", "--history FILE"},
      {"simulate a.qtr --target 7", "--target", "there is no place 7", "places 0 to 0"},
      {"simulate a.qtr --clear 7", "--clear", "there is no place 7", "places 0 to 0"}};
  for (size_t i = 0; i < sizeof slips / sizeof slips[0]; i++)
    expect_refusal(slips[i][0], slips[i][1], slips[i][2], slips[i][3]);
}

static void test_a_table_too_large_is_met_with_what_helps(void) {
  expect_refusal("learn a.txt --starts any --table-limit 0.001 --robots 6 --start-regions 9 -o t.qtr", "a.txt",
                 "the table would take", "take fewer regions with --start-regions");
  write_file("many.txt", "S111111111111111\n");
  expect_refusal("learn many.txt --cleared any --table-limit 0.01 -o t.qtr", "many.txt", "the table would take",
                 "list fewer places");
  TEST_ASSERT_NULL_MESSAGE(strstr(r.err, "regions"), r.err);
}

static void test_likelihoods_are_told_as_short_as_the_table_knows_them(void) {
  write_file("w.txt", "S..2\n...3\n");
  run_tool(&r, "learn w.txt -q -o w.qtr");
  run_tool(&r, "inspect w.qtr --json");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "\"probability\": 0.4}"), r.out);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "\"probability\": 0.6}"), r.out);
}

/* Two plans of one mission: stopped far from the optimum, and at it. */
static void test_optimal_is_said_of_no_plan_with_a_wide_gap(void) {
  write_file("wide.txt", "1..2..3\n.#.#.#.\nS..4..5\n.#.#.#.\n6..7..8\n");
  run_tool(&r, "learn wide.txt --robots 2 --gap 1 --json=wide.json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  char json[1 << 13];
  read_text("wide.json", json, sizeof json);
  TEST_ASSERT_EQUAL_INT(json_value(json, "gap") <= 1e-5, strstr(r.out, "certified optimal") != NULL);
  run_tool(&r, "learn wide.txt --robots 2");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "certified optimal"), r.out);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_slips_in_a_mission);
  RUN_TEST(test_slips_in_a_csv);
  RUN_TEST(test_slips_on_the_command_line);
  RUN_TEST(test_a_table_too_large_is_met_with_what_helps);
  RUN_TEST(test_likelihoods_are_told_as_short_as_the_table_knows_them);
  RUN_TEST(test_optimal_is_said_of_no_plan_with_a_wide_gap);
  return UNITY_END();
}
