/* Numbers with their nouns, and that no report of the tool says "1 places". */
#include "host/base/count.h"

#include <ctype.h>
#include <stdbool.h>

#include "support/tool_run.h"

void setUp(void) {
}
void tearDown(void) {
}

static void test_one_is_singular_all_else_plural(void) {
  TEST_ASSERT_EQUAL_STRING("1 place", counted(1, "place").text);
  TEST_ASSERT_EQUAL_STRING("0 places", counted(0, "place").text);
  TEST_ASSERT_EQUAL_STRING("11 places", counted(11, "place").text);
  TEST_ASSERT_EQUAL_STRING("18446744073709551615 termination signals", counted(UINT64_MAX, "termination signal").text);
}

static void test_a_y_after_a_consonant_becomes_ies(void) {
  TEST_ASSERT_EQUAL_STRING("2 tries", counted(2, "try").text);
  TEST_ASSERT_EQUAL_STRING("1 try", counted(1, "try").text);
  TEST_ASSERT_EQUAL_STRING("0 Q entries", counted(0, "Q entry").text);
  TEST_ASSERT_EQUAL_STRING("3 days", counted(3, "day").text);
}

static void test_a_measure_that_reads_one_is_singular(void) {
  TEST_ASSERT_EQUAL_STRING("1 step", measured(1.0, "step").text);
  TEST_ASSERT_EQUAL_STRING("1 step", measured(1.0000000001, "step").text);
  TEST_ASSERT_EQUAL_STRING("1.5 steps", measured(1.5, "step").text);
  TEST_ASSERT_EQUAL_STRING("0 steps", measured(0.0, "step").text);
}

/* Whether one of the next two words is a plural. */
static bool has_plural(const char *word) {
  static const char *const singular[] = {"is", "this", "less", "loss", "across", "was", "has"};
  for (int words = 0; words < 2 && isalpha((unsigned char)*word); words++) {
    const size_t length = strcspn(word, " ,;:.()\n");
    bool plain = word[length - 1] != 's' || length < 3;
    for (size_t i = 0; i < sizeof singular / sizeof singular[0]; i++)
      plain = plain || (strlen(singular[i]) == length && strncmp(word, singular[i], length) == 0);
    if (!plain) return true;
    word += length + (word[length] == ' ');
  }
  return false;
}

/* Whether the 1 stands alone and counts what follows, as in "1 places"; not in "21 places" or "at step 1 seekers". */
static bool is_count(const char *text, const char *at) {
  if (at >= text + 5 && strncmp(at - 5, "step ", 5) == 0) return false;
  if (at >= text + 2 && (strncmp(at - 2, "x ", 2) == 0 || strncmp(at - 2, "y ", 2) == 0)) return false; /* a size */
  return at == text || (!isalnum((unsigned char)at[-1]) && strchr(".:-+", at[-1]) == NULL);
}

static const char *find_slip(const char *text) {
  for (const char *at = text; (at = strstr(at, "1 ")) != NULL; at++)
    if (is_count(text, at) && has_plural(at + 2)) return at;
  return NULL;
}

static void expect_no_slip(const char *words) {
  tool_result r;
  run_tool(&r, "%s", words);
  const char *slip = find_slip(r.out);
  if (slip == NULL) slip = find_slip(r.err);
  if (slip != NULL) TEST_FAIL_MESSAGE(slip);
}

static void test_the_search_for_slips_finds_them(void) {
  TEST_ASSERT_NOT_NULL(find_slip("map.txt: 1 free cells, 2 places"));
  TEST_ASSERT_NOT_NULL(find_slip("3 free cells, 1 places"));
  TEST_ASSERT_NOT_NULL(find_slip("1 Q entries"));
  TEST_ASSERT_NULL(find_slip("1 free cell, 1 place, 1 robot; 21 places; 0.1 s"));
  TEST_ASSERT_NULL(find_slip("place 0 (column 1, row 0), 1 time"));
}

static void test_no_report_on_one_of_all_has_a_slip(void) {
  tool_result r;
  write_file("map.txt", "S1\n");
  write_file("one.yaml", "map: one.txt\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 0, row: 0}]\n");
  write_file("one.txt", ".\n");
  write_file("games.csv", "place\n0\n");
  run_tool(&r, "learn map.txt");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "2 free cells, 1 place, 1 robot\n"), r.out);
  static const char *const lines[] = {"learn map.txt -o m.qtr",
                                      "learn map.txt --objective time",
                                      "learn one.yaml",
                                      "learn map.txt --learner paper --episodes 1",
                                      "exact map.txt",
                                      "exact map.txt --objective time",
                                      "inspect m.qtr",
                                      "simulate m.qtr",
                                      "simulate m.qtr --target 0",
                                      "simulate m.qtr --lost 0@0",
                                      "tune map.txt --episodes 1",
                                      "belief map.txt --history games.csv",
                                      "belief one.yaml --history games.csv --prior 1",
                                      "belief map.txt --history games.csv --belief b.qtb --prior 1",
                                      "belief map.txt --belief b.qtb",
                                      "draw m.qtr -o -",
                                      "draw map.txt -o - --regions --spots",
                                      "learn map.txt --starts any -o any.qtr",
                                      "simulate m.qtr --from 0,0 --from 1,0",
                                      "simulate m.qtr --target 1",
                                      "simulate m.qtr --from 5,5",
                                      "learn map.txt --robots 1",
                                      "tune map.txt --episodes 1 --budget-entries 1"};
  for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) expect_no_slip(lines[i]);
}

static void test_no_fault_of_a_file_has_a_slip(void) {
  write_file("short.txt", "S1.\n.\n");
  write_file("short.map", "type octile\nheight 1\nwidth 2\nmap\n.\n");
  write_file("ends.map", "type octile\nheight 1\nwidth 2\nmap\n");
  write_file("more.map", "type octile\nheight 1\nwidth 2\nmap\n..\n..\n");
  write_file("m.yaml", "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\n"
                       "free_thresh: 0.2\n");
  write_file("m.pgm", "P5 1 1 255\nxy");
  write_file("csv.yaml", "map: map.txt\nplaces_csv: p.csv\n");
  write_file("p.csv", "x\n");
  write_file("two.csv", "place,found\n0\n");
  static const char *const lines[] = {"learn short.txt",
                                      "learn short.map",
                                      "learn ends.map",
                                      "learn more.map",
                                      "learn m.yaml",
                                      "learn csv.yaml",
                                      "belief map.txt --history two.csv"};
  for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) expect_no_slip(lines[i]);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_one_is_singular_all_else_plural);
  RUN_TEST(test_a_y_after_a_consonant_becomes_ies);
  RUN_TEST(test_a_measure_that_reads_one_is_singular);
  RUN_TEST(test_the_search_for_slips_finds_them);
  RUN_TEST(test_no_report_on_one_of_all_has_a_slip);
  RUN_TEST(test_no_fault_of_a_file_has_a_slip);
  return UNITY_END();
}
