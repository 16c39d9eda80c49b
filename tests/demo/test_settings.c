/* The demo's command line: what it means, and one line for each way of getting it wrong. */
#include <string.h>

#include "settings.h"
#include "support/tool_run.h"

enum { WORDS_MOST = 32 };

static settings s;
static fault why;

void setUp(void) {
  memset(&why, 0, sizeof why);
}

void tearDown(void) {
}

/* Parse a line of words. They must outlive the settings, and getopt() still looks at the last word of options long
 * past. */
static int parse(const char *line) {
  static char texts[100][250];
  static int lines;
  char *text = texts[lines++];
  static char self[] = "quarter-demo";
  char *words[WORDS_MOST + 1] = {self};
  int count = 1;
  snprintf(text, sizeof texts[0], "%s", line);
  for (char *word = strtok(text, " "); word != NULL && count < WORDS_MOST; word = strtok(NULL, " "))
    words[count++] = word;
  return settings_parse(&s, count, words, &why);
}

static void test_a_mission_alone_has_the_documented_defaults(void) {
  TEST_ASSERT_EQUAL_INT(0, parse("m.yaml"));
  TEST_ASSERT_EQUAL_STRING("m.yaml", s.mission);
  TEST_ASSERT_NULL(s.table);
  TEST_ASSERT_NULL(s.replay);
  TEST_ASSERT_NULL(s.log);
  TEST_ASSERT_NULL(s.faults);
  TEST_ASSERT_EQUAL_INT(-1, s.mine);
  TEST_ASSERT_EQUAL_INT(0, s.robots);
  TEST_ASSERT_EQUAL_INT(0, s.runs);
  TEST_ASSERT_EQUAL_INT(0, s.strategy);
  TEST_ASSERT_EQUAL_UINT64(1, s.seed);
  TEST_ASSERT_EQUAL_DOUBLE(10.0, s.learn_limit);
  TEST_ASSERT_EQUAL_DOUBLE(0.0, s.speed);
  TEST_ASSERT_FALSE(s.json || s.quiet || s.help || s.clear_all || s.lose_one || s.processes || s.live || s.no_ghost);
  TEST_ASSERT_TRUE(settings_want_ghost(&s));
}

static void test_every_option_is_taken(void) {
  TEST_ASSERT_EQUAL_INT(
      0, parse("-o a.html --table b --save-table c --log d --faults e --lcm-url f --json=g -q --clear-all "
               "--robots 3 --mine 4 --seed 18446744073709551615 --speed 2.5 --learn-limit 0.5 m.yaml"));
  TEST_ASSERT_EQUAL_STRING("a.html", s.replay);
  TEST_ASSERT_EQUAL_STRING("b", s.table);
  TEST_ASSERT_EQUAL_STRING("c", s.save);
  TEST_ASSERT_EQUAL_STRING("d", s.log);
  TEST_ASSERT_EQUAL_STRING("e", s.faults);
  TEST_ASSERT_EQUAL_STRING("f", s.lcm_url);
  TEST_ASSERT_EQUAL_STRING("g", s.json_path);
  TEST_ASSERT_TRUE(s.json && s.quiet && s.clear_all);
  TEST_ASSERT_EQUAL_INT(3, s.robots);
  TEST_ASSERT_EQUAL_INT(4, s.mine);
  TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, s.seed);
  TEST_ASSERT_EQUAL_DOUBLE(2.5, s.speed);
  TEST_ASSERT_EQUAL_DOUBLE(0.5, s.learn_limit);
}

