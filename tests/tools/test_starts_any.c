/* One table for starts anywhere: on small maps held against what is learnt for each start alone, on a floor of an
 * office's size against the limits. */
#include "support/tool_run.h"

#include "support/random.h"

static tool_result learnt, other;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* ---- small maps ---- */

enum { COLUMNS = 6, ROWS = 5 };

typedef struct {
  char rows[ROWS * (COLUMNS + 1) + 1];
} drawing;

static char *at(drawing *d, unsigned cell) {
  return &d->rows[cell / COLUMNS * (COLUMNS + 1) + cell % COLUMNS];
}

/* A free cell becomes `glyph`. Returns which. */
static unsigned put(drawing *d, test_random *random, char glyph) {
  unsigned cell;
  do cell = random_below(random, COLUMNS * ROWS);
  while (*at(d, cell) != '.');
  *at(d, cell) = glyph;
  return cell;
}

static drawing draw_map(test_random *random) {
  drawing d;
  memset(d.rows, '.', sizeof d.rows);
  for (unsigned row = 0; row < ROWS; row++) d.rows[row * (COLUMNS + 1) + COLUMNS] = '\n';
  d.rows[sizeof d.rows - 1] = '\0';
  for (unsigned walls = random_below(random, 5); walls > 0; walls--) put(&d, random, '#');
  for (char weight = '1'; weight < '5'; weight++) put(&d, random, weight);
  return d;
}

/* Two robots from cells at random, by the table and by a mission of their own. */
static void compare(const drawing *bare, test_random *random) {
  drawing d = *bare;
  const unsigned a = put(&d, random, 'S'), b = put(&d, random, 'S');
  write_file("there.txt", d.rows);
  run_tool(&learnt, "learn there.txt --json");
  if (learnt.status != 0) return; /* a place is out of reach from there */
  run_tool(&other, "simulate any.qtr --from %u,%u --from %u,%u --json", a % COLUMNS, a / COLUMNS, b % COLUMNS,
           b / COLUMNS);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, other.status, other.err);
  TEST_ASSERT_TRUE_MESSAGE(json_is(other.out, "off_table", "0"), case_note);
  const double best = json_value(learnt.out, "value");
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(3e-5 * best, best, json_value(other.out, "value"), case_note);
}

static void test_where_no_two_cells_share_a_region_each_start_is_played_as_if_learnt_for_it(void) {
  for (unsigned number = 0; number < 6; number++) {
    test_random random = random_case("starts", number);
    const drawing bare = draw_map(&random);
    drawing d = bare;
    put(&d, &random, 'S');
    write_file("here.txt", d.rows);
    run_tool(&learnt, "learn here.txt --robots 2 --starts any --start-regions 30 -q -o any.qtr");
    if (learnt.status != 0) continue;
    for (int trial = 0; trial < 5; trial++) compare(&bare, &random);
  }
}

static void test_start_without_a_way_to_any_place_is_refused_by_name(void) {
  write_file("cut.txt", "1..S..#.\n......#.\n..2...#.\n");
  run_tool(&learnt, "learn cut.txt --starts any -o any.qtr --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
  run_tool(&other, "simulate any.qtr --from 7,1");
  TEST_ASSERT_EQUAL_INT(2, other.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(other.err, "--from 7,1: no place can be reached from there"), other.err);
  run_tool(&other, "simulate any.qtr --from 6,1");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(other.err, "--from 6,1: an obstacle"), other.err);
}

static void test_regions_are_as_many_as_asked_for(void) {
  write_file("map.txt", "1..S..#.\n......#.\n..2.....\n");
  for (int most = 1; most < 9; most += 3) {
    run_tool(&learnt, "learn map.txt --robots 2 --starts any --start-regions %d --json", most);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
    TEST_ASSERT_EQUAL_DOUBLE(most, json_value(learnt.out, "regions_meant"));
    TEST_ASSERT_EQUAL_DOUBLE(most * (most + 1) / 2.0 + 1.0, json_value(learnt.out, "games"));
  }
}

static void test_budget_of_bytes_is_kept(void) {
  static const double megabytes[] = {0.002, 0.004, 0.02};
  write_file("map.txt", "1..S..#..3\n......#...\n..2.......\n4.........\n");
  for (int i = 0; i < 3; i++) {
    run_tool(&learnt, "learn map.txt --robots 3 --starts any --table-limit %g --json", megabytes[i]);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
    TEST_ASSERT_TRUE(json_value(learnt.out, "table_bytes") <= 1e6 * megabytes[i]);
    TEST_ASSERT_TRUE(json_is(learnt.out, "complete", "true"));
  }
}

/* ---- the field's terms ---- */

#define TERMS                                                                                                          \
  "map: ground.txt\ncell_size: 2\nscan_seconds: 4\nclasses:\n  drone: {speed: 4%s}\n  rover: {speed: 1, rough: "       \
  "false}\nrobots:\n - {column: 0, row: 0, class: drone}\n - {column: 0, row: 3, class: rover, ready_seconds: 4}\n"    \
  "places:\n - {column: 8, row: 0, weight: 3, detection: 0.7, looks: 2}\n - {column: 5, row: 3}\n%s"

static void write_terms(const char *drone, const char *more) {
  char text[1000];
  snprintf(text, sizeof text, TERMS, drone, more);
  write_file("ground.txt", "S........\n..##..~~.\n..##..~~.\n.........\n");
  write_file("m.yaml", text);
}

