/* Tables of missions with the field's terms: what robots play from them is what was learnt, and none announces what it
 * has not looked at as often as its territory owes. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/doubles.h"
#include "quarter/claim.h"
#include "quarter/export.h"
#include "quarter/nominal.h"
#include "quarter/seeker.h"
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
static uint8_t bytes[BYTES], torn[BYTES];
static int32_t size;
static qtr_policy policy;

void setUp(void) {
}

void tearDown(void) {
}

static void make_table(unsigned seed, unsigned features) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  terms_game_make(&mission, seed, features);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&learner, ground, NULL, &config), case_note);
  while (qtr_learner_step(learner) == QTR_LEARNING) continue;
  size = qtr_export(learner, bytes, BYTES);
  TEST_ASSERT_GREATER_THAN_INT32_MESSAGE(0, size, qtr_strerror(size));
  TEST_ASSERT_EQUAL_INT32_MESSAGE(size, (int32_t)qtr_export_size(learner), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(&policy, bytes, (uint32_t)size), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_check(&policy), case_note);
}

/* Games of each feature, then mixed ones. */
static void make_any_table(unsigned number) {
  const unsigned seed = number / (TERMS_FEATURES + 1) + 1;
  const unsigned feature = number % (TERMS_FEATURES + 1);
  make_table(seed, feature < TERMS_FEATURES ? 1u << feature : terms_mix(seed));
}

/* ---- the division ---- */

static void test_robots_play_the_game_that_was_learnt(void) {
  for (unsigned number = 0; number < GAMES; number++) {
    qtr_joint joint;
    qtr_move move;
    make_any_table(number);
    const qtr_play *best = qtr_learner_best(learner);
    unsigned made = 0;
    qtr_joint_start(&joint, &policy.board, NULL, NULL);
    while (qtr_policy_move(&policy, &joint, &move)) {
      TEST_ASSERT_LESS_THAN_MESSAGE(best->choices, made, case_note);
      TEST_ASSERT_EQUAL_INT_MESSAGE(best->seeker[made], move.seeker, case_note);
      TEST_ASSERT_EQUAL_UINT16_MESSAGE(best->choice[made++], move.choice, case_note);
      TEST_ASSERT_FALSE_MESSAGE(move.off_table, case_note);
    }
    TEST_ASSERT_EQUAL_MESSAGE(best->choices, made, case_note);
  }
}

static double bits_to_double(uint64_t bits) {
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static void test_figure_is_the_certificates(void) {
  for (unsigned number = 0; number < GAMES; number++) {
    qtr_certificate certificate;
    qtr_claim claim;
    make_any_table(number);
    qtr_learner_certificate(learner, &certificate);
    qtr_claim_read(&claim, &policy);
    TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(certificate.objective, bits_to_double(claim.figure), case_note);
  }
}

static void test_looks_lie_in_their_places_cells(void) {
  for (unsigned number = 0; number < GAMES; number++) {
    make_any_table(number);
    for (unsigned place = 0; place < policy.board.places; place++) {
      TEST_ASSERT_EQUAL_UINT_MESSAGE(qtr_game_place(&game, place), qtr_policy_place(&policy, place), case_note);
      TEST_ASSERT_EQUAL_MESSAGE(qtr_policy_cell(&policy, qtr_policy_place(&policy, place)),
                                qtr_policy_cell(&policy, place), case_note);
    }
  }
}

/* ---- executors ---- */

static unsigned looks_owed(const qtr_seeker *seeker, unsigned territory, unsigned place) {
  unsigned owed = 0;
  for (unsigned i = 0; i < seeker->division.moves; i++)
    owed += seeker->division.seeker[i] == territory && qtr_policy_place(&policy, seeker->division.place[i]) == place;
  return owed;
}

/* A robot alone, in any order of looks in passing and shut doors: what it announces it has looked at as often as its
 * territories owe in all, and it comes to an end. */
static void search_alone(unsigned self, test_random *random) {
  qtr_seeker seeker;
  qtr_signal signal;
  unsigned made[TERMS_MOST_LOOKS] = {0};
  unsigned owed[TERMS_MOST_LOOKS] = {0};
  qtr_seeker_init(&seeker, &policy, self, NULL, 0);
  for (unsigned turns = 0; qtr_seeker_target(&seeker) != QTR_STAND_DOWN; turns++) {
    const unsigned place = qtr_policy_place(&policy, qtr_seeker_target(&seeker));
    TEST_ASSERT_LESS_THAN_MESSAGE(200, turns, case_note);
    if (random_chance(random, 10)) {
      qtr_seeker_blocked(&seeker, place);
    } else {
      const unsigned at = random_chance(random, 20) ? random_below(random, mission.places) : place;
      qtr_seeker_visited(&seeker, at);
      made[at]++;
    }
    while (qtr_seeker_announce(&seeker, &signal))
      for (unsigned p = 0; p < mission.places; p++) owed[p] += looks_owed(&seeker, signal.territory, p);
    for (unsigned p = 0; p < mission.places; p++) TEST_ASSERT_LESS_OR_EQUAL_UINT_MESSAGE(made[p], owed[p], case_note);
  }
}

static void test_nothing_is_announced_that_was_not_looked_at_often_enough(void) {
  for (unsigned number = 0; number < GAMES; number++) {
    make_any_table(number);
    test_random random = random_case("executors", number);
    for (unsigned self = 0; self < mission.seekers; self++) search_alone(self, &random);
  }
}

/* ---- damage ---- */

static void test_table_cut_short_or_flipped_is_refused(void) {
  for (unsigned number = 0; number < 3 * (TERMS_FEATURES + 1); number++) {
    make_any_table(number);
    for (uint32_t cut = 0; cut < (uint32_t)size; cut++)
      TEST_ASSERT_NOT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(&policy, bytes, cut), case_note);
    for (uint32_t bit = 0; bit < 8u * (uint32_t)size; bit += 3) {
      memcpy(torn, bytes, (size_t)size);
      torn[bit / 8] ^= (uint8_t)(1u << bit % 8);
      TEST_ASSERT_NOT_EQUAL_INT_MESSAGE(QTR_OK, qtr_policy_open(&policy, torn, (uint32_t)size), case_note);
    }
  }
}

