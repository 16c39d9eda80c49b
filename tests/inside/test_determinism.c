/* profiles: host mcu */
/* The same mission gives the same table, bit for bit: learnt twice, over dirty memory, by any compiler at any level of
 * optimisation. The numbers below change only when the learner or the format does; then a failure prints the new ones. */
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

/* ---- golden numbers ---- */

/* All that the learner decides: the table but for the version that wrote it and the checksum over it. */
static uint32_t table_hash(void) {
  memset(table_bytes + QTR_POLICY_PRODUCER, 0, 4);
  memset(table_bytes + QTR_POLICY_CRC, 0, 4);
  return qtr_crc32_add(0, table_bytes, table_size);
}

typedef struct {
  const char *rows;
  uint8_t seekers;
  uint8_t objective;
  uint8_t rule;
  uint32_t hash;
} golden_drawing;

static const golden_drawing drawings[] = {
    {"1..S..2/.#~..1./3.....S", 0, QTR_DISCOUNTED, QTR_RULE_FREE, 0x63A87A8E},
    {"1..S..2/.#~..1./3.....S", 0, QTR_TIME, QTR_RULE_FREE, 0x67BA8AD3},
    {"1..S..2/.#~..1./3.....S", 0, QTR_DISCOUNTED, QTR_RULE_PAPER, 0x50BF3C31},
    {"S..1..#..2/.##...#.#./..3.~~...1/1#...#..#./....#..2..", 2, QTR_DISCOUNTED, QTR_RULE_FREE, 0x8A8DF420},
    {"S..1..#..2/.##...#.#./..3.~~...1/1#...#..#./....#..2..", 3, QTR_TIME, QTR_RULE_FREE, 0x277E4DC6},
    {"S..1..#..2/.##...#.#./..3.~~...1/1#...#..#./....#..2..", 3, QTR_TIME, QTR_RULE_PAPER, 0xC9AC4BE9},
};

/* Counts differences, so that one run shows all the new numbers. */
static unsigned is_other_hash(uint32_t expected) {
  const uint32_t actual = table_hash();
  if (actual != expected) printf("%s: 0x%08X now\n", case_note, (unsigned)actual);
  return actual != expected;
}

static void test_drawings_give_the_golden_tables(void) {
  unsigned others = 0;
  for (unsigned i = 0; i < sizeof drawings / sizeof drawings[0]; i++) {
    const golden_drawing *drawing = &drawings[i];
    snprintf(case_note, sizeof case_note, "drawing %u", i);
    mission_draw(&table_mission, drawing->rows);
    if (drawing->seekers > 0) mission_crew(&table_mission, drawing->seekers);
    table_mission.aim.kind = drawing->objective;
    table_mission.rule = drawing->rule;
    learn_and_export(1000, 0x5A);
    others += is_other_hash(drawing->hash);
  }
  TEST_ASSERT_EQUAL(0, others);
}

/* Open ground, 13 places of even odds, 2 seekers: hundreds of episodes, each on the floats of the ones before. */
static void test_hundreds_of_episodes_give_the_golden_table(void) {
  static const uint32_t hash[2] = {0x80169489, 0xE9D429AE};
  unsigned others = 0;
  for (uint8_t objective = 0; objective < 2; objective++) {
    test_random random = {2024};
    snprintf(case_note, sizeof case_note, "episodes, objective %u", objective);
    qtr_mission_default(&table_mission);
    table_mission.columns = table_mission.rows = 30;
    table_mission.aim.kind = objective;
    memset(table_mission.cost, 1, 900);
    for (; table_mission.places < 13; table_mission.places++) {
      table_mission.place[table_mission.places] = (qtr_cell)(table_mission.places * 69 + random_below(&random, 69));
      table_mission.weight[table_mission.places] = random_in(&random, 8, 10);
    }
    table_mission.start[0] = 899;
    mission_crew(&table_mission, 2);
    dirty(0x5A);
    table_learn(0);
    table_learner->phase = QTR_PHASE_EPISODES; /* the first prices alone, so that Q has the work */
    for (unsigned step = 0; step < 400; step++) qtr_learner_step(table_learner);
    TEST_ASSERT_GREATER_THAN(300, table_learner->episodes);
    table_export();
    others += is_other_hash(hash[objective]);
  }
  TEST_ASSERT_EQUAL(0, others);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learning_twice_gives_the_same_bytes);
  RUN_TEST(test_certificates_repeat_at_every_step);
  RUN_TEST(test_drawings_give_the_golden_tables);
  RUN_TEST(test_hundreds_of_episodes_give_the_golden_table);
  return UNITY_END();
}
