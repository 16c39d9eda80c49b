/* The best game out of the routes within the gap, against an enumeration of games, and against episodes where there are
 * too many. */
#include <math.h>
#include <string.h>

#include "learn/learner.h"
#include "search/selection.h"
#include "support/brute.h"
#include "support/learnt.h"
#include "support/missions.h"
#include "support/random.h"
#include "support/scattered.h"
#include "unity.h"

#define POOL_BYTES (32u << 20)
#define NEAR 1e-9

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_bound bound;
static double gains[QTR_GAINS_BYTES(1) / sizeof(double) + 1];
static qtr_pool pool;
static qtr_duals duals;
static const qtr_basis no_basis;
static qtr_selection selection;
static uint64_t block[POOL_BYTES / 8];
static qtr_routes routes;
static qtr_play best, play;
static brute_game brute;
static unsigned triples, branches;

void setUp(void) {
  triples = branches = 0;
  learning_by_episodes = false;
}

void tearDown(void) {
}

/* Prices tuned for so many steps, and shaken where that is asked for. */
static void begin(test_random *random, unsigned steps, double shaken) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  qtr_play_by_rate(&best, &game);
  qtr_bound_init(&bound, gains, ground, best.visit);
  while (steps-- > 0 && qtr_bound_improve(&bound, best.score.worth)) {}
  for (unsigned place = 0; place < game.board.places; place++)
    bound.price[place] += shaken * fabs(bound.price[place]) * (random_unit(random) - 0.5);
  bound.filling = 0; /* C is of other prices */
  qtr_bound_settle(&bound);
}

/* What is better by less than that is no better. */
static double target(void) {
  return best.score.worth + 0.1 * NEAR * fabs(best.score.worth);
}

static void list(void) {
  enum qtr_listing status;
  double least[QTR_MAX_SEEKERS];
  qtr_pool_init(&pool, block, sizeof block, &bound);
  qtr_pool_duals(&pool, &duals);
  const double gap = qtr_pool_upper(&pool, &duals) - target();
  for (unsigned squad = 0; squad < pool.squads; squad++) least[squad] = duals.squad[squad] - gap;
  qtr_pool_begin(&pool, &duals, least);
  do status = qtr_pool_go_on(&pool, 1000);
  while (status == QTR_LISTING);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_LISTED, status, case_note);
}

static void take_game(void) {
  qtr_selection_routes(&selection, &routes);
  qtr_play_routes(&play, &game, &routes);
  if (play.score.worth > best.score.worth) best = play;
  qtr_selection_raise(&selection, target());
}

/* Choose to the end; at no time is the bound below the optimum. */
static void choose(double optimum) {
  const size_t used = qtr_pool_bytes(&pool, pool.labels);
  const double slack = NEAR * fmax(1.0, fabs(optimum));
  enum qtr_selecting status;
  TEST_ASSERT_TRUE(qtr_selection_begin(&selection, &pool, (uint8_t *)block + used, sizeof block - used, &duals,
                                       &no_basis, target()));
  do {
    status = qtr_selection_go_on(&selection);
    if (status == QTR_SELECTION_GAME) take_game();
    TEST_ASSERT_TRUE_MESSAGE(selection.upper >= optimum - slack, case_note);
    triples += selection.master.triples > 0;
    branches += selection.depth > 0;
  } while (status == QTR_SELECTING || status == QTR_SELECTION_GAME);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_SELECTED, status, case_note);
  TEST_ASSERT_TRUE_MESSAGE(fabs(best.score.worth - optimum) <= slack, case_note);
}

static void test_game_chosen_is_the_best_of_all(void) {
  for (unsigned number = 0; number < random_cases(300); number++) {
    test_random random = random_case("small games", number);
    mission_random(&mission, &random, (mission_size){9, 7, 5, 3});
    mission.rule = QTR_RULE_FREE;
    brute_set_up(&brute, &mission);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
    begin(&random, random_below(&random, 10), random_unit(&random));
    list();
    choose(brute_optimum(&brute));
  }
}

static void test_mixtures_are_taken_apart_by_triples_and_branches(void) {
  for (unsigned number = 0; number < random_cases(24); number++) {
    test_random random = random_case("larger games", number);
    scattered_make(&mission, &game, &travel, number + 1, 24, 14, 4, number % 2 ? QTR_TIME : QTR_DISCOUNTED);
    for (unsigned place = 0; place < mission.places; place++) mission.weight[place] = random_in(&random, 4, 6);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
    begin(&random, 200, 0.05);
    list();
    choose(learnt_optimum(ground));
  }
  TEST_ASSERT_GREATER_THAN(0, triples);
  TEST_ASSERT_GREATER_THAN(0, branches);
}

static void test_block_that_is_too_small_is_told(void) {
  test_random random = random_case("small block", 1);
  mission_random(&mission, &random, (mission_size){9, 7, 5, 2});
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL));
  begin(&random, 1, 0.0);
  list();
  TEST_ASSERT_FALSE(qtr_selection_begin(&selection, &pool, block, 1000, &duals, &no_basis, best.score.worth));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_game_chosen_is_the_best_of_all);
  RUN_TEST(test_mixtures_are_taken_apart_by_triples_and_branches);
  RUN_TEST(test_block_that_is_too_small_is_told);
  return UNITY_END();
}
