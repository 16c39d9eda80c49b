/* profiles: host mcu */
/* The learner's result as a table: everything in it is what was learnt. */
#include <math.h>
#include <string.h>

#include "quarter/claim.h"
#include "quarter/deployment.h"
#include "support/forging.h"

static qtr_policy policy;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static double load_double(uint32_t offset) {
  const uint64_t bits = qtr_load64(table_bytes + offset);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static void test_size_is_told_beforehand_and_needed_to_the_byte(void) {
  table_draw("1..S..2/..1...1", 2);
  const uint32_t size = qtr_export_size(table_learner);
  TEST_ASSERT_EQUAL_UINT32(size, table_size);
  memset(table_bytes, 0xA5, sizeof table_bytes);
  TEST_ASSERT_EQUAL_INT32(QTR_ERR_SPACE, qtr_export(table_learner, table_bytes, size - 1));
  TEST_ASSERT_EQUAL_INT32(QTR_ERR_SPACE, qtr_export(table_learner, table_bytes, 0));
  TEST_ASSERT_EQUAL_HEX8(0xA5, table_bytes[0]);
  TEST_ASSERT_EQUAL_INT32(size, qtr_export(table_learner, table_bytes, size));
  TEST_ASSERT_EQUAL_HEX8(0xA5, table_bytes[size]);
}

/* 160 of header, 4 of two seekers' starts, 4 cells (3 places, 1 start) of 2 bytes, 3 weights, 4 rows of 3 travel times
 * of a byte, the records of a key and a choice of a byte, 2 bytes of grid. A key: two nodes of 4 and none, two times of
 * 0 to 6, three places: 5 * 7 * 5 * 7 * 8 = 9800, 2 bytes. */
static void test_size_by_hand(void) {
  table_draw("1..S..2/..1....", 2);
  const uint32_t records = qtr_learner_best(table_learner)->choices;
  TEST_ASSERT_EQUAL_UINT32(160 + 4 + 2 * 4 + 4 * 3 + 4 * 3 + 3 * records + 2, table_size);
}

static void test_header_says_what_was_learnt(void) {
  qtr_certificate certificate;
  mission_draw(&table_mission, "1..S..2/..1...S");
  table_mission.aim.kind = QTR_TIME;
  table_mission.frame.cell_size_um = 50000;
  table_mission.frame.origin_x_um = -1234567;
  table_mission.frame.origin_y_um = 7654321;
  table_learn(1000);
  table_export();
  qtr_learner_certificate(table_learner, &certificate);
  TEST_ASSERT_EQUAL_MEMORY("QTRP", table_bytes, 4);
  TEST_ASSERT_EQUAL(QTR_POLICY_FORMAT, qtr_load16(table_bytes + QTR_POLICY_VERSION));
  TEST_ASSERT_EQUAL_UINT32(table_size, qtr_load32(table_bytes + QTR_POLICY_SIZE));
  TEST_ASSERT_EQUAL(7, qtr_load16(table_bytes + QTR_POLICY_COLUMNS));
  TEST_ASSERT_EQUAL(2, qtr_load16(table_bytes + QTR_POLICY_ROWS));
  TEST_ASSERT_EQUAL(3, qtr_load16(table_bytes + QTR_POLICY_PLACES));
  TEST_ASSERT_EQUAL(2, table_bytes[QTR_POLICY_SEEKERS]);
  TEST_ASSERT_EQUAL(2, table_bytes[QTR_POLICY_STARTS]);
  TEST_ASSERT_EQUAL(QTR_RULE_FREE, table_bytes[QTR_POLICY_RULE]);
  TEST_ASSERT_EQUAL(QTR_TIME, table_bytes[QTR_POLICY_OBJECTIVE]);
  TEST_ASSERT_EQUAL(1, table_bytes[QTR_POLICY_CERTIFIED]);
  TEST_ASSERT_EQUAL_UINT64(1, qtr_load64(table_bytes + QTR_POLICY_SEED));
  TEST_ASSERT_TRUE(load_double(QTR_POLICY_GAMMA) == 0.99);
  TEST_ASSERT_TRUE(load_double(QTR_POLICY_VALUE) == certificate.value);
  TEST_ASSERT_TRUE(load_double(QTR_POLICY_TIME) == certificate.expected_time);
  TEST_ASSERT_TRUE(load_double(QTR_POLICY_BOUND) == certificate.bound);
  TEST_ASSERT_TRUE(load_double(QTR_POLICY_GAP) == certificate.gap);
  TEST_ASSERT_EQUAL_UINT32(50000, qtr_load32(table_bytes + QTR_POLICY_CELL_SIZE));
  TEST_ASSERT_EQUAL_INT64(-1234567, (int64_t)qtr_load64(table_bytes + QTR_POLICY_ORIGIN_X));
  TEST_ASSERT_EQUAL_INT64(7654321, (int64_t)qtr_load64(table_bytes + QTR_POLICY_ORIGIN_Y));
  table_open(&policy);
  const qtr_frame frame = qtr_policy_frame(&policy);
  TEST_ASSERT_EQUAL_UINT32(50000, frame.cell_size_um);
  TEST_ASSERT_EQUAL_INT64(-1234567, frame.origin_x_um);
  TEST_ASSERT_EQUAL_INT64(7654321, frame.origin_y_um);
}

static void test_weights_are_fixed_point_likelihoods(void) {
  table_draw("1.S.3", 1);
  table_open(&policy);
  TEST_ASSERT_EQUAL_HEX32(0x40000000u, qtr_policy_weight(&policy, 0));
  TEST_ASSERT_EQUAL_HEX32(0xC0000000u, qtr_policy_weight(&policy, 1));
  table_draw("S.3", 1); /* certain: the most that 32 bits hold */
  table_open(&policy);
  TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFFu, qtr_policy_weight(&policy, 0));
}

