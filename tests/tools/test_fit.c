/* `--profile`: what a table takes on a robot, and that one which does not fit is told before any work, and not
 * written. */
#include <unistd.h>

#include "support/tool_run.h"

/* 5 x 4 cells can be reached, of 7 x 4; the mission's 3 places. */
#define MAP "S...##.\n#1.3.#.\n...###.\n1...##.\n"

static tool_result result;

void setUp(void) {
  write_file("map.txt", MAP);
  remove("t.qtr");
  remove("t.c");
}

void tearDown(void) {
}

/* The line of standard error. */
static void expect_unfit(const char *says) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(5, result.status, result.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, says), result.err);
}

static void write_sizes(int cells, int places, int seekers) {
  char text[200];
  snprintf(text, sizeof text, "#define QTR_MAX_CELLS %d\n#define QTR_MAX_PLACES %d\n#define QTR_MAX_SEEKERS %d\n",
           cells, places, seekers);
  write_file("mine.h", text);
}

static void test_a_table_that_fits_tells_what_it_takes(void) {
  run_tool(&result, "learn map.txt --robots 2 -o t.qtr --profile mcu");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.out, "fits mcu: "), result.out);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.out, "QTR_MAX_CELLS=20 QTR_MAX_PLACES=3 QTR_MAX_SEEKERS=2\n"), result.out);
  TEST_ASSERT_EQUAL_INT(0, access("t.qtr", F_OK));
}

static void test_json_has_the_figures(void) {
  run_tool(&result, "learn map.txt --robots 2 --c t.c --profile mcu --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_TRUE(json_is(result.out, "fits", "true"));
  TEST_ASSERT_TRUE(json_is(json_text(result.out, "needed"), "QTR_MAX_CELLS", "20"));
  const char *ram = json_text(result.out, "ram_bytes");
  TEST_ASSERT_EQUAL_DOUBLE(json_value(ram, "all"),
                           json_value(ram, "policy") + json_value(ram, "seeker") + json_value(ram, "field"));
  char source[3000], size[80];
  read_text("t.c", source, sizeof source);
  snprintf(size, sizeof size, "const uint32_t t_size = %.0f;", json_value(result.out, "flash_bytes"));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(source, size), size);
}

static void test_without_the_option_nothing_is_said(void) {
  run_tool(&result, "learn map.txt --robots 2");
  TEST_ASSERT_NULL(strstr(result.out, "fits"));
  run_tool(&result, "learn map.txt --robots 2 --json");
  TEST_ASSERT_NULL(strstr(result.out, "profile"));
}

static void test_each_size_is_needed_to_the_last(void) {
  write_sizes(20, 3, 2);
  run_tool(&result, "learn map.txt --robots 2 -q --profile mine.h");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  write_sizes(19, 3, 2);
  run_tool(&result, "learn map.txt --robots 2 -o t.qtr --c t.c --profile mine.h");
  expect_unfit("map.txt: does not fit --profile mine.h: raise QTR_MAX_CELLS from 19 to 20\n");
  TEST_ASSERT_EQUAL_STRING("", result.out);
  TEST_ASSERT_FALSE(access("t.qtr", F_OK) == 0 || access("t.c", F_OK) == 0);
  write_sizes(20, 2, 1);
  run_tool(&result, "learn map.txt --robots 2 -q --profile mine.h");
  expect_unfit("raise QTR_MAX_PLACES from 2 to 3\n");
  expect_unfit("raise QTR_MAX_SEEKERS from 1 to 2\n");
}

/* Robots that may start anywhere are told of all of the map. */
static void test_a_table_for_any_start_needs_the_whole_map(void) {
  write_sizes(28, 3, 1);
  run_tool(&result, "learn map.txt -q -o t.qtr --starts any --profile mine.h");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  run_tool(&result, "inspect t.qtr -q --profile mine.h");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  write_sizes(27, 3, 1);
  run_tool(&result, "inspect t.qtr --profile mine.h --json");
  expect_unfit("t.qtr: does not fit --profile mine.h: raise QTR_MAX_CELLS from 27 to 28\n");
  TEST_ASSERT_TRUE(json_is(result.out, "fits", "false"));
  run_tool(&result, "learn map.txt -q -o t.qtr --starts any --profile mine.h");
  expect_unfit("raise QTR_MAX_CELLS from 27 to 28\n");
}

static void test_a_profile_that_cannot_be_read_is_bad_input(void) {
  run_tool(&result, "learn map.txt -o t.qtr --profile avr");
  TEST_ASSERT_EQUAL_INT(2, result.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "avr: no such file"), result.err);
  run_tool(&result, "learn map.txt -o t.qtr --profile map.txt");
  TEST_ASSERT_EQUAL_INT(2, result.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "states none of QTR_MAX_CELLS"), result.err);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_table_that_fits_tells_what_it_takes);
  RUN_TEST(test_json_has_the_figures);
  RUN_TEST(test_without_the_option_nothing_is_said);
  RUN_TEST(test_each_size_is_needed_to_the_last);
  RUN_TEST(test_a_table_for_any_start_needs_the_whole_map);
  RUN_TEST(test_a_profile_that_cannot_be_read_is_bad_input);
  return UNITY_END();
}
