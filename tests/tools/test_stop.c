/* The host tool ended early, by a time limit or by a signal at any moment from its first: a policy that is whole and
 * says why it ended, or nothing written and an exit status of its own. Moments are counted in the tool's own processor
 * time, so that a loaded machine sees the same ones. */
#include <dirent.h>
#include <sched.h>
#include <signal.h>
#include <stdint.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "support/tool_run.h"

#define LONG QUARTER_SOURCE_DIR "/tests/data/long.txt"
#define SHORT QUARTER_SOURCE_DIR "/demo/missions/minefield/mission.yaml"
#define EXACT QUARTER_SOURCE_DIR "/tests/data/reference/case12.txt"

static tool_result result, other;

void setUp(void) {
  remove("t.qtr");
}

void tearDown(void) {
}

static int exists(const char *path) {
  struct stat about;
  return stat(path, &about) == 0;
}

/* 128 places on 60x60 cells: a first plan takes seconds to be improved. */
static void write_many(void) {
  char text[61 * 60 + 1];
  for (int cell = 0; cell < 61 * 60; cell++) text[cell] = cell % 61 == 60 ? '\n' : '.';
  for (int place = 0; place < 128; place++) {
    const int cell = 11 + place * 28;
    text[cell / 60 * 61 + cell % 60] = (char)('1' + place * 7 % 9);
  }
  text[0] = 'S';
  text[61 * 60] = '\0';
  write_file("many.txt", text);
}

/* ---- signals ---- */

static void start_tool(const char *const *words, int pending) {
  sigset_t held;
  if (freopen("out.txt", "w", stdout) == NULL || freopen("err.txt", "w", stderr) == NULL) _exit(127);
  if (pending != 0) {
    sigemptyset(&held);
    sigaddset(&held, pending);
    sigprocmask(SIG_BLOCK, &held, NULL);
    raise(pending);
  }
  execv(QUARTER_TOOL, (char *const *)(uintptr_t)words);
  _exit(127);
}

static int has_ended(pid_t child) {
  siginfo_t ended = {.si_pid = 0};
  waitid(P_PID, (id_t)child, &ended, WEXITED | WNOHANG | WNOWAIT);
  return ended.si_pid != 0;
}

/* Whether the process catches the signal: the kernel's own account of it. */
static int catches(pid_t child, int number) {
  char path[64], text[4096];
  snprintf(path, sizeof path, "/proc/%ld/status", (long)child);
  read_text(path, text, sizeof text);
  const char *caught = strstr(text, "SigCgt:");
  return caught != NULL && (strtoull(caught + 7, NULL, 16) >> (number - 1) & 1u) != 0;
}

static double used_milliseconds(pid_t child) {
  clockid_t clock;
  struct timespec used = {0, 0};
  if (clock_getcpuclockid(child, &clock) == 0) clock_gettime(clock, &used);
  return 1e3 * (double)used.tv_sec + 1e-6 * (double)used.tv_nsec;
}

/* Until the process has used so much processor time since it began to catch the signal, or has ended. */
static void await(pid_t child, int number, double milliseconds) {
  while (!has_ended(child) && !catches(child, number)) sched_yield();
  const double begin = used_milliseconds(child);
  while (!has_ended(child) && used_milliseconds(child) < begin + milliseconds) sched_yield();
}

/* Run the tool and send it the signal after so much of its processor time; -1: it is there before the tool starts. */
static void run_signalled(const char *const *words, int number, long milliseconds) {
  int status = 0;
  fflush(stdout);
  const pid_t child = fork();
  if (child == 0) start_tool(words, milliseconds < 0 ? number : 0);
  TEST_ASSERT_TRUE(child > 0);
  if (milliseconds >= 0) await(child, number, (double)milliseconds);
  if (milliseconds >= 0) kill(child, number);
  TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  read_text("out.txt", result.out, sizeof result.out);
  read_text("err.txt", result.err, sizeof result.err);
}

