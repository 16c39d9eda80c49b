/* Policy tables for the tests, learnt from a mission. */
#ifndef QUARTER_TESTS_TABLES_H
#define QUARTER_TESTS_TABLES_H

#include "learning.h"
#include "missions.h"
#include "quarter/digest.h"
#include "quarter/export.h"
#include "quarter/learner.h"
#include "quarter/nominal.h"
#include "quarter/policy.h"
#include "quarter/status.h"
#include "quarter/writer.h"
#include "random.h"
#include "steps.h"
#include "unity.h"

enum { TABLE_MOST = 64 * 1024 };

static qtr_mission table_mission;
static qtr_travel table_travel;
static qtr_game table_game;
static qtr_environment *table_ground;
static qtr_learner *table_learner;
static uint8_t table_bytes[TABLE_MOST];
static uint32_t table_size;
static uint8_t table_copy[TABLE_MOST]; /* to be changed */

/* Learn `table_mission` for at most so many steps. */
static inline void table_learn(unsigned steps) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_mission_check(&table_mission, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&table_game, &table_mission, &table_travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&table_ground, &table_game, &table_travel), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&table_learner, table_ground, NULL, &config), case_note);
  while (steps > 0 && qtr_learner_step(table_learner) == QTR_LEARNING) steps--;
}

static inline void table_export(void) {
  memset(table_bytes, 0xA5, sizeof table_bytes);
  const int32_t written = qtr_export(table_learner, table_bytes, sizeof table_bytes);
  TEST_ASSERT_GREATER_THAN_MESSAGE(0, written, case_note);
  table_size = (uint32_t)written;
}

static inline void table_open(qtr_policy *policy) {
  memset(policy, 0xA5, sizeof *policy);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(policy, table_bytes, table_size), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_check(policy), case_note);
}

/* Open the table, and take a copy of it. */
static inline void table_take(qtr_policy *policy) {
  table_open(policy);
  memcpy(table_copy, table_bytes, table_size);
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

/* A table for any start. Cells 0 to 3 go by cell 1, cells 5 and 6 by cell 6; the mission's own start is cell 3. */
static inline void table_draw_regions(void) {
  static const qtr_cell start[3] = {1, 6, 3};
  static const uint16_t region[7] = {0, 0, 0, 0, 0xFFFF, 1, 1};
  static uint8_t steps[4 * 5 * 2];
  qtr_certificate certificate;
  table_draw("1..S#.2/.......", 1);
  qtr_learner_certificate(table_learner, &certificate);
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  qtr_board board = table_game.board;
  board.starts = 3;
  board.start_of[0] = 2;
  board.step_bytes = 4;
  board.steps = steps;
  for (unsigned place = 0; place < 2; place++) {
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_travel_fill(&table_travel, &grid, table_mission.place[place]));
    for (unsigned node = 0; node < 5; node++) {
      const qtr_cell cell = node < 2 ? table_mission.place[node] : start[node - 2];
      steps_put(steps, node * 2 + place, table_travel.to_go[cell]);
    }
  }
  uint16_t of[14];
  for (unsigned cell = 0; cell < 14; cell++) of[cell] = cell < 7 ? region[cell] : region[cell - 7 == 4 ? 5 : cell - 7];
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_board_init(&board));
  const qtr_table_content content = {
      &table_mission, &board, table_game.probability, start, of, NULL, 0, &certificate, 1, NULL, NULL, NULL};
  const int32_t written = qtr_table_write(&content, table_bytes, sizeof table_bytes);
  TEST_ASSERT_GREATER_THAN(0, written);
  table_size = (uint32_t)written;
}

/* Write a travel time into a copy of an open policy's bytes, in as many bytes as the table has for one. */
static inline void table_set_steps(uint8_t *bytes, const qtr_policy *policy, unsigned node, unsigned place,
                                   qtr_steps steps) {
  const unsigned width = policy->board.step_bytes;
  uint8_t *at = bytes + (policy->board.steps - policy->bytes) + width * (node * policy->board.places + place);
  for (unsigned i = 0; i < width; i++) at[i] = (uint8_t)(steps >> (8 * i) & 0xFFu);
}

#endif