static void test_the_other_ways_of_playing_are_taken(void) {
  TEST_ASSERT_EQUAL_INT(0, parse("m.yaml --runs 7 --lose-one --strategy informed --mine none --json"));
  TEST_ASSERT_EQUAL_INT(7, s.runs);
  TEST_ASSERT_TRUE(s.lose_one && s.json);
  TEST_ASSERT_NULL(s.json_path);
  TEST_ASSERT_EQUAL_INT(2, s.strategy);
  TEST_ASSERT_EQUAL_INT(-2, s.mine);
  TEST_ASSERT_EQUAL_INT(0, parse("--live --port 8080 m.yaml"));
  TEST_ASSERT_TRUE(s.live);
  TEST_ASSERT_EQUAL_INT(8080, s.port);
  TEST_ASSERT_EQUAL_INT(0, parse("--follow --lcm-url x m.yaml"));
  TEST_ASSERT_TRUE(s.follow);
  TEST_ASSERT_EQUAL_INT(0, parse("--processes --output x m.yaml"));
  TEST_ASSERT_TRUE(s.processes);
  TEST_ASSERT_EQUAL_STRING("x", s.replay);
}

static void test_help_needs_no_mission(void) {
  TEST_ASSERT_EQUAL_INT(0, parse("--help"));
  TEST_ASSERT_TRUE(s.help);
  TEST_ASSERT_EQUAL_INT(0, parse("-h"));
  TEST_ASSERT_TRUE(s.help);
}

/* Each is one line that names what is wrong. */
static void refuse(const char *line, const char *named) {
  setUp();
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, parse(line), line);
  TEST_ASSERT_GREATER_THAN_MESSAGE(10, strlen(why.text), line);
  TEST_ASSERT_NULL_MESSAGE(strchr(why.text, '\n'), line);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, named), line);
}

static void test_numbers_out_of_range_are_refused(void) {
  refuse("--port 65536 m.yaml", "--port 65536");
  refuse("--port -1 m.yaml", "--port -1");
  refuse("--robots 0 m.yaml", "--robots 0");
  refuse("--robots 17 m.yaml", "from 1 to 16");
  refuse("--runs 0 m.yaml", "--runs 0");
  refuse("--runs 1000001 m.yaml", "--runs 1000001");
  refuse("--mine -1 m.yaml", "--mine -1");
  refuse("--mine 128 m.yaml", "--mine 128");
  refuse("--speed 0 m.yaml", "--speed 0");
  refuse("--speed 1e999 m.yaml", "--speed 1e999");
  refuse("--learn-limit 0 m.yaml", "--learn-limit 0");
  refuse("--seed -1 m.yaml", "--seed -1");
  refuse("--seed 18446744073709551616 m.yaml", "--seed");
}

static void test_what_is_no_number_is_refused(void) {
  refuse("--robots two m.yaml", "--robots two");
  refuse("--robots 2.5 m.yaml", "not a whole number");
  refuse("--robots 2x m.yaml", "--robots 2x");
  refuse("--runs nan m.yaml", "--runs nan");
  refuse("--speed inf m.yaml", "--speed inf");
  refuse("--speed nan m.yaml", "--speed nan");
  refuse("--mine some m.yaml", "--mine some");
  refuse("--seed x m.yaml", "--seed x");
  refuse("--seed 0x10 m.yaml", "--seed 0x10");
  refuse("--seed 1.5 m.yaml", "--seed 1.5");
  refuse("--seed +1 m.yaml", "--seed +1");
}

static void test_an_empty_value_is_refused(void) {
  static const char *const options[] = {"--robots=", "--runs=", "--seed=", "--speed=", "--mine=", "--strategy="};
  for (unsigned i = 0; i < sizeof options / sizeof options[0]; i++)
    refuse(options[i], options[i][2] == 's' ? "--s" : "--");
}

static void test_unknown_words_are_refused_by_name(void) {
  refuse("--frobnicate m.yaml", "'--frobnicate'");
  refuse("-x m.yaml", "'-x'");
  refuse("-qx m.yaml", "x");
  refuse("--strategy luck m.yaml", "--strategy luck");
  refuse("m.yaml --log", "no value after '--log'");
  refuse("m.yaml -o", "no value after '-o'");
}