static void test_classes_looks_ready_times_and_a_deadline_are_taken(void) {
  static const char *const aims[] = {"", "objective: time\n", "objective: deadline\ndeadline_seconds: 40\n"};
  for (int i = 0; i < 3; i++) {
    write_terms("", aims[i]);
    run_tool(&learnt, "learn m.yaml --starts any -o any.qtr --json");
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
    TEST_ASSERT_EQUAL_DOUBLE(100.0, json_value(learnt.out, "trials"));
    run_tool(&other, "simulate any.qtr --from 6,1 --from 8,3 --json");
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, other.status, other.err);
    TEST_ASSERT_TRUE(json_is(other.out, "off_table", "0"));
  }
  run_tool(&other, "simulate any.qtr --from 8,3 --from 6,1");
  TEST_ASSERT_EQUAL_INT(2, other.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(other.err, "--from 6,1: no place can be reached"), other.err);
}

/* Homes are where the robots start: from the mission's own it earns what it says, from others what is measured. */
static void test_coming_home_is_taken(void) {
  write_terms("", "objective: time\nhome_weight: 1\n");
  run_tool(&learnt, "learn m.yaml --starts any -o any.qtr --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
  TEST_ASSERT_EQUAL_DOUBLE(100.0, json_value(learnt.out, "trials"));
  TEST_ASSERT_TRUE(json_value(learnt.out, "median_loss") < 0.05);
  run_tool(&other, "simulate any.qtr --from 6,1 --from 8,3 --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, other.status, other.err);
  TEST_ASSERT_TRUE(json_is(other.out, "off_table", "0"));
  run_tool(&other, "inspect any.qtr --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, other.status, other.err);
  TEST_ASSERT_EQUAL_DOUBLE(json_value(learnt.out, "expected_time"), json_value(other.out, "expected_time"));
}

static void test_robots_that_must_be_home_in_time_are_refused(void) {
  write_terms(", endurance_seconds: 900", "");
  run_tool(&learnt, "learn m.yaml --starts any");
  TEST_ASSERT_EQUAL_INT(2, learnt.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(
      strstr(learnt.err, "--starts any takes no endurance: which robot is home in time depends on where it starts"),
      learnt.err);
}

/* ---- an office floor ---- */

enum { WIDE = 190, HIGH = 111, ROOM = 18 };

static char floor_rows[HIGH * (WIDE + 1) + 1];

static char *tile(unsigned column, unsigned row) {
  return &floor_rows[row * (WIDE + 1) + column];
}

static bool is_wall(unsigned column, unsigned row) {
  return column % ROOM == 0 || row % ROOM == 0 || column == WIDE - 1 || row == HIGH - 1;
}

/* A door of two cells in each wall between two rooms, somewhere. */
static void open_doors(test_random *random) {
  for (unsigned y = 0; y + ROOM < HIGH; y += ROOM)
    for (unsigned x = 0; x + ROOM < WIDE; x += ROOM) {
      const unsigned along = random_in(random, 1, ROOM - 4);
      if (x > 0) *tile(x, y + along) = *tile(x, y + along + 1) = '.';
      if (y > 0) *tile(x + along, y) = *tile(x + along + 1, y) = '.';
    }
}

static void put_on_floor(test_random *random, char glyph) {
  unsigned column, row;
  do {
    column = random_below(random, WIDE - ROOM);
    row = random_below(random, HIGH - ROOM);
  } while (*tile(column, row) != '.');
  *tile(column, row) = glyph;
}

static void write_floor(test_random *random) {
  for (unsigned row = 0; row < HIGH; row++) {
    for (unsigned column = 0; column < WIDE; column++) *tile(column, row) = is_wall(column, row) ? '#' : '.';
    *tile(WIDE, row) = '\n';
  }
  open_doors(random);
  for (char weight = '1'; weight < '8'; weight++) put_on_floor(random, weight);
  put_on_floor(random, 'S');
  write_file("floor.txt", floor_rows);
}

static void test_office_floor_takes_little_and_loses_little(void) {
  test_random random = random_case("floor", 0);
  write_floor(&random);
  run_tool(&learnt, "learn floor.txt --robots 3 --starts any --start-regions 30 -o floor.qtr --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, learnt.err);
  TEST_ASSERT_TRUE(json_value(learnt.out, "cells") > 15000.0);
  TEST_ASSERT_EQUAL_DOUBLE(100.0, json_value(learnt.out, "trials"));
  TEST_ASSERT_TRUE_MESSAGE(json_value(learnt.out, "table_bytes") < 5e5, case_note);
  TEST_ASSERT_TRUE_MESSAGE(json_value(learnt.out, "median_loss") < 0.03, case_note);
  TEST_ASSERT_TRUE(json_value(learnt.out, "median_loss") <= json_value(learnt.out, "ninety_loss"));
  TEST_ASSERT_TRUE(json_value(learnt.out, "ninety_loss") <= json_value(learnt.out, "worst_loss"));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_where_no_two_cells_share_a_region_each_start_is_played_as_if_learnt_for_it);
  RUN_TEST(test_start_without_a_way_to_any_place_is_refused_by_name);
  RUN_TEST(test_regions_are_as_many_as_asked_for);
  RUN_TEST(test_budget_of_bytes_is_kept);
  RUN_TEST(test_classes_looks_ready_times_and_a_deadline_are_taken);
  RUN_TEST(test_coming_home_is_taken);
  RUN_TEST(test_robots_that_must_be_home_in_time_are_refused);
  RUN_TEST(test_office_floor_takes_little_and_loses_little);
  return UNITY_END();
}
