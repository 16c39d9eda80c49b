/* Tables of the past, read as ever: each tests/golden/NAME.qtr says what NAME.read says. Given the name of a table, it prints
 * that instead (tests/golden/README.md). */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "quarter/robot.h"
#include "robot/layout.h"
#include "unity.h"

#define GOLDEN QUARTER_SOURCE_DIR "/tests/golden/"

static uint8_t bytes[1 << 18];
static uint32_t size;
static qtr_policy policy;
static char said[1 << 17];
static size_t length;

void setUp(void) {
}

void tearDown(void) {
}

static void __attribute__((format(printf, 1, 2))) say(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int written = vsnprintf(said + length, sizeof said - length, format, arguments);
  va_end(arguments);
  TEST_ASSERT_TRUE(written >= 0 && length + (size_t)written < sizeof said);
  length += (size_t)written;
}

static size_t read_file(const char *path, void *into, size_t room) {
  FILE *file = fopen(path, "rb");
  TEST_ASSERT_NOT_NULL_MESSAGE(file, path);
  const size_t got = fread(into, 1, room, file);
  fclose(file);
  TEST_ASSERT_LESS_THAN_MESSAGE(room, got, path);
  return got;
}

/* ---- what a table says ---- */

/* By its bits: no rounding, no locale. */
static void say_double(const char *name, uint32_t offset) {
  say("%s", name);
  for (unsigned i = 8; i-- > 0;) say("%s%02x", i == 7 ? " " : "", bytes[offset + i]);
  say("\n");
}

static void say_header(void) {
  const qtr_board *board = &policy.board;
  say("digest %08lx\n", (unsigned long)qtr_policy_digest(&policy));
  say("places %u robots %u starts %u rule %u longest way %lu\n", board->places, board->seekers, board->starts,
      board->rule, (unsigned long)board->keys.longest);
  say("records %lu of %u-word keys, %u bits\n", (unsigned long)policy.records, board->keys.words, board->keys.bits);
  say("objective %u certified %u\n", bytes[QTR_POLICY_OBJECTIVE], bytes[QTR_POLICY_CERTIFIED]);
  say_double("gamma", QTR_POLICY_GAMMA);
  say_double("value", QTR_POLICY_VALUE);
  say_double("expected time", QTR_POLICY_TIME);
  say_double("bound", QTR_POLICY_BOUND);
  say_double("gap", QTR_POLICY_GAP);
}

static void say_map(void) {
  for (unsigned row = 0; row < policy.grid.rows; row++) {
    say("map ");
    for (unsigned column = 0; column < policy.grid.columns; column++) {
      const unsigned cost = qtr_grid_cost(&policy.grid, (qtr_cell)(row * policy.grid.columns + column));
      say("%c", cost == 0 ? '#' : cost == 1 ? '.' : (char)('0' + cost % 10));
    }
    say("\n");
  }
}

static void say_nodes(void) {
  for (unsigned place = 0; place < policy.board.places; place++)
    say("place %u cell %lu weight %08lx\n", place, (unsigned long)qtr_policy_cell(&policy, place),
        (unsigned long)qtr_policy_weight(&policy, place));
  for (unsigned start = 0; start < policy.board.starts; start++)
    say("start %u cell %lu\n", start, (unsigned long)qtr_policy_cell(&policy, policy.board.places + start));
}

/* Every robot's route in nominal time, a place@the step at which it is chosen. */
static void say_routes(const char *name, const qtr_cell *starts, const qtr_places *cleared) {
  qtr_deployment deployment;
  uint32_t off_table = 0;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, &policy, starts, cleared));
  for (int seeker = 0; seeker < policy.board.seekers; seeker++) {
    qtr_joint joint;
    qtr_steps now = 0;
    uint16_t place;
    say("%s: robot %d:", name, seeker);
    qtr_joint_start(&joint, &policy.board, deployment.start_of, &deployment.cleared);
    while ((place = qtr_policy_play(&policy, &joint, seeker, &now, &off_table)) != QTR_STAND_DOWN)
      say(" %u@%lu", place, (unsigned long)now);
    say(" done@%lu\n", (unsigned long)now);
  }
  say("%s: off the table %lu\n", name, (unsigned long)off_table);
}

