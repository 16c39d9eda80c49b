/* profiles: host mcu */
/* Tables with every number in its range, checksum and digest right, that cannot be true all the same: refused on
 * opening. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "support/forging.h"

static qtr_policy policy;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* A forger makes checksum and digest right, opens, and starts from the true table again. */
static void expect(int status) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(status, table_forge(&policy, table_copy, table_size), case_note);
  table_take(&policy);
}

/* ---- travel times ---- */

/* Two seekers with a start each, four places, terrain. */
static void make_table(void) {
  table_draw("1..S..2/.#~..1./3.....S", 0);
  table_take(&policy);
}

static void set_steps(unsigned node, unsigned place, qtr_steps steps) {
  table_set_steps(table_copy, &policy, node, place, steps);
  snprintf(case_note, sizeof case_note, "%u steps from node %u to place %u", (unsigned)steps, node, place);
}

static void test_way_that_one_node_alone_lacks_is_refused(void) {
  make_table();
  for (unsigned node = 0; node < 6; node++) {
    for (unsigned place = 0; place < 4; place++) {
      set_steps(node, place, QTR_NEVER);
      expect(QTR_ERR_TRAVEL);
    }
  }
}

static void test_way_that_leads_only_there_is_refused(void) {
  make_table();
  for (unsigned place = 1; place < 4; place++) {
    for (unsigned node = 0; node < 6; node++)
      if (node != place) set_steps(node, place, QTR_NEVER);
    expect(QTR_ERR_TRAVEL);
  }
}

static void cut_off(unsigned place) {
  for (unsigned node = 0; node < 6; node++)
    if (node != place) set_steps(node, place, QTR_NEVER);
  for (unsigned other = 0; other < 4; other++)
    if (other != place) set_steps(place, other, QTR_NEVER);
}

static void test_place_that_nobody_reaches_is_refused(void) {
  make_table();
  for (unsigned place = 0; place < 4; place++) {
    cut_off(place);
    expect(QTR_ERR_TRAVEL);
  }
  cut_off(3); /* but for a start, whose seeker reaches nothing else, a way as long as any: keys stay what they are */
  for (unsigned other = 0; other < 3; other++) set_steps(5, other, QTR_NEVER);
  set_steps(5, 3, policy.board.keys.longest);
  expect(QTR_OK);
}

/* Mutual, and with the first place, and yet no two parts: place 0 reaches 1 and 2, which do not reach each other. */
static void test_reach_that_is_no_division_is_refused(void) {
  make_table();
  set_steps(1, 2, QTR_NEVER);
  set_steps(2, 1, QTR_NEVER);
  expect(QTR_ERR_TRAVEL);
}

static void test_way_into_a_part_of_the_map_and_not_back_is_refused(void) {
  table_draw("S1.#.2S", 0);
  table_take(&policy);
  set_steps(0, 1, 9);
  expect(QTR_ERR_TRAVEL);
  set_steps(1, 0, 9);
  expect(QTR_ERR_TRAVEL);
  set_steps(2, 1, 9);
  expect(QTR_ERR_TRAVEL);
  set_steps(0, 1, 9);
  set_steps(1, 0, 9);
  expect(QTR_ERR_TRAVEL); /* the starts still reach one each */
  expect(QTR_OK);         /* and as it was, two parts */
}

/* Both of its seekers at the left start: what lies right of the wall is in nobody's reach. */
static void test_place_that_only_an_empty_start_reaches_is_refused(void) {
  table_draw("S1.#.2S", 0);
  table_take(&policy);
  qtr_store16(table_copy + QTR_POLICY_HEADER_BYTES + 2, 0);
  expect(QTR_ERR_TRAVEL);
}

static void test_way_without_time_between_two_cells_is_refused(void) {
  make_table();
  for (unsigned node = 0; node < 6; node++) {
    for (unsigned place = 0; place < 4; place++) {
      if (node == place) continue;
      set_steps(node, place, 0);
      expect(QTR_ERR_TRAVEL);
    }
  }
}

