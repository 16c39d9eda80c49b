/* The host tool from outside: exit statuses, files whole or absent, JSON, and every bad input told in one clear
 * line. */
#include <sys/stat.h>
#include <unistd.h>

#include "support/tool_run.h"

#define SMALL "S...\n#1.3\n...#\n1...\n"

static tool_result result, other;

void setUp(void) {
  write_file("small.txt", SMALL);
  remove("t.qtr");
  remove("t.c");
  remove("t.json");
}

void tearDown(void) {
}

static int exists(const char *path) {
  struct stat about;
  return stat(path, &about) == 0;
}

/* Exit status 2, one line on standard error that holds both words, nothing on standard output. */
static void expect_refusal(const char *word, const char *mend) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(2, result.status, result.err);
  TEST_ASSERT_EQUAL_STRING_MESSAGE("", result.out, result.err);
  const char *line_end = strchr(result.err, '\n');
  TEST_ASSERT_NOT_NULL_MESSAGE(line_end, result.err);
  TEST_ASSERT_EQUAL_STRING_MESSAGE("", line_end + 1, "more than one line");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, word), result.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, mend), result.err);
}

static void expect_bad_drawing(const char *drawing, const char *word) {
  write_file("bad.txt", drawing);
  run_tool(&result, "learn bad.txt -o t.qtr --c t.c --json=t.json");
  expect_refusal("bad.txt", word);
  TEST_ASSERT_FALSE(exists("t.qtr") || exists("t.c") || exists("t.json"));
}

static void expect_bad_mission(const char *mission, const char *word) {
  write_file("bad.yaml", mission);
  run_tool(&result, "learn bad.yaml -o t.qtr");
  expect_refusal("bad.yaml", word);
  TEST_ASSERT_FALSE(exists("t.qtr"));
}

/* ---- what it does ---- */

static void test_learning_writes_a_table_that_simulates_to_the_same_value(void) {
  run_tool(&result, "learn small.txt --robots 2 -o t.qtr --c t.c --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  run_tool(&other, "simulate t.qtr --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, other.status, other.err);
  TEST_ASSERT_DOUBLE_WITHIN(1e-8, json_value(result.out, "value"), json_value(other.out, "value"));
  TEST_ASSERT_DOUBLE_WITHIN(1e-8, json_value(result.out, "expected_time"), json_value(other.out, "expected_time"));
  TEST_ASSERT_EQUAL_DOUBLE(0.0, json_value(other.out, "off_table"));
  TEST_ASSERT_TRUE(exists("t.c"));
}

static void test_json_has_every_documented_key(void) {
  static const char *const keys[] = {"cells",   "places",  "robots",        "objective",       "gamma",     "rule",
                                     "value",   "gap",     "expected_time", "objective_value", "certified", "episodes",
                                     "updates", "q_bytes", "q_entries",     "objective_bound", "seconds",   "seed",
                                     "routes",  "seeker",  "steps"};
  run_tool(&result, "learn small.txt --robots 2 --json");
  run_tool(&other, "exact small.txt --robots 2 --json");
  for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
    json_text(result.out, keys[i]);
    json_text(other.out, keys[i]);
  }
}

static void test_a_run_repeats_to_the_byte(void) {
  static char first[1 << 16];
  run_tool(&result, "learn small.txt --robots 2 --quiet --c t.c");
  read_text("t.c", first, sizeof first);
  run_tool(&result, "learn small.txt --robots 2 --quiet --c t.c");
  read_text("t.c", result.out, sizeof result.out);
  TEST_ASSERT_EQUAL_STRING(first, result.out);
}

static void test_progress_and_report_keep_quiet_in_a_pipe(void) {
  run_tool(&result, "learn small.txt --robots 2 --quiet -o t.qtr");
  TEST_ASSERT_EQUAL_INT(0, result.status);
  TEST_ASSERT_EQUAL_STRING("", result.out);
  TEST_ASSERT_EQUAL_STRING("", result.err);
}

static void test_a_target_ends_the_game_when_it_is_found(void) {
  run_tool(&result, "learn small.txt --robots 2 -o t.qtr");
  run_tool(&result, "simulate t.qtr --target 2 --json");
  TEST_ASSERT_TRUE(json_value(result.out, "found_step") > 0.0);
  TEST_ASSERT_EQUAL_DOUBLE(1.0, json_value(result.out, "found_signals"));
}