static void test_unlikely_place_keeps_a_weight(void) {
  mission_draw(&table_mission, "1.S.3");
  table_mission.weight[0] = 1e-300;
  table_learn(1000);
  table_export();
  table_open(&policy);
  TEST_ASSERT_EQUAL_HEX32(1, qtr_policy_weight(&policy, 0));
}

static void test_plain_ground_takes_a_bit_a_cell_and_terrain_a_byte(void) {
  table_draw("1.S.3....", 1);
  table_open(&policy);
  TEST_ASSERT_EQUAL(QTR_GRID_BITS, policy.grid.encoding);
  table_draw("1.S.3...~", 1);
  table_open(&policy);
  TEST_ASSERT_EQUAL(QTR_GRID_BYTES, policy.grid.encoding);
}

/* A cell of the table's grid, as one of the map. */
static unsigned on_map(unsigned cell) {
  qtr_claim claim;
  qtr_claim_read(&claim, &policy);
  const unsigned column = claim.left + cell % policy.grid.columns;
  return (claim.top + cell / policy.grid.columns) * table_mission.columns + column;
}

static void expect_mission_in_table(void) {
  const qtr_board *board = &policy.board;
  for (unsigned cell = 0; cell < qtr_grid_cells(&policy.grid); cell++)
    TEST_ASSERT_EQUAL_MESSAGE(table_mission.cost[on_map(cell)], qtr_grid_cost(&policy.grid, (qtr_cell)cell), case_note);
  for (unsigned place = 0; place < table_mission.places; place++) {
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(table_mission.place[place], on_map(qtr_policy_cell(&policy, place)), case_note);
    const double weight = table_game.probability[place] * 4294967296.0;
    TEST_ASSERT_TRUE_MESSAGE(fabs(weight - qtr_policy_weight(&policy, place)) <= 1.0, case_note);
  }
  for (unsigned i = 0; i < table_mission.seekers; i++)
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(table_mission.start[i],
                                     on_map(qtr_policy_cell(&policy, (unsigned)board->places + board->start_of[i])),
                                     case_note);
  for (unsigned node = 0; node < (unsigned)board->places + board->starts; node++)
    for (unsigned place = 0; place < board->places; place++)
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(qtr_board_steps(&table_game.board, 0, node, place),
                                       qtr_board_steps(board, 0, node, place), case_note);
}

