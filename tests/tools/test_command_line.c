/* The command line as an attacker and an accident would have it: small memory, full disks, closed outputs, outputs that
 * are inputs under another name, inputs that are no files. */
#include <fcntl.h>
#include <stdbool.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/tool_run.h"

static tool_result result;

void setUp(void) {
  write_file("area.txt", "S...\n#1.3\n...#\n1...\n");
  write_file("place.csv", "x,y,weight\n2.5,2.5,1\n");
  write_file("area.yaml", "map: area.txt\nrobots: [{column: 0, row: 0}]\nplaces_csv: place.csv\n");
  unlink("t.qtr");
  unlink("link.qtr");
}

void tearDown(void) {
}

/* Run a shell line in which $Q is the tool. */
static void run_shell(const char *line) {
  char command[4096];
  snprintf(command, sizeof command, "Q='%s'; { %s; } 2>err.txt", QUARTER_TOOL, line);
  const int status = system(command);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  read_text("err.txt", result.err, sizeof result.err);
}

static void expect_one_line(int status, const char *word, const char *note) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(status, result.status, note);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, word), result.err);
  TEST_ASSERT_EQUAL_PTR_MESSAGE(result.err + strlen(result.err) - 1, strchr(result.err, '\n'), result.err);
}

/* ---- memory ---- */

/* Open ground with a start and 8 places on it. */
static void write_square(const char *path, int side) {
  FILE *file = fopen(path, "w");
  TEST_ASSERT_NOT_NULL(file);
  for (int row = 0; row < side; row++)
    for (int column = 0; column <= side; column++) {
      const int cell = row * side + column;
      const bool is_place = cell % (side * side / 8) == side / 2;
      fputc(column == side ? '\n' : cell == 0 ? 'S' : is_place ? '1' : '.', file);
    }
  fclose(file);
}

/* Of address space a sanitizer takes terabytes for its own use. */
static void need_no_sanitizer(void) {
#ifdef __SANITIZE_ADDRESS__
  TEST_IGNORE_MESSAGE("a sanitizer takes more address space than any limit");
#endif
}

static void test_what_needs_no_memory_runs_in_50_megabytes(void) {
  need_no_sanitizer();
  static const char *const lines[] = {"--version",     "--help",        "learn --help", "tune --help",
                                      "draw --help",   "belief --help", "exact --help", "exact area.txt",
                                      "inspect t.qtr", "simulate t.qtr"};
  run_tool(&result, "learn area.txt -q -o t.qtr");
  for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
    char line[200];
    snprintf(line, sizeof line, "ulimit -v 51200; $Q %s >out.txt", lines[i]);
    run_shell(line);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, lines[i]);
  }
}

/* What a mission takes goes by the mission, not by the largest that the build holds. */
static void test_small_mission_runs_in_100_megabytes(void) {
  need_no_sanitizer();
  static const char *const lines[] = {"learn 30.txt -q --robots 16 -o 30.qtr",
                                      "learn 30.txt -q --aggregate spots --objective time --gap 1e-9",
                                      "learn 30.txt -q --learner paper --aggregate both --episodes 200",
                                      "learn 30.txt -q --cleared any --starts any --start-regions 2",
                                      "tune 30.txt -q --learner paper --episodes 5",
                                      "draw 30.txt --regions --spots -o 30.svg",
                                      "draw 30.qtr -o 30.svg",
                                      "exact 30.txt --robots 2",
                                      "simulate 30.qtr",
                                      "inspect 30.qtr"};
  write_square("30.txt", 30);
  for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
    char line[200];
    snprintf(line, sizeof line, "ulimit -v 100000; $Q %s >out.txt", lines[i]);
    run_shell(line);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", result.err, lines[i]);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, lines[i]);
  }
}

static void test_memory_that_is_not_to_be_had_is_said(void) {
  need_no_sanitizer();
  static const char *const lines[] = {"learn area.txt -o no.qtr --learner paper --aggregate regions",
                                      "tune area.txt --learner paper --episodes 2"};
  for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
    char line[200];
    snprintf(line, sizeof line, "ulimit -v 16384; $Q %s", lines[i]);
    run_shell(line);
    expect_one_line(2, "no memory", lines[i]);
  }
  TEST_ASSERT_EQUAL_INT(-1, access("no.qtr", F_OK));
}

/* ---- standard output ---- */

