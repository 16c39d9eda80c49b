/* The learner under the field's terms, against an enumeration of all plans: its certified value is the optimum, every
 * bound in every state is one, and the game it plays is the mission's. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "learn/learner.h"
#include "support/learning.h"
#include "support/terms_games.h"
#include "unity.h"

#ifndef GAMES
#define GAMES 500 /* of each feature, and mixed */
#endif
#define NEAR 1e-9

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_learner *learner;
static qtr_learner_config config;

void setUp(void) {
  qtr_learner_config_default(&config);
}

void tearDown(void) {
}

static void begin(unsigned seed, unsigned features) {
  terms_game_make(&mission, seed, features);
  learning_by_episodes = seed % 3 == 0;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_mission_check(&mission, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&learner, ground, NULL, &config), case_note);
}

static void assert_near(double expected, double actual, double by, const char *what) {
  char text[300];
  snprintf(text, sizeof text, "%s: %s: %.12f expected, %.12f found", case_note, what, expected, actual);
  TEST_ASSERT_TRUE_MESSAGE(fabs(expected - actual) <= by * fmax(1.0, fabs(expected)), text);
}

/* ---- certificates ---- */

static void expect_certified(unsigned seed, unsigned features, bool weakened) {
  qtr_certificate certificate;
  begin(seed, features);
  if (weakened) { /* no prices, no good first game: the certificate must come from Q-learning alone */
    for (unsigned place = 0; place < game.board.places; place++) learner->bound.price[place] = 0.0;
    learner->bound.filling = 0; /* C is of other prices */
    qtr_bound_settle(&learner->bound);
    learner->phase = QTR_PHASE_EPISODES;
    learner->upper = learner->ground_upper = 1e6;
    learner->best.score.worth = -1e9;
  }
  while (qtr_learner_step(learner) == QTR_LEARNING) continue;
  qtr_learner_certificate(learner, &certificate);
  TEST_ASSERT_TRUE_MESSAGE(certificate.certified, case_note);
  const double optimum = brute_force_value(&mission);
  assert_near(optimum, certificate.objective, config.gap + NEAR, "certified value");
  const double sign = qtr_objective_in_words(mission.aim.kind)->less_is_better ? -1.0 : 1.0;
  TEST_ASSERT_TRUE_MESSAGE(sign * certificate.bound >= sign * optimum - NEAR * fmax(1.0, fabs(optimum)), case_note);
}

static void test_certified_value_is_the_optimum_with_each_feature(void) {
  for (int feature = 0; feature < TERMS_FEATURES; feature++)
    for (unsigned seed = 1; seed <= GAMES; seed++) expect_certified(seed, 1u << feature, seed % 4 == 0);
}

static void test_certified_value_is_the_optimum_with_features_mixed(void) {
  for (unsigned seed = 1; seed <= GAMES; seed++) expect_certified(seed, terms_mix(seed), seed % 4 == 0);
}

static void test_terms_at_their_defaults_are_the_plain_game(void) {
  for (unsigned seed = 1; seed <= GAMES / 5; seed++) expect_certified(seed, 0, false);
}

/* ---- every state ---- */

static uint64_t states;

static double value_of(const qtr_situation *state);

/* The most that comes after a choice, counted from it; and that the bound is no less. */
static double value_after(const qtr_situation *after) {
  qtr_situation next = *after;
  qtr_outcome outcome;
  qtr_environment_pass(ground, &next, &outcome);
  const double value = outcome.reward + outcome.discount * value_of(&next);
  const double most = qtr_bound_state(&learner->bound, after);
  states++;
  TEST_ASSERT_TRUE_MESSAGE(most >= value - NEAR * fmax(1.0, fabs(value)), case_note);
  return value;
}

static double value_of(const qtr_situation *state) {
  const int seeker = qtr_joint_chooser(&state->joint, &ground->board);
  qtr_places choices;
  double best = -HUGE_VAL;
  if (seeker == QTR_NOBODY) return 0.0;
  const bool may_stand_down = qtr_joint_choices(&state->joint, &ground->board, seeker, &choices);
  for (unsigned choice = 0; choice <= ground->board.places; choice++) {
    const bool stands = choice == ground->board.places;
    if (stands ? !may_stand_down : !qtr_places_has(&choices, choice)) continue;
    qtr_situation after = *state;
    const double at_once = qtr_environment_choose(ground, &after, seeker, stands ? QTR_STAND_DOWN : (uint16_t)choice);
    best = fmax(best, at_once + value_after(&after));
  }
  return best;
}

/* Before anybody has chosen time may have to pass: until the first seeker is ready. */
static double value_of_game(void) {
  qtr_situation state;
  qtr_outcome outcome;
  qtr_environment_start(ground, &state);
  qtr_environment_pass(ground, &state, &outcome);
  return outcome.reward + outcome.discount * value_of(&state);
}

static double figure_of(double worth) {
  return mission.aim.kind == QTR_TIME ? -worth : worth;
}

static void test_no_bound_in_any_state_is_below_the_exact_value(void) {
  states = 0;
  for (unsigned seed = 1; seed <= GAMES; seed++) {
    begin(seed, terms_mix(seed));
    /* From a good play's prices to the best, and some on the way. */
    for (unsigned step = seed % 7; step > 0 && learner->phase != QTR_PHASE_EPISODES; step--) qtr_learner_step(learner);
    qtr_bound_settle(&learner->bound);
    assert_near(brute_force_value(&mission), figure_of(value_of_game()), NEAR, "value of the game");
  }
  TEST_ASSERT_GREATER_THAN_UINT64(1000, states);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_certified_value_is_the_optimum_with_each_feature);
  RUN_TEST(test_certified_value_is_the_optimum_with_features_mixed);
  RUN_TEST(test_terms_at_their_defaults_are_the_plain_game);
  RUN_TEST(test_no_bound_in_any_state_is_below_the_exact_value);
  return UNITY_END();
}
