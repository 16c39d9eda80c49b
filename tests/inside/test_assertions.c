#define _POSIX_C_SOURCE 200809L
/* What the core rests on is asserted, and each assertion can fail: every one is broken here, on the robot side and in
 * the table's rooms; those of the learner's model and aggregates are in test_assertions_model.c, those of search and
 * learning in test_assertions_search.c. That all hold otherwise every other test of the core shows, for they link it
 * with its assertions. */
#include <string.h>

#include "core/bytes.h"
#include "learn/learner.h"
#include "quarter/any_start.h"
#include "quarter/claim.h"
#include "quarter/random.h"
#include "quarter/rest.h"
#include "quarter/seeker.h"
#include "quarter/start_trials.h"
#include "robot/board.h"
#include "robot/layout.h"
#include "support/death.h"
#include "support/forging.h"
#include "table/record.h"

static qtr_policy policy;
static qtr_joint joint;
static uint8_t copy[TABLE_MOST];

/* Two seekers at one start, three places; everything is in order. */
void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  table_draw("1..S..2/..~...3", 2);
  memcpy(copy, table_bytes, table_size);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, copy, table_size));
  qtr_joint_start(&joint, &policy.board, NULL, NULL);
}

void tearDown(void) {
}

static void set_out(void) {
  qtr_joint_choose(&joint, &policy.board, 0, 0);
  qtr_joint_choose(&joint, &policy.board, 1, 1);
}

/* ---- what is in order does not end ---- */

static void do_nothing_wrong(void) {
  uint16_t choice;
  qtr_policy_lookup(&policy, &joint, &choice);
  set_out();
  while (qtr_joint_advance(&joint, &policy.board, NULL) > 0) {}
}

static void test_what_is_in_order_does_not_end(void) {
  TEST_ASSERT_FALSE(is_death(do_nothing_wrong));
}

/* ---- keys ---- */

static void give_a_time_beyond_the_longest(void) {
  qtr_key key;
  joint.remaining[0] = policy.board.keys.longest + 1;
  qtr_joint_key(&key, &joint, &policy.board.keys);
}

static void give_a_place_beyond_the_last(void) {
  qtr_key key;
  joint.visited.word[0] |= 8;
  qtr_joint_key(&key, &joint, &policy.board.keys);
}

static void make_a_key_longer_than_was_measured(void) {
  qtr_key key;
  qtr_key_shape shape = policy.board.keys;
  shape.bits = 3;
  set_out();
  qtr_joint_key(&key, &joint, &shape);
}

static void measure_keys_of_nothing(void) {
  qtr_key_shape shape = {.seekers = 1};
  qtr_key_measure(&shape);
}

static void test_keys(void) {
  expect_death("a number fits its bits", give_a_time_beyond_the_longest);
  expect_death("visited places are the board's", give_a_place_beyond_the_last);
  expect_death("no key is longer than was measured", make_a_key_longer_than_was_measured);
  expect_death("no game is without places", measure_keys_of_nothing);
}

/* ---- the board and the joint game ---- */

static void ask_for_a_seeker_that_is_none(void) {
  qtr_steps_between(&policy.board, 2, 0, 1);
}

static void ask_for_a_node_that_is_none(void) {
  qtr_steps_between(&policy.board, 0, 4, 1);
}

static void ask_for_a_place_that_is_none(void) {
  qtr_steps_between(&policy.board, 0, 0, 3);
}

static void start_where_there_is_no_start(void) {
  const uint16_t start_of[2] = {0, 1};
  qtr_places all;
  memset(&all, 0xFF, sizeof all);
  qtr_joint_start(&joint, &policy.board, start_of, &all);
}

static void visit_more_than_is_left(void) {
  set_out();
  joint.unvisited = 1;
  joint.remaining[1] = joint.remaining[0];
  qtr_joint_advance(&joint, &policy.board, NULL);
}

static void let_choose_who_has_no_choice(void) {
  joint.visited.word[0] = 7;
  qtr_joint_chooser(&joint, &policy.board);
}

static void go_a_way_that_grew(void) {
  table_set_steps(copy, &policy, 3, 1, policy.board.keys.longest + 1); /* from the start to place 1 */
  qtr_joint_choose(&joint, &policy.board, 0, 1);
}

static void be_bound_for_a_start(void) {
  joint.remaining[0] = 1;
  joint.bound.word[0] = 8;
  qtr_joint_advance(&joint, &policy.board, NULL);
}

static void be_bound_unknown_to_all(void) {
  set_out();
  qtr_places_clear(&joint.bound);
  qtr_joint_advance(&joint, &policy.board, NULL);
}

