/* The table of options against what else tells of them: the defaults in force, the commands' help, README.md. */
#include "host/base/option.h"

#include <ctype.h>

#include "options.h"
#include "support/tool_run.h"

enum { OPTIONS_MOST = 64 };

static const char *const commands[] = {"new",  "learn",   "exact",  "simulate", "inspect",
                                       "draw", "compare", "export", "tune",     "belief"};
enum { COMMANDS = sizeof commands / sizeof commands[0] };

static tool_result help[COMMANDS];

void setUp(void) {
  for (int i = 0; i < COMMANDS; i++)
    if (help[i].out[0] == '\0') run_tool(&help[i], "%s --help", commands[i]);
}

void tearDown(void) {
}

/* A command that takes every option. */
static option_set take_all(void) {
  static option_line lines[OPTIONS_MOST + 1];
  int count = 0;
  for (const option_record *r = option_records; r->name != NULL; r++) lines[count++].options = r->name;
  return (option_set){"all", "", "", option_records, lines};
}

static void test_the_default_that_help_tells_is_the_default(void) {
  static options taken, by_default;
  const option_set set = take_all();
  int told = 0;
  fault why;
  for (const option_record *r = option_records; r->name != NULL; r++) {
    /* These are the input's and the belief's own where nothing is said. */
    if (r->standard == NULL || strcmp(r->name, "gamma") == 0 || strcmp(r->name, "keep") == 0) continue;
    static char self[] = "all", word[100];
    char *words[] = {self, word, NULL};
    snprintf(word, sizeof word, "--%s=%s", r->name, r->standard);
    options_default(&taken);
    options_default(&by_default);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, option_parse(&taken, &set, 2, words, &why), word);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&by_default, &taken, sizeof taken, word);
    told++;
  }
  TEST_ASSERT_GREATER_THAN_INT(9, told);
}

static void test_gamma_and_keep_are_what_help_tells(void) {
  static qtr_mission mission;
  static tool_result result;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_mission_default(&mission));
  TEST_ASSERT_EQUAL_DOUBLE(0.99, mission.aim.gamma);
  write_file("area.txt", "S..1\n");
  write_file("games.csv", "place\n0\n");
  run_tool(&result, "belief area.txt --history games.csv --json");
  TEST_ASSERT_EQUAL_DOUBLE(1.0, json_value(result.out, "keep"));
}

/* "--name" and no longer name. */
static bool tells_of(const char *text, const char *name) {
  char word[64];
  const int length = snprintf(word, sizeof word, "--%s", name);
  for (const char *at = text; (at = strstr(at, word)) != NULL; at++)
    if (!isalpha((unsigned char)at[length]) && at[length] != '-') return true;
  return false;
}

static void test_every_option_is_of_some_command_and_told_of_in_its_help(void) {
  for (const option_record *r = option_records; r->name != NULL; r++) {
    bool told = strcmp(r->name, "help") == 0;
    for (int i = 0; i < COMMANDS && !told; i++) told = tells_of(help[i].out, r->name);
    TEST_ASSERT_TRUE_MESSAGE(told, r->name);
  }
}

/* Wherever README.md writes `quarter COMMAND ... --option`. */
static void test_what_the_readme_names_is_there(void) {
  static char readme[100000];
  int named = 0;
  read_text(QUARTER_SOURCE_DIR "/README.md", readme, sizeof readme);
  for (char *at = readme; (at = strstr(at, "quarter ")) != NULL;) {
    at += strlen("quarter ");
    char *end = at + strcspn(at, "`\n");
    for (int i = 0; i < COMMANDS; i++) {
      if (strncmp(at, commands[i], strlen(commands[i])) != 0) continue;
      for (char *word = strstr(at, " --"); word != NULL && word < end; word = strstr(word + 3, " --")) {
        char name[40];
        snprintf(name, sizeof name, "%.*s", (int)strspn(word + 3, "abcdefghijklmnopqrstuvwxyz-"), word + 3);
        TEST_ASSERT_TRUE_MESSAGE(tells_of(help[i].out, name), name);
        named++;
      }
    }
  }
  TEST_ASSERT_GREATER_THAN_INT(10, named);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_default_that_help_tells_is_the_default);
  RUN_TEST(test_gamma_and_keep_are_what_help_tells);
  RUN_TEST(test_every_option_is_of_some_command_and_told_of_in_its_help);
  RUN_TEST(test_what_the_readme_names_is_there);
  return UNITY_END();
}
