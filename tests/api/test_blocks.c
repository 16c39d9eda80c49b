/* profiles: host mcu */
/* The caller's blocks: as large as is said is enough, less is refused, nothing is touched beside them, and a Q-table
 * that grows by being moved learns what one that is large from the start learns. */
#include <stdlib.h>
#include <string.h>

#include "quarter/regions.h"
#include "support/settings.h"
#include "support/tables.h"

enum { GUARD = 64 };

static qtr_learner_config config;
static qtr_regions regions;
static uint64_t scratch[(QTR_REGIONS_SCRATCH_BYTES + 7) / 8];

void setUp(void) {
  qtr_learner_config_default(&config);
  table_draw("S..1..2..3/...#....../5..4..#..S", 0);
}

void tearDown(void) {
}

/* A block of so many bytes and some beside them, which nobody may touch. */
static uint8_t *take(size_t bytes) {
  uint8_t *block = malloc(bytes + GUARD);
  TEST_ASSERT_NOT_NULL(block);
  memset(block, 0xA5, bytes + GUARD);
  return block;
}

static void give_back(uint8_t *block, size_t bytes) {
  for (size_t i = 0; i < GUARD; i++) TEST_ASSERT_EQUAL_HEX8(0xA5, block[bytes + i]);
  free(block);
}

/* Regions of a few cells, and spots. */
static qtr_aggregation by_both(void) {
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  const qtr_regions_config limits = region_limits(4, 3);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_regions_build(&regions, &grid, &limits, scratch, sizeof scratch));
  const qtr_spots_config spots = spot_limits(2, 5, 0.0);
  return aggregation_of(&spots, &regions);
}

static void test_environment_stays_in_its_block(void) {
  const qtr_aggregation both = by_both();
  const qtr_aggregation *const hows[] = {NULL, &both};
  for (unsigned i = 0; i < 2; i++) {
    const size_t bytes = qtr_environment_bytes(&table_game, hows[i]);
    uint8_t *block = take(bytes);
    qtr_environment *made = NULL;
    TEST_ASSERT_LESS_OR_EQUAL(i == 0 ? QTR_ENVIRONMENT_BYTES : QTR_ENVIRONMENT_REGIONS_BYTES, bytes);
    TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE,
                          qtr_environment_init(&made, block, bytes - 1, &table_game, hows[i], &table_travel));
    TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_environment_init(&made, NULL, bytes, &table_game, hows[i], &table_travel));
    TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT,
                          qtr_environment_init(&made, block + 4, bytes, &table_game, hows[i], &table_travel));
    TEST_ASSERT_NULL(made);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_environment_init(&made, block, bytes, &table_game, hows[i], &table_travel));
    TEST_ASSERT_NOT_NULL(made);
    give_back(block, bytes);
  }
}

static void test_division_stays_in_its_scratch(void) {
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  const size_t bytes = qtr_regions_scratch_bytes(qtr_grid_cells(&grid));
  const qtr_regions_config limits = region_limits(4, 3);
  uint8_t *block = take(bytes);
  TEST_ASSERT_LESS_OR_EQUAL(QTR_REGIONS_SCRATCH_BYTES, qtr_regions_scratch_bytes(QTR_MAX_CELLS));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_regions_build(&regions, &grid, &limits, block, bytes - 1));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_regions_build(&regions, &grid, &limits, NULL, bytes));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_regions_build(&regions, &grid, &limits, block + 4, bytes));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_regions_build(&regions, &grid, &limits, block, bytes));
  give_back(block, bytes);
}

static void test_learner_stays_in_its_blocks(void) {
  const size_t bytes = qtr_learner_bytes(&table_game);
  const size_t words = QTR_QTABLE_LEAST_WORDS;
  uint8_t *work = take(bytes);
  uint8_t *table = take(words * sizeof(uint32_t));
  TEST_ASSERT_LESS_OR_EQUAL(QTR_LEARNER_BYTES, bytes);
  const qtr_learner_blocks right = {work, bytes, (uint32_t *)(void *)table, words, NULL, 0};
  qtr_learner_blocks wrong[5] = {right, right, right, right, right};
  wrong[0].work_bytes--;
  wrong[1].work = NULL;
  wrong[2].table_words--;
  wrong[3].table = NULL;
  wrong[4].work = work + 4;
  qtr_learner *made = NULL;
  for (unsigned i = 0; i < 5; i++)
    TEST_ASSERT_EQUAL_INT(i < 4 ? QTR_ERR_SPACE : QTR_ERR_ARGUMENT,
                          qtr_learner_init(&made, &wrong[i], table_ground, NULL, &config));
  TEST_ASSERT_NULL(made);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_learner_init(&made, &right, table_ground, NULL, &config));
  while (qtr_learner_step(made) == QTR_LEARNING) {}
  TEST_ASSERT_GREATER_THAN(0, qtr_export_size(made));
  give_back(work, bytes);
  give_back(table, words * sizeof(uint32_t));
}

/* ---- a Q-table that grows ---- */

/* Open ground and a learner that explores: entries without end. */
static void begin_exploring(const qtr_learner_blocks *blocks) {
  config.setting = QTR_SETTING_PAPER;
  config.gap = 0.0;
  table_draw("S..1..2..3/........../5..4..6..S", 0);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_learner_init(&table_learner, blocks, table_ground, NULL, &config));
}

static void learn_for_a_while(qtr_certificate *certificate, bool grows, uint32_t **table, size_t *words) {
  for (unsigned step = 0; step < 1000; step++) {
    const size_t needed = qtr_learner_table_needs(table_learner);
    TEST_ASSERT_LESS_OR_EQUAL(QTR_QTABLE_WORDS, needed);
    if (grows && needed > *words) {
      *table = realloc(*table, needed * sizeof **table);
      *words = needed;
      TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_learner_move_table(table_learner, *table, *words));
    }
    qtr_learner_step(table_learner);
  }
  memset(certificate, 0, sizeof *certificate);
  qtr_learner_certificate(table_learner, certificate);
}

static void test_growing_table_learns_what_a_large_one_does(void) {
  qtr_certificate whole, grown;
  qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(learning_memory);
  uint32_t *table = malloc(QTR_QTABLE_LEAST_WORDS * sizeof *table);
  size_t words = QTR_QTABLE_LEAST_WORDS;
  begin_exploring(&blocks);
  learn_for_a_while(&whole, false, NULL, NULL);
  const uint32_t entries = qtr_learner_entries(table_learner);
  blocks.table = table;
  blocks.table_words = words;
  begin_exploring(&blocks);
  learn_for_a_while(&grown, true, &table, &words);
  TEST_ASSERT_EQUAL_UINT32(entries, qtr_learner_entries(table_learner));
  TEST_ASSERT_EQUAL_UINT64(whole.updates, grown.updates);
  TEST_ASSERT_TRUE(whole.max_q == grown.max_q && whole.value == grown.value && whole.bound == grown.bound);
  TEST_ASSERT_GREATER_THAN(QTR_QTABLE_LEAST_WORDS, words);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_learner_move_table(table_learner, table, QTR_QTABLE_LEAST_WORDS / 8));
  free(table);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_environment_stays_in_its_block);
  RUN_TEST(test_division_stays_in_its_scratch);
  RUN_TEST(test_learner_stays_in_its_blocks);
  RUN_TEST(test_growing_table_learns_what_a_large_one_does);
  return UNITY_END();
}
