/* Sizes from a robot's own config header: read as the compiler takes it, or refused. */
#include "host/table/config_header.h"
#include "support/tool_run.h"

static robot_sizes sizes;
static fault why;

void setUp(void) {
  sizes = (robot_sizes){{10, 20, 30}};
}

void tearDown(void) {
}

static void expect(uint32_t cells, uint32_t places, uint32_t seekers, const char *text) {
  write_file("mine.h", text);
  why.text[0] = '\0';
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, config_header_read(&sizes, "mine.h", &why), why.text);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(cells, sizes.of[ROBOT_CELLS], text);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(places, sizes.of[ROBOT_PLACES], text);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(seekers, sizes.of[ROBOT_SEEKERS], text);
}

static void refuse(const char *where, const char *says, const char *text) {
  write_file("mine.h", text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, config_header_read(&sizes, "mine.h", &why), text);
  TEST_ASSERT_EQUAL_STRING_LEN_MESSAGE(where, why.text, strlen(where), why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, says), why.text);
}

static void test_what_is_stated_is_taken_and_the_rest_stays(void) {
  expect(400, 20, 30, "#define QTR_MAX_CELLS 400\n");
  expect(400, 8, 2, "#define QTR_MAX_PLACES 8\n#define QTR_MAX_SEEKERS 2");
  expect(1, 8, 2, "\xef\xbb\xbf#define QTR_MAX_CELLS 1\r\n");
}

static void test_numbers_are_as_c_writes_them(void) {
  expect(1024, 16, 8,
         "# define\tQTR_MAX_CELLS 0x400u\n  #define QTR_MAX_PLACES 16ul /* few */\n#define QTR_MAX_SEEKERS 010 // 8");
}

static void test_the_largest_sizes_are_taken(void) {
  expect(16777216, 4096, 64,
         "#define QTR_MAX_CELLS 16777216\n#define QTR_MAX_PLACES 4096\n#define QTR_MAX_SEEKERS 64\n");
}

static void test_guards_are_seen_through(void) {
  expect(400, 20, 2,
         "#ifndef MINE_H\n/* a\n#define QTR_MAX_CELLS 7\n*/\n#define MINE_H\n#include <stdint.h>\n#ifdef "
         "DEBUG\n#define LOG 1\n"
         "#else\n#define LOG 0\n#endif\n#define QTR_MAX_CELLS 400\n#ifndef QTR_MAX_SEEKERS\n#define QTR_MAX_SEEKERS "
         "2\n#endif\n"
         "#define QTR_MAX_REGIONS (3 * 4)\n#define QTR_MAX_PLACES_ELSEWHERE 9\n#define NOTE \"/* \"\n#endif\n");
}

static void test_what_only_the_compiler_knows_is_refused(void) {
  refuse("mine.h:2", "stands under a condition", "#if BOARD == 2\n#define QTR_MAX_CELLS 400\n#endif\n");
  refuse("mine.h:2", "stands under a condition", "#ifndef NDEBUG\n#define QTR_MAX_CELLS 400\n#endif\n");
  refuse("mine.h:5", "stands under a condition",
         "#ifndef MINE_H\n#define MINE_H\n#ifdef SMALL\n#else\n#define QTR_MAX_PLACES 4\n#endif\n#endif\n");
  refuse("mine.h:4", "stands under a condition",
         "#ifndef LOG\n#define LOG 1\n#else\n#define QTR_MAX_PLACES 4\n#endif\n");
  refuse("mine.h:1", "'(32 * 32)', no plain number", "#define QTR_MAX_CELLS (32 * 32)\n");
  refuse("mine.h:1", "'WIDTH', no plain number", "#define QTR_MAX_CELLS WIDTH\n");
  refuse("mine.h:1", "no plain number", "#define QTR_MAX_CELLS\n");
  refuse("mine.h:1", "no plain number", "#define QTR_MAX_CELLS 0\n");
  refuse("mine.h:1", "no plain number", "#define QTR_MAX_CELLS -1\n");
  refuse("mine.h:1", "no plain number", "#define QTR_MAX_CELLS 4294967296\n");
  refuse("mine.h:1", "no plain number", "#define QTR_MAX_CELLS 99999999999999999999999\n");
  refuse("mine.h:1", "no plain number", "#define QTR_MAX_CELLS 40\\\n0\n");
  refuse("mine.h:1", "is 16777217, and quarter/config.h takes at most 16777216; lower it",
         "#define QTR_MAX_CELLS 16777217\n");
  refuse("mine.h:1", "is 4097, and quarter/config.h takes at most 4096", "#define QTR_MAX_PLACES 4097\n");
  refuse("mine.h:1", "is 65, and quarter/config.h takes at most 64", "#define QTR_MAX_SEEKERS 65\n");
  refuse("mine.h:3", "in line 1 already", "#define QTR_MAX_CELLS 4\n\n#define QTR_MAX_CELLS 4\n");
  refuse("mine.h:2", "undefined", "#define QTR_MAX_CELLS 4\n#undef QTR_MAX_CELLS\n");
  refuse("mine.h:1", "included", "#include \"sizes.h\"\n#define QTR_MAX_CELLS 4\n");
  refuse("mine.h:1", "included", "#include SIZES\n#define QTR_MAX_CELLS 4\n");
}

static void test_a_file_without_sizes_is_refused(void) {
  refuse("mine.h: ", "states none of QTR_MAX_CELLS, QTR_MAX_PLACES and QTR_MAX_SEEKERS",
         "#define QTR_QTABLE_WORDS 2048\n");
  refuse("mine.h: ", "states none", "/* #define QTR_MAX_CELLS 4 */\n// #define QTR_MAX_CELLS 4\n");
  refuse("mine.h: ", "is empty", "");
  TEST_ASSERT_EQUAL_INT(-1, config_header_read(&sizes, "nothing.h", &why));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "nothing.h: no such file"), why.text);
}

static void test_depth_and_length_are_limited(void) {
  char text[4000] = "";
  for (int i = 0; i < 33; i++) strcat(text, "#if 1\n");
  refuse("mine.h:33", "conditions", text);
  memset(text, 'x', 3000);
  strcpy(text + 3000, "\n#define QTR_MAX_CELLS 5\n");
  expect(5, 20, 30, text);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_is_stated_is_taken_and_the_rest_stays);
  RUN_TEST(test_numbers_are_as_c_writes_them);
  RUN_TEST(test_the_largest_sizes_are_taken);
  RUN_TEST(test_guards_are_seen_through);
  RUN_TEST(test_what_only_the_compiler_knows_is_refused);
  RUN_TEST(test_a_file_without_sizes_is_refused);
  RUN_TEST(test_depth_and_length_are_limited);
  return UNITY_END();
}