static void test_a_survivor_takes_over_what_a_lost_robot_leaves(void) {
  run_tool(&result, "learn small.txt --robots 2 -o t.qtr");
  run_tool(&result, "simulate t.qtr --lost 0@0 --json");
  TEST_ASSERT_TRUE(json_is(result.out, "unvisited", "[]"));
}

/* A number of a CSV text, rows and columns counted from 0. */
static double curve_field(const char *text, int row, int column) {
  for (; row > 0; row--) text = strchr(text, '\n') + 1;
  for (; column > 0; column--) text = strchr(text, ',') + 1;
  return strtod(text, NULL);
}

static void test_a_curve_tells_how_the_learning_went(void) {
  static char text[1 << 16];
  run_tool(&result, "learn small.txt --robots 2 --learner paper --gap 0 --episodes 500 --curve c.csv --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  read_text("c.csv", text, sizeof text);
  TEST_ASSERT_EQUAL_INT(0, strncmp(text, "episode,max_q,value,expected_time,bound,updates,q_entries\n", 57));
  int rows = 0;
  for (const char *at = text; (at = strchr(at, '\n')) != NULL; at++) rows++;
  TEST_ASSERT_EQUAL_DOUBLE(1.0, curve_field(text, 1, 0));
  TEST_ASSERT_EQUAL_DOUBLE(500.0, curve_field(text, rows - 1, 0));
  for (int row = 2; row < rows; row++) {
    TEST_ASSERT_TRUE(curve_field(text, row, 0) > curve_field(text, row - 1, 0));
    TEST_ASSERT_TRUE(curve_field(text, row, 0) <= 1.05 * curve_field(text, row - 1, 0) + 1.0);
  }
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, json_value(result.out, "max_q"), curve_field(text, rows - 1, 1));
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, json_value(result.out, "value"), curve_field(text, rows - 1, 2));
  TEST_ASSERT_EQUAL_DOUBLE(json_value(result.out, "q_entries"), curve_field(text, rows - 1, 6));
}

/* MaxQ of the certified setting is a bound on what can be earned, also when no game was needed to prove it. */
static void test_the_certified_settings_max_q_is_its_bound(void) {
  run_tool(&result, "learn small.txt --robots 2 --json");
  TEST_ASSERT_TRUE(json_value(result.out, "max_q") >= json_value(result.out, "value") * (1 - 1e-9));
  TEST_ASSERT_DOUBLE_WITHIN(1e-4, json_value(result.out, "value"), json_value(result.out, "max_q"));
}

/* Section 5.2.3: MaxQ never falls while times are alike for all of a region, and keeps on going to and fro where they
 * are each cell's own. */
static int count_falls(const char *times) {
  static char text[1 << 18];
  int falls = 0;
  run_tool(&result,
           "learn '%s/demo/missions/paper/fig43d.txt' --robots 2 --learner paper --gap 0 --episodes 3000 --aggregate "
           "regions --explore epsilon:0.7 --region-times %s --curve c.csv -q",
           QUARTER_SOURCE_DIR, times);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  read_text("c.csv", text, sizeof text);
  const char *line = strchr(text, '\n') + 1;
  for (const char *next; (next = strchr(line, '\n')) != NULL && next[1] != '\0'; line = next + 1)
    falls += curve_field(next + 1, 0, 1) < curve_field(line, 0, 1) - 1e-6;
  return falls;
}

static void test_times_from_the_representative_end_the_oscillation(void) {
  TEST_ASSERT_EQUAL_INT(0, count_falls("representative"));
  TEST_ASSERT_GREATER_THAN_INT(10, count_falls("true"));
}

static void test_drawing_regions_tells_how_many_and_how_far(void) {
  run_tool(&result, "draw '%s/demo/missions/paper/fig53.txt' --regions -o r.svg --json", QUARTER_SOURCE_DIR);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_EQUAL_DOUBLE(657.0, json_value(result.out, "cells"));
  TEST_ASSERT_TRUE(json_value(result.out, "regions") <= 43.0);
  TEST_ASSERT_TRUE(json_value(result.out, "mean_distance") > 1.0);
}

static void test_pictures_of_missions_and_tables(void) {
  run_tool(&result, "learn small.txt --robots 2 -o t.qtr");
  run_tool(&result, "draw t.qtr -o t.svg");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  run_tool(&result, "draw small.txt -o s.svg");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
}