static void test_one_mission_is_wanted(void) {
  refuse("", "name one mission");
  refuse("-q", "name one mission");
  refuse("one.yaml two.yaml", "name one mission");
}

static void test_what_does_not_go_together_is_refused(void) {
  refuse("--runs 5 -o a.html m.yaml", "--runs");
  refuse("--runs 5 --log a m.yaml", "--runs");
  refuse("--runs 5 --live m.yaml", "--runs");
  refuse("--runs 5 --processes m.yaml", "--runs");
  refuse("--processes --strategy nearest m.yaml", "--strategy");
  refuse("--processes --live m.yaml", "--live");
  refuse("--follow --runs 5 m.yaml", "--follow");
  refuse("--follow --log a m.yaml", "--follow");
}

/* Of the lines of docs/demo.md that show how to run it. */
static void test_what_the_documentation_shows_is_taken(void) {
  static char page[60000];
  int shown = 0;
  read_text(QUARTER_SOURCE_DIR "/docs/demo.md", page, sizeof page);
  for (char *line = strtok(page, "\n"); line != NULL; line = strtok(NULL, "\n")) {
    const char *word = strstr(line, "./run demo ");
    while (word != NULL && (word = strstr(word, " --")) != NULL) {
      char name[40];
      word += 3;
      snprintf(name, sizeof name, "%.*s", (int)strspn(word, "abcdefghijklmnopqrstuvwxyz-"), word);
      TEST_ASSERT_TRUE_MESSAGE(option_is_taken(&settings_options, name), name);
      shown++;
    }
  }
  TEST_ASSERT_GREATER_THAN_INT(6, shown);
}

static void test_the_default_that_help_tells_is_the_default(void) {
  static settings by_default;
  int told = 0;
  TEST_ASSERT_EQUAL_INT(0, parse("m.yaml"));
  by_default = s;
  for (const option_record *r = settings_options.table; r->name != NULL; r++) {
    static char words[250];
    if (r->standard == NULL) continue;
    snprintf(words, sizeof words, "--%s %s m.yaml", r->name, r->standard);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, parse(words), words);
    TEST_ASSERT_EQUAL_UINT64_MESSAGE(by_default.seed, s.seed, words);
    TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(by_default.learn_limit, s.learn_limit, words);
    TEST_ASSERT_EQUAL_INT_MESSAGE(by_default.run, s.run, words);
    told++;
  }
  TEST_ASSERT_EQUAL_INT(3, told);
}

static void test_a_ghost_is_wanted_beside_the_plan_unless_it_is_refused(void) {
  TEST_ASSERT_EQUAL_INT(0, parse("m.yaml"));
  TEST_ASSERT_TRUE(settings_want_ghost(&s));
  TEST_ASSERT_EQUAL_INT(0, parse("--no-ghost m.yaml"));
  TEST_ASSERT_FALSE(settings_want_ghost(&s));
  TEST_ASSERT_EQUAL_INT(0, parse("--strategy nearest m.yaml"));
  TEST_ASSERT_FALSE(settings_want_ghost(&s));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_the_documentation_shows_is_taken);
  RUN_TEST(test_the_default_that_help_tells_is_the_default);
  RUN_TEST(test_a_mission_alone_has_the_documented_defaults);
  RUN_TEST(test_every_option_is_taken);
  RUN_TEST(test_the_other_ways_of_playing_are_taken);
  RUN_TEST(test_help_needs_no_mission);
  RUN_TEST(test_numbers_out_of_range_are_refused);
  RUN_TEST(test_what_is_no_number_is_refused);
  RUN_TEST(test_an_empty_value_is_refused);
  RUN_TEST(test_unknown_words_are_refused_by_name);
  RUN_TEST(test_one_mission_is_wanted);
  RUN_TEST(test_what_does_not_go_together_is_refused);
  RUN_TEST(test_a_ghost_is_wanted_beside_the_plan_unless_it_is_refused);
  return UNITY_END();
}
