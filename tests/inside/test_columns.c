/* Prices of routes: at no time is their bound below the optimum, and in the end all better games are among the routes
 * that they list; against an enumeration of games, and against episodes where there are too many. */
#include <math.h>
#include <string.h>

#include "learn/learner.h"
#include "search/columns.h"
#include "search/selection.h"
#include "support/brute.h"
#include "support/learnt.h"
#include "support/missions.h"
#include "support/random.h"
#include "support/scattered.h"
#include "unity.h"

#define POOL_BYTES (24u << 20)
#define ROOM_BYTES (8u << 20)
#define PLACES_MOST 16u
#define NEAR 1e-9

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_bound bound;
static double gains[QTR_GAINS_BYTES(1) / sizeof(double) + 1];
static qtr_pool pool;
static qtr_columns columns;
static qtr_selection selection;
static uint64_t pool_block[POOL_BYTES / 8];
static uint64_t room_block[ROOM_BYTES / 8];
static double charge[PLACES_MOST * PLACES_MOST];
static qtr_routes routes;
static qtr_play best, play;
static brute_game brute;
static unsigned triples, proofs;

void setUp(void) {
  triples = proofs = 0;
  learning_by_episodes = false;
}

void tearDown(void) {
}

static double target(void) {
  return best.score.worth + 0.1 * NEAR * fabs(best.score.worth);
}

/* Prices tuned for so many steps, and shaken. */
static void begin(test_random *random, unsigned steps, double shaken, uint32_t labels) {
  const qtr_columns_room room = {charge, room_block, sizeof room_block, labels};
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  qtr_play_by_rate(&best, &game);
  qtr_bound_init(&bound, gains, ground, best.visit);
  while (steps-- > 0 && qtr_bound_improve(&bound, best.score.worth)) {}
  for (unsigned place = 0; place < game.board.places; place++)
    bound.price[place] += shaken * fabs(bound.price[place]) * (random_unit(random) - 0.5);
  bound.filling = 0; /* C is of other prices */
  qtr_bound_settle(&bound);
  qtr_pool_init(&pool, pool_block, sizeof pool_block, &bound);
  qtr_columns_begin(&columns, &bound, &pool, &room, target());
}

/* Until no triples are left to be added, or for so many rounds of them. */
static void price(double optimum, unsigned rounds) {
  const double slack = NEAR * fmax(1.0, fabs(optimum));
  double before = columns.upper;
  enum qtr_pricing status = QTR_PRICING;
  while (status != QTR_PRICING_STUCK && rounds > 0) {
    status = qtr_columns_go_on(&columns);
    rounds -= status == QTR_PRICED;
    TEST_ASSERT_TRUE_MESSAGE(columns.upper >= optimum - slack, case_note);
    TEST_ASSERT_TRUE_MESSAGE(columns.upper <= before, case_note);
    proofs += columns.upper < before;
    triples += columns.center.triples > 0;
    before = columns.upper;
    if (columns.upper <= optimum + slack) return;
  }
}

static void take_game(void) {
  qtr_selection_routes(&selection, &routes);
  qtr_play_routes(&play, &game, &routes);
  if (play.score.worth > best.score.worth) best = play;
  qtr_selection_raise(&selection, target());
}

/* The best game is among the routes within what is left of the gap. */
static void choose(double optimum) {
  enum qtr_selecting status;
  TEST_ASSERT_TRUE(qtr_columns_settle(&columns));
  pool.labels_most = pool.labels_room;
  qtr_columns_list(&columns, columns.upper - target());
  while (qtr_pool_go_on(&pool, 1000) == QTR_LISTING) {}
  const size_t used = qtr_pool_bytes(&pool, pool.labels);
  TEST_ASSERT_TRUE(qtr_selection_begin(&selection, &pool, (uint8_t *)pool_block + used, sizeof pool_block - used,
                                       &columns.center, &columns.basis, target()));
  do {
    status = qtr_selection_go_on(&selection);
    if (status == QTR_SELECTION_GAME) take_game();
  } while (status == QTR_SELECTING || status == QTR_SELECTION_GAME);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_SELECTED, status, case_note);
  TEST_ASSERT_TRUE_MESSAGE(fabs(best.score.worth - optimum) <= NEAR * fmax(1.0, fabs(optimum)), case_note);
}

static void test_bound_is_never_below_the_optimum_of_small_games(void) {
  for (unsigned number = 0; number < random_cases(200); number++) {
    test_random random = random_case("small games", number);
    mission_random(&mission, &random, (mission_size){9, 7, 5, 3});
    mission.rule = QTR_RULE_FREE;
    brute_set_up(&brute, &mission);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
    const double optimum = brute_optimum(&brute);
    begin(&random, random_below(&random, 10), random_unit(&random), random_in(&random, 64, 512));
    price(optimum, random_in(&random, 1, 4));
    choose(optimum);
  }
  TEST_ASSERT_GREATER_THAN(random_cases(100), proofs);
}

static void test_triples_bring_the_bound_down_to_a_list_that_holds_the_optimum(void) {
  for (unsigned number = 0; number < random_cases(24); number++) {
    test_random random = random_case("larger games", number);
    scattered_make(&mission, &game, &travel, number + 1, 24, 14, 3, number % 2 ? QTR_TIME : QTR_DISCOUNTED);
    for (unsigned place = 0; place < mission.places; place++) mission.weight[place] = random_in(&random, 4, 6);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
    const double optimum = learnt_optimum(ground);
    begin(&random, 20, 0.05, 1u << random_in(&random, 11, 15));
    price(optimum, 4);
    choose(optimum);
  }
  TEST_ASSERT_GREATER_THAN(0, triples);
}

/* What is begun anew is the bound's own. */
static void test_bound_is_as_it_was_when_it_is_settled(void) {
  test_random random = random_case("settled", 1);
  scattered_make(&mission, &game, &travel, 3, 24, 14, 3, QTR_TIME);
  int visits[QTR_MAX_PLACES] = {0};
  begin(&random, 20, 0.0, 1u << 15);
  const double before = qtr_gains_walk(&bound.gains, 0, visits);
  price(-HUGE_VAL, 3);
  qtr_gains_charge(&bound.gains, NULL);
  qtr_bound_settle(&bound);
  TEST_ASSERT_TRUE(qtr_gains_walk(&bound.gains, 0, visits) == before);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_bound_is_never_below_the_optimum_of_small_games);
  RUN_TEST(test_triples_bring_the_bound_down_to_a_list_that_holds_the_optimum);
  RUN_TEST(test_bound_is_as_it_was_when_it_is_settled);
  return UNITY_END();
}