/* Every third place cleared: mostly off the table, so by weight for the way. */
static void say_routes_of_the_rest(void) {
  qtr_places cleared;
  qtr_places_clear(&cleared);
  for (unsigned place = 0; place < policy.board.places; place += 3) qtr_places_add(&cleared, place);
  say_routes("every third cleared", NULL, &cleared);
}

/* Each free cell of a table for any start, all robots there. */
static void say_deployments(void) {
  for (uint32_t cell = 0; policy.regions != NULL && cell < qtr_grid_cells(&policy.grid); cell++) {
    qtr_cell starts[QTR_MAX_SEEKERS];
    char name[40];
    for (unsigned i = 0; i < policy.board.seekers; i++) starts[i] = (qtr_cell)cell;
    if (qtr_grid_cost(&policy.grid, (qtr_cell)cell) == 0) continue;
    snprintf(name, sizeof name, "all from cell %lu", (unsigned long)cell);
    say_routes(name, starts, NULL);
  }
}

static void read_table(const char *path) {
  length = 0;
  size = (uint32_t)read_file(path, bytes, sizeof bytes);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(&policy, bytes, size), path);
  say_header();
  say_map();
  say_nodes();
  say_routes("plan", NULL, NULL);
  say_routes_of_the_rest();
  say_deployments();
}

/* ---- the tables ---- */

static void expect_read_as_ever(const char *name) {
  static char expected[sizeof said];
  char path[1000];
  snprintf(path, sizeof path, GOLDEN "%s.read", name);
  expected[read_file(path, expected, sizeof expected)] = '\0';
  snprintf(path, sizeof path, GOLDEN "%s.qtr", name);
  read_table(path);
  TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, said, name);
}

static void test_31_places(void) {
  expect_read_as_ever("places-31");
  expect_read_as_ever("places-31-2");
}

static void test_32_places(void) {
  expect_read_as_ever("places-32");
  expect_read_as_ever("places-32-2");
}

static void test_33_places(void) {
  expect_read_as_ever("places-33");
  expect_read_as_ever("places-33-2");
}

static void test_63_places(void) {
  expect_read_as_ever("places-63");
  expect_read_as_ever("places-63-2");
}

static void test_64_places(void) {
  expect_read_as_ever("places-64");
  expect_read_as_ever("places-64-2");
}

static void test_65_places(void) {
  expect_read_as_ever("places-65");
  expect_read_as_ever("places-65-2");
}

static void test_any_start(void) {
  expect_read_as_ever("any-start");
  expect_read_as_ever("any-start-2");
}

static void test_most_places_and_robots(void) {
  expect_read_as_ever("most");
  expect_read_as_ever("most-2");
}

static void test_golden_tables_are_what_their_names_say(void) {
  read_table(GOLDEN "most.qtr");
  TEST_ASSERT_EQUAL(128, policy.board.places);
  TEST_ASSERT_EQUAL(16, policy.board.seekers);
  TEST_ASSERT_EQUAL(1, policy.format);
  read_table(GOLDEN "any-start.qtr");
  TEST_ASSERT_NOT_NULL(policy.regions);
  read_table(GOLDEN "most-2.qtr");
  TEST_ASSERT_EQUAL(2, policy.format);
}

int main(int argc, char **argv) {
  if (argc > 1) {
    read_table(argv[1]);
    return fputs(said, stdout) < 0;
  }
  UNITY_BEGIN();
  RUN_TEST(test_31_places);
  RUN_TEST(test_32_places);
  RUN_TEST(test_33_places);
  RUN_TEST(test_63_places);
  RUN_TEST(test_64_places);
  RUN_TEST(test_65_places);
  RUN_TEST(test_any_start);
  RUN_TEST(test_most_places_and_robots);
  RUN_TEST(test_golden_tables_are_what_their_names_say);
  return UNITY_END();
}
