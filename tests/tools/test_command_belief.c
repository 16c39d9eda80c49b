/* `quarter belief`: weights from a history of games, the belief saved from one time to the next, and every bad history
 * told in one line with nothing written. */
#include <math.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/tool_run.h"

/* Places: 0 at column 1, row 1, weight 1; 1 at column 3, row 1, weight 3; 2 at column 0, row 3, weight 1. */
#define SMALL "S...\n#1.3\n...#\n1...\n"

static tool_result result;

void setUp(void) {
  write_file("small.txt", SMALL);
  write_file("even.txt", "S...\n#1.1\n...#\n1...\n");
  remove("places.csv");
  remove("b.qtb");
  remove("r.json");
}

void tearDown(void) {
}

static int exists(const char *path) {
  struct stat about;
  return stat(path, &about) == 0;
}

static void expect_success(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_EQUAL_STRING("", result.err);
}

/* Exit status 2, one line that holds both texts, nothing printed. */
static void expect_refusal(const char *what, const char *mend) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(2, result.status, result.err);
  TEST_ASSERT_EQUAL_STRING("", result.out);
  const char *line_end = strchr(result.err, '\n');
  TEST_ASSERT_NOT_NULL_MESSAGE(line_end, result.err);
  TEST_ASSERT_EQUAL_STRING_MESSAGE("", line_end + 1, "more than one line");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, what), result.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, mend), result.err);
}

/* The history is refused with a line that holds both texts, and nothing is written. */
static void expect_bad_history(const char *history, const char *what, const char *mend) {
  write_file("bad.csv", history);
  run_tool(&result, "belief small.txt --history bad.csv --belief b.qtb -o places.csv --json=r.json");
  expect_refusal(what, mend);
  TEST_ASSERT_FALSE(exists("places.csv") || exists("b.qtb") || exists("r.json"));
}

/* The estimates of places 0, 1 and 2 in the JSON of the last run. */
static void expect_estimates(double first, double second, double third) {
  const double expected[3] = {first, second, third};
  const char *at = json_text(result.out, "place");
  for (int place = 0; place < 3; place++) {
    at = json_text(at, "estimate");
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, expected[place], strtod(at, NULL));
  }
}

static void learn_from(const char *input, const char *history, const char *options) {
  write_file("games.csv", history);
  run_tool(&result, "belief %s --history games.csv --json %s", input, options);
  expect_success();
}

/* ---- what it estimates ---- */

static void test_finds_shift_the_mission_s_weights(void) {
  learn_from("small.txt", "game,place,found\n1,0,1\n2,0,1\n3,2,1\n", "--prior 5");
  expect_estimates(3.0 / 8, 3.0 / 8, 2.0 / 8); /* 1 + 2, 3 + 0, 1 + 1 of 5 + 3 */
  TEST_ASSERT_EQUAL_INT(3, (int)json_value(result.out, "games"));
  TEST_ASSERT_EQUAL_INT(3, (int)json_value(result.out, "finds"));
}

static void test_the_prior_counts_half_a_find_a_place_by_default(void) {
  learn_from("even.txt", "place\n1\n", "");
  expect_estimates(0.2, 0.6, 0.2); /* 0.5, 1.5, 0.5 of 2.5 */
  TEST_ASSERT_EQUAL_DOUBLE(1.5, json_value(result.out, "prior"));
}

static void test_a_place_is_named_by_number_cell_or_point(void) {
  learn_from("even.txt", "place\n1\n1\n2\n", "");
  expect_estimates(0.5 / 4.5, 2.5 / 4.5, 1.5 / 4.5);
  learn_from("even.txt", "found\n1\n1\n2\n", "");
  expect_estimates(0.5 / 4.5, 2.5 / 4.5, 1.5 / 4.5);
  learn_from("even.txt", "column,row\n3,1\n3,1\n0,3\n", "");
  expect_estimates(0.5 / 4.5, 2.5 / 4.5, 1.5 / 4.5);
  learn_from("even.txt", "y,x\n2.5,3.5\n2,3\n0.9,0.1\n", ""); /* y points up; the lower left corner is the cell's */
  expect_estimates(0.5 / 4.5, 2.5 / 4.5, 1.5 / 4.5);
}

