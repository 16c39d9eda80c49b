/* A game on record: the JSON is JSON and says what happened, and no name can break out of the page that holds it. */
#include <ctype.h>

#include "play.h"
#include "record.h"

static record r;
static char *json_of_game; /* as record_json() wrote it at the end of the game */
static const char *page_path;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
  free(json_of_game);
  json_of_game = NULL;
}

/* ---- a checker of JSON (RFC 8259), which shares nothing with the writer ---- */

/* Each skips what it reads; NULL: it is not there. */
static const char *skip_value(const char *at, int depth);

static const char *skip_space(const char *at) {
  while (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r') at++;
  return at;
}

static const char *skip_escape(const char *at) {
  if (*at != 'u') return *at != '\0' && strchr("\"\\/bfnrt", *at) != NULL ? at + 1 : NULL;
  for (int i = 1; i <= 4; i++)
    if (!isxdigit((unsigned char)at[i])) return NULL;
  return at + 5;
}

static const char *skip_string(const char *at) {
  if (*at++ != '"') return NULL;
  while (at != NULL && *at != '"') {
    if ((unsigned char)*at < 0x20) return NULL;
    at = *at == '\\' ? skip_escape(at + 1) : at + 1;
  }
  return at != NULL ? at + 1 : NULL;
}

static const char *skip_digits(const char *at) {
  if (!isdigit((unsigned char)*at)) return NULL;
  while (isdigit((unsigned char)*at)) at++;
  return at;
}

static const char *skip_number(const char *at) {
  if (*at == '-') at++;
  at = *at == '0' ? at + 1 : skip_digits(at);
  if (at != NULL && *at == '.') at = skip_digits(at + 1);
  if (at == NULL || (*at != 'e' && *at != 'E')) return at;
  at++;
  return skip_digits(*at == '+' || *at == '-' ? at + 1 : at);
}

/* Members of an object or of an array, behind its bracket. */
static const char *skip_members(const char *at, char end, int depth) {
  at = skip_space(at);
  if (*at == end) return at + 1;
  for (;; at++) {
    at = skip_space(at);
    if (end == '}') {
      at = skip_string(at);
      if (at == NULL || *(at = skip_space(at)) != ':') return NULL;
      at++;
    }
    at = skip_value(at, depth + 1);
    if (at == NULL) return NULL;
    at = skip_space(at);
    if (*at == end) return at + 1;
    if (*at != ',') return NULL;
  }
}

static const char *skip_value(const char *at, int depth) {
  static const char *const words[] = {"true", "false", "null"};
  at = skip_space(at);
  if (depth > 20) return NULL;
  if (*at == '{') return skip_members(at + 1, '}', depth);
  if (*at == '[') return skip_members(at + 1, ']', depth);
  if (*at == '"') return skip_string(at);
  for (int i = 0; i < 3; i++)
    if (strncmp(at, words[i], strlen(words[i])) == 0) return at + strlen(words[i]);
  return skip_number(at);
}

static bool is_json(const char *text) {
  const char *end = skip_value(text, 0);
  return end != NULL && *skip_space(end) == '\0';
}

static void test_the_checker_tells_json_from_what_is_none(void) {
  static const char *const good[] = {"{}", "[1, -2.5e+3, 0]", "{\"a\": [true, null, \"\\u00e9\\/\"]}", " 0.1 "};
  static const char *const bad[] = {"",   "{",   "[1,]",      "[1 2]",    "{\"a\" 1}", "{a: 1}",     "01",
                                    "1.", "nan", "-",         "\"\\x\"",  "\"\n\"",    "{} {}",      "[inf]",
                                    "+1", ".5",  "\"\\u12\"", "{\"a\":}", "[\"open]",  "{\"a\": 1,}"};
  for (unsigned i = 0; i < sizeof good / sizeof good[0]; i++) TEST_ASSERT_TRUE_MESSAGE(is_json(good[i]), good[i]);
  for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) TEST_ASSERT_FALSE_MESSAGE(is_json(bad[i]), bad[i]);
}

/* ---- recording a game ---- */

static bool with_ghost;

