/* The best game out of the routes within the gap by sets of places, against an enumeration of games. */
#include <math.h>
#include <string.h>

#include "search/deal.h"
#include "support/brute.h"
#include "support/learning.h"
#include "support/missions.h"
#include "support/random.h"
#include "unity.h"

#define POOL_BYTES (8u << 20)
#define NEAR 1e-12

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_bound bound;
static double gains[QTR_GAINS_BYTES(1) / sizeof(double) + 1];
static qtr_pool pool;
static qtr_duals duals;
static uint64_t block[POOL_BYTES / 8];
static qtr_routes routes;
static qtr_play play;
static brute_game brute;

void setUp(void) {
}

void tearDown(void) {
}

static void begin(test_random *random, unsigned places) {
  mission_random(&mission, random, (mission_size){9, 7, places, 3});
  mission.rule = QTR_RULE_FREE;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  qtr_play_by_rate(&play, &game);
  qtr_bound_init(&bound, gains, ground, play.visit);
  for (unsigned steps = random_below(random, 10); steps > 0 && qtr_bound_improve(&bound, play.score.worth); steps--) {}
  TEST_ASSERT_TRUE_MESSAGE(qtr_bound_settle(&bound), case_note);
}

/* All routes of games that are worth more than `target`. */
static void list(double target) {
  double least[QTR_MAX_SEEKERS];
  qtr_pool_init(&pool, block, sizeof block / 2, &bound);
  qtr_pool_duals(&pool, &duals);
  const double gap = qtr_pool_upper(&pool, &duals) - target;
  for (unsigned squad = 0; squad < pool.squads; squad++) least[squad] = duals.squad[squad] - gap;
  qtr_pool_begin(&pool, &duals, least);
  while (qtr_pool_go_on(&pool, 1000) == QTR_LISTING) {}
}

static bool deal(void) {
  uint8_t *left = (uint8_t *)block + sizeof block / 2;
  const bool dealt = qtr_deal(&pool, left, &routes);
  const uint8_t *past = left + qtr_deal_bytes(&pool);
  TEST_ASSERT_TRUE(past <= (uint8_t *)block + sizeof block);
  return dealt;
}

static void test_game_dealt_is_the_best_of_all(void) {
  for (unsigned number = 0; number < random_cases(400); number++) {
    test_random random = random_case("games", number);
    begin(&random, 5);
    brute_set_up(&brute, &mission);
    const double optimum = brute_optimum(&brute);
    const double slack = NEAR * fmax(1.0, fabs(optimum));
    list(optimum - 1e-6 * fmax(1.0, fabs(optimum)));
    TEST_ASSERT_TRUE_MESSAGE(deal(), case_note);
    qtr_play_routes(&play, &game, &routes);
    TEST_ASSERT_TRUE_MESSAGE(fabs(play.score.worth - optimum) <= slack, case_note);
  }
}

static void test_no_game_is_dealt_where_none_is_better(void) {
  unsigned none = 0;
  for (unsigned number = 0; number < random_cases(200); number++) {
    test_random random = random_case("no better", number);
    begin(&random, 5);
    brute_set_up(&brute, &mission);
    const double optimum = brute_optimum(&brute);
    list(optimum + 1e-6 * fmax(1.0, fabs(optimum)));
    if (!deal()) {
      none++;
      continue;
    }
    qtr_play_routes(&play, &game, &routes);
    TEST_ASSERT_TRUE_MESSAGE(play.score.worth <= optimum + NEAR * fmax(1.0, fabs(optimum)), case_note);
  }
  TEST_ASSERT_GREATER_THAN(0, none);
}

/* As many places as can be: each of them once, and no worse than by rate. */
static void test_all_places_are_dealt(void) {
  for (unsigned number = 0; number < random_cases(50); number++) {
    test_random random = random_case("all", number);
    begin(&random, QTR_DEALT_MOST);
    list(-HUGE_VAL);
    TEST_ASSERT_TRUE_MESSAGE(deal(), case_note);
    unsigned visited = 0;
    for (unsigned seeker = 0; seeker < game.board.seekers; seeker++) visited += routes.length[seeker];
    TEST_ASSERT_EQUAL_UINT_MESSAGE(mission.places, visited, case_note);
    const double before = play.score.worth;
    qtr_play_routes(&play, &game, &routes);
    TEST_ASSERT_TRUE_MESSAGE(play.score.worth >= before - NEAR * fabs(before), case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_game_dealt_is_the_best_of_all);
  RUN_TEST(test_no_game_is_dealt_where_none_is_better);
  RUN_TEST(test_all_places_are_dealt);
  return UNITY_END();
}
