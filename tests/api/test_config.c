/* profiles: host mcu */
/* Callers built under other array sizes are refused wherever a structure is set up, before anything is written. */
#include <string.h>

#include "quarter/field.h"
#include "quarter/learn.h"
#include "quarter/robot.h"
#include "support/settings.h"
#include "support/tables.h"

#define FOREIGN (QTR_CONFIG_ID + 1u)

static qtr_field table_field;

void setUp(void) {
}

void tearDown(void) {
}

/* Only the beginning: what follows it is as large as the structure says, and the foreign one's may be smaller. */
static union {
  uint8_t bytes[256];
  qtr_board board;
  qtr_deployment deployment;
  qtr_seeker seeker;
  uint64_t aligned;
} small;

static void expect_refused(int status, const void *structure, size_t size) {
  const uint8_t *bytes = structure;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CONFIG, status);
  for (size_t i = 0; i < size; i++) TEST_ASSERT_EQUAL_HEX8(0xA5, bytes[i]);
}

static void test_robot_side_refuses_callers_of_other_sizes(void) {
  static qtr_policy policy;
  table_draw("1..S..2/..1...S", 0);
  table_open(&policy);
  memset(&small, 0xA5, sizeof small);
  expect_refused(qtr_board_init_built(&small.board, FOREIGN), &small, sizeof small);
  expect_refused(qtr_deployment_init_built(&small.deployment, &policy, NULL, NULL, FOREIGN), &small, sizeof small);
  expect_refused(qtr_seeker_init_built(&small.seeker, &policy, 0, NULL, 0, FOREIGN), &small, sizeof small);
  expect_refused(qtr_seeker_restore_built(&small.seeker, &policy, 0, NULL, 0, FOREIGN), &small, sizeof small);
  memset(&table_field, 0xA5, sizeof table_field);
  expect_refused(qtr_field_fill_built(&table_field, &policy.grid, 0, FOREIGN), &table_field, sizeof table_field);
  memset(&policy, 0xA5, sizeof policy);
  expect_refused(qtr_policy_open_built(&policy, table_bytes, table_size, FOREIGN), &policy, sizeof policy);
}

static void test_learner_side_refuses_callers_of_other_sizes(void) {
  static qtr_spots spots, scratch;
  static qtr_regions regions;
  static uint64_t regions_scratch[(QTR_REGIONS_SCRATCH_BYTES + 7) / 8];
  static qtr_belief belief;
  static qtr_any_start any;
  static qtr_start_trials trials;
  const qtr_any_start_asked asked = {&table_game, NULL, true};
  const qtr_any_start_blocks blocks = {NULL, NULL, NULL, NULL, 0};
  const qtr_spots_config limits = spot_limits(2, 5, 0.0);
  qtr_regions_config sizes;
  qtr_regions_default(&sizes);
  table_draw("1..S..2/..1...S", 0);
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  const qtr_spot_ground ground = {table_mission.places, table_game.steps, table_game.probability,
                                  &table_game.objective};
  memset(&spots, 0xA5, sizeof spots);
  expect_refused(qtr_spots_build_sized(&spots, &ground, &limits, &scratch, FOREIGN), &spots, sizeof spots);
  memset(&regions, 0xA5, sizeof regions);
  expect_refused(qtr_regions_build_built(&regions, &grid, &sizes, regions_scratch, sizeof regions_scratch, FOREIGN),
                 &regions, sizeof regions);
  memset(&any, 0xA5, sizeof any);
  expect_refused(qtr_any_start_init_built(&any, &asked, &blocks, &table_travel, FOREIGN), &any, sizeof any);
  memset(&trials, 0xA5, sizeof trials);
  expect_refused(qtr_start_trials_begin_built(&trials, 1, FOREIGN), &trials, sizeof trials);
  memset(&belief, 0xA5, sizeof belief);
  expect_refused(qtr_belief_init_sized(&belief, 2, NULL, 1.0, 1.0, FOREIGN), &belief, sizeof belief);
  expect_refused(qtr_belief_load_sized(&belief, table_bytes, table_size, FOREIGN), &belief, sizeof belief);
}

static void test_learner_refuses_callers_of_other_sizes(void) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  table_draw("1..S..2/..1...S", 0);
  const size_t some = 4096; /* of what is too large to be looked at whole */
  const qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(learning_memory);
  memset(learning_memory.work, 0xA5, some);
  expect_refused(qtr_learner_init_built(&table_learner, &blocks, table_ground, NULL, &config, FOREIGN),
                 learning_memory.work, some);
  void *block = learning_memory.ground;
  memset(block, 0xA5, some);
  expect_refused(qtr_environment_init_built(&table_ground, block, sizeof learning_memory.ground, &table_game, NULL,
                                            &table_travel, FOREIGN),
                 block, some);
  memset(&table_game, 0xA5, some);
  expect_refused(qtr_game_init_built(&table_game, &table_mission, &table_travel, NULL, FOREIGN), &table_game, some);
  memset(&table_mission, 0xA5, sizeof table_mission);
  expect_refused(qtr_mission_default_built(&table_mission, FOREIGN), &table_mission, sizeof table_mission);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_robot_side_refuses_callers_of_other_sizes);
  RUN_TEST(test_learner_side_refuses_callers_of_other_sizes);
  RUN_TEST(test_learner_refuses_callers_of_other_sizes);
  return UNITY_END();
}