static int keep_json(void *user, const arena *a, const game_result *result, fault *why) {
  size_t size;
  if (with_ghost) TEST_ASSERT_EQUAL_INT(0, record_add_ghost(user, &a->setup, NULL, why));
  FILE *memory = open_memstream(&json_of_game, &size);
  TEST_ASSERT_NOT_NULL(memory);
  record_json(memory, user, a, result);
  fclose(memory);
  play_arena = *a;
  return page_path != NULL ? record_page(page_path, user, a, result, why) : 0;
}

/* Play the plan and keep its JSON, and its page if there is a path for one. */
static void record_game(game_setup setup, const char *page) {
  page_path = page;
  /* What was read is known by its number, which a file that was removed leaves to the next one: the page of the game
   * before may bear that of a mission's file of before, and would be spared. */
  if (page != NULL) remove(page);
  record_begin(&r, &play_plan);
  setup.user = &r;
  setup.watch = record_watch;
  setup.finish = keep_json;
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, game_play(&setup, &play_result, NULL, &play_why), play_why.text);
  record_free(&r);
}

/* The first numbers of the array at a key of the first track. */
static double track_number(const char *key) {
  const char *track = strstr(json_of_game, "\"tracks\"");
  TEST_ASSERT_NOT_NULL(track);
  return strtod(json_text(track, key) + 1, NULL);
}

static void test_the_record_is_json_whatever_happened(void) {
  const fault_script faults = {7,
                               {{0.0, FAULT_LOSS, -1, 0.5, 0},
                                {0.0, FAULT_SHUT, -1, 0.0, 8},
                                {1.0, FAULT_SLIP, -1, 0.5, 0},
                                {1.0, FAULT_RESET, 2, 0.0, 0},
                                {2.0, FAULT_STUCK, 1, 0.0, 0},
                                {2.5, FAULT_RESTART, 2, 0.0, 0},
                                {3.0, FAULT_LOST, 0, 0.0, 0}}};
  play_prepare_drawn("1...S...2/.#~..###./3.......4", 3);
  for (int mine = -2; mine < 4; mine++) {
    game_setup setup = play_setup(5);
    setup.arena.mine = mine;
    setup.arena.clear_all = mine == 0;
    setup.arena.faults = mine % 2 == 0 ? &faults : NULL;
    record_game(setup, NULL);
    TEST_ASSERT_TRUE_MESSAGE(is_json(json_of_game), json_of_game);
    tearDown();
  }
}

static void test_the_record_holds_the_game_without_a_plan_where_it_is_wanted(void) {
  play_prepare_drawn("1...S...2/.#~..###./3.......4", 3);
  record_game(play_setup(5), NULL);
  TEST_ASSERT_NULL(strstr(json_of_game, "\"ghost\""));
  free(json_of_game);
  with_ghost = true;
  record_game(play_setup(5), NULL);
  with_ghost = false;
  TEST_ASSERT_TRUE_MESSAGE(is_json(json_of_game), json_of_game);
  const char *ghost_json = strstr(json_of_game, "\"ghost\"");
  TEST_ASSERT_NOT_NULL(ghost_json);
  TEST_ASSERT_TRUE(json_is(ghost_json, "strategy", "\"nearest\""));
  game_setup setup = play_setup(5);
  setup.strategy = STRATEGY_NEAREST;
  play(setup);
  TEST_ASSERT_DOUBLE_WITHIN(0.001, play_result.found_at, json_value(ghost_json, "finished_at"));
}

/* The last count that changed is the whole game's, and none is said before a robot has something to say. */
static void test_the_record_counts_what_robots_say_to_one_another(void) {
  play_prepare_drawn("S....1/......", 0);
  record_game(play_setup(5), NULL);
  const char *said = json_text(json_of_game, "said");
  double at, count = 0.0, first = -1.0;
  for (int read; sscanf(said += strcspn(said, "[0123456789") + (*said == '['), "[%lf, %lf]%n", &at, &count, &read) == 2;
       said += read)
    if (first < 0.0) first = at;
  TEST_ASSERT_TRUE(first >= play_result.found_at - 0.1);
  TEST_ASSERT_DOUBLE_WITHIN(2.0, (double)play_result.counts.sent[KIND_TERMINATE], count);
}

/* Who says so need not be whose territory it is: robots repeat what they know. */
static void test_the_record_tells_who_says_that_a_territory_is_done(void) {
  play_prepare_drawn("S.1..2/......", 0);
  game_setup setup = play_setup(5);
  setup.arena.mine = -2;
  record_game(setup, NULL);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(json_of_game, "\"text\": \"robot 0: territory 0 is done\""), json_of_game);
}

