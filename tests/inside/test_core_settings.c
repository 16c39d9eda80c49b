/* Settings come from their defaults: what these hold, that they are in their own ranges, and that nothing else is
 * taken. */
#include <math.h>
#include <string.h>

#include "quarter/learn.h"
#include "quarter/status.h"
#include "search/explore.h"
#include "support/learning.h"
#include "support/missions.h"
#include "support/settings.h"
#include "unity.h"

static qtr_mission mission;
static qtr_game game;
static qtr_environment *environment;
static qtr_learner *learner;
static qtr_travel travel;

void setUp(void) {
  mission_draw(&mission, "S..1..2");
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL));
  TEST_ASSERT_EQUAL_INT(QTR_OK, ground_init(&environment, &game, &travel));
}

void tearDown(void) {
}

/* As a caller that has filled in all that it knows of, but asked no default. */
#define UNMAKE(settings) ((settings).made ^= 1)

static void test_exploration(void) {
  qtr_exploration_plan plan;
  qtr_explorer explorer;
  qtr_exploration_default(&plan);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_exploration_check(&plan));
  plan.kind = QTR_EXPLORE_SOFTMAX + 1;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_exploration_check(&plan));
  qtr_exploration_default(&plan);
  plan.first = 1.1;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_exploration_check(&plan));
  qtr_exploration_default(&plan);
  plan.decay = NAN;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_exploration_check(&plan));
  qtr_exploration_default(&plan);
  UNMAKE(plan);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_exploration_check(&plan));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_explorer_init(&explorer, &plan, 1));
}

static void test_learner(void) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_learner_config_check(&config));
  config.alpha = 0.0;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_learner_config_check(&config));
  qtr_learner_config_default(&config);
  config.gap = -1e-9;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_learner_config_check(&config));
  qtr_learner_config_default(&config);
  UNMAKE(config.exploration);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_learner_config_check(&config));
  qtr_learner_config_default(&config);
  UNMAKE(config);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_learner_config_check(&config));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, learner_init(&learner, environment, NULL, &config));
}

static void test_regions(void) {
  static qtr_regions regions;
  static uint64_t scratch[(QTR_REGIONS_SCRATCH_BYTES + 7) / 8];
  const qtr_grid grid = qtr_mission_grid(&mission);
  qtr_regions_config config;
  qtr_regions_default(&config);
  TEST_ASSERT_EQUAL_UINT32(25, config.max_size);
  TEST_ASSERT_EQUAL_UINT32(15, config.diameter);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_regions_check(&config));
  UNMAKE(config);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_regions_check(&config));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch));
}

static void test_spots(void) {
  static qtr_spots spots, scratch;
  const qtr_spot_ground ground = {mission.places, game.steps, game.probability, &game.objective};
  qtr_spots_config config;
  qtr_spots_default(&config);
  TEST_ASSERT_EQUAL_UINT8(5, config.size);
  TEST_ASSERT_EQUAL_UINT32(25, config.diameter);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_spots_check(&config));
  UNMAKE(config);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_spots_check(&config));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_spots_build(&spots, &ground, &config, &scratch));
}

static void expect_aggregation(int status, const qtr_aggregation *how) {
  TEST_ASSERT_EQUAL_INT(status, qtr_aggregation_check(how));
  TEST_ASSERT_EQUAL_INT(status, aggregate_init(&environment, &game, how, &travel));
}

static void test_aggregation(void) {
  qtr_aggregation how;
  qtr_aggregation_default(&how);
  TEST_ASSERT_FALSE(how.by_spots);
  TEST_ASSERT_NULL(how.regions);
  expect_aggregation(QTR_OK, &how);
  how.spot_order = QTR_SPOT_NEAREST + 1;
  expect_aggregation(QTR_ERR_ARGUMENT, &how);
  qtr_aggregation_default(&how);
  how.region_times = QTR_TIMES_TRUE + 1;
  expect_aggregation(QTR_ERR_ARGUMENT, &how);
  qtr_aggregation_default(&how);
  how.rule = QTR_RULE_PAPER + 1;
  expect_aggregation(QTR_ERR_ARGUMENT, &how);
  qtr_aggregation_default(&how);
  UNMAKE(how);
  expect_aggregation(QTR_ERR_ARGUMENT, &how);
}

static void test_aggregation_is_asked_for_the_spots_that_it_takes_alone(void) {
  qtr_aggregation how;
  qtr_aggregation_default(&how);
  how.spots = spot_limits(QTR_MAX_SPOT_SIZE + 1, 3, 0.0);
  expect_aggregation(QTR_OK, &how);
  how.by_spots = true;
  expect_aggregation(QTR_ERR_LIMIT, &how);
}

static void test_mission(void) {
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_mission_check(&mission, NULL));
  UNMAKE(mission);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_mission_check(&mission, NULL));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_exploration);
  RUN_TEST(test_learner);
  RUN_TEST(test_regions);
  RUN_TEST(test_spots);
  RUN_TEST(test_aggregation);
  RUN_TEST(test_aggregation_is_asked_for_the_spots_that_it_takes_alone);
  RUN_TEST(test_mission);
  return UNITY_END();
}