static void test_way_from_a_place_to_itself_that_takes_time_is_refused(void) {
  make_table();
  for (unsigned place = 0; place < 4; place++) {
    set_steps(place, place, 1);
    expect(QTR_ERR_TRAVEL);
  }
}

static void test_two_places_in_one_cell_are_refused(void) {
  make_table();
  const uint32_t cells = policy.at[SECTION_CELLS];
  qtr_store32(table_copy + cells + 4, qtr_load32(table_copy + cells));
  set_steps(0, 1, 0);
  set_steps(1, 0, 0);
  expect(QTR_ERR_TRAVEL);
}

/* ---- likelihoods ---- */

static void test_likelihoods_that_do_not_sum_to_one_are_refused(void) {
  make_table();
  const uint32_t at = policy.at[SECTION_WEIGHTS];
  const uint32_t weight = qtr_load32(table_copy + at);
  uint64_t sum = 0;
  for (unsigned place = 0; place < 4; place++) sum += qtr_policy_weight(&policy, place);
  const uint32_t most = (uint32_t)(((uint64_t)1 << 32) + 4 - sum) + weight;
  const uint32_t tried[] = {most, most + 1, most - 8, most - 9, 1, UINT32_MAX};
  for (unsigned i = 0; i < 6; i++) {
    qtr_store32(table_copy + at, tried[i]);
    expect(i % 2 == 0 && i < 4 ? QTR_OK : QTR_ERR_CORRUPT);
  }
}

/* ---- the certificate ---- */

static void set_double(uint32_t offset, double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  qtr_store64(table_copy + offset, bits);
  snprintf(case_note, sizeof case_note, "%g at offset %u", value, (unsigned)offset);
}

static double get_double(uint32_t offset) {
  const uint64_t bits = qtr_load64(table_bytes + offset);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static void expect_double(int status, uint32_t offset, double value) {
  set_double(offset, value);
  expect(status);
}

static void make_certified(uint8_t objective) {
  mission_draw(&table_mission, "1..S..2/.#~..1./3.....S");
  table_mission.aim.kind = objective;
  table_learn(1000);
  table_export();
  table_take(&policy);
}

static void test_numbers_that_are_none_are_refused(void) {
  static const uint32_t offsets[] = {QTR_POLICY_GAMMA, QTR_POLICY_VALUE, QTR_POLICY_TIME, QTR_POLICY_BOUND,
                                     QTR_POLICY_GAP};
  const double values[] = {NAN, -(double)NAN, HUGE_VAL, -HUGE_VAL};
  for (uint8_t objective = 0; objective < 2; objective++) {
    make_certified(objective);
    for (unsigned i = 0; i < 5; i++)
      for (unsigned k = 0; k < 4; k++) expect_double(QTR_ERR_CERTIFICATE, offsets[i], values[k]);
  }
}

static void test_negative_numbers_are_refused(void) {
  for (uint8_t objective = 0; objective < 2; objective++) {
    make_certified(objective);
    expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAMMA, -0.5);
    expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_VALUE, -1.0);
    expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_TIME, -1e-300);
    expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAP, -1e-300);
  }
  make_certified(0);
  expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_BOUND, -9.0);
}

static void test_discount_that_is_none_is_refused(void) {
  make_certified(0);
  expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAMMA, 0.0);
  expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAMMA, -0.0);
  expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAMMA, 1.0);
  expect_double(QTR_OK, QTR_POLICY_GAMMA, 1.0 - DBL_EPSILON);
  expect_double(QTR_OK, QTR_POLICY_GAMMA, 1e-310);
}