/* A robot that is told of looks in passing, too: what it announces it has looked at as often in those cells. */
static void search_forged(test_random *random) {
  qtr_seeker seeker;
  qtr_signal signal;
  unsigned made[TERMS_MOST_LOOKS] = {0}, owed[TERMS_MOST_LOOKS] = {0};
  qtr_seeker_init(&seeker, &policy, 0, NULL, 0);
  for (unsigned turns = 0; qtr_seeker_target(&seeker) != QTR_STAND_DOWN; turns++) {
    TEST_ASSERT_LESS_THAN_MESSAGE(200, turns, case_note);
    const unsigned at =
        random_chance(random, 40) ? random_below(random, policy.board.places) : qtr_seeker_target(&seeker);
    for (unsigned p = 0; p < policy.board.places; p++)
      made[p] += qtr_policy_cell(&policy, p) == qtr_policy_cell(&policy, at);
    qtr_seeker_visited(&seeker, at);
    while (qtr_seeker_announce(&seeker, &signal))
      for (unsigned i = 0; i < seeker.division.moves; i++)
        for (unsigned p = 0; p < policy.board.places; p++)
          owed[p] += seeker.division.seeker[i] == signal.territory &&
                     qtr_policy_cell(&policy, p) == qtr_policy_cell(&policy, seeker.division.place[i]);
    for (unsigned p = 0; p < policy.board.places; p++)
      TEST_ASSERT_LESS_OR_EQUAL_UINT_MESSAGE(made[p], owed[p], case_note);
  }
}

/* Sums are easily redone: what opens then still leads nowhere outside, and its game and its robots end. */
static void test_forged_terms_are_refused_or_played_to_an_end(void) {
  for (unsigned number = 0; number < 40 * (TERMS_FEATURES + 1); number++) {
    make_any_table(number % (4 * (TERMS_FEATURES + 1)));
    test_random random = random_case("forged", number);
    memcpy(torn, bytes, (size_t)size);
    for (unsigned i = 0; i < 3; i++) {
      const bool in_header = random_chance(&random, 40) || (policy.features & QTR_FEATURE_TERMS) == 0;
      const uint32_t at = in_header ? random_in(&random, QTR_POLICY_FOUND, QTR_POLICY_HEADER_BYTES - 1)
                                    : random_in(&random, policy.at[SECTION_TERMS], policy.at[SECTION_RECORDS] - 1);
      if (at < (uint32_t)size) torn[at] = (uint8_t)random_below(&random, 256);
    }
    table_seal(torn, (uint32_t)size);
    qtr_policy forged;
    if (qtr_policy_open(&forged, torn, (uint32_t)size) == QTR_ERR_SELFTEST) {
      qtr_store32(torn + QTR_POLICY_DIGEST, qtr_policy_digest(&forged));
      table_seal(torn, (uint32_t)size);
    }
    if (qtr_policy_open(&policy, torn, (uint32_t)size) != QTR_OK) continue;
    qtr_policy_check(&policy);
    search_forged(&random);
  }
}

/* A later look that is said to be at another place than its cell is: a robot opens it, and tells looks by cells. */
static void test_look_forged_to_be_at_another_place_is_made_in_its_cell(void) {
  unsigned played = 0;
  for (unsigned seed = 1; seed <= 200; seed++) {
    make_table(seed, TERMS_LOOKS);
    test_random random = random_case("forged looks", seed);
    if (policy.board.terms.look_of == NULL || mission.places < 2) continue;
    uint8_t *look = bytes + (policy.board.terms.look_of - bytes) + 2 * mission.places;
    qtr_store16(look, (qtr_load16(look) + 1) % mission.places);
    table_seal(bytes, (uint32_t)size);
    qtr_store32(bytes + QTR_POLICY_DIGEST, qtr_policy_open(&policy, bytes, (uint32_t)size) == QTR_ERR_SELFTEST
                                               ? qtr_policy_digest(&policy)
                                               : qtr_load32(bytes + QTR_POLICY_DIGEST));
    table_seal(bytes, (uint32_t)size);
    if (qtr_policy_open(&policy, bytes, (uint32_t)size) != QTR_OK) continue;
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_ERR_TRAVEL, qtr_policy_check(&policy), case_note);
    for (unsigned tries = 0; tries < 10; tries++, played++) search_forged(&random);
  }
  TEST_ASSERT_GREATER_THAN(100, played);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_robots_play_the_game_that_was_learnt);
  RUN_TEST(test_figure_is_the_certificates);
  RUN_TEST(test_looks_lie_in_their_places_cells);
  RUN_TEST(test_nothing_is_announced_that_was_not_looked_at_often_enough);
  RUN_TEST(test_table_cut_short_or_flipped_is_refused);
  RUN_TEST(test_forged_terms_are_refused_or_played_to_an_end);
  RUN_TEST(test_look_forged_to_be_at_another_place_is_made_in_its_cell);
  return UNITY_END();
}
