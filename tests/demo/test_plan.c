/* The plan of a mission: who goes where when, with what chance, and no table of another mission. */
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include "host/base/stop.h"
#include "play.h"

void setUp(void) {
  file_forget("own.qtr"); /* each test is a process of its own to the tool */
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void write_drawing(const char *path, const char *rows) {
  char text[500];
  snprintf(text, sizeof text, "%s\n", rows);
  for (char *c = text; *c != '\0'; c++)
    if (*c == '/') *c = '\n';
  write_file(path, text);
}

/* ---- what it says ---- */

/* One robot, place 0 of weight 1 three steps to the left, place 1 of weight 3 one step to the right. Right first: found
 * at 1 with 3/4, and 4 steps later, at 5, with 1/4. */
static void test_one_robots_plan_by_hand(void) {
  play_prepare_drawn("1..S3", 0);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.25, play_plan.likelihood[0]);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.75, play_plan.likelihood[1]);
  TEST_ASSERT_EQUAL_INT(2, play_plan.routes[0].places);
  TEST_ASSERT_EQUAL_INT(1, play_plan.routes[0].place[0]);
  TEST_ASSERT_EQUAL_UINT(1, play_plan.step[1]);
  TEST_ASSERT_EQUAL_UINT(5, play_plan.step[0]);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.75 * 1 + 0.25 * 5, play_plan.expected_step);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 5.0, game_plan_seconds(&play_plan.t));
}

static void test_the_chance_of_a_find_rises_at_the_visits(void) {
  play_prepare_drawn("1..S3", 0);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.0, plan_found_by(&play_plan, 0.5));
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.75, plan_found_by(&play_plan, 1.0));
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.75, plan_found_by(&play_plan, 4.9));
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, 1.0, plan_found_by(&play_plan, 5.0));
}

static void test_territories_are_those_of_the_routes(void) {
  play_prepare_drawn("1.S...S.1", 0);
  for (int robot = 0; robot < 2; robot++) {
    TEST_ASSERT_EQUAL_INT(1, play_plan.routes[robot].places);
    TEST_ASSERT_EQUAL_INT(robot, play_plan.territory[play_plan.routes[robot].place[0]]);
  }
  TEST_ASSERT_EQUAL_UINT(2, play_plan.step[0]);
  TEST_ASSERT_EQUAL_UINT(2, play_plan.step[1]);
}

static void test_as_many_robots_start_as_are_asked_for(void) {
  play_prepare_drawn("1...S...1", 3);
  TEST_ASSERT_EQUAL_INT(3, play_plan.t.policy.board.seekers);
}

static void test_a_plan_has_its_missions_name(void) {
  play_prepare_drawn("1..S3", 0);
  TEST_ASSERT_EQUAL_STRING("drawn.txt", play_plan.name);
  write_file("named.yaml", "name: A name\nmap: drawn.txt\n");
  play_prepare("named.yaml", 0);
  TEST_ASSERT_EQUAL_STRING("A name", play_plan.name);
}

static void test_a_plan_counts_the_places_that_are_too_unlikely_to_be_certified(void) {
  write_drawing("plain.txt", "S....");
  write_file("unlikely.yaml", "map: plain.txt\nplaces:\n- {column: 2, row: 0, weight: 1}\n"
                              "- {column: 4, row: 0, weight: 1e-7}\n- {column: 3, row: 0, weight: 1e-11}\n");
  play_prepare("unlikely.yaml", 0);
  TEST_ASSERT_EQUAL_INT(1, play_plan.negligible);
  play_prepare_drawn("S.1.2", 0);
  TEST_ASSERT_EQUAL_INT(0, play_plan.negligible);
}

/* ---- tables from files ---- */

static void save_table_of(const char *rows) {
  write_drawing("own.txt", rows);
  const int status = play_make("own.txt", NULL, 0, "own.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, play_why.text);
}

static void test_a_saved_table_gives_the_same_plan(void) {
  save_table_of("1..S3/....2");
  const plan saved = play_plan;
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_make("own.txt", "own.qtr", 0, NULL), play_why.text);
  TEST_ASSERT_EQUAL_DOUBLE(saved.expected_step, play_plan.expected_step);
  TEST_ASSERT_EQUAL_MEMORY(saved.step, play_plan.step, sizeof saved.step);
  TEST_ASSERT_EQUAL_MEMORY(saved.likelihood, play_plan.likelihood, sizeof saved.likelihood);
}

/* One line that names table, mission and what is different. */
static void refuse(const char *rows, const char *difference) {
  write_drawing("other.txt", rows);
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, play_make("other.txt", "own.qtr", 0, NULL), rows);
  TEST_ASSERT_NULL_MESSAGE(strchr(play_why.text, '\n'), play_why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "own.qtr"), play_why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "other.txt"), play_why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, difference), play_why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "learn it again"), play_why.text);
}

