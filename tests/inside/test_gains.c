/* What a walk with memory can collect, against an enumeration of all walks that visit no place twice: never less, and
 * the same where all is remembered. */
#include <math.h>
#include <string.h>

#include "quarter/game.h"
#include "search/gains.h"
#include "support/learning.h"
#include "support/missions.h"
#include "support/random.h"
#include "unity.h"

#define PLACES_MOST 6u

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_gains gains;
static double block[QTR_GAINS_BYTES(1) / sizeof(double) + 1];
static double price[QTR_MAX_PLACES];
static double charge[PLACES_MOST * PLACES_MOST];

void setUp(void) {
}

void tearDown(void) {
}

/* Half of the games with several looks at some places. */
static void begin(test_random *random, unsigned columns, unsigned rows) {
  const bool again = random_chance(random, 50);
  mission_random(&mission, random, (mission_size){columns, rows, again ? PLACES_MOST / 2 : PLACES_MOST, 2});
  if (again) mission_look_again(&mission, random, PLACES_MOST);
  mission.aim.kind = random_chance(random, 50) ? QTR_TIME : QTR_DISCOUNTED;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  qtr_gains_init(&gains, block, ground);
  for (unsigned i = 0; i < PLACES_MOST * PLACES_MOST; i++) charge[i] = 0.0;
  for (unsigned place = 0; place < game.board.places; place++)
    price[place] = mission.aim.kind == QTR_TIME ? 4.0 * random_unit(random) - 12.0 : 4.0 * random_unit(random);
}

static bool is_remembered_all(void) {
  for (unsigned look = 0; look < gains.looks.count; look++) {
    unsigned known = gains.near.count[look];
    for (unsigned other = 0; other < gains.looks.count; other++)
      known += qtr_looks_first(&gains.looks, other) == qtr_looks_first(&gains.looks, look);
    if (known < gains.looks.count) return false;
  }
  return true;
}

/* Whether a walk that has been to some places goes back if it goes to another one. */
static bool goes_back(unsigned been, unsigned place) {
  for (unsigned other = 0; other < game.board.places; other++)
    if ((been >> other & 1u) != 0 && qtr_looks_is_before(&gains.looks, place, other)) return true;
  return false;
}

/* The most that a walk collects from a node on that goes to no place of `been`. */
static double enumerate(unsigned node, qtr_steps when, unsigned been) {
  double best = 0.0;
  for (unsigned place = 0; place < game.board.places; place++) {
    if ((been >> place & 1u) != 0 || goes_back(been, place)) continue;
    const qtr_steps way = qtr_board_steps(&game.board, 0, node, place);
    if (way == QTR_NEVER) continue;
    const double on = qtr_game_worth(&game, place, when + way) - price[place] +
                      enumerate(place, when + way, been | 1u << place) -
                      (node < game.board.places ? charge[node * game.board.places + place] : 0.0);
    if (on > best) best = on;
  }
  return best;
}

static double walk_of(unsigned seeker) {
  int visits[QTR_MAX_PLACES] = {0};
  return qtr_gains_walk(&gains, seeker, visits);
}

static double truth_of(unsigned seeker) {
  return enumerate((unsigned)game.board.places + game.board.start_of[seeker], 0, 0);
}

/* Slots reach far beyond any walk of so few places. */
static qtr_steps far_enough(void) {
  return PLACES_MOST * (game.board.keys.longest + 1);
}

static void test_walks_that_remember_all_are_those_that_repeat_nothing(void) {
  unsigned looser = 0, exact = 0;
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("walks", number);
    begin(&random, 8, 6);
    qtr_gains_cut(&gains, far_enough());
    double before = HUGE_VAL;
    do {
      TEST_ASSERT_TRUE(qtr_gains_fill(&gains, price));
      const double most = walk_of(0);
      /* More memory is never worth more. */
      TEST_ASSERT_TRUE_MESSAGE(most <= before + 1e-9, case_note);
      TEST_ASSERT_TRUE_MESSAGE(most >= truth_of(0) - 1e-9, case_note);
      before = most;
      looser += most > truth_of(0) + 1e-6;
    } while (qtr_gains_remember_more(&gains));
    if (!is_remembered_all() || gains.slot_steps > 1) continue;
    exact++;
    TEST_ASSERT_TRUE_MESSAGE(fabs(before - truth_of(0)) < 1e-9, case_note);
  }
  TEST_ASSERT_GREATER_THAN(10, looser);
  TEST_ASSERT_GREATER_THAN(200, exact);
}

