/* Records of options: each kind of value in its field, what is refused, and the help that is made of them. */
#include "host/base/option.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "unity.h"

typedef struct {
  bool mark, yes;
  const char *text, *file;
  double number;
  int whole;
  uint8_t small;
  uint64_t large;
} things;

static int take_twice(void *settings, const option_record *record, const char *value, fault *why) {
  things *t = settings;
  uint64_t count;
  if (option_count(&count, record->name, value, 0, 100, why) != 0) return -1;
  t->whole = 2 * (int)count;
  return 0;
}

static const char *const colours[] = {"red", "green", "blue", NULL};
static const char *const answers[] = {"no", "yes", NULL};

static option_table records = {
    {.name = "mark", .letter = 'm', .help = "a mark", .kind = OPTION_MARK, OPTION_FIELD(things, mark)},
    {.name = "text", .argument = "WORD", .help = "a text", .kind = OPTION_TEXT, OPTION_FIELD(things, text)},
    {.name = "file",
     .letter = 'f',
     .argument = "FILE",
     .help = "a file",
     .kind = OPTION_FILE,
     OPTION_FIELD(things, file)},
    {.name = "share",
     .argument = "X",
     .help = "a share (default %s)\nof all",
     .standard = "0.5",
     .kind = OPTION_NUMBER,
     OPTION_FIELD(things, number),
     .least = 0,
     .most = 1,
     .open = true,
     .range = "between 0 and 1"},
    {.name = "size",
     .argument = "N",
     .standard = "7",
     .kind = OPTION_COUNT,
     OPTION_FIELD(things, whole),
     .first = 1,
     .last = 9},
    {.name = "seed", .argument = "N", .kind = OPTION_COUNT, OPTION_FIELD(things, large), .last = UINT64_MAX},
    {.name = "colour", .argument = "C", .kind = OPTION_WORD, OPTION_FIELD(things, small), .words = colours},
    {.name = "sure", .argument = "A", .kind = OPTION_WORD, OPTION_FIELD(things, yes), .words = answers},
    {.name = "twice", .argument = "[=N]", .help = "twice as much", .kind = OPTION_OWN, .take = take_twice},
    {.name = "alien", .kind = OPTION_MARK, OPTION_FIELD(things, mark)},
    {.name = "help", .letter = 'h', .kind = OPTION_MARK, OPTION_FIELD(things, mark)},
    {.name = NULL}};

static const option_line lines[] = {
    OPTION_LINE("mark"),
    OPTION_LINE("text"),
    {"file", "a %sfile of its own", 30},
    OPTION_LINE("share"),
    {"size, seed,\ncolour [sure]", "of size %s", 0},
    OPTION_LINE("twice"),
    {NULL, NULL, 0},
};
static const option_set set = {"try", "Before.\n", "After.\n", records, lines};

static things taken;
static fault why;

void setUp(void) {
  memset(&taken, 0, sizeof taken);
  memset(&why, 0, sizeof why);
}

void tearDown(void) {
}

/* The words must outlive what is taken from them. */
static int parse(const char *line) {
  static char text[200];
  static char self[] = "try";
  char *words[20] = {self};
  int count = 1;
  snprintf(text, sizeof text, "%s", line);
  for (char *word = strtok(text, " "); word != NULL; word = strtok(NULL, " ")) words[count++] = word;
  return option_parse(&taken, &set, count, words, &why);
}

static void expect_fault(const char *line, const char *text) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, parse(line), line);
  TEST_ASSERT_EQUAL_STRING(text, why.text);
}

static void test_each_kind_goes_into_its_field(void) {
  TEST_ASSERT_EQUAL_INT(0, parse("-m --text= -f a.txt --share 0.25 --size 9 --seed 18446744073709551615 --colour blue "
                                 "--sure yes input"));
  TEST_ASSERT_TRUE(taken.mark && taken.yes);
  TEST_ASSERT_EQUAL_STRING("", taken.text);
  TEST_ASSERT_EQUAL_STRING("a.txt", taken.file);
  TEST_ASSERT_EQUAL_DOUBLE(0.25, taken.number);
  TEST_ASSERT_EQUAL_INT(9, taken.whole);
  TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, taken.large);
  TEST_ASSERT_EQUAL_INT(2, taken.small);
  TEST_ASSERT_EQUAL_INT(0, parse("--twice=4"));
  TEST_ASSERT_EQUAL_INT(8, taken.whole);
}

static void test_what_is_out_of_range_is_named_with_the_range(void) {
  expect_fault("--share 1", "--share 1: not a number between 0 and 1");
  expect_fault("--share x", "--share x: not a number between 0 and 1");
  expect_fault("--size 10", "--size 10: not a whole number from 1 to 9");
  expect_fault("--size 2.0", "--size 2.0: not a whole number from 1 to 9");
  expect_fault("--seed 18446744073709551616",
               "--seed 18446744073709551616: not a whole number from 0 to 18446744073709551615");
  expect_fault("--colour grey", "--colour grey: say red, green or blue");
  expect_fault("--sure maybe", "--sure maybe: say no or yes");
  expect_fault("--file=", "--file: the name of the file is empty");
}

static void test_a_command_takes_what_its_lines_name(void) {
  expect_fault("--alien", "try: no such option '--alien'; 'quarter try --help' shows what there is");
  expect_fault("--colr red", "try: no such option '--colr'; did you mean --colour?");
  expect_fault("--size", "try: no value after '--size'; 'quarter try --help' shows what there is");
  TEST_ASSERT_TRUE(option_is_taken(&set, "sure"));
  TEST_ASSERT_TRUE(option_is_taken(&set, "help"));
  TEST_ASSERT_FALSE(option_is_taken(&set, "alien"));
  TEST_ASSERT_FALSE(option_is_taken(&set, "siz"));
}

static void test_words_end_at_the_first_that_is_no_option(void) {
  TEST_ASSERT_EQUAL_INT(0, parse("--size 3 -- -m"));
  TEST_ASSERT_FALSE(taken.mark);
  TEST_ASSERT_EQUAL_INT(4, optind);
}

static void test_help_is_made_of_lines_and_records(void) {
  static const char expected[] = "Before.\n"
                                 "  -m, --mark               a mark\n"
                                 "      --text WORD          a text\n"
                                 "  -f, --file FILE             a file of its own\n"
                                 "      --share X            a share (default 0.5)\n"
                                 "                           of all\n"
                                 "      --size N, --seed N,\n"
                                 "      --colour C [--sure A] of size 7\n"
                                 "      --twice[=N]          twice as much\n"
                                 "After.\n";
  char *text = NULL;
  size_t size = 0;
  FILE *memory = open_memstream(&text, &size);
  TEST_ASSERT_NOT_NULL(memory);
  option_help(memory, &set);
  fclose(memory);
  TEST_ASSERT_EQUAL_STRING(expected, text);
  free(text);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_each_kind_goes_into_its_field);
  RUN_TEST(test_what_is_out_of_range_is_named_with_the_range);
  RUN_TEST(test_a_command_takes_what_its_lines_name);
  RUN_TEST(test_words_end_at_the_first_that_is_no_option);
  RUN_TEST(test_help_is_made_of_lines_and_records);
  return UNITY_END();
}
