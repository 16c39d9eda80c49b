/* The paper's setting of the learner, Q from 0 and exploring, on small games with the field's terms: in the end it
 * plays what an enumeration of all plans finds best, its Q says what that is worth, and its bound holds on the way. */
#include <math.h>
#include <stdio.h>

#include "support/learning.h"
#include "support/terms_games.h"
#include "unity.h"

enum { GAMES = 60, MIXED = 300, EPISODES_MOST = 40000 };
#define NEAR 1e-5 /* Q is kept in floats */

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_learner *learner;
static uint64_t most_episodes;

void setUp(void) {
}

void tearDown(void) {
}

static void begin(unsigned seed, unsigned features) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  config.setting = QTR_SETTING_PAPER;
  config.gap = 0.0; /* it goes on whatever its bound proves */
  config.seed = seed;
  config.alpha = 1.0;
  terms_game_make(&mission, seed, features);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_mission_check(&mission, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&learner, ground, NULL, &config), case_note);
}

static bool is_near(double value, double optimum) {
  return fabs(value - optimum) <= NEAR * fmax(1.0, fabs(optimum));
}

static void check_honest(const qtr_certificate *c, double optimum) {
  const double sign = qtr_objective_in_words(mission.aim.kind)->less_is_better ? -1.0 : 1.0;
  const double slack = NEAR * fmax(1.0, fabs(optimum));
  char text[300];
  snprintf(text, sizeof text, "%s: %.9f is best, %.9f played, bound %.9f", case_note, optimum, c->objective, c->bound);
  TEST_ASSERT_TRUE_MESSAGE(sign * c->objective <= sign * optimum + slack, text);
  TEST_ASSERT_TRUE_MESSAGE(sign * c->bound >= sign * optimum - slack, text);
}

/* Whether the largest Q is the whole game's: its clock begins with the first choice, and what is left at the end of
 * everybody's endurance is counted apart. */
static bool is_whole(void) {
  bool ready = false;
  for (int i = 0; i < mission.seekers; i++) ready = ready || mission.ready[i] == 0;
  return ready && game.board.terms.end == NULL;
}

/* That Q is the game's worth, as the objective has it. */
static bool is_told(const qtr_certificate *c, double optimum) {
  return !is_whole() || is_near(mission.aim.kind == QTR_TIME ? -c->max_q : c->max_q, optimum);
}

static void expect_learnt(unsigned seed, unsigned features) {
  qtr_certificate c = {.episodes = 0};
  char text[300];
  begin(seed, features);
  const double optimum = brute_force_value(&mission);
  bool done = false;
  while (!done && c.episodes < EPISODES_MOST) {
    const enum qtr_learning learning = qtr_learner_step(learner);
    qtr_learner_certificate(learner, &c);
    check_honest(&c, optimum);
    done = (is_near(c.objective, optimum) && is_told(&c, optimum)) || learning != QTR_LEARNING;
  }
  snprintf(text, sizeof text, "%s: %.9f is best, %.9f played, Q %.9f after %llu episodes", case_note, optimum,
           c.objective, c.max_q, (unsigned long long)c.episodes);
  TEST_ASSERT_TRUE_MESSAGE(is_near(c.objective, optimum), text);
  TEST_ASSERT_TRUE_MESSAGE(is_told(&c, optimum), text);
  if (c.episodes > most_episodes) most_episodes = c.episodes;
}

static void test_exploring_from_0_reaches_the_optimum_with_each_feature(void) {
  for (int feature = 0; feature < TERMS_FEATURES; feature++)
    for (unsigned seed = 1; seed <= GAMES; seed++) expect_learnt(seed, 1u << feature);
}

static void test_exploring_from_0_reaches_the_optimum_with_features_mixed(void) {
  for (unsigned seed = 1; seed <= MIXED; seed++) expect_learnt(seed, terms_mix(seed));
  printf("at most %llu episodes\n", (unsigned long long)most_episodes);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_exploring_from_0_reaches_the_optimum_with_each_feature);
  RUN_TEST(test_exploring_from_0_reaches_the_optimum_with_features_mixed);
  return UNITY_END();
}
