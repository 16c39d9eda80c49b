/* Policy tables for the tests: learnt from a mission, and forged. */
#ifndef QUARTER_TESTS_TABLES_H
#define QUARTER_TESTS_TABLES_H

#include "core/bytes.h"
#include "core/crc.h"
#include "missions.h"
#include "quarter/export.h"
#include "quarter/learner.h"
#include "quarter/policy.h"
#include "quarter/status.h"
#include "random.h"
#include "unity.h"

enum { TABLE_MOST = 64 * 1024 };

static qtr_mission table_mission;
static qtr_field table_field;
static qtr_game table_game;
static qtr_environment table_ground;
static qtr_learner table_learner;
static uint8_t table_bytes[TABLE_MOST];
static uint32_t table_size;

/* Learn `table_mission` for at most so many steps. */
static inline void table_learn(unsigned steps) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_mission_check(&table_mission, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&table_game, &table_mission, &table_field, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_environment_init(&table_ground, &table_game, NULL, &table_field),
                                case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_learner_init(&table_learner, &table_ground, NULL, &config), case_note);
  while (steps > 0 && qtr_learner_step(&table_learner) == QTR_LEARNING) steps--;
}

static inline void table_export(void) {
  memset(table_bytes, 0xA5, sizeof table_bytes);
  const int32_t written = qtr_export(&table_learner, table_bytes, sizeof table_bytes);
  TEST_ASSERT_GREATER_THAN_MESSAGE(0, written, case_note);
  table_size = (uint32_t)written;
}

static inline void table_open(qtr_policy *policy) {
  memset(policy, 0xA5, sizeof *policy);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(policy, table_bytes, table_size), case_note);
}

/* The table of a random mission. */
static inline void table_random(test_random *random, mission_size most) {
  mission_random(&table_mission, random, most);
  table_learn(3);
  table_export();
}

/* The table of a drawing whose one start holds `seekers`; 0: as drawn. */
static inline void table_draw(const char *rows, uint8_t seekers) {
  mission_draw(&table_mission, rows);
  if (seekers > 0) mission_crew(&table_mission, seekers);
  table_learn(1000);
  table_export();
}

/* Make the checksum right again. */
static inline void table_seal(uint8_t *bytes, uint32_t size) {
  store32_le(bytes + QTR_POLICY_CRC, crc32_add(0, bytes + QTR_POLICY_COLUMNS, size - QTR_POLICY_COLUMNS));
}

/* Make checksum and digest right for what the bytes say now, as a forger would, and open. */
static inline int table_forge(qtr_policy *policy, uint8_t *bytes, uint32_t size) {
  table_seal(bytes, size);
  const int status = qtr_policy_open(policy, bytes, size);
  if (status != QTR_ERR_SELFTEST || policy->board.keys.words != bytes[QTR_POLICY_KEY_WORDS]) return status;
  store32_le(bytes + QTR_POLICY_DIGEST, qtr_policy_digest(policy));
  table_seal(bytes, size);
  return qtr_policy_open(policy, bytes, size);
}

#endif