static void expect_whole_or_nothing(const char *reason, int status, const char *note) {
  if (result.status == 3) {
    TEST_ASSERT_FALSE_MESSAGE(exists("t.qtr"), note);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", result.out, note);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, reason), result.err);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "a first plan, which takes about"), result.err);
    TEST_ASSERT_EQUAL_PTR_MESSAGE(result.err + strlen(result.err) - 1, strchr(result.err, '\n'), result.err);
    return;
  }
  TEST_ASSERT_EQUAL_INT_MESSAGE(status, result.status, note);
  TEST_ASSERT_TRUE_MESSAGE(strncmp(json_text(result.out, "ended") + 1, reason, strlen(reason)) == 0, result.out);
  run_tool(&other, "simulate t.qtr --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, other.status, other.err);
  /* Who is done early takes over from others, so that what is not optimal may get better. */
  TEST_ASSERT_TRUE_MESSAGE(
      json_value(other.out, "expected_time") <= (1.0 + 1e-7) * json_value(result.out, "expected_time"), note);
}

static void signal_at_many_moments(const char *const *words) {
  static const long moments[] = {-1, 0, 1, 2, 3, 5, 8, 13, 21, 34, 55, 89, 144, 233};
  for (size_t i = 0; i < sizeof moments / sizeof moments[0]; i++) {
    char note[64];
    const int number = i % 2 == 0 ? SIGINT : SIGTERM;
    snprintf(note, sizeof note, "signal %d at %ld ms", number, moments[i]);
    remove("t.qtr");
    run_signalled(words, number, moments[i]);
    expect_whole_or_nothing("interrupted", 128 + number, note);
  }
}

#define LEARN(...) ((const char *const[]){"quarter", "learn", "--gap", "0", "--json", "-o", "t.qtr", __VA_ARGS__, NULL})

static void test_a_signal_at_any_moment_ends_the_search_with_the_best_policy(void) {
  signal_at_many_moments(LEARN(LONG, "--robots", "8"));
}

static void test_a_signal_while_the_first_plan_is_improved(void) {
  write_many();
  signal_at_many_moments(LEARN("many.txt", "--objective", "time"));
}

static void test_a_signal_with_spots(void) {
  write_many();
  signal_at_many_moments(LEARN("many.txt", "--aggregate", "spots", "--spot-size", "8"));
}

static void test_a_signal_in_the_paper_setting(void) {
  write_many();
  signal_at_many_moments(LEARN("many.txt", "--learner", "paper", "--aggregate", "both"));
}

static void test_a_signal_that_was_there_before_the_plan_is_told_from_one_after_it(void) {
  run_signalled(LEARN(LONG, "--robots", "8"), SIGINT, -1);
  TEST_ASSERT_EQUAL_INT(3, result.status);
  run_signalled(LEARN(LONG, "--robots", "8"), SIGINT, 300);
  TEST_ASSERT_EQUAL_INT(130, result.status);
}

/* ---- the time limit ---- */

static void limit(const char *words, double seconds) {
  char note[256];
  snprintf(note, sizeof note, "%s --time-limit %g", words, seconds);
  remove("t.qtr");
  run_tool(&result, "learn %s --time-limit %g -o t.qtr --json", words, seconds);
  expect_whole_or_nothing("time limit", 0, note);
}

static void test_a_time_limit_of_any_length_gives_a_policy_or_none(void) {
  static const double limits[] = {0.001, 0.003, 0.01, 0.03, 0.1, 0.3};
  write_many();
  for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
    limit("many.txt --robots 2", limits[i]);
    limit("many.txt --robots 16 --rule paper", limits[i]);
    limit("many.txt --aggregate spots", limits[i]);
    limit("many.txt --learner paper --aggregate both", limits[i]);
  }
}

/* What is learnt of the other starts is in the table, and the mission's own plan is the report's, whenever the end
 * came. */
static void test_a_table_for_any_start_holds_what_was_learnt_in_time(void) {
  static const double limits[] = {0.02, 0.1, 0.5};
  write_file("wide.txt", "S......2..#.....\n#1.3......5...1.\n...#......#...7.\n1.....4.......9.\n");
  for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
    run_tool(&result,
             "learn wide.txt --robots 4 --starts any --region-size 3 --region-diameter 3 --table-limit 1000 -o t.qtr"
             " --json --time-limit %g",
             limits[i]);
    if (result.status == 3) continue;
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
    TEST_ASSERT_TRUE(json_is(result.out, "complete", "false"));
    run_tool(&other, "simulate t.qtr --json");
    TEST_ASSERT_DOUBLE_WITHIN(1e-8, json_value(result.out, "value"), json_value(other.out, "value"));
    run_tool(&other, "simulate t.qtr --from 15,0 --from 15,3 --from 0,3 --from 9,0 --json");
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, other.status, other.err);
    TEST_ASSERT_TRUE(json_is(other.out, "unvisited", "[]"));
  }
}

static void test_tuning_reports_what_was_tried_in_time(void) {
  write_many();
  run_tool(&result, "tune many.txt --robots 4 --time-limit 1 --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_TRUE(json_value(result.out, "tried") >= 1.0);
  TEST_ASSERT_TRUE(json_value(result.out, "tried") < json_value(result.out, "planned"));
  run_signalled((const char *const[]){"quarter", "tune", "many.txt", "--robots", "4", NULL}, SIGTERM, 500);
  TEST_ASSERT_EQUAL_INT_MESSAGE(143, result.status, result.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.out, "interrupted"), result.out);
}