static void test_policy_better_than_its_bound_is_refused(void) {
  make_certified(0);
  const double value = get_double(QTR_POLICY_VALUE);
  set_double(QTR_POLICY_GAP, 0.5);
  expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_BOUND, value * (1.0 - DBL_EPSILON));
  set_double(QTR_POLICY_GAP, 0.5);
  expect_double(QTR_OK, QTR_POLICY_BOUND, value * (1.0 + DBL_EPSILON));
  make_certified(1);
  const double time = get_double(QTR_POLICY_TIME);
  set_double(QTR_POLICY_GAP, 0.5);
  expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_BOUND, time * (1.0 + DBL_EPSILON));
  set_double(QTR_POLICY_GAP, 0.5);
  expect_double(QTR_OK, QTR_POLICY_BOUND, time * (1.0 - DBL_EPSILON));
  set_double(QTR_POLICY_GAP, 1.5); /* stopped so early that the bound says nothing: so 0.1.0 wrote it */
  expect_double(QTR_OK, QTR_POLICY_BOUND, -0.5 * time);
}

static void test_gap_is_open_where_value_and_bound_differ_and_nowhere_else(void) {
  for (uint8_t objective = 0; objective < 2; objective++) {
    make_certified(objective);
    const double reached = get_double(objective == 1 ? QTR_POLICY_TIME : QTR_POLICY_VALUE);
    const double better = reached * (objective == 1 ? 0.5 : 2.0);
    set_double(QTR_POLICY_BOUND, better);
    expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAP, 0.0);
    set_double(QTR_POLICY_BOUND, better);
    expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAP, -0.0);
    set_double(QTR_POLICY_BOUND, reached);
    expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAP, 1e-9);
    set_double(QTR_POLICY_BOUND, reached);
    expect_double(QTR_OK, QTR_POLICY_GAP, 0.0);
  }
}

/* Where gamma^t has come to its end as a double there is nothing to divide by. */
static void test_gap_to_a_value_of_nothing_may_be_infinite_but_not_certified(void) {
  make_certified(0);
  set_double(QTR_POLICY_VALUE, 0.0);
  table_copy[QTR_POLICY_CERTIFIED] = 0;
  expect_double(QTR_OK, QTR_POLICY_GAP, HUGE_VAL);
  set_double(QTR_POLICY_VALUE, 0.0);
  table_copy[QTR_POLICY_CERTIFIED] = 1;
  expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAP, HUGE_VAL);
  set_double(QTR_POLICY_VALUE, 0.0);
  table_copy[QTR_POLICY_CERTIFIED] = 0;
  expect_double(QTR_ERR_CERTIFICATE, QTR_POLICY_GAP, NAN);
}

/* ---- bytes that mean nothing ---- */

static void expect_byte(uint32_t offset, unsigned value) {
  table_copy[offset] = (uint8_t)value;
  snprintf(case_note, sizeof case_note, "%u at offset %u", value, (unsigned)offset);
  expect(QTR_ERR_CORRUPT);
}

static void test_bytes_kept_for_later_are_0(void) {
  table_draw("1..S..2", 1);
  table_take(&policy);
  for (unsigned at = QTR_POLICY_SPARE; at < QTR_POLICY_HEADER_BYTES; at++) expect_byte(at, 1);
  expect_byte(table_size - 1, 0xFF); /* the eighth of seven cells */
}

static void test_map_without_metres_lies_nowhere(void) {
  make_table();
  expect_byte(QTR_POLICY_ORIGIN_X, 1);
  expect_byte(QTR_POLICY_ORIGIN_Y + 7, 0x80);
  qtr_store32(table_copy + QTR_POLICY_CELL_SIZE, 50000);
  table_copy[QTR_POLICY_ORIGIN_X] = 1;
  expect(QTR_OK);
}

static void test_turn_that_is_no_angle_is_refused(void) {
  make_table();
  expect_byte(QTR_POLICY_COSINE, 1);
  qtr_store32(table_copy + QTR_POLICY_CELL_SIZE, 50000);
  expect_byte(QTR_POLICY_SINE, 1);
  qtr_store32(table_copy + QTR_POLICY_CELL_SIZE, 50000);
  qtr_store32(table_copy + QTR_POLICY_SINE, (uint32_t)-QTR_FRAME_ONE);
  expect(QTR_OK);
}