static void test_layout_is_a_matter_of_taste(void) {
  learn_from("even.txt",
             "\xef\xbb\xbf# two games\r\n\r\n \"found\" , game ,place\r\n yes,a, \"1\"\r\ntrue,b,1\r\nno,b,0", "");
  expect_estimates(0.5 / 3.5, 2.5 / 3.5, 0.5 / 3.5);
  TEST_ASSERT_EQUAL_INT(2, (int)json_value(result.out, "games"));
}

static void test_a_game_without_a_find_counts_for_the_places_not_searched(void) {
  learn_from("even.txt", "game,place,found\n1,1,0\n", "");
  expect_estimates(0.4, 0.2, 0.4); /* half a find for each of the others */
  TEST_ASSERT_EQUAL_INT(1, (int)json_value(result.out, "games_without_find"));
  learn_from("even.txt", "game,place,found\n1,1,0\n", "--detection 0.5");
  expect_estimates(0.9 / 2.5, 0.7 / 2.5, 0.9 / 2.5); /* shares 2 : 1 : 2 of one find */
}

/* Detection 0.5 at place 1 leaves half of it, another look a quarter; place 2 has the mission's 0.8. */
#define MISSING                                                                                                        \
  "map: even.txt\ndetection: 0.8\nlooks: 2\nscan_seconds: 1\nrobots: [{column: 0, row: 0}]\n"                          \
  "places:\n - {column: 1, row: 1, name: Bay}\n - {column: 3, row: 1, detection: 0.5, scan_seconds: 4}\n"              \
  " - {column: 0, row: 3, looks: 1}\n"

static void test_looks_in_vain_count_by_each_place_s_own_detection(void) {
  write_file("miss.yaml", MISSING);
  learn_from("miss.yaml", "game,place,found\n1,1,0\n", "");
  expect_estimates(0.9 / 2.5, 0.7 / 2.5, 0.9 / 2.5);
  learn_from("miss.yaml", "game,place,found,looks\n1,1,0,2\n1,2,0,1\n", ""); /* shares 1 : 0.25 : 0.2 of one find */
  expect_estimates((0.5 + 1 / 1.45) / 2.5, (0.5 + 0.25 / 1.45) / 2.5, (0.5 + 0.2 / 1.45) / 2.5);
  TEST_ASSERT_TRUE(json_is(result.out, "detection", "null"));
  learn_from("miss.yaml", "game,place,found\n1,Bay,0\n1,Bay (look 2),0\n", ""); /* 0.04 : 1 : 1 */
  expect_estimates((0.5 + 0.04 / 2.04) / 2.5, (0.5 + 1 / 2.04) / 2.5, (0.5 + 1 / 2.04) / 2.5);
  TEST_ASSERT_EQUAL_INT(2, (int)json_value(result.out, "looks_in_vain"));
  learn_from("miss.yaml", "game,place,found\n1,1,0\n", "--detection 1"); /* the option over the mission */
  expect_estimates(0.4, 0.2, 0.4);
}

static void test_looks_before_the_find_change_nothing(void) {
  write_file("miss.yaml", MISSING);
  learn_from("miss.yaml", "game,place,found,looks\n1,0,0,2\n1,1,1,2\n", "");
  expect_estimates(0.2, 0.6, 0.2);
}

static void test_the_places_written_keep_what_they_say_of_scans_and_looks(void) {
  write_file("miss.yaml", MISSING);
  write_file("games.csv", "place\n1\n");
  run_tool(&result, "belief miss.yaml --history games.csv -o places.csv --quiet");
  expect_success();
  read_text("places.csv", result.out, sizeof result.out);
  TEST_ASSERT_EQUAL_STRING("column,row,weight,name,scan_seconds,detection,looks\n1,1,0.2,Bay,,0.8,2\n"
                           "3,1,0.6,,4,0.5,2\n0,3,0.2,,,0.8,1\n",
                           result.out);
  write_file("next.yaml", "map: even.txt\nplaces_csv: places.csv\nscan_seconds: 1\nrobots: [{column: 0, row: 0}]\n");
  run_tool(&result, "learn next.yaml --json");
  expect_success();
}

static void test_what_was_searched_before_the_find_changes_nothing(void) {
  learn_from("even.txt", "game,place,found\n1,0,0\n1,2,0\n1,1,1\n", "");
  expect_estimates(0.2, 0.6, 0.2);
}

static void test_old_finds_may_fade(void) {
  learn_from("even.txt", "place\n0\n2\n", "--keep 0.5");
  expect_estimates(1.0 / 3, 0.5 / 3, 1.5 / 3);
}