/* Every way to say something, sent to `where`. */
static void expect_unsaid(const char *where) {
  static const char *const lines[] = {"--help",
                                      "--version",
                                      "learn --help",
                                      "exact --help",
                                      "simulate --help",
                                      "inspect --help",
                                      "draw --help",
                                      "tune --help",
                                      "belief --help",
                                      "learn area.txt",
                                      "exact area.txt",
                                      "inspect t.qtr",
                                      "simulate t.qtr",
                                      "tune area.txt",
                                      "learn area.txt --json",
                                      "learn area.txt -o -",
                                      "draw area.txt -o -",
                                      "belief area.txt --history games.csv"};
  run_tool(&result, "learn area.txt -q -o t.qtr");
  write_file("games.csv", "place\n1\n");
  for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
    char line[200];
    snprintf(line, sizeof line, "$Q %s %s", lines[i], where);
    run_shell(line);
    expect_one_line(2, "cannot write", lines[i]);
  }
}

static void test_nothing_that_was_not_said_counts_as_said(void) {
  expect_unsaid(">/dev/full");
}

/* What is preloaded into every program, as faketime is, opens files of its own before a program begins. */
static void need_closed_descriptors(void) {
  run_shell("env test -e /proc/self/fd/1 >&-");
  if (result.status == 0) TEST_IGNORE_MESSAGE("a preloaded library takes what is closed");
}

static void test_a_closed_output_is_no_output(void) {
  need_closed_descriptors();
  expect_unsaid(">&-");
}