static void test_a_table_of_another_mission_is_refused_by_what_is_different(void) {
  save_table_of("1..S3/....2");
  refuse("1..S3/.#..2", "its map is another one");
  refuse("1..S3/~...2", "its map is another one");
  refuse("1..S3./....2.", "its map is another one");
  refuse("1..S3/.....", "other places");
  refuse("1..S3/...2.", "places lie elsewhere");
  refuse("1.SS3/....2", "another number of robots");
  refuse("1.S.3/....2", "start elsewhere");
}

static void test_a_file_that_is_no_table_is_refused(void) {
  write_drawing("own.txt", "1..S3");
  TEST_ASSERT_EQUAL_INT(-1, play_make("own.txt", "own.txt", 0, NULL));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "own.txt"), play_why.text);
  TEST_ASSERT_EQUAL_INT(-1, play_make("own.txt", "not_there.qtr", 0, NULL));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "not_there.qtr"), play_why.text);
}

static void test_a_table_whose_bytes_were_damaged_is_refused(void) {
  char bytes[4096];
  save_table_of("1..S3/....2");
  FILE *file = fopen("own.qtr", "rb");
  TEST_ASSERT_NOT_NULL(file);
  const size_t size = fread(bytes, 1, sizeof bytes, file);
  fclose(file);
  for (size_t at = 0; at < size; at += 7) {
    bytes[at] ^= 0x10;
    remove("damaged.qtr"); /* written anew it would wait for the disk each time */
    file = fopen("damaged.qtr", "wb");
    TEST_ASSERT_NOT_NULL(file);
    fwrite(bytes, 1, size, file);
    fclose(file);
    TEST_ASSERT_EQUAL_INT(-1, play_make("own.txt", "damaged.qtr", 0, NULL));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "damaged.qtr"), play_why.text);
    bytes[at] ^= 0x10;
  }
}

static void test_a_mission_that_cannot_be_played_is_refused(void) {
  TEST_ASSERT_EQUAL_INT(-1, play_make("not_there.yaml", NULL, 0, NULL));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "not_there.yaml"), play_why.text);
  write_drawing("closed.txt", "S#1");
  TEST_ASSERT_EQUAL_INT(-1, play_make("closed.txt", NULL, 0, NULL));
  TEST_ASSERT_NULL(strchr(play_why.text, '\n'));
}

/* ---- ended early ---- */

static void interrupt(int number) {
  (void)number;
  raise(SIGINT);
}

/* Ends the process with status 0 if all is as it should be: what stop.h notes is never forgotten. */
static void learn_interrupted(long microseconds) {
  const struct itimerval once = {{0, 0}, {0, microseconds}};
  signal(SIGVTALRM, interrupt);
  stop_begin();
  setitimer(ITIMER_VIRTUAL, &once, NULL);
  const int status = play_make(QUARTER_SOURCE_DIR "/tests/data/long.txt", NULL, 8, "early.qtr");
  const bool ended = status == -1 && play_why.status == EXIT_STOPPED && stop_signal() == SIGINT;
  const bool said =
      strstr(play_why.text, "(interrupted)") != NULL && strstr(play_why.text, "nothing was written") != NULL;
  _exit(ended && said && access("early.qtr", F_OK) != 0 ? 0 : 1);
}

/* After so much of the learner's own time: before there is a first plan, and long after it. */
static void test_a_signal_ends_the_learning_at_once_with_nothing_written(void) {
  const long moments[] = {1, 1000, 20000, 300000, 900000};
  for (unsigned i = 0; i < sizeof moments / sizeof moments[0]; i++) {
    int status = -1;
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) learn_interrupted(moments[i]);
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    snprintf(case_note, sizeof case_note, "after %ld microseconds", moments[i]);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_one_robots_plan_by_hand);
  RUN_TEST(test_the_chance_of_a_find_rises_at_the_visits);
  RUN_TEST(test_territories_are_those_of_the_routes);
  RUN_TEST(test_as_many_robots_start_as_are_asked_for);
  RUN_TEST(test_a_plan_has_its_missions_name);
  RUN_TEST(test_a_plan_counts_the_places_that_are_too_unlikely_to_be_certified);
  RUN_TEST(test_a_saved_table_gives_the_same_plan);
  RUN_TEST(test_a_table_of_another_mission_is_refused_by_what_is_different);
  RUN_TEST(test_a_file_that_is_no_table_is_refused);
  RUN_TEST(test_a_table_whose_bytes_were_damaged_is_refused);
  RUN_TEST(test_a_mission_that_cannot_be_played_is_refused);
  RUN_TEST(test_a_signal_ends_the_learning_at_once_with_nothing_written);
  plan_free(&play_plan);
  return UNITY_END();
}
