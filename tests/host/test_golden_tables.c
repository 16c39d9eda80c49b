/* Tables of the past, read as ever: each tests/golden/NAME.qtr says what NAME.read says. Given the path of a table, it
 * prints that instead (tests/golden/README.md). */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "host/table/table.h"
#include "quarter/digest.h"
#include "quarter/nominal.h"
#include "quarter/robot.h"
#include "robot/joint_key.h"
#include "robot/layout.h"
#include "unity.h"

#define GOLDEN QUARTER_SOURCE_DIR "/tests/golden/"

static table t;
static const qtr_policy *const policy = &t.policy;
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

/* ---- what a table says ---- */

/* By its bits: no rounding, no locale. */
static void say_double(const char *name, const uint8_t *bytes) {
  say("%s %016llx\n", name, (unsigned long long)qtr_load64(bytes));
}

/* Of the greatest key of format 1: all places visited, all seekers stood down with the longest way to go. */
static unsigned key_bits_1(const qtr_key_shape *shape) {
  qtr_joint greatest = {0};
  qtr_key key;
  for (unsigned place = 0; place < shape->places; place++) qtr_places_add(&greatest.visited, place);
  for (unsigned i = 0; i < shape->seekers; i++) {
    greatest.node[i] = shape->nodes;
    greatest.remaining[i] = shape->longest;
  }
  const unsigned words = qtr_joint_key_1(&key, &greatest, shape);
  unsigned bits = 32 * words;
  while (bits > 0 && ((key.word[(bits - 1) / 32] >> ((bits - 1) % 32)) & 1u) == 0) bits--;
  return bits;
}

static void say_header(void) {
  const qtr_board *board = &policy->board;
  const uint8_t *bytes = policy->bytes;
  say("digest %08lx\n", (unsigned long)qtr_policy_digest(policy));
  say("places %u robots %u starts %u rule %u longest way %lu\n", board->places, board->seekers, board->starts,
      board->rule, (unsigned long)board->keys.longest);
  say("records %lu of %u-word keys, %u bits\n", (unsigned long)policy->records, bytes[QTR_POLICY_KEY_WORDS],
      policy->format == 1 ? key_bits_1(&board->keys) : board->keys.bits);
  say("objective %u certified %u\n", bytes[QTR_POLICY_OBJECTIVE], bytes[QTR_POLICY_CERTIFIED]);
  say_double("gamma", bytes + QTR_POLICY_GAMMA);
  say_double("value", bytes + QTR_POLICY_VALUE);
  say_double("expected time", bytes + QTR_POLICY_TIME);
  say_double("bound", bytes + QTR_POLICY_BOUND);
  say_double("gap", bytes + QTR_POLICY_GAP);
}

static void say_map(void) {
  for (unsigned row = 0; row < policy->grid.rows; row++) {
    say("map ");
    for (unsigned column = 0; column < policy->grid.columns; column++) {
      const unsigned cost = qtr_grid_cost(&policy->grid, (qtr_cell)(row * policy->grid.columns + column));
      say("%c", cost == 0 ? '#' : cost == 1 ? '.' : (char)('0' + cost % 10));
    }
    say("\n");
  }
}

static void say_nodes(void) {
  for (unsigned place = 0; place < policy->board.places; place++)
    say("place %u cell %lu weight %08lx\n", place, (unsigned long)qtr_policy_cell(policy, place),
        (unsigned long)qtr_policy_weight(policy, place));
  for (unsigned start = 0; start < policy->board.starts; start++)
    say("start %u cell %lu\n", start, (unsigned long)qtr_policy_cell(policy, policy->board.places + start));
}

/* What the field's terms add; formats and tables without them say nothing of it. */
static void say_terms(void) {
  const qtr_board *board = &policy->board;
  if ((policy->features & QTR_FEATURE_TERMS) == 0) return;
  say("classes %u clock %lu deadline %lu found", qtr_board_classes(board), (unsigned long)board->terms.clock,
      (unsigned long)t.claim.deadline);
  say_double("", policy->bytes + QTR_POLICY_FOUND);
  for (unsigned i = 0; i < board->seekers; i++) {
    say("robot %u class %u steps a cell %lu ready %lu end %lu: from its start", i, board->class_of[i],
        (unsigned long)qtr_claim_cell_steps(policy, board->class_of[i]), (unsigned long)qtr_board_ready(board, i),
        (unsigned long)qtr_board_end(board, i));
    for (unsigned place = 0; place < board->places; place++)
      say(" %lu", (unsigned long)qtr_board_steps(board, i, board->places + board->start_of[i], place));
    say("\n");
  }
  for (unsigned place = 0; place < board->places; place++)
    say("place %u is a look at %u\n", place, qtr_policy_place(policy, place));
}