/* 7 x 3 cells, all of their map. */
static void test_grid_that_does_not_lie_on_its_map_is_refused(void) {
  make_table();
  expect_byte(QTR_POLICY_LEFT, 1);
  expect_byte(QTR_POLICY_TOP, 1);
  expect_byte(QTR_POLICY_MAP_COLUMNS, 6);
  expect_byte(QTR_POLICY_MAP_ROWS, 2);
  table_copy[QTR_POLICY_MAP_COLUMNS]++;
  table_copy[QTR_POLICY_LEFT]++;
  expect(QTR_OK);
}

static void test_feature_of_a_later_version_is_refused(void) {
  make_table();
  for (unsigned bit = 3; bit < 32; bit++) {
    qtr_store32(table_copy + QTR_POLICY_FEATURES, (uint32_t)1 << bit);
    expect(QTR_ERR_FORMAT);
  }
}

/* ---- regions ---- */

static void make_regions(void) {
  table_draw_regions();
  table_take(&policy);
}

static void expect_region(int status, unsigned cell, unsigned region) {
  qtr_store16(table_copy + policy.at[SECTION_REGIONS] + 2 * cell, region);
  snprintf(case_note, sizeof case_note, "cell %u in region %u", cell, region);
  expect(status);
}

static void test_region_that_is_none_is_refused(void) {
  make_regions();
  for (unsigned cell = 0; cell < 14; cell++) {
    if (cell == 4) continue;
    expect_region(QTR_ERR_CORRUPT, cell, 3);
    expect_region(QTR_ERR_CORRUPT, cell, 4);
    expect_region(QTR_ERR_CORRUPT, cell, 0xFFFF);
  }
}

static void test_blocked_cell_is_of_no_region(void) {
  make_regions();
  expect_region(QTR_ERR_CORRUPT, 4, 0);
  expect_region(QTR_ERR_CORRUPT, 4, 3);
  expect_region(QTR_ERR_CORRUPT, 4, 0xFFFE);
  expect_region(QTR_OK, 4, 0xFFFF);
}

static void test_region_whose_start_lies_elsewhere_is_refused(void) {
  make_regions();
  expect_region(QTR_ERR_CORRUPT, 0, 2); /* the mission's own start, which is of region 0 */
  expect_region(QTR_ERR_CORRUPT, 1, 1); /* region 0's start is of region 1 */
  expect_region(QTR_OK, 2, 1);          /* another division is one */
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_way_that_one_node_alone_lacks_is_refused);
  RUN_TEST(test_way_that_leads_only_there_is_refused);
  RUN_TEST(test_place_that_nobody_reaches_is_refused);
  RUN_TEST(test_reach_that_is_no_division_is_refused);
  RUN_TEST(test_way_into_a_part_of_the_map_and_not_back_is_refused);
  RUN_TEST(test_place_that_only_an_empty_start_reaches_is_refused);
  RUN_TEST(test_way_without_time_between_two_cells_is_refused);
  RUN_TEST(test_way_from_a_place_to_itself_that_takes_time_is_refused);
  RUN_TEST(test_two_places_in_one_cell_are_refused);
  RUN_TEST(test_likelihoods_that_do_not_sum_to_one_are_refused);
  RUN_TEST(test_numbers_that_are_none_are_refused);
  RUN_TEST(test_negative_numbers_are_refused);
  RUN_TEST(test_discount_that_is_none_is_refused);
  RUN_TEST(test_policy_better_than_its_bound_is_refused);
  RUN_TEST(test_gap_is_open_where_value_and_bound_differ_and_nowhere_else);
  RUN_TEST(test_gap_to_a_value_of_nothing_may_be_infinite_but_not_certified);
  RUN_TEST(test_bytes_kept_for_later_are_0);
  RUN_TEST(test_map_without_metres_lies_nowhere);
  RUN_TEST(test_turn_that_is_no_angle_is_refused);
  RUN_TEST(test_grid_that_does_not_lie_on_its_map_is_refused);
  RUN_TEST(test_feature_of_a_later_version_is_refused);
  RUN_TEST(test_region_that_is_none_is_refused);
  RUN_TEST(test_blocked_cell_is_of_no_region);
  RUN_TEST(test_region_whose_start_lies_elsewhere_is_refused);
  return UNITY_END();
}
