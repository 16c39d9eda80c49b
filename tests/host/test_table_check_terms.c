/* Tables of missions with the field's terms, held against their own map: as they are written they are true of it, and
 * with a time, a way home or a figure changed they are not. */
#include <stdio.h>
#include <string.h>

#include "host/plan/simulation.h"
#include "host/table/certificate.h"
#include "host/table/table_check.h"
#include "quarter/export.h"
#include "quarter/status.h"
#include "robot/layout.h"
#include "support/forging.h"
#include "support/learning.h"
#include "support/terms_games.h"
#include "unity.h"

enum { GAMES = 400, BYTES = 1 << 16 };

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_learner *learner;
static uint8_t bytes[BYTES];
static uint32_t size;
static qtr_policy policy;
static fault why;

void setUp(void) {
}

void tearDown(void) {
}

/* Games of each feature, then mixed ones; some are stopped before they are certified. */
static void make_table(unsigned number) {
  const unsigned seed = number / (TERMS_FEATURES + 1) + 1;
  const unsigned feature = number % (TERMS_FEATURES + 1);
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  terms_game_make(&mission, seed, feature < TERMS_FEATURES ? 1u << feature : terms_mix(seed));
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&learner, ground, NULL, &config), case_note);
  for (unsigned steps = number % 5; steps != 1 && qtr_learner_step(learner) == QTR_LEARNING; steps--) continue;
  const int32_t written = qtr_export(learner, bytes, BYTES);
  TEST_ASSERT_GREATER_THAN_INT32_MESSAGE(0, written, case_note);
  size = (uint32_t)written;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(&policy, bytes, size), case_note);
}

static void test_every_exported_table_is_true_of_its_map(void) {
  for (unsigned number = 0; number < GAMES; number++) {
    make_table(number);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, table_check(&policy, case_note, &why), why.text);
  }
}

/* Robots on time come to each place when the plan says, or sooner, by one that is done with its own: which gains
 * nothing where the plan is the best there is. */
static void test_robots_that_walk_the_grid_earn_what_the_table_says(void) {
  static simulation s;
  static table t;
  simulation_config config;
  simulation_config_default(&config);
  for (unsigned number = 0; number < GAMES; number++) {
    char text[400];
    make_table(number);
    t.policy = policy;
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, simulation_run(&s, &t, NULL, &config, &why), why.text);
    const table_certificate c = table_certificate_of(&policy);
    snprintf(text, sizeof text, "%s: %.9g planned, %.9g earned", case_note, c.value, s.value);
    TEST_ASSERT_TRUE_MESSAGE(s.value >= c.value - 1e-6, text);
    const bool is_best = c.certified && c.objective == QTR_DISCOUNTED && policy.board.terms.end == NULL;
    if (is_best) TEST_ASSERT_TRUE_MESSAGE(s.value <= c.value * (1.0 + 1e-4), text);
  }
}

static void expect_refused(uint32_t at, uint8_t byte) {
  const uint8_t before = bytes[at];
  bytes[at] = byte;
  table_seal(bytes, size);
  if (qtr_policy_open(&policy, bytes, size) == QTR_ERR_SELFTEST) {
    qtr_store32(bytes + QTR_POLICY_DIGEST, qtr_policy_digest(&policy));
    table_seal(bytes, size);
  }
  const bool opens = qtr_policy_open(&policy, bytes, size) == QTR_OK && qtr_policy_check(&policy) == QTR_OK;
  if (opens) TEST_ASSERT_EQUAL_INT_MESSAGE(-1, table_check(&policy, "forged.qtr", &why), case_note);
  bytes[at] = before;
}

/* The steps of a class, and every byte of the figures that only a host looks at. */
static void test_other_words_of_terms_are_refused(void) {
  for (unsigned number = 0; number < GAMES / 4; number++) {
    make_table(number);
    if ((policy.features & QTR_FEATURE_TERMS) == 0) continue;
    const uint32_t terms = policy.at[SECTION_TERMS];
    expect_refused(terms + QTR_TERMS_CLASS + 4u * policy.board.class_of[0],
                   (uint8_t)(bytes[terms + QTR_TERMS_CLASS + 4u * policy.board.class_of[0]] + 1));
    expect_refused(QTR_POLICY_FOUND + 6, (uint8_t)(bytes[QTR_POLICY_FOUND + 6] ^ 4));
    expect_refused(terms + QTR_TERMS_FINDABLE + 6, (uint8_t)(bytes[terms + QTR_TERMS_FINDABLE + 6] ^ 4));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_exported_table_is_true_of_its_map);
  RUN_TEST(test_robots_that_walk_the_grid_earn_what_the_table_says);
  RUN_TEST(test_other_words_of_terms_are_refused);
  return UNITY_END();
}