/* What is shut is a place, at the right end of the top row, or a cell of the row below. */
static void test_the_record_tells_what_was_shut_and_who_had_no_power(void) {
  const fault_script faults = {4,
                               {{0.0, FAULT_SHUT, -1, 0.0, 5},
                                {0.0, FAULT_SHUT, -1, 0.0, 7},
                                {1.0, FAULT_RESET, 0, 0.0, 0},
                                {2.5, FAULT_RESTART, 0, 0.0, 0}}};
  play_prepare_drawn("S.1..2/......", 0);
  game_setup setup = play_setup(5);
  setup.arena.mine = 0;
  setup.arena.faults = &faults;
  record_game(setup, NULL);
  TEST_ASSERT_NOT_NULL_MESSAGE(
      strstr(json_of_game, "\"kind\": \"shut\", \"place\": 1, \"x\": 5.5, \"y\": 0.5, \"text\": \"place 1 is shut"),
      json_of_game);
  TEST_ASSERT_NOT_NULL_MESSAGE(
      strstr(json_of_game, "\"kind\": \"shut\", \"x\": 1.5, \"y\": 1.5, \"text\": \"a door is shut\""), json_of_game);
  TEST_ASSERT_NOT_NULL(strstr(json_of_game, "robot 0 has no power"));
  TEST_ASSERT_NOT_NULL(strstr(json_of_game, "robot 0 has power again"));
}

static void test_the_record_says_what_happened(void) {
  play_prepare_drawn("S....1/......", 0);
  record_game(play_setup(5), NULL);
  TEST_ASSERT_EQUAL_DOUBLE(1, json_value(json_of_game, "format"));
  TEST_ASSERT_TRUE(json_is(json_of_game, "title", "\"drawn.txt\""));
  TEST_ASSERT_EQUAL_DOUBLE(5, json_value(json_of_game, "seed"));
  TEST_ASSERT_TRUE(json_is(json_of_game, "mode", "\"find\""));
  TEST_ASSERT_EQUAL_DOUBLE(6, json_value(json_of_game, "columns"));
  TEST_ASSERT_EQUAL_DOUBLE(2, json_value(json_of_game, "rows"));
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, play_result.duration, json_value(json_of_game, "duration"));
  TEST_ASSERT_EQUAL_DOUBLE(1, json_value(json_of_game, "scanned"));
  TEST_ASSERT_DOUBLE_WITHIN(0.1, play_result.found_at, json_value(json_of_game, "found_at"));
  TEST_ASSERT_EQUAL_DOUBLE(5, json_value(json_of_game, "planned_at"));
  TEST_ASSERT_NOT_NULL(strstr(json_of_game, "robot 0 found it at place 0"));
}

/* In hundredths of a cell, y down from the top. */
static void test_tracks_begin_at_the_start(void) {
  play_prepare_drawn("..S..1/....../......", 0);
  record_game(play_setup(5), NULL);
  TEST_ASSERT_DOUBLE_WITHIN(5, 250, track_number("x"));
  TEST_ASSERT_DOUBLE_WITHIN(5, 50, track_number("y"));
}

static void test_there_is_a_sample_every_tenth_of_a_second(void) {
  play_prepare_drawn("....../..S..1/......", 0);
  record_game(play_setup(5), NULL);
  const char *at = json_text(strstr(json_of_game, "\"tracks\""), "x");
  int samples = 1;
  for (; *at != ']'; at++) samples += *at == ',';
  TEST_ASSERT_INT_WITHIN(2, 10 * play_result.duration, samples);
}

static void test_tracks_on_a_wide_map_are_where_the_robot_is(void) {
  char rows[410];
  memset(rows, '.', 400);
  memcpy(rows + 390, "S....1", 7);
  play_prepare_drawn(rows, 0);
  record_game(play_setup(5), NULL);
  TEST_ASSERT_DOUBLE_WITHIN(5, 39050, track_number("x"));
}