/* Every state that the best game meets has its record, and there is no other. */
static void expect_best_game_in_table(void) {
  const qtr_play *best = qtr_learner_best(table_learner);
  qtr_state state;
  qtr_outcome outcome;
  qtr_game_start(&table_game, &state);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(best->choices, policy.records, case_note);
  for (unsigned i = 0; i < best->choices; i++) {
    uint16_t choice = 0;
    bool off_table = true;
    TEST_ASSERT_TRUE_MESSAGE(qtr_policy_lookup(&policy, &state.joint, &choice), case_note);
    TEST_ASSERT_EQUAL_HEX16_MESSAGE(best->choice[i], choice, case_note);
    TEST_ASSERT_EQUAL_HEX16_MESSAGE(choice, qtr_policy_choose(&policy, &state.joint, best->seeker[i], &off_table),
                                    case_note);
    TEST_ASSERT_FALSE_MESSAGE(off_table, case_note);
    qtr_game_choose(&table_game, &state, best->seeker[i], best->choice[i]);
    qtr_game_pass(&table_game, &state, &outcome);
  }
}

static void test_what_is_read_is_what_was_learnt(void) {
  for (unsigned number = 0; number < 400; number++) {
    test_random random = random_case("round trip", number);
    table_random(&random, (mission_size){12, 10, 9, 4});
    table_open(&policy);
    expect_mission_in_table();
    expect_best_game_in_table();
  }
}

static void test_learning_stopped_at_any_step_exports(void) {
  for (unsigned steps = 0; steps < 60; steps++) {
    test_random random = random_case("stopped", steps / 4);
    mission_random(&table_mission, &random, (mission_size){20, 16, 14, 3});
    table_learn(steps % 4 == 3 ? 200 : steps % 4);
    table_export();
    table_open(&policy);
    qtr_certificate certificate;
    qtr_learner_certificate(table_learner, &certificate);
    TEST_ASSERT_EQUAL_MESSAGE(certificate.certified, table_bytes[QTR_POLICY_CERTIFIED], case_note);
    TEST_ASSERT_TRUE_MESSAGE(load_double(QTR_POLICY_GAP) == certificate.gap, case_note);
    expect_best_game_in_table();
  }
}

static void test_largest_mission_of_static_blocks_exports(void) {
  static uint8_t large[4 * (QTR_STATIC_NODES * (QTR_STATIC_PLACES + 2) + QTR_MAX_CHOICES * (QTR_KEY_WORDS + 1)) + 4096];
  qtr_mission_default(&table_mission);
  table_mission.columns = 32;
  table_mission.rows = 32;
  memset(table_mission.cost, 1, 32 * 32);
  table_mission.places = QTR_STATIC_PLACES;
  table_mission.seekers = QTR_MAX_SEEKERS;
  for (unsigned place = 0; place < QTR_STATIC_PLACES; place++) {
    table_mission.place[place] = (qtr_cell)(1023 - place * (900 / QTR_STATIC_PLACES));
    table_mission.weight[place] = 1.0 + place % 5;
  }
  for (unsigned i = 0; i < QTR_MAX_SEEKERS; i++) table_mission.start[i] = (qtr_cell)i;
  table_learn(0);
  const int32_t written = qtr_export(table_learner, large, sizeof large);
  TEST_ASSERT_EQUAL_INT32(qtr_export_size(table_learner), written);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, large, (uint32_t)written));
  expect_mission_in_table();
  expect_best_game_in_table();
}

