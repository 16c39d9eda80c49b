/* profiles: host mcu */
/* What the learner decides, by its hash: the same by any compiler at any level of optimisation on any processor (the
 * tests golden_WAY build this file in several ways). The numbers change only when the learner or the format does; then
 * a failure prints the new ones. */
#include <stddef.h>
#include <string.h>

#include "learn/learner.h"
#include "support/forging.h"

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  learning_by_episodes = true;
}

void tearDown(void) {
}

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
    {"1..S..2/.#~..1./3.....S", 0, QTR_DISCOUNTED, QTR_RULE_FREE, 0x1C5BAEA9},
    {"1..S..2/.#~..1./3.....S", 0, QTR_TIME, QTR_RULE_FREE, 0xE35E8C90},
    {"1..S..2/.#~..1./3.....S", 0, QTR_DISCOUNTED, QTR_RULE_PAPER, 0x27E6237C},
    {"S..1..#..2/.##...#.#./..3.~~...1/1#...#..#./....#..2..", 2, QTR_DISCOUNTED, QTR_RULE_FREE, 0xB712CACD},
    {"S..1..#..2/.##...#.#./..3.~~...1/1#...#..#./....#..2..", 3, QTR_TIME, QTR_RULE_FREE, 0xB74B498B},
    {"S..1..#..2/.##...#.#./..3.~~...1/1#...#..#./....#..2..", 3, QTR_TIME, QTR_RULE_PAPER, 0x84728122},
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
    table_learn(1000);
    table_export();
    others += is_other_hash(drawing->hash);
  }
  TEST_ASSERT_EQUAL(0, others);
}

/* Open ground, 13 places of even odds. */
static void open_ground(uint8_t objective, uint8_t seekers) {
  test_random random = {2024};
  qtr_mission_default(&table_mission);
  table_mission.columns = table_mission.rows = 30;
  table_mission.aim.kind = objective;
  memset(table_mission.cost, 1, 900);
  for (; table_mission.places < 13; table_mission.places++) {
    table_mission.place[table_mission.places] = (qtr_cell)(table_mission.places * 69 + random_below(&random, 69));
    table_mission.weight[table_mission.places] = random_in(&random, 8, 10);
  }
  table_mission.start[0] = 899;
  mission_crew(&table_mission, seekers);
}

/* Two seekers: hundreds of episodes, each on the floats of the ones before. */
static void test_hundreds_of_episodes_give_the_golden_table(void) {
  static const uint32_t hash[2] = {0x923AA1A6, 0xFBF81C81};
  unsigned others = 0;
  for (uint8_t objective = 0; objective < 2; objective++) {
    snprintf(case_note, sizeof case_note, "episodes, objective %u", objective);
    open_ground(objective, 2);
    table_learn(0);
    table_learner->phase = QTR_PHASE_EPISODES; /* the first prices alone, so that Q has the work */
    for (unsigned step = 0; step < 400; step++) qtr_learner_step(table_learner);
    TEST_ASSERT_GREATER_THAN(300, table_learner->episodes);
    table_export();
    others += is_other_hash(hash[objective]);
  }
  TEST_ASSERT_EQUAL(0, others);
}

/* The same ground, more seekers: the best game chosen among routes. */
static void test_routes_give_the_golden_table(void) {
  static const uint32_t hash[2] = {0x657B87AD, 0x0DC46EDA};
  static uint64_t routes[(1u << 19) / 8];
  unsigned others = 0;
  for (uint8_t objective = 0; objective < 2; objective++) {
    const qtr_learner_blocks blocks = {
        learning_memory.work, sizeof learning_memory.work, learning_memory.table, QTR_QTABLE_WORDS, routes,
        sizeof routes};
    qtr_learner_config config;
    snprintf(case_note, sizeof case_note, "routes, objective %u", objective);
    open_ground(objective, 4);
    table_learn(0);
    qtr_learner_config_default(&config);
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_learner_init(&table_learner, &blocks, table_ground, NULL, &config));
    table_learner->phase = QTR_PHASE_EPISODES;
    TEST_ASSERT_EQUAL_INT(QTR_LEARNING, qtr_learner_step(table_learner));
    while (qtr_learner_step(table_learner) == QTR_LEARNING) {}
    TEST_ASSERT_EQUAL_MESSAGE(1, table_learner->episodes, case_note);
    table_export();
    others += is_other_hash(hash[objective]);
  }
  TEST_ASSERT_EQUAL(0, others);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_drawings_give_the_golden_tables);
  RUN_TEST(test_hundreds_of_episodes_give_the_golden_table);
  RUN_TEST(test_routes_give_the_golden_table);
  return UNITY_END();
}
