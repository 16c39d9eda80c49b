/* A mission as large as the host holds, nearly: 1,000 places and 32 robots, learnt for as long as so many askings of
 * the watch take, put into a table, opened, and played by robots' own code. And the vicinity that it is searched by. */
#include <stdlib.h>
#include <string.h>

#include "quarter/learn.h"
#include "search/play.h"
#include "search/vicinity.h"
#include "support/scattered.h"
#include "unity.h"

enum { PLACES = 1000, ROBOTS = 32, SIDE = 120, ASKINGS = 20000 };

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_vicinity vicinity;

void setUp(void) {
}

void tearDown(void) {
}

static unsigned left;

static bool ask(void *context) {
  (void)context;
  return left > 0 && left-- > 0;
}

static void *take(size_t bytes) {
  void *block = malloc(bytes);
  TEST_ASSERT_NOT_NULL(block);
  return block;
}

static void make(unsigned places, unsigned robots) {
  scattered_make(&mission, &game, &travel, 7, SIDE, places, robots, QTR_TIME);
}

/* ---- the whole way ---- */

static qtr_learner *learn(void **work, void **table, void **ground_block) {
  const size_t words = (size_t)1 << 20;
  const size_t ground_bytes = qtr_environment_bytes(&game, NULL);
  qtr_environment *ground;
  qtr_learner *learner;
  qtr_learner_config config;
  *work = take(qtr_learner_bytes(&game));
  *table = take(words * sizeof(uint32_t));
  *ground_block = take(ground_bytes);
  qtr_learner_config_default(&config);
  const qtr_learner_blocks blocks = {*work, qtr_learner_bytes(&game), *table, words, NULL, 0};
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_environment_init(&ground, *ground_block, ground_bytes, &game, NULL, &travel));
  left = ASKINGS;
  mission.watch.go_on = ask;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_learner_init(&learner, &blocks, ground, NULL, &config));
  while (left > 0) qtr_learner_step(learner);
  return learner;
}

/* Robots come to the very choices that were learnt, all by the table. */
static void expect_best_game(const qtr_policy *policy, const qtr_play *best) {
  static qtr_division division;
  qtr_deployment deployment;
  unsigned visits = 0;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, policy, NULL, NULL));
  qtr_division_begin(&division, policy, &deployment);
  while (qtr_division_play(&division, policy)) {}
  TEST_ASSERT_EQUAL_UINT32(0, division.off_table);
  TEST_ASSERT_EQUAL_UINT(PLACES, division.moves);
  for (unsigned i = 0; i < best->choices; i++) {
    if (best->choice[i] == QTR_STAND_DOWN) continue;
    TEST_ASSERT_EQUAL_UINT16(best->choice[i], division.place[visits]);
    TEST_ASSERT_EQUAL_UINT8(best->seeker[i], division.seeker[visits]);
    visits++;
  }
  TEST_ASSERT_EQUAL_UINT(PLACES, visits);
}

static void test_a_thousand_places_are_learnt_and_played_by_their_table(void) {
  static qtr_play by_rate;
  void *work, *table, *ground;
  qtr_certificate certificate;
  qtr_policy policy;
  make(PLACES, ROBOTS);
  qtr_play_by_rate(&by_rate, &game);
  qtr_learner *learner = learn(&work, &table, &ground);
  qtr_learner_certificate(learner, &certificate);
  TEST_ASSERT_TRUE(certificate.expected_time < 0.97 * by_rate.score.expected_time);
  TEST_ASSERT_TRUE(certificate.bound > 0.0 && certificate.bound <= certificate.expected_time);
  const int32_t size = qtr_export_size(learner);
  uint8_t *bytes = take((size_t)size);
  TEST_ASSERT_EQUAL_INT32(size, qtr_export(learner, bytes, (uint32_t)size));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, bytes, (uint32_t)size));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_check(&policy));
  expect_best_game(&policy, qtr_learner_best(learner));
  free(bytes);
  free(ground);
  free(table);
  free(work);
}

/* ---- keys ---- */

static void test_a_key_tells_a_thousand_places_apart(void) {
  static qtr_key keys[PLACES + 1];
  qtr_joint joint;
  make(PLACES, ROBOTS);
  const unsigned words = game.board.keys.words;
  TEST_ASSERT_GREATER_OR_EQUAL(PLACES / 32 + ROBOTS * 10 / 32, words);
  for (unsigned place = 0; place <= PLACES; place++) {
    qtr_joint_start(&joint, &game.board, NULL, NULL);
    if (place < PLACES) qtr_places_add(&joint.visited, place);
    qtr_joint_key(&keys[place], &joint, &game.board.keys);
    for (unsigned other = 0; other < place; other++)
      TEST_ASSERT_NOT_EQUAL(0, memcmp(keys[place].word, keys[other].word, words * sizeof(uint32_t)));
  }
}

/* ---- vicinity ---- */

static uint32_t around(unsigned place, unsigned other) {
  return qtr_board_steps(&game.board, 0, place, other) + qtr_board_steps(&game.board, 0, other, place);
}

static void test_vicinity_is_who_is_nearest(void) {
  make(200, 2);
  qtr_vicinity_init(&vicinity, &game);
  TEST_ASSERT_TRUE(qtr_vicinity_in_use(&vicinity));
  for (unsigned place = 0; place < 200; place++) {
    const uint32_t farthest = around(place, vicinity.near[place][QTR_VICINITY - 1]);
    unsigned nearer = 0, no_farther = 0;
    for (unsigned other = 0; other < 200; other++) {
      nearer += other != place && around(place, other) < farthest;
      no_farther += other != place && around(place, other) <= farthest;
    }
    TEST_ASSERT_LESS_THAN(QTR_VICINITY, nearer);
    TEST_ASSERT_GREATER_OR_EQUAL(QTR_VICINITY, no_farther);
    for (unsigned i = 0; i < QTR_VICINITY; i++) {
      const unsigned other = vicinity.near[place][i];
      TEST_ASSERT_TRUE(other != place && around(place, other) <= farthest);
      TEST_ASSERT_TRUE(qtr_vicinity_has(&vicinity, place, other) && qtr_vicinity_has(&vicinity, other, place));
      if (i > 0) TEST_ASSERT_TRUE(around(place, vicinity.near[place][i - 1]) <= around(place, other));
    }
  }
}

static void test_small_games_are_searched_whole(void) {
  make(QTR_SEARCHED_WHOLE, 2);
  qtr_vicinity_init(&vicinity, &game);
  TEST_ASSERT_FALSE(qtr_vicinity_in_use(&vicinity));
  TEST_ASSERT_TRUE(qtr_vicinity_has(&vicinity, 0, 1));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_thousand_places_are_learnt_and_played_by_their_table);
  RUN_TEST(test_a_key_tells_a_thousand_places_apart);
  RUN_TEST(test_vicinity_is_who_is_nearest);
  RUN_TEST(test_small_games_are_searched_whole);
  return UNITY_END();
}