static void test_many_games_bring_the_hider_s_habits_to_light(void) {
  FILE *file = fopen("many.csv", "w");
  TEST_ASSERT_NOT_NULL(file);
  fputs("place\n", file);
  for (int game = 0; game < 1000; game++) fputs(game % 10 < 6 ? "2\n" : game % 10 < 9 ? "0\n" : "1\n", file);
  fclose(file);
  run_tool(&result, "belief small.txt --history many.csv --json");
  expect_success();
  const char *at = json_text(result.out, "place");
  const double truth[3] = {0.3, 0.1, 0.6};
  for (int place = 0; place < 3; place++) {
    at = json_text(at, "estimate");
    TEST_ASSERT_DOUBLE_WITHIN(0.002, truth[place], strtod(at, NULL));
  }
}

/* ---- what it writes ---- */

static void test_the_places_it_writes_are_a_mission_s_places(void) {
  write_file("games.csv", "place\n0\n0\n0\n");
  run_tool(&result, "belief small.txt --history games.csv --prior 5 -o places.csv --quiet");
  expect_success();
  TEST_ASSERT_EQUAL_STRING("", result.out);
  read_text("places.csv", result.out, sizeof result.out);
  TEST_ASSERT_EQUAL_STRING("column,row,weight\n1,1,0.5\n3,1,0.375\n0,3,0.125\n", result.out);
  write_file("next.yaml", "map: small.txt\nplaces_csv: places.csv\nrobots: [{column: 0, row: 0}]\n");
  run_tool(&result, "belief next.yaml --history games.csv --prior 5 --json");
  expect_success();
  expect_estimates(5.5 / 8, 1.875 / 8, 0.625 / 8);
  run_tool(&result, "learn next.yaml --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
}

static void test_places_on_a_map_with_metres_are_written_in_metres(void) {
  write_file("map.pgm", "P2 4 2 255\n255 255 255 255\n255 255 255 255\n");
  write_file("map.yaml", "image: map.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                         "free_thresh: 0.196\n");
  write_file("metric.yaml", "map: map.yaml\nrobots: [{column: 0, row: 0}]\n"
                            "places: [{x: 0.75, y: 2.1, weight: 1}, {x: -0.6, y: 2.9, weight: 1}]\n");
  write_file("games.csv", "x,y,found\n0.51,2.49,1\n");
  run_tool(&result, "belief metric.yaml --history games.csv -o -");
  expect_success();
  TEST_ASSERT_EQUAL_STRING("x,y,weight\n0.75,2.25,0.75\n-0.75,2.75,0.25\n", result.out);
}

static void test_text_and_json_tell_the_same(void) {
  write_file("games.csv", "place\n1\n");
  run_tool(&result, "belief even.txt --history games.csv --json=r.json");
  expect_success();
  TEST_ASSERT_NOT_NULL(strstr(result.out, "1 game with 1 find, 0 without any"));
  TEST_ASSERT_NOT_NULL(strstr(result.out, "place 1 (column 3, row 1): 0.3333 -> 0.6, found 1 time"));
  read_text("r.json", result.out, sizeof result.out);
  expect_estimates(0.2, 0.6, 0.2);
}

/* ---- the saved belief ---- */

static void test_a_saved_belief_goes_on_where_it_was(void) {
  learn_from("even.txt", "place\n0\n1\n", "--belief b.qtb --prior 3");
  TEST_ASSERT_TRUE(json_is(result.out, "resumed", "false"));
  learn_from("even.txt", "place\n1\n1\n", "--belief b.qtb");
  TEST_ASSERT_TRUE(json_is(result.out, "resumed", "true"));
  TEST_ASSERT_EQUAL_INT(2, (int)json_value(result.out, "games"));
  TEST_ASSERT_EQUAL_INT(4, (int)json_value(result.out, "games_in_all"));
  expect_estimates(2.0 / 7, 4.0 / 7, 1.0 / 7);
  run_tool(&result, "belief even.txt --belief b.qtb --json");
  expect_success();
  expect_estimates(2.0 / 7, 4.0 / 7, 1.0 / 7);
}

static void test_a_refused_history_leaves_the_saved_belief_alone(void) {
  learn_from("even.txt", "place\n0\n1\n", "--belief b.qtb");
  write_file("bad.csv", "place\n0\n9\n");
  run_tool(&result, "belief even.txt --belief b.qtb --history bad.csv");
  expect_refusal("bad.csv:3: ", "number 9");
  run_tool(&result, "belief even.txt --belief b.qtb --json");
  TEST_ASSERT_EQUAL_INT(2, (int)json_value(result.out, "games_in_all"));
}

static void test_what_cannot_be_written_leaves_the_saved_belief_alone(void) {
  learn_from("even.txt", "place\n0\n1\n", "--belief b.qtb");
  run_tool(&result, "belief even.txt --belief b.qtb --history games.csv -o nowhere/places.csv");
  expect_refusal("nowhere/places.csv", "make its folder first");
  run_tool(&result, "belief even.txt --belief nowhere/b.qtb --history games.csv -o places.csv");
  expect_refusal("nowhere/b.qtb", "make its folder first");
  TEST_ASSERT_FALSE(exists("places.csv"));
  run_tool(&result, "belief even.txt --belief b.qtb --json");
  TEST_ASSERT_EQUAL_INT(2, (int)json_value(result.out, "games_in_all"));
}

static void test_beliefs_that_are_none_or_another_s_are_refused(void) {
  char bytes[40];
  learn_from("even.txt", "place\n0\n", "--belief b.qtb");
  write_file("other.txt", "S...\n#1.1\n...#\n.1..\n");
  run_tool(&result, "belief other.txt --belief b.qtb");
  expect_refusal("b.qtb: ", "another mission's places");
  run_tool(&result, "belief even.txt --belief b.qtb --prior 4");
  expect_refusal("b.qtb: ", "leave --prior out");
  run_tool(&result, "belief even.txt --belief small.txt");
  expect_refusal("small.txt: ", "not a saved belief");
  FILE *file = fopen("b.qtb", "rb");
  TEST_ASSERT_NOT_NULL(file);
  TEST_ASSERT_EQUAL_size_t(sizeof bytes, fread(bytes, 1, sizeof bytes, file));
  fclose(file);
  file = fopen("b.qtb", "wb");
  fwrite(bytes, 1, sizeof bytes, file);
  fclose(file);
  run_tool(&result, "belief even.txt --belief b.qtb");
  expect_refusal("b.qtb: ", "cut short");
}

/* ---- bad input ---- */

static void test_unknown_places_are_refused(void) {
  expect_bad_history("place\n0\n3\n", "bad.csv:3: ", "its places are 0 to 2");
  expect_bad_history("place\n-1\n", "bad.csv:2: ", "number -1");
  expect_bad_history("place\nshed\n", "bad.csv:2: the place \"shed\"", "0 to 2");
  expect_bad_history("place\n1.5\n", "bad.csv:2: ", "0 to 2");
  expect_bad_history("column,row\n1,1\n2,2\n", "bad.csv:3: ", "column 2, row 2");
  expect_bad_history("x,y\n1.5,2.5\n100,-3\n", "bad.csv:3: ", "x 100, y -3");
  expect_bad_history("x,y\nnan,1\n", "bad.csv:2: the x \"nan\"", "write a number");
}

static void test_malformed_rows_are_refused(void) {
  expect_bad_history("game,place,found\n1,0\n", "bad.csv:2: the line has 2 fields and the header 3", "commas");
  expect_bad_history("place\n0,1\n", "bad.csv:2: the line has 2 fields and the header 1", "commas");
  expect_bad_history("place,found\n0,maybe\n", "bad.csv:2: found is \"maybe\"", "write 1");
  expect_bad_history("place,found\n0,\n", "bad.csv:2: found is \"\"", "write 1");
  expect_bad_history("game,place\n,0\n", "bad.csv:2: ", "no name");
  expect_bad_history("place,found,looks\n0,0,0\n", "bad.csv:2: looks is \"0\"", "1 to");
  expect_bad_history("place,found,looks\n0,0,\n", "bad.csv:2: looks is \"\"", "how many");
  expect_bad_history("place\n0 (look x)\n", "bad.csv:2: the place \"0 (look x)\"", "0 to 2");
}

static void test_headers_that_are_none_are_refused(void) {
  expect_bad_history("1,0,1\n", "bad.csv:1: ", "game,place,found");
  expect_bad_history("game,plaec\n1,0\n", "bad.csv:1: ", "write \"place\"");
  expect_bad_history("game,found\n1,0\n", "bad.csv:1: ", "name the place");
  expect_bad_history("place,column,row\n0,1,1\n", "bad.csv:1: ", "in one way");
  expect_bad_history("column\n1\n", "bad.csv:1: ", "column,row");
  expect_bad_history("place,place\n1,1\n", "bad.csv:1: two columns are \"place\"", "drop one");
  expect_bad_history("place\n", "bad.csv: ", "no game");
  expect_bad_history("# nothing\n", "bad.csv: ", "no header");
  expect_bad_history("", "bad.csv: ", "empty");
}

static void test_games_that_cannot_be_are_refused(void) {
  expect_bad_history("game,place,found\n7,0,0\n7,1,0\n7,2,0\n8,0,1\n", "bad.csv:2: ", "--detection");
  expect_bad_history("game,place\n1,0\n2,0\n1,2\n", "bad.csv:4: game \"1\" has ended", "line 2");
}

static void test_files_and_options_that_are_wrong_are_refused(void) {
  write_file("games.csv", "place\n1\n");
  run_tool(&result, "belief small.txt");
  expect_refusal("belief: ", "--history");
  run_tool(&result, "belief small.txt --belief none.qtb");
  expect_refusal("none.qtb: ", "--history");
  run_tool(&result, "belief small.txt --history none.csv");
  expect_refusal("none.csv: ", "check its name");
  run_tool(&result, "belief none.yaml --history games.csv");
  expect_refusal("none.yaml: ", "check its name");
  run_tool(&result, "belief small.txt --history games.csv --prior 0");
  expect_refusal("--prior 0: ", "from 1e-6");
  run_tool(&result, "belief small.txt --history games.csv --keep 2");
  expect_refusal("--keep 2: ", "up to 1");
  run_tool(&result, "belief small.txt --history games.csv --detection -1");
  expect_refusal("--detection -1: ", "from 0 to 1");
}

static void test_nothing_is_written_over_what_is_read(void) {
  write_file("games.csv", "place\n1\n");
  run_tool(&result, "belief small.txt --history games.csv -o games.csv");
  expect_refusal("games.csv", "name another file");
  run_tool(&result, "belief small.txt --history games.csv -o small.txt");
  expect_refusal("small.txt", "name another file");
  run_tool(&result, "belief small.txt --history games.csv --belief b.qtb -o b.qtb");
  expect_refusal("b.qtb", "name another file");
  run_tool(&result, "belief small.txt --history games.csv --belief -");
  expect_refusal("--belief -", "name a file");
  run_tool(&result, "belief small.txt --history games.csv --json -o -");
  expect_refusal("-", "name another file");
  read_text("games.csv", result.out, sizeof result.out);
  TEST_ASSERT_EQUAL_STRING("place\n1\n", result.out);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_finds_shift_the_mission_s_weights);
  RUN_TEST(test_the_prior_counts_half_a_find_a_place_by_default);
  RUN_TEST(test_a_place_is_named_by_number_cell_or_point);
  RUN_TEST(test_layout_is_a_matter_of_taste);
  RUN_TEST(test_a_game_without_a_find_counts_for_the_places_not_searched);
  RUN_TEST(test_what_was_searched_before_the_find_changes_nothing);
  RUN_TEST(test_looks_in_vain_count_by_each_place_s_own_detection);
  RUN_TEST(test_looks_before_the_find_change_nothing);
  RUN_TEST(test_the_places_written_keep_what_they_say_of_scans_and_looks);
  RUN_TEST(test_old_finds_may_fade);
  RUN_TEST(test_many_games_bring_the_hider_s_habits_to_light);
  RUN_TEST(test_the_places_it_writes_are_a_mission_s_places);
  RUN_TEST(test_places_on_a_map_with_metres_are_written_in_metres);
  RUN_TEST(test_text_and_json_tell_the_same);
  RUN_TEST(test_a_saved_belief_goes_on_where_it_was);
  RUN_TEST(test_a_refused_history_leaves_the_saved_belief_alone);
  RUN_TEST(test_what_cannot_be_written_leaves_the_saved_belief_alone);
  RUN_TEST(test_beliefs_that_are_none_or_another_s_are_refused);
  RUN_TEST(test_unknown_places_are_refused);
  RUN_TEST(test_malformed_rows_are_refused);
  RUN_TEST(test_headers_that_are_none_are_refused);
  RUN_TEST(test_games_that_cannot_be_are_refused);
  RUN_TEST(test_files_and_options_that_are_wrong_are_refused);
  RUN_TEST(test_nothing_is_written_over_what_is_read);
  return UNITY_END();
}