/* ---- commands that have nothing to show before their end ---- */

static int is_temporary(const struct dirent *entry) {
  return strncmp(entry->d_name, "made.", 5) == 0 && strlen(entry->d_name) > 9;
}

/* Files of the test's folder that stand beside the name they are to get, "made.csv.sv4gYw". */
static int count_temporary(void) {
  struct dirent **found;
  const int count = scandir(".", &found, is_temporary, alphasort);
  for (int i = 0; i < count; i++) free(found[i]);
  if (count >= 0) free(found);
  return count;
}

/* `words`, told to write made.*, end whole with 0 or at once with the signal's status. */
static void end_at_many_moments(const char *const *words, const char *made) {
  static const long moments[] = {-1, 0, 1, 2, 3, 5, 8, 13, 21};
  write_file("games.csv", "place\n1\n2\n");
  run_tool(&other, "learn %s -o t.qtr -q", SHORT);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, other.status, other.err);
  for (size_t i = 0; i < sizeof moments / sizeof moments[0]; i++) {
    char note[64];
    const int number = i % 2 == 0 ? SIGINT : SIGTERM;
    snprintf(note, sizeof note, "%s, signal %d at %ld ms", words[1], number, moments[i]);
    remove(made);
    run_signalled(words, number, moments[i]);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, count_temporary(), note);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", result.err, note);
    if (result.status == 0) TEST_ASSERT_TRUE_MESSAGE(exists(made), note);
    if (result.status != 0) TEST_ASSERT_EQUAL_INT_MESSAGE(128 + number, result.status, note);
    if (moments[i] < 0) TEST_ASSERT_FALSE_MESSAGE(exists(made), note);
  }
}

static void test_a_signal_ends_commands_that_answer_at_once(void) {
  end_at_many_moments((const char *const[]){"quarter", "exact", EXACT, "--json=made.json", NULL}, "made.json");
  end_at_many_moments((const char *const[]){"quarter", "draw", "t.qtr", "-o", "made.svg", "-q", NULL}, "made.svg");
  end_at_many_moments((const char *const[]){"quarter", "simulate", "t.qtr", "--json=made.json", NULL}, "made.json");
  end_at_many_moments((const char *const[]){"quarter", "inspect", "t.qtr", "--json=made.json", NULL}, "made.json");
  end_at_many_moments(
      (const char *const[]){"quarter", "belief", SHORT, "--history", "games.csv", "-o", "made.csv", "-q", NULL},
      "made.csv");
}

/* `belief` opens all that it writes before it writes: here it waits for a reader of the pipe, with made.csv begun. */
static void test_a_file_that_a_signal_finds_half_written_goes(void) {
  static const char *const words[] = {"quarter", "belief",   SHORT,         "--history", "games.csv",
                                      "-o",      "made.csv", "--json=pipe", NULL};
  int status = 0;
  write_file("games.csv", "place\n1\n2\n");
  write_file("made.csv", "as it was\n");
  remove("pipe");
  TEST_ASSERT_EQUAL_INT(0, mkfifo("pipe", 0600));
  fflush(stdout);
  const pid_t child = fork();
  if (child == 0) start_tool(words, 0);
  while (!has_ended(child) && count_temporary() == 0) sched_yield();
  TEST_ASSERT_FALSE(has_ended(child));
  kill(child, SIGTERM);
  TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
  TEST_ASSERT_TRUE(WIFEXITED(status));
  TEST_ASSERT_EQUAL_INT(143, WEXITSTATUS(status));
  TEST_ASSERT_EQUAL_INT(0, count_temporary());
  read_text("made.csv", result.out, sizeof result.out);
  TEST_ASSERT_EQUAL_STRING("as it was\n", result.out);
  remove("made.csv");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_signal_at_any_moment_ends_the_search_with_the_best_policy);
  RUN_TEST(test_a_signal_while_the_first_plan_is_improved);
  RUN_TEST(test_a_signal_with_spots);
  RUN_TEST(test_a_signal_in_the_paper_setting);
  RUN_TEST(test_a_signal_that_was_there_before_the_plan_is_told_from_one_after_it);
  RUN_TEST(test_a_time_limit_of_any_length_gives_a_policy_or_none);
  RUN_TEST(test_a_table_for_any_start_holds_what_was_learnt_in_time);
  RUN_TEST(test_tuning_reports_what_was_tried_in_time);
  RUN_TEST(test_a_signal_ends_commands_that_answer_at_once);
  RUN_TEST(test_a_file_that_a_signal_finds_half_written_goes);
  return UNITY_END();
}