/* Until the seeker chooses, or is known to have nothing left. */
static uint16_t choose_next(qtr_joint *joint, int seeker, qtr_steps *now, unsigned *off_table) {
  while (joint->node[seeker] != QTR_STAND_DOWN) {
    const int chooser = qtr_joint_chooser(joint, &policy->board);
    bool off = false;
    if (chooser == QTR_NOBODY) {
      const qtr_steps passed = qtr_joint_advance(joint, &policy->board, NULL);
      if (passed == 0) break;
      *now += passed;
      continue;
    }
    const uint16_t choice = qtr_policy_choose(policy, joint, chooser, &off);
    qtr_joint_choose(joint, &policy->board, chooser, choice);
    *off_table += off;
    if (chooser == seeker) return choice;
  }
  return QTR_STAND_DOWN;
}

/* Every robot's route in nominal time, a place@the step at which it is chosen. */
static void say_routes(const char *name, const uint16_t *start_of, const qtr_places *cleared) {
  unsigned off_table = 0;
  for (int seeker = 0; seeker < policy->board.seekers; seeker++) {
    qtr_joint joint;
    qtr_steps now = 0;
    uint16_t place;
    say("%s: robot %d:", name, seeker);
    qtr_joint_start(&joint, &policy->board, start_of, cleared);
    while ((place = choose_next(&joint, seeker, &now, &off_table)) != QTR_STAND_DOWN)
      say(" %u@%lu", place, (unsigned long)now);
    say(" done@%lu\n", (unsigned long)now);
  }
  say("%s: off the table %u\n", name, off_table);
}

/* Every third place cleared: mostly off the table, so by weight for the way. */
static void say_routes_of_the_rest(void) {
  qtr_places cleared;
  qtr_places_clear(&cleared);
  for (unsigned place = 0; place < policy->board.places; place += 3) qtr_places_add(&cleared, place);
  say_routes("every third cleared", NULL, &cleared);
}

/* Each free cell of a table for any start, all robots there. */
static void say_deployments(void) {
  for (uint32_t cell = 0; policy->any_start && cell < qtr_grid_cells(&policy->grid); cell++) {
    qtr_deployment deployment;
    qtr_cell starts[QTR_MAX_SEEKERS];
    char name[40];
    for (unsigned i = 0; i < policy->board.seekers; i++) starts[i] = (qtr_cell)cell;
    if (qtr_deployment_init(&deployment, policy, starts, NULL) != QTR_OK) continue;
    snprintf(name, sizeof name, "all from cell %lu", (unsigned long)cell);
    say_routes(name, deployment.start_of, &deployment.cleared);
  }
}

static void read_golden(const char *path, unsigned format) {
  fault why;
  length = 0;
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, table_read(&t, path, &why), why.text);
  TEST_ASSERT_TRUE_MESSAGE(format == 0 || policy->format == format, path);
  say_header();
  say_map();
  say_nodes();
  say_terms();
  say_routes("plan", NULL, NULL);
  say_routes_of_the_rest();
  say_deployments();
  table_free(&t);
}

/* ---- the tables ---- */

static void expect_read_as_ever(const char *name, unsigned format) {
  static char expected[sizeof said];
  char path[1000];
  snprintf(path, sizeof path, GOLDEN "%s.read", name);
  FILE *file = fopen(path, "rb");
  TEST_ASSERT_NOT_NULL_MESSAGE(file, path);
  expected[fread(expected, 1, sizeof expected - 1, file)] = '\0';
  fclose(file);
  snprintf(path, sizeof path, GOLDEN "%s.qtr", name);
  read_golden(path, format);
  TEST_ASSERT_EQUAL_STRING_MESSAGE(expected, said, name);
}

static void test_tables_of_format_1_are_read_as_ever(void) {
  static const char *const names[] = {"any-start", "most",      "places-31", "places-32",
                                      "places-33", "places-63", "places-64", "places-65"};
  for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) expect_read_as_ever(names[i], 1);
}

static void test_tables_of_format_2_are_read_as_ever(void) {
  static const char *const names[] = {"2-plain", "2-any-start", "2-terms", "2-deadline"};
  for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) expect_read_as_ever(names[i], 2);
}

int main(int argc, char **argv) {
  if (argc > 1) {
    read_golden(argv[1], 0);
    return fputs(said, stdout) < 0;
  }
  UNITY_BEGIN();
  RUN_TEST(test_tables_of_format_1_are_read_as_ever);
  RUN_TEST(test_tables_of_format_2_are_read_as_ever);
  return UNITY_END();
}