/* What nobody gets to is left out of the grid, and the frame is that of what is left. */
static void test_grid_is_cropped_to_what_can_be_reached(void) {
  int64_t x, y, x_there, y_there;
  mission_draw(&table_mission, "..#######/###.S.1##/#2....###/#########/.........");
  table_mission.frame = (qtr_frame){250000, 1000000, -3000000, 0, QTR_FRAME_ONE};
  table_learn(100);
  table_export();
  table_open(&policy);
  TEST_ASSERT_EQUAL(6, policy.grid.columns);
  TEST_ASSERT_EQUAL(2, policy.grid.rows);
  expect_mission_in_table();
  const qtr_grid whole = qtr_mission_grid(&table_mission);
  const qtr_frame frame = qtr_policy_frame(&policy);
  for (unsigned cell = 0; cell < 12; cell++) {
    TEST_ASSERT_TRUE(qtr_frame_centre(&frame, &policy.grid, (qtr_cell)cell, &x, &y));
    TEST_ASSERT_TRUE(qtr_frame_centre(&table_mission.frame, &whole, (qtr_cell)on_map(cell), &x_there, &y_there));
    TEST_ASSERT_INT64_WITHIN(1, x_there, x);
    TEST_ASSERT_INT64_WITHIN(1, y_there, y);
  }
}

/* Ways up to 254 steps take a byte, to 65,534 two. */
static void test_ways_take_as_many_bytes_as_the_longest_needs(void) {
  static char rows[300];
  for (unsigned steps = 253; steps < 257 && steps < QTR_MAX_CELLS; steps++) {
    memset(rows, '.', sizeof rows);
    rows[0] = 'S';
    rows[steps] = '1';
    rows[steps + 1] = '\0';
    table_draw(rows, 1);
    table_open(&policy);
    TEST_ASSERT_EQUAL(steps < 255 ? 1 : 2, policy.board.step_bytes);
    TEST_ASSERT_EQUAL_UINT32(steps, qtr_board_steps(&policy.board, 0, 1, 0));
  }
}

static void test_places_cleared_and_numbers_are_held(void) {
  static const uint16_t number[] = {3, 4, 9};
  qtr_places cleared;
  qtr_claim claim;
  qtr_certificate certificate;
  qtr_deployment home;
  table_draw("1..S..2/..1....", 2);
  table_mission.number = number;
  qtr_places_clear(&cleared);
  qtr_places_add(&cleared, 2);
  qtr_learner_certificate(table_learner, &certificate);
  const qtr_cell start[] = {table_mission.start[0]};
  const qtr_table_content content = {.mission = &table_mission,
                                     .board = &table_game.board,
                                     .probability = table_game.probability,
                                     .start = start,
                                     .certificate = &certificate,
                                     .cleared = &cleared};
  const int32_t written = qtr_table_write(&content, table_bytes, sizeof table_bytes);
  TEST_ASSERT_GREATER_THAN(0, written);
  TEST_ASSERT_EQUAL_INT32(written, qtr_table_size(&content));
  table_size = (uint32_t)written;
  table_open(&policy);
  qtr_claim_read(&claim, &policy);
  for (unsigned place = 0; place < 3; place++)
    TEST_ASSERT_EQUAL_UINT(number[place], qtr_claim_number(&claim, &policy, place));
  TEST_ASSERT_EQUAL_UINT(3, qtr_claim_number(&claim, &policy, 3));
  qtr_deployment_home(&home, &policy);
  TEST_ASSERT_TRUE(qtr_places_has(&home.cleared, 2) && !qtr_places_has(&home.cleared, 0));
  table_mission.number = NULL;
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_size_is_told_beforehand_and_needed_to_the_byte);
  RUN_TEST(test_size_by_hand);
  RUN_TEST(test_header_says_what_was_learnt);
  RUN_TEST(test_weights_are_fixed_point_likelihoods);
  RUN_TEST(test_unlikely_place_keeps_a_weight);
  RUN_TEST(test_plain_ground_takes_a_bit_a_cell_and_terrain_a_byte);
  RUN_TEST(test_what_is_read_is_what_was_learnt);
  RUN_TEST(test_learning_stopped_at_any_step_exports);
  RUN_TEST(test_largest_mission_of_static_blocks_exports);
  RUN_TEST(test_grid_is_cropped_to_what_can_be_reached);
  RUN_TEST(test_ways_take_as_many_bytes_as_the_longest_needs);
  RUN_TEST(test_places_cleared_and_numbers_are_held);
  return UNITY_END();
}
