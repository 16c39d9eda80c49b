/* profiles: host mcu */
/* The same mission gives the same table, bit for bit: learnt twice, over dirty memory. */
#include <stddef.h>
#include <string.h>

#include "learn/learner.h"
#include "support/forging.h"

static uint8_t first[TABLE_MOST];
static uint32_t first_size;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* Whatever lay in memory before. The Q-table's words are dirtied at its beginning alone: they are many. */
static void dirty(uint8_t with) {
  memset(learning_memory.ground, with, sizeof learning_memory.ground);
  memset(learning_memory.work, with, sizeof learning_memory.work);
  memset(learning_memory.table, with, 4096);
  memset(&table_game, with, sizeof table_game);
  memset(&table_travel, with, sizeof table_travel);
}

static void learn_and_export(unsigned steps, uint8_t with) {
  dirty(with);
  table_learn(steps);
  table_export();
}

static void learn_twice(unsigned steps) {
  learn_and_export(steps, 0x00);
  memcpy(first, table_bytes, table_size);
  first_size = table_size;
  learn_and_export(steps, 0xA5);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(first_size, table_size, case_note);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(first, table_bytes, table_size, case_note);
}

static void test_learning_twice_gives_the_same_bytes(void) {
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("twice", number);
    mission_random(&table_mission, &random, (mission_size){20, 16, 12, 4});
    learn_twice(random_below(&random, 40));
  }
}

static void test_certificates_repeat_at_every_step(void) {
  static qtr_certificate seen[60];
  test_random random = random_case("steps", 7);
  mission_random(&table_mission, &random, (mission_size){20, 16, 16, 3});
  for (int run = 0; run < 2; run++) {
    dirty(run == 0 ? 0x00 : 0xA5);
    table_learn(0);
    for (unsigned step = 0; step < 60; step++) {
      qtr_certificate now;
      memset(&now, 0, sizeof now);
      qtr_learner_step(table_learner);
      qtr_learner_certificate(table_learner, &now);
      if (run == 0) seen[step] = now;
      TEST_ASSERT_TRUE(now.bound == seen[step].bound);
      TEST_ASSERT_TRUE(now.objective == seen[step].objective);
      TEST_ASSERT_EQUAL_UINT64(seen[step].updates, now.updates);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learning_twice_gives_the_same_bytes);
  RUN_TEST(test_certificates_repeat_at_every_step);
  return UNITY_END();
}