/* In any slot, of any memory, from any place. */
static void test_gains_are_no_less_than_any_walk_on(void) {
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("gains", number);
    begin(&random, 7, 5);
    qtr_gains_cut(&gains, far_enough());
    while (random_chance(&random, 60) && qtr_gains_remember_more(&gains)) {}
    TEST_ASSERT_TRUE(qtr_gains_fill(&gains, price));
    for (unsigned n = 0; n < 200; n++) {
      const unsigned place = random_below(&random, game.board.places);
      const unsigned been = random_below(&random, 1u << game.board.places) & ~(1u << place);
      const qtr_steps when = random_below(&random, 3 * game.board.keys.longest + 1);
      qtr_places set, none;
      qtr_places_clear(&set);
      qtr_places_clear(&none);
      for (unsigned other = 0; other < game.board.places; other++)
        if (been >> other & 1u) qtr_places_add(&set, other);
      const qtr_memory memory = qtr_near_of(&gains.near, place, &set, &none);
      const double truth =
          qtr_game_worth(&game, place, when) - price[place] + enumerate(place, when, been | 1u << place);
      TEST_ASSERT_TRUE_MESSAGE(qtr_gains_at(&gains, 0, place, memory, when) >= truth - 1e-9, case_note);
    }
  }
}

static void test_moves_that_are_charged_are_not_free(void) {
  unsigned dearer = 0, exact = 0;
  for (unsigned number = 0; number < random_cases(200); number++) {
    test_random random = random_case("charges", number);
    begin(&random, 9, 7);
    qtr_gains_cut(&gains, far_enough());
    while (qtr_gains_remember_more(&gains)) {}
    TEST_ASSERT_TRUE(qtr_gains_fill(&gains, price));
    const double before = walk_of(0);
    for (unsigned i = 0; i < (unsigned)game.board.places * game.board.places; i++)
      charge[i] = random_chance(&random, 50) ? 4.0 * random_unit(&random) : 0.0;
    qtr_gains_charge(&gains, charge);
    TEST_ASSERT_TRUE(qtr_gains_fill(&gains, price));
    TEST_ASSERT_TRUE_MESSAGE(walk_of(0) >= truth_of(0) - 1e-9, case_note);
    dearer += truth_of(0) < before - 1e-6;
    if (is_remembered_all() && gains.slot_steps == 1) {
      exact++;
      TEST_ASSERT_TRUE_MESSAGE(fabs(walk_of(0) - truth_of(0)) < 1e-9, case_note);
    }
    qtr_gains_charge(&gains, NULL);
    TEST_ASSERT_TRUE(qtr_gains_fill(&gains, price));
    TEST_ASSERT_TRUE_MESSAGE(walk_of(0) == before, case_note);
  }
  TEST_ASSERT_GREATER_THAN(random_cases(20), dearer);
  TEST_ASSERT_GREATER_THAN(random_cases(100), exact);
}

static void begin_long_ways(test_random *random) {
  begin(random, 8, 6);
  for (unsigned cell = 0; cell < (unsigned)mission.columns * mission.rows; cell++)
    if (mission.cost[cell] > 0) mission.cost[cell] = (uint8_t)random_in(random, 100, 255);
  if (mission.aim.kind == QTR_DISCOUNTED) mission.aim.gamma = 0.9999;
  for (unsigned place = 0; place < game.board.places; place++)
    if (mission.aim.kind == QTR_TIME) price[place] = -2000.0 * random_unit(random);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  qtr_gains_init(&gains, block, ground);
  qtr_gains_cut(&gains, far_enough());
}

/* Long ways: a slot is of many steps, and what is on the line between two of them is still above the truth, by
 * little. */
static void test_lines_between_slots_are_above_the_truth_and_near_it(void) {
  unsigned coarse = 0;
  double loose = 0.0;
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("long ways", number);
    begin_long_ways(&random);
    while (qtr_gains_remember_more(&gains)) {}
    TEST_ASSERT_TRUE(qtr_gains_fill(&gains, price));
    const double most = walk_of(0);
    const double truth = truth_of(0);
    TEST_ASSERT_TRUE_MESSAGE(most >= truth - 1e-9 * fabs(truth), case_note);
    coarse += gains.slot_steps > 1;
    if (!is_remembered_all() || truth <= 0.0) continue;
    if ((most - truth) / truth > loose) loose = (most - truth) / truth;
  }
  TEST_ASSERT_GREATER_THAN(20, coarse);
  TEST_ASSERT_TRUE(loose < 0.01);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_walks_that_remember_all_are_those_that_repeat_nothing);
  RUN_TEST(test_gains_are_no_less_than_any_walk_on);
  RUN_TEST(test_moves_that_are_charged_are_not_free);
  RUN_TEST(test_lines_between_slots_are_above_the_truth_and_near_it);
  return UNITY_END();
}
