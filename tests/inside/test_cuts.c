/* What walks under some prices say of the bound under others: never more than it is there. */
#include <math.h>
#include <stdio.h>

#include "quarter/game.h"
#include "search/cuts.h"
#include "support/learning.h"
#include "support/missions.h"
#include "support/random.h"
#include "unity.h"

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_gains gains;
static qtr_bundle bundle;
static double block[QTR_GAINS_BYTES(1) / sizeof(double) + 1];

void setUp(void) {
}

void tearDown(void) {
}

/* Up to four seekers; some set out together, some apart. Cells are crossed in a step, or slots were of several and C on
 * lines between walks: a cut that follows one of them is a guess then. */
static void begin(test_random *random) {
  mission_random(&mission, random, (mission_size){9, 8, 8, 4});
  mission.rule = QTR_RULE_FREE;
  for (unsigned cell = 0; cell < qtr_mission_cells(&mission); cell++) mission.cost[cell] = mission.cost[cell] > 0;
  mission.aim.kind = random_chance(random, 50) ? QTR_TIME : QTR_DISCOUNTED;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  qtr_gains_init(&gains, block, ground);
  qtr_gains_cut(&gains, 380);
}

/* Not so low that walks go on past the last slot, where C is no walk's. */
static void draw_prices(test_random *random, double *price) {
  for (unsigned target = 0; target < ground->targets.count; target++)
    price[target] = mission.aim.kind == QTR_TIME ? -2.0 * random_unit(random) : 0.5 + 3.5 * random_unit(random);
}

/* L, and how often the best walks come to each target. */
static double bound_under(const double *price, int *visits) {
  double upper = qtr_objective_left(&game.objective, 1.0);
  TEST_ASSERT_TRUE_MESSAGE(qtr_gains_fill(&gains, price), case_note);
  for (unsigned target = 0; target < ground->targets.count; target++) {
    upper += price[target];
    visits[target] = 0;
  }
  for (unsigned seeker = 0; seeker < game.board.seekers; seeker++) upper += qtr_gains_walk(&gains, seeker, visits);
  return upper;
}

static double said_of(unsigned cut, const double *center, const double *price) {
  double value = bundle.value[cut];
  for (unsigned target = 0; target < ground->targets.count; target++)
    value += bundle.slope[cut][target] * (price[target] - center[target]);
  return value;
}

static void test_cuts_are_never_above_the_bound(void) {
  const double nowhere[QTR_MAX_PLACES] = {0.0};
  unsigned several = 0;
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("cuts", number);
    double center[QTR_MAX_PLACES], price[QTR_MAX_PLACES];
    int visits[QTR_MAX_PLACES];
    begin(&random);
    draw_prices(&random, center);
    qtr_bundle_init(&bundle, ground->targets.count);
    const double upper = bound_under(center, visits);
    qtr_cuts_add(&bundle, &gains, center, nowhere, upper, visits);
    several += bundle.cuts > 1;
    for (unsigned i = 0; i < 10; i++) {
      draw_prices(&random, price);
      const double bound = i > 0 ? bound_under(price, visits) : upper;
      for (unsigned cut = 0; cut < bundle.cuts; cut++)
        TEST_ASSERT_TRUE_MESSAGE(said_of(cut, center, i > 0 ? price : center) <= bound + 1e-9 * (1.0 + fabs(bound)),
                                 case_note);
    }
  }
  TEST_ASSERT_GREATER_THAN(50, several);
}

/* That of the best walks; a step from the center is taken off. */
static void test_a_cut_touches_the_bound(void) {
  for (unsigned number = 0; number < 50; number++) {
    test_random random = random_case("the touch", number);
    double center[QTR_MAX_PLACES], price[QTR_MAX_PLACES], step[QTR_MAX_PLACES];
    int visits[QTR_MAX_PLACES];
    begin(&random);
    draw_prices(&random, center);
    draw_prices(&random, price);
    for (unsigned target = 0; target < ground->targets.count; target++) step[target] = price[target] - center[target];
    qtr_bundle_init(&bundle, ground->targets.count);
    const double upper = bound_under(price, visits);
    qtr_cuts_add(&bundle, &gains, price, step, upper, visits);
    double nearest = HUGE_VAL;
    for (unsigned cut = 0; cut < bundle.cuts; cut++) nearest = fmin(nearest, fabs(said_of(cut, center, price) - upper));
    TEST_ASSERT_TRUE_MESSAGE(nearest <= 1e-9 * (1.0 + fabs(upper)), case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_cuts_are_never_above_the_bound);
  RUN_TEST(test_a_cut_touches_the_bound);
  return UNITY_END();
}