static void test_unreachable_places_are_named_or_left_out(void) {
  write_file("split.txt", "S.1#1\n...#3\n");
  run_tool(&result, "learn split.txt -o t.qtr");
  expect_refusal("place 1", "--skip-unreachable");
  TEST_ASSERT_NOT_NULL(strstr(result.err, "place 2"));
  TEST_ASSERT_FALSE(exists("t.qtr"));
  run_tool(&result, "learn split.txt --skip-unreachable --json");
  TEST_ASSERT_EQUAL_INT(0, result.status);
  TEST_ASSERT_EQUAL_DOUBLE(1.0, json_value(result.out, "places"));
  TEST_ASSERT_NOT_NULL(strstr(result.err, "place 2"));
}

/* ---- aggregation: what is reported is what the policy earns on the ground, whatever it was learnt on ---- */

#define MANY QUARTER_SOURCE_DIR "/tests/data/reference/case09.txt"
#define FEW QUARTER_SOURCE_DIR "/tests/data/reference/case03.txt"

static void expect_ground_value(const char *words) {
  run_tool(&result, "learn " MANY " --robots 4 %s -o t.qtr --json", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  run_tool(&other, "simulate t.qtr --json");
  /* Who is done early takes over from others: what is not optimal gets better by it, and never worse. */
  TEST_ASSERT_TRUE_MESSAGE(json_value(other.out, "value") >= json_value(result.out, "value") - 1e-7, words);
  TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(0.0, json_value(other.out, "off_table"), words);
  TEST_ASSERT_TRUE_MESSAGE(json_value(result.out, "objective_bound") >= 8.355621 * (1.0 - 1e-6), words);
  TEST_ASSERT_TRUE_MESSAGE(json_value(result.out, "value") <= 8.355622 * (1.0 + 1e-6), words);
}

static void test_value_is_the_grounds_under_every_aggregation(void) {
  expect_ground_value("--aggregate spots");
  expect_ground_value("--aggregate spots --spot-order nearest --spot-likelihood 0.5");
  expect_ground_value("--learner paper --episodes 300");
  expect_ground_value(
      "--learner paper --rule paper --episodes 300 --aggregate regions --region-size 9 --region-diameter 6");
  expect_ground_value("--learner paper --rule paper --episodes 300 --aggregate both --explore softmax:2:0.5:0.99");
}

/* Found on the ground: the best policy of these spots earns 8.16. */
static void test_search_on_the_ground_goes_on_from_what_spots_give(void) {
  run_tool(&result, "learn " MANY " --robots 4 --aggregate spots --episodes 1 --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_TRUE(json_value(result.out, "value") >= 8.355621 * (1.0 - 1e-3));
}

static void test_tuning_finds_what_loses_nothing_and_keeps_to_a_budget(void) {
  run_tool(&result, "tune small.txt --robots 2 --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_TRUE(json_value(result.out, "gap") < 1e-5);
  run_tool(&result, "tune " FEW " --robots 2 --learner paper --episodes 50 --budget-entries 20 --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  const char *tries = json_text(result.out, "tries");
  for (const char *at = tries; (at = strstr(at, "\"q_entries\"")) != NULL; at++)
    TEST_ASSERT_TRUE(json_value(at, "q_entries") <= 20.0); /* without a budget some have 104 */
  run_tool(&result, "tune " FEW " --robots 2 --learner paper --episodes 50 --budget-entries 1");
  expect_refusal("case03.txt", "--budget-entries");
}

static void test_a_table_for_any_start_answers_everywhere(void) {
  run_tool(&result, "learn small.txt --robots 2 --starts any --start-regions 4 -o t.qtr --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_EQUAL_DOUBLE(100.0, json_value(result.out, "trials"));
  TEST_ASSERT_TRUE(json_value(result.out, "worst_loss") >= 0.0);
  run_tool(&other, "simulate t.qtr --json");
  TEST_ASSERT_DOUBLE_WITHIN(1e-8, json_value(result.out, "value"), json_value(other.out, "value"));
  for (int cell = 0; cell < 16; cell++) {
    if (SMALL[cell / 4 * 5 + cell % 4] == '#') continue;
    run_tool(&other, "simulate t.qtr --from %d,%d --from 3,0 --json", cell % 4, cell / 4);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, json_value(other.out, "off_table"));
    TEST_ASSERT_TRUE(json_is(other.out, "unvisited", "[]"));
  }
  run_tool(&result, "simulate t.qtr --from 0,1 --from 0,0");
  expect_refusal("--from", "obstacle");
}

static void test_a_table_for_any_progress_resumes_on_the_table(void) {
  static const char *const cleared[] = {"0", "1", "2", "0,1", "0,2", "1,2"};
  run_tool(&result, "learn small.txt --robots 2 --cleared any -o t.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  for (int i = 0; i < 6; i++) {
    run_tool(&other, "simulate t.qtr --clear %s --json", cleared[i]);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, json_value(other.out, "off_table"));
    TEST_ASSERT_TRUE(json_is(other.out, "unvisited", "[]"));
  }
}

static void test_a_table_too_large_is_refused_with_its_size(void) {
  run_tool(&result, "learn " MANY " --robots 4 --starts any --start-regions 20 --cleared any -o t.qtr");
  expect_refusal("--table-limit", "MB");
  TEST_ASSERT_FALSE(exists("t.qtr"));
}

static void test_regions_are_drawn(void) {
  run_tool(&result, "draw small.txt --regions --region-size 4 --region-diameter 3 -o t.svg");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
}

static void test_bad_aggregations(void) {
  run_tool(&result, "learn small.txt --aggregate regions");
  expect_refusal("--aggregate", "--learner paper");
  run_tool(&result, "learn small.txt --aggregate heaps");
  expect_refusal("heaps", "spots");
  run_tool(&result, "learn small.txt --spot-size 0");
  expect_refusal("--spot-size", "1");
  run_tool(&result, "learn small.txt --spot-size 9");
  expect_refusal("--spot-size", "8");
  run_tool(&result, "learn small.txt --spot-diameter 0");
  expect_refusal("--spot-diameter", "1");
  run_tool(&result, "learn small.txt --region-size 0");
  expect_refusal("--region-size", "1");
  run_tool(&result, "learn small.txt --region-diameter 99999999");
  expect_refusal("--region-diameter", "1");
  run_tool(&result, "learn small.txt --learner paper --explore epsilon:2");
  expect_refusal("--explore", "0 to 1");
  run_tool(&result, "learn small.txt --learner paper --alpha 0");
  expect_refusal("--alpha", "above 0");
}

/* ---- bad input ---- */

static void test_bad_drawings(void) {
  expect_bad_drawing("", "empty");
  expect_bad_drawing("S..\n.1\n", "2");
  expect_bad_drawing("S.?\n.1.\n", "?");
  expect_bad_drawing("...\n.1.\n", "S");
  expect_bad_drawing("S..\n...\n", "place");
}

static void test_bad_missions(void) {
  expect_bad_mission("map: small.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 0, row: 1, weight: 1}]\n",
                     "place 0");
  expect_bad_mission("map: small.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 9, row: 1, weight: 1}]\n",
                     "bad.yaml:3");
  expect_bad_mission("map: small.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 1, weight: 1},\n"
                     "  {column: 1, row: 1, weight: 2}]\n",
                     "place 1");
  expect_bad_mission("map: small.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 1, weight: 0}]\n",
                     "weight");
  expect_bad_mission("map: small.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 1, weight: .nan}]\n",
                     "weight");
  expect_bad_mission("map: small.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 1, weight: 1e999}]\n",
                     "weight");
  expect_bad_mission("map: small.txt\nrobots: []\nplaces: [{column: 1, row: 1}]\n", "robots");
  expect_bad_mission("map: small.txt\ngamma: 1\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 1}]\n",
                     "gamma");
  expect_bad_mission("map: small.txt\nrobtos: [{column: 0, row: 0}]\n", "robtos");
  expect_bad_mission("map: nowhere.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 1}]\n", "nowhere.txt");
  expect_bad_mission("map: [1\n", "bad.yaml:");
}

static void test_more_than_the_build_holds(void) {
  static char drawing[2048] = "S";
  memset(drawing + 1, '1', 1100);
  drawing[1101] = '\0';
  expect_bad_drawing(drawing, "QTR_MAX_PLACES");
  run_tool(&result, "learn small.txt --robots 99");
  expect_refusal("QTR_MAX_SEEKERS", "--robots");
}

static void test_bad_words_on_the_command_line(void) {
  run_tool(&result, "learn");
  expect_refusal("quarter", "--help");
  run_tool(&result, "learn small.txt --frobnicate");
  expect_refusal("--frobnicate", "--help");
  run_tool(&result, "learn small.txt --target 1");
  expect_refusal("--target", "--help");
  run_tool(&result, "learn small.txt --robots 0");
  expect_refusal("--robots", "1");
  run_tool(&result, "learn small.txt --gamma 1");
  expect_refusal("--gamma", "below 1");
  run_tool(&result, "learn small.txt --gamma nan");
  expect_refusal("--gamma", "below 1");
  run_tool(&result, "learn small.txt --objective speed");
  expect_refusal("speed", "time");
  run_tool(&result, "learn small.txt small.txt");
  expect_refusal("small.txt", "one input");
  run_tool(&result, "fly small.txt");
  expect_refusal("fly", "--help");
  run_tool(&result, "learn nowhere.txt -o t.qtr");
  expect_refusal("nowhere.txt", "no such file");
}

static void test_outputs_that_cannot_be_written(void) {
  run_tool(&result, "learn small.txt --robots 2 -o nowhere/t.qtr");
  expect_refusal("nowhere/t.qtr", "folder");
  run_tool(&result, "learn small.txt --robots 2 -o .");
  expect_refusal(".", "name a file");
  run_tool(&result, "learn small.txt --robots 2 --quiet -o /dev/full");
  expect_refusal("/dev/full", "space");
  TEST_ASSERT_TRUE(access("/dev/full", W_OK) == 0);
  run_tool(&result, "learn small.txt --robots 2 --json=/dev/full");
  expect_refusal("/dev/full", "space");
}

static void test_tables_that_are_none(void) {
  run_tool(&result, "simulate small.txt");
  expect_refusal("small.txt", "not a Quarter policy table");
  run_tool(&result, "learn small.txt --robots 2 -o t.qtr --quiet");
  TEST_ASSERT_EQUAL_INT(0, system("head -c 200 t.qtr >cut.qtr"));
  run_tool(&result, "inspect cut.qtr");
  expect_refusal("cut.qtr", "cut short");
  TEST_ASSERT_EQUAL_INT(0, system("{ head -c 150 t.qtr; printf X; tail -c +152 t.qtr; } >flipped.qtr"));
  run_tool(&result, "simulate flipped.qtr");
  expect_refusal("flipped.qtr", "checksum");
  run_tool(&result, "simulate t.qtr --lost 7@1");
  expect_refusal("--lost", "robots 0 to 1");
  run_tool(&result, "simulate t.qtr --target 3");
  expect_refusal("--target", "places 0 to 2");
  run_tool(&result, "simulate t.qtr --late 1");
  expect_refusal("--late", "SEEKER:+STEPS");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learning_writes_a_table_that_simulates_to_the_same_value);
  RUN_TEST(test_json_has_every_documented_key);
  RUN_TEST(test_a_run_repeats_to_the_byte);
  RUN_TEST(test_progress_and_report_keep_quiet_in_a_pipe);
  RUN_TEST(test_a_target_ends_the_game_when_it_is_found);
  RUN_TEST(test_a_survivor_takes_over_what_a_lost_robot_leaves);
  RUN_TEST(test_a_curve_tells_how_the_learning_went);
  RUN_TEST(test_the_certified_settings_max_q_is_its_bound);
  RUN_TEST(test_times_from_the_representative_end_the_oscillation);
  RUN_TEST(test_drawing_regions_tells_how_many_and_how_far);
  RUN_TEST(test_pictures_of_missions_and_tables);
  RUN_TEST(test_unreachable_places_are_named_or_left_out);
  RUN_TEST(test_value_is_the_grounds_under_every_aggregation);
  RUN_TEST(test_search_on_the_ground_goes_on_from_what_spots_give);
  RUN_TEST(test_tuning_finds_what_loses_nothing_and_keeps_to_a_budget);
  RUN_TEST(test_a_table_for_any_start_answers_everywhere);
  RUN_TEST(test_a_table_for_any_progress_resumes_on_the_table);
  RUN_TEST(test_a_table_too_large_is_refused_with_its_size);
  RUN_TEST(test_regions_are_drawn);
  RUN_TEST(test_bad_aggregations);
  RUN_TEST(test_bad_drawings);
  RUN_TEST(test_bad_missions);
  RUN_TEST(test_more_than_the_build_holds);
  RUN_TEST(test_bad_words_on_the_command_line);
  RUN_TEST(test_outputs_that_cannot_be_written);
  RUN_TEST(test_tables_that_are_none);
  return UNITY_END();
}