static void test_board_and_joint_game(void) {
  expect_death("a seeker of the board", ask_for_a_seeker_that_is_none);
  expect_death("a node of the board", ask_for_a_node_that_is_none);
  expect_death("a place of the board", ask_for_a_place_that_is_none);
  expect_death("a start of the board", start_where_there_is_no_start);
  expect_death("a place is visited once", visit_more_than_is_left);
  expect_death("the chooser has a choice", let_choose_who_has_no_choice);
  expect_death("keys have room for the way", go_a_way_that_grew);
  expect_death("on its way, a seeker is bound for a place", be_bound_for_a_start);
  expect_death("which the others know", be_bound_unknown_to_all);
}

/* ---- an open policy stays as it was opened ---- */

static void lay_out_more_than_32_bits(void) {
  policy.board.places = QTR_MAX_PLACES + 1;
  qtr_layout_find(&policy);
}

static void lay_out_more_cells_than_there_are(void) {
  policy.grid.columns = 0xFFFF;
  policy.grid.rows = 0xFFFF;
  qtr_layout_find(&policy);
}

static void follow_times_of_another_grid(void) {
  static uint8_t cells[3] = {1, 1, 1};
  const qtr_grid grid = {3, 1, QTR_GRID_BYTES, cells};
  qtr_travel_fill(&table_travel, &grid, 2);
  cells[2] = 7;
  qtr_travel_next(&table_travel, &grid, 1);
}

static void test_open_policy(void) {
  TEST_ASSERT_GREATER_THAN_UINT32(1, policy.records);
  expect_death("sections have sizes of 32 bits", lay_out_more_than_32_bits);
  expect_death("and a grid that the build holds", lay_out_more_cells_than_there_are);
  expect_death("travel times are of their grid", follow_times_of_another_grid);
}

/* ---- tables under way ---- */

static uint8_t record[QTR_RECORD_BYTES];

static void record_a_choice_that_is_none(void) {
  qtr_record_write(record, &joint, &policy.board, 3);
}

static void record_when_nobody_chooses(void) {
  set_out();
  qtr_record_write(record, &joint, &policy.board, 2);
}

static void leave_nothing(void) {
  static qtr_mission rest;
  uint16_t number[QTR_MAX_PLACES];
  qtr_places all;
  memset(&all, 0xFF, sizeof all);
  rest = table_mission;
  qtr_rest_make(&rest, number, &table_mission, table_mission.start, &all);
}

static void draw_below_0(void) {
  uint64_t state = 1;
  qtr_lcg_below(&state, 0);
}

static void test_records_rest_and_draws(void) {
  expect_death("a record's choice is a place or none", record_a_choice_that_is_none);
  expect_death("a record is for somebody's turn", record_when_nobody_chooses);
  expect_death("something is left", leave_nothing);
  expect_death("there is a number to draw", draw_below_0);
}

static qtr_any_start any;
static qtr_routes routes;

static void make_any_start(void) {
  static uint8_t steps[4 * 4 * 3];
  static qtr_cell start[1];
  static uint8_t entries[4096];
  const qtr_any_start_asked asked = {&table_game, NULL, true};
  const qtr_any_start_blocks blocks = {steps, start, NULL, entries, sizeof entries};
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_init(&any, &asked, &blocks, &table_travel));
  qtr_play_to_routes(&table_learner->best, &table_game, &routes);
}

static void add_no_game(void) {
  qtr_any_start_add(&any, &routes, NULL);
}

static void add_after_the_end(void) {
  qtr_any_start_next(&any);
  qtr_any_start_finish(&any);
  qtr_any_start_add(&any, &routes, NULL);
}

static void visit_a_place_twice(void) {
  qtr_any_start_next(&any);
  memset(&routes, 0, sizeof routes);
  routes.length[0] = 2;
  qtr_any_start_add(&any, &routes, NULL);
}

static void add_a_trial_that_was_not_drawn(void) {
  qtr_start_trials trials;
  qtr_start_trials_begin(&trials, 1);
  qtr_deployment_init(&trials.deployment, &policy, NULL, NULL);
  qtr_start_trials_add(&trials, &policy, &table_game, 1.0);
}

static void test_any_start(void) {
  make_any_start();
  expect_death("a game is under way", add_no_game);
  expect_death("the games are not over", add_after_the_end);
  expect_death("routes lead to places that are left", visit_a_place_twice);
  expect_death("a trial was drawn", add_a_trial_that_was_not_drawn);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_is_in_order_does_not_end);
  RUN_TEST(test_keys);
  RUN_TEST(test_board_and_joint_game);
  RUN_TEST(test_open_policy);
  RUN_TEST(test_records_rest_and_draws);
  RUN_TEST(test_any_start);
  return UNITY_END();
}
