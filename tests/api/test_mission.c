/* profiles: host mcu */
/* What is wrong with a mission, and whose fault it is. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "quarter/mission.h"
#include "support/missions.h"
#include "unity.h"

static qtr_mission mission;

void setUp(void) {
  mission_draw(&mission, "S1#2/.S.3");
}

void tearDown(void) {
}

static void expect(int status, int culprit) {
  int found = -77;
  TEST_ASSERT_EQUAL_INT(status, qtr_mission_check(&mission, &found));
  TEST_ASSERT_EQUAL_INT(culprit, found);
  TEST_ASSERT_EQUAL_INT(status, qtr_mission_check(&mission, NULL));
}

static void test_sound_mission_passes(void) {
  expect(QTR_OK, 0);
}

static void test_defaults_are_those_documented(void) {
  memset(&mission, 0xA5, sizeof mission);
  qtr_mission_default(&mission);
  TEST_ASSERT_EQUAL(QTR_DISCOUNTED, mission.aim.kind);
  TEST_ASSERT_EQUAL(QTR_RULE_FREE, mission.rule);
  TEST_ASSERT_TRUE(mission.aim.gamma == 0.99);
  TEST_ASSERT_EQUAL(0, mission.places);
  TEST_ASSERT_EQUAL(0, mission.seekers);
  TEST_ASSERT_EQUAL_UINT32(0, mission.frame.cell_size_um);
}

static void test_empty_mission_has_no_cells(void) {
  qtr_mission_default(&mission);
  expect(QTR_ERR_ARGUMENT, 0);
}

static void test_mission_without_seekers_or_places(void) {
  mission.seekers = 0;
  expect(QTR_ERR_NO_START, 0);
  setUp();
  mission.places = 0;
  expect(QTR_ERR_NO_PLACE, 0);
}

static void test_more_than_the_build_holds(void) {
  mission.places = QTR_MAX_PLACES + 1;
  expect(QTR_ERR_LIMIT, 0);
  setUp();
  mission.columns = 65535;
  mission.rows = 65535;
  expect(QTR_ERR_LIMIT, 0);
  setUp();
  mission.columns = QTR_MAX_CELLS / 256 + 1;
  mission.rows = 256;
  expect(QTR_ERR_LIMIT, 0);
  setUp();
  mission.seekers = QTR_MAX_SEEKERS + 1;
  expect(QTR_ERR_LIMIT, 0);
}

static void test_start_on_an_obstacle_or_off_the_map(void) {
  mission.start[1] = 2;
  expect(QTR_ERR_START, 1);
  mission.start[1] = 8;
  expect(QTR_ERR_START, 1);
  mission.start[1] = QTR_NO_CELL;
  expect(QTR_ERR_START, 1);
  mission.start[0] = 2;
  expect(QTR_ERR_START, 0);
}

static void test_place_on_an_obstacle_or_off_the_map(void) {
  mission.place[2] = 2;
  expect(QTR_ERR_PLACE, 2);
  mission.place[2] = 8;
  expect(QTR_ERR_PLACE, 2);
  mission.place[1] = QTR_NO_CELL;
  expect(QTR_ERR_PLACE, 1);
}

static void test_two_places_on_one_cell_blame_the_second(void) {
  mission.place[2] = mission.place[0];
  expect(QTR_ERR_PLACE, 2);
}

static void test_starts_may_coincide_with_one_another_and_with_places(void) {
  mission.start[0] = mission.start[1] = mission.place[1];
  expect(QTR_OK, 0);
}

static void test_weights_that_are_no_likelihoods(void) {
  static const double wrong[] = {0.0, -0.0, -1.0, (double)NAN, (double)INFINITY, -(double)INFINITY, DBL_MAX};
  for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    setUp();
    mission.weight[1] = wrong[i];
    expect(QTR_ERR_WEIGHT, 1);
  }
}

static void test_smallest_and_greatest_weights_pass(void) {
  mission.weight[0] = DBL_MIN;
  mission.weight[1] = DBL_MAX / QTR_MAX_PLACES;
  expect(QTR_OK, 0);
}

static void test_gamma_outside_0_to_1(void) {
  static const double wrong[] = {0.0, 1.0, -0.5, 1.5, (double)NAN, (double)INFINITY};
  for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    mission.aim.gamma = wrong[i];
    expect(QTR_ERR_ARGUMENT, 0);
  }
}

static void test_objective_or_rule_that_is_none(void) {
  mission.aim.kind = QTR_OBJECTIVES;
  expect(QTR_ERR_ARGUMENT, 0);
  setUp();
  mission.rule = 2;
  expect(QTR_ERR_ARGUMENT, 0);
}

static void test_grid_shows_the_missions_cells(void) {
  const qtr_grid grid = qtr_mission_grid(&mission);
  TEST_ASSERT_EQUAL(4, grid.columns);
  TEST_ASSERT_EQUAL(2, grid.rows);
  TEST_ASSERT_EQUAL(0, qtr_grid_cost(&grid, 2));
  TEST_ASSERT_EQUAL(1, qtr_grid_cost(&grid, 3));
  mission.cost[3] = 200;
  TEST_ASSERT_EQUAL(200, qtr_grid_cost(&grid, 3));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_sound_mission_passes);
  RUN_TEST(test_defaults_are_those_documented);
  RUN_TEST(test_empty_mission_has_no_cells);
  RUN_TEST(test_mission_without_seekers_or_places);
  RUN_TEST(test_more_than_the_build_holds);
  RUN_TEST(test_start_on_an_obstacle_or_off_the_map);
  RUN_TEST(test_place_on_an_obstacle_or_off_the_map);
  RUN_TEST(test_two_places_on_one_cell_blame_the_second);
  RUN_TEST(test_starts_may_coincide_with_one_another_and_with_places);
  RUN_TEST(test_weights_that_are_no_likelihoods);
  RUN_TEST(test_smallest_and_greatest_weights_pass);
  RUN_TEST(test_gamma_outside_0_to_1);
  RUN_TEST(test_objective_or_rule_that_is_none);
  RUN_TEST(test_grid_shows_the_missions_cells);
  return UNITY_END();
}