/* What is closed is not taken for the first file opened. */
static void test_a_report_never_ends_up_in_a_table_for_a_closed_output(void) {
  need_closed_descriptors();
  run_shell("$Q learn area.txt -o t.qtr >&-");
  TEST_ASSERT_EQUAL_INT(2, result.status);
  run_tool(&result, "inspect t.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
}

static void test_a_report_never_ends_up_in_a_table(void) {
  run_shell("$Q learn area.txt -o - >t.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  run_tool(&result, "inspect t.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
}

/* ---- outputs ---- */

static void expect_refused(const char *words, const char *reason) {
  run_tool(&result, "%s", words);
  TEST_ASSERT_EQUAL_STRING_MESSAGE("", result.out, words);
  expect_one_line(2, reason, words);
}

static void test_no_input_is_written_over_under_any_name(void) {
  static const char *const inputs[] = {"area.yaml", "area.txt", "place.csv"};
  for (int i = 0; i < 3; i++) {
    char before[400], after[400], words[200];
    read_text(inputs[i], before, sizeof before);
    unlink("soft");
    unlink("hard");
    TEST_ASSERT_EQUAL_INT(0, symlink(inputs[i], "soft"));
    TEST_ASSERT_EQUAL_INT(0, link(inputs[i], "hard"));
    const char *const names[] = {inputs[i], "soft", "hard"};
    for (int j = 0; j < 3; j++) {
      static const char *const options[] = {
          "learn area.yaml -o ",     "learn area.yaml --c ",   "learn area.yaml --curve ", "learn area.yaml --json=",
          "exact area.yaml --json=", "tune area.yaml --json=", "draw area.yaml -o "};
      for (size_t k = 0; k < sizeof options / sizeof options[0]; k++) {
        snprintf(words, sizeof words, "%s%s", options[k], names[j]);
        expect_refused(words, "is what is read");
      }
    }
    read_text(inputs[i], after, sizeof after);
    TEST_ASSERT_EQUAL_STRING(before, after);
  }
  run_tool(&result, "learn area.txt -q -o t.qtr");
  expect_refused("inspect t.qtr --json=./t.qtr", "is what is read");
  expect_refused("simulate t.qtr --json=t.qtr", "is what is read");
  expect_refused("draw t.qtr -o t.qtr", "is what is read");
}

static void test_no_two_outputs_are_one_file(void) {
  char folder[4096];
  expect_refused("learn area.txt -o a.out --c a.out", "--c a.out: is where --output goes");
  expect_refused("learn area.txt -o a.out --json=./a.out", "is where --output goes");
  expect_refused("learn area.txt -o - --json", "is where --output goes");
  TEST_ASSERT_NOT_NULL(getcwd(folder, sizeof folder));
  TEST_ASSERT_EQUAL_INT(0, setenv("FOLDER", folder, 1)); /* for the shell: the path may hold any quotes */
  expect_refused("learn area.txt --curve \"$FOLDER/a.out\" -o a.out", "is where --output goes");
  write_file("t.qtr", "old");
  TEST_ASSERT_EQUAL_INT(0, symlink("t.qtr", "link.qtr"));
  expect_refused("draw area.txt -o t.qtr --json=link.qtr", "is where --output goes");
  TEST_ASSERT_EQUAL_INT(-1, access("a.out", F_OK));
}

static void test_a_file_that_is_replaced_keeps_its_mode_and_its_link(void) {
  struct stat about;
  write_file("t.qtr", "old");
  TEST_ASSERT_EQUAL_INT(0, chmod("t.qtr", 0640));
  TEST_ASSERT_EQUAL_INT(0, symlink("t.qtr", "link.qtr"));
  run_tool(&result, "learn area.txt -q -o link.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  TEST_ASSERT_EQUAL_INT(0, lstat("link.qtr", &about));
  TEST_ASSERT_TRUE(S_ISLNK(about.st_mode));
  TEST_ASSERT_EQUAL_INT(0, stat("t.qtr", &about));
  TEST_ASSERT_EQUAL_INT(0640, about.st_mode & 0777);
  run_tool(&result, "inspect t.qtr");
  TEST_ASSERT_EQUAL_INT(0, result.status);
}

/* ---- inputs that are no files ---- */

static void test_pipes_folders_and_devices_are_no_inputs(void) {
  static const char *const commands[] = {"learn", "exact",   "draw -o x.svg", "export -o x.csv",
                                         "tune",  "inspect", "simulate",      "belief"};
  static const char *const inputs[] = {"pipe", ".", "/dev/null", "nowhere", "''"};
  unlink("pipe");
  TEST_ASSERT_EQUAL_INT(0, mkfifo("pipe", 0600));
  for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
    for (size_t j = 0; j < sizeof inputs / sizeof inputs[0]; j++) {
      char words[200];
      snprintf(words, sizeof words, "%s %s", commands[i], inputs[j]);
      expect_refused(words, inputs[j][0] == '\'' ? "empty" : inputs[j]);
    }
  }
}

/* ---- exit statuses ---- */

static void test_places_left_unvisited_have_a_status_of_their_own(void) {
  run_tool(&result, "learn area.txt -q -o t.qtr");
  run_tool(&result, "simulate t.qtr -q");
  TEST_ASSERT_EQUAL_INT(0, result.status);
  run_tool(&result, "simulate t.qtr -q --lost 0@0");
  TEST_ASSERT_EQUAL_INT(4, result.status);
  run_tool(&result, "simulate t.qtr -q --target 1");
  TEST_ASSERT_EQUAL_INT(0, result.status);
  run_tool(&result, "simulate t.qtr -q --target 1 --lost 0@0");
  TEST_ASSERT_EQUAL_INT(4, result.status);
}

/* Told by the number of places, and not by the work: the drawing's map is cut in two, which only the work finds out. */
static void test_too_many_places_for_the_exact_solver_are_refused_before_any_work(void) {
  write_file("many.txt", "S#1111111111\n##1111111111\n.#1111111111\n");
  expect_refused("exact many.txt", "30 places");
  expect_refused("exact many.txt --robots 2 --rule paper", "30 places");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_needs_no_memory_runs_in_50_megabytes);
  RUN_TEST(test_small_mission_runs_in_100_megabytes);
  RUN_TEST(test_memory_that_is_not_to_be_had_is_said);
  RUN_TEST(test_nothing_that_was_not_said_counts_as_said);
  RUN_TEST(test_a_closed_output_is_no_output);
  RUN_TEST(test_a_report_never_ends_up_in_a_table_for_a_closed_output);
  RUN_TEST(test_a_report_never_ends_up_in_a_table);
  RUN_TEST(test_no_input_is_written_over_under_any_name);
  RUN_TEST(test_no_two_outputs_are_one_file);
  RUN_TEST(test_a_file_that_is_replaced_keeps_its_mode_and_its_link);
  RUN_TEST(test_pipes_folders_and_devices_are_no_inputs);
  RUN_TEST(test_places_left_unvisited_have_a_status_of_their_own);
  RUN_TEST(test_too_many_places_for_the_exact_solver_are_refused_before_any_work);
  return UNITY_END();
}
