/* ./run bench --instances: what it prints of small files, and what it refuses. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "field/asked.h"
#include "field/instances.h"
#include "quarter/config.h"
#include "quarter/objective.h"
#include "unity.h"

static char printed[4096], said[4096];
static fault why;

void setUp(void) {
}

void tearDown(void) {
  unlink("small/a.tsp");
  unlink("small/b.tsp");
}

static void write_file(const char *path, const char *text) {
  mkdir("small", 0700);
  FILE *file = fopen(path, "w");
  TEST_ASSERT_NOT_NULL(file);
  TEST_ASSERT_TRUE(fputs(text, file) >= 0);
  TEST_ASSERT_EQUAL_INT(0, fclose(file));
}

static void read_back(FILE *file, char *text, size_t size) {
  rewind(file);
  text[fread(text, 1, size - 1, file)] = '\0';
  fclose(file);
}

/* The exit status; what went to the two outputs is in `printed` and `said`. */
static int bench(const char *words) {
  char copy[256];
  char *argv[16];
  int argc = 0;
  snprintf(copy, sizeof copy, "%s", words);
  for (char *word = strtok(copy, " "); word != NULL; word = strtok(NULL, " ")) argv[argc++] = word;
  argv[argc] = NULL;
  bench_asked asked;
  FILE *out = tmpfile();
  FILE *errors = tmpfile();
  const int before = dup(2);
  dup2(fileno(errors), 2);
  int status = bench_ask(&asked, argc, argv, &why);
  status = status == 0 ? bench_instances(out, &asked) : bench_fail(&why);
  fflush(stderr);
  dup2(before, 2);
  close(before);
  read_back(out, printed, sizeof printed);
  read_back(errors, said, sizeof said);
  return status;
}

/* The words of a command line. */
#define BENCH(words) bench("bench " words)
/* On a line, the first town between: 1 before it, 2 and 6 behind it. One robot: 1, then back by 2 + 1, then 4 more: 1 +
 * 4 + 8 = 13; the other way round 2 + 5 + 12 or 2 + 6 + 13. */
#define LINE                                                                                                           \
  "NAME: line\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 10 0\n2 9 0\n3 12 0\n4 16 "    \
  "0\nEOF\n"

/* By way of the second town the third is 2 away, and 9 straight: going straight to it visits nothing on the way. */
#define SHORTCUT                                                                                                       \
  "NAME: shortcut\nTYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: UPPER_ROW\n"               \
  "EDGE_WEIGHT_SECTION\n1 9\n1\nEOF\n"

/* The certificate and the time it took differ from machine to machine; the rest is told. */
static void expect_printed(const char *text) {
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(printed, text), printed);
}

static void test_list_of_what_is_learnt_is_printed(void) {
  write_file("small/a.tsp", LINE);
  write_file("small/b.tsp", SHORTCUT);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, BENCH("--instances small --time-limit 60 --json"), said);
  expect_printed("[\n  {\"instance\": \"line\", \"robots\": 1, \"kind\": \"open\", \"sum\": 13, \"bound_sum\": 13, "
                 "\"certified\": true, \"seconds\": ");
  expect_printed(
      "},\n  {\"instance\": \"shortcut\", \"robots\": 1, \"kind\": \"open\", \"sum\": 3, \"bound_sum\": 3, ");
}

static void test_way_home_counts_as_a_place(void) {
  write_file("small/a.tsp", LINE);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, BENCH("--instances small/a.tsp --return --json"), said);
  expect_printed("\"kind\": \"return\", \"sum\": 27, \"bound_sum\": 27, \"certified\": true"); /* 13 + 8 + 6 */
}

static void test_robots_divide_the_towns(void) {
  write_file("small/a.tsp", LINE);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, BENCH("--instances small --robots 2 --json"), said);
  expect_printed("\"robots\": 2, \"kind\": \"open\", \"sum\": 9, \"bound_sum\": 9"); /* 1, and 2 + 6 */
}

/* 1 + g^3 + g^7 for steps 1, 4 and 8. */
static void test_discounted_sum_is_of_powers_of_gamma(void) {
  write_file("small/a.tsp", LINE);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, BENCH("--instances small --objective discounted --gamma 0.5"), said);
  expect_printed("line              1 robots, open    sum 1.1328125, bound 1.1328125");
}

static void test_file_at_fault_is_named_before_anything_is_learnt(void) {
  write_file("small/a.tsp", LINE);
  write_file("small/b.tsp", "TYPE: TOUR\n");
  TEST_ASSERT_EQUAL_INT(2, BENCH("--instances small --json"));
  TEST_ASSERT_EQUAL_STRING("bench: small/b.tsp:1: TYPE: of the types TSP and ATSP alone are read\n", said);
  TEST_ASSERT_EQUAL_STRING("", printed);
}

static void test_towns_that_are_one_are_refused(void) {
  write_file("small/a.tsp", "NAME: twins\nTYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n"
                            "1 0 0\n2 1 0\n3 1 0.2\n");
  TEST_ASSERT_EQUAL_INT(2, BENCH("--instances small"));
  TEST_ASSERT_EQUAL_STRING("bench: small/a.tsp:5: towns 2 and 3 are 0 apart: make them one\n", said);
}

static void expect_refusal(int status, const char *line) {
  TEST_ASSERT_EQUAL_INT(2, status);
  TEST_ASSERT_EQUAL_STRING(line, said);
}

static void test_words_that_do_not_go_together_are_refused(void) {
  expect_refusal(BENCH("--json"), "bench: --json goes with --takeover or --instances\n");
  expect_refusal(BENCH("--instances small --takeover"),
                 "bench: --row, --certificates, --clone, --takeover, --instances and --family: one at a time\n");
  expect_refusal(BENCH("--instances small --return --objective discounted"),
                 "bench: --return goes with --instances and --objective time alone\n");
  expect_refusal(BENCH("more"), "bench: 'more' is no option; ./run bench --help names them\n");
  expect_refusal(BENCH("--instances nowhere"),
                 "bench: nowhere: is no folder with files named *.tsp, and no such file\n");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_list_of_what_is_learnt_is_printed);
  RUN_TEST(test_way_home_counts_as_a_place);
  RUN_TEST(test_robots_divide_the_towns);
  RUN_TEST(test_discounted_sum_is_of_powers_of_gamma);
  RUN_TEST(test_file_at_fault_is_named_before_anything_is_learnt);
  RUN_TEST(test_towns_that_are_one_are_refused);
  RUN_TEST(test_words_that_do_not_go_together_are_refused);
  return UNITY_END();
}