static void test_a_page_that_follows_is_told_all_but_what_happened(void) {
  const record_head head = {7, true, 1};
  size_t size;
  play_prepare_drawn("1...S...2", 0);
  FILE *memory = open_memstream(&json_of_game, &size);
  TEST_ASSERT_NOT_NULL(memory);
  record_hello(memory, &play_plan, &head);
  fclose(memory);
  TEST_ASSERT_TRUE_MESSAGE(is_json(json_of_game), json_of_game);
  TEST_ASSERT_TRUE(json_is(json_of_game, "live", "true"));
  TEST_ASSERT_TRUE(json_is(json_of_game, "mode", "\"clear\""));
  TEST_ASSERT_TRUE(json_is(json_of_game, "mines", "[1]"));
  TEST_ASSERT_EQUAL_DOUBLE(7, json_value(json_of_game, "seed"));
  TEST_ASSERT_NULL(strstr(json_of_game, "\"tracks\""));
}

/* ---- the page ---- */

/* What a browser takes the data's element to hold: up to the first "</script", in any case. It must not hold "<!--"
 * either, behind which a browser looks for the end elsewhere. */
static char *data_of_page(const char *path) {
  static char page[1 << 20];
  static const char element[] = "<script id=\"replay\" type=\"application/json\">";
  read_text(path, page, sizeof page);
  char *data = strstr(page, element);
  TEST_ASSERT_NOT_NULL(data);
  data += strlen(element);
  char *end = strstr(data, "</");
  TEST_ASSERT_NOT_NULL(end);
  TEST_ASSERT_EQUAL_INT(0, strncmp(end, "</script>", 9));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(end, "</html>"), "the page goes on behind the data");
  *end = '\0';
  return data;
}

static void prepare_named(const char *name) {
  char text[300];
  write_file("drawn.txt", "S.1\n");
  snprintf(text, sizeof text, "name: '%s'\nmap: drawn.txt\n", name);
  write_file("named.yaml", text);
  play_prepare("named.yaml", 0);
  TEST_ASSERT_EQUAL_STRING(name, play_plan.name);
}

static void test_no_name_breaks_out_of_the_page(void) {
  static const char *const names[] = {"Plain",       "</script><script>alert(1)</script>",
                                      "</SCRIPT >",  "<!-- <script>",
                                      "a \"b\" \\c", "\xC3\xA4 \xF0\x9F\x8E\x89"};
  for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) {
    prepare_named(names[i]);
    record_game(play_setup(5), "page.html");
    const char *data = data_of_page("page.html");
    TEST_ASSERT_TRUE_MESSAGE(is_json(json_of_game), names[i]);
    TEST_ASSERT_TRUE_MESSAGE(is_json(data), names[i]);
    TEST_ASSERT_NULL_MESSAGE(strstr(data, "<!--"), names[i]);
    TEST_ASSERT_NULL_MESSAGE(strstr(data, "<script"), names[i]);
    tearDown();
  }
}

static void test_a_page_that_cannot_be_written_is_refused(void) {
  prepare_named("Plain");
  page_path = "no/such/folder/page.html";
  record_begin(&r, &play_plan);
  game_setup setup = play_setup(5);
  setup.user = &r;
  setup.watch = record_watch;
  setup.finish = keep_json;
  TEST_ASSERT_EQUAL_INT(-1, game_play(&setup, &play_result, NULL, &play_why));
  record_free(&r);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "no/such/folder/page.html"), play_why.text);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_checker_tells_json_from_what_is_none);
  RUN_TEST(test_the_record_is_json_whatever_happened);
  RUN_TEST(test_the_record_holds_the_game_without_a_plan_where_it_is_wanted);
  RUN_TEST(test_the_record_counts_what_robots_say_to_one_another);
  RUN_TEST(test_the_record_tells_who_says_that_a_territory_is_done);
  RUN_TEST(test_the_record_tells_what_was_shut_and_who_had_no_power);
  RUN_TEST(test_the_record_says_what_happened);
  RUN_TEST(test_tracks_begin_at_the_start);
  RUN_TEST(test_there_is_a_sample_every_tenth_of_a_second);
  RUN_TEST(test_tracks_on_a_wide_map_are_where_the_robot_is);
  RUN_TEST(test_a_page_that_follows_is_told_all_but_what_happened);
  RUN_TEST(test_no_name_breaks_out_of_the_page);
  RUN_TEST(test_a_page_that_cannot_be_written_is_refused);
  plan_free(&play_plan);
  return UNITY_END();
}
