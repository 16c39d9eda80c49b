/* The settings of a plan: what the default asks for, and what does not go together. */
#include "host/plan/plan_config.h"

#include <string.h>

#include "host/plan/simulation.h"
#include "unity.h"

static plan_config config;
static fault why;

void setUp(void) {
  memset(&why, 0, sizeof why);
  plan_config_default(&config);
}

void tearDown(void) {
}

static void test_the_default_is_the_input_learnt_on_its_true_map(void) {
  TEST_ASSERT_EQUAL_INT(0, plan_config_check(&config, &why));
  TEST_ASSERT_EQUAL_INT(PLAN_AS_STATED, config.aim.kind);
  TEST_ASSERT_EQUAL_INT(PLAN_AS_STATED, config.rule);
  TEST_ASSERT_EQUAL_DOUBLE(0.0, config.aim.gamma);
  TEST_ASSERT_EQUAL_INT(0, config.reading.robots);
  TEST_ASSERT_EQUAL_INT(QTR_SETTING_CERTIFIED, config.learner.setting);
  TEST_ASSERT_EQUAL_INT(AGGREGATE_NONE, config.aggregate.way);
  TEST_ASSERT_FALSE(config.any_starts || config.any_cleared);
}

static void test_settings_that_did_not_come_from_the_default_are_refused(void) {
  memset(&config, 0, sizeof config);
  TEST_ASSERT_EQUAL_INT(-1, plan_config_check(&config, &why));
  TEST_ASSERT_NOT_NULL(strstr(why.text, "plan_config_default()"));
}

/* Times between regions are no bounds: nothing could be certified. */
static void test_regions_go_with_the_paper_setting_alone(void) {
  const int ways[] = {AGGREGATE_REGIONS, AGGREGATE_BOTH};
  for (int i = 0; i < 2; i++) {
    plan_config_default(&config);
    config.aggregate.way = ways[i];
    TEST_ASSERT_EQUAL_INT(-1, plan_config_check(&config, &why));
    TEST_ASSERT_NOT_NULL(strstr(why.text, "--learner paper"));
    config.learner.setting = QTR_SETTING_PAPER;
    TEST_ASSERT_EQUAL_INT(0, plan_config_check(&config, &why));
  }
}

static void test_spots_go_with_either_setting(void) {
  config.aggregate.way = AGGREGATE_SPOTS;
  TEST_ASSERT_EQUAL_INT(0, plan_config_check(&config, &why));
  config.learner.setting = QTR_SETTING_PAPER;
  TEST_ASSERT_EQUAL_INT(0, plan_config_check(&config, &why));
}

static void test_a_game_by_default_has_everybody_on_time_and_no_target(void) {
  simulation_config game;
  memset(&game, 0xFF, sizeof game);
  simulation_config_default(&game);
  TEST_ASSERT_EQUAL_INT(SIMULATION_NO_TARGET, game.target);
  TEST_ASSERT_EQUAL_INT(0, game.lates + game.losts + game.froms);
  TEST_ASSERT_FALSE(game.clear_all);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_default_is_the_input_learnt_on_its_true_map);
  RUN_TEST(test_settings_that_did_not_come_from_the_default_are_refused);
  RUN_TEST(test_regions_go_with_the_paper_setting_alone);
  RUN_TEST(test_spots_go_with_either_setting);
  RUN_TEST(test_a_game_by_default_has_everybody_on_time_and_no_target);
  return UNITY_END();
}
