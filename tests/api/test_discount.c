/* profiles: host mcu */
/* Discounts from 0.1 to 0.999999 over ways of 1 to a million steps: what the arithmetic cannot tell apart is refused or
 * said, never called equal. Exact values come from going through all plays. */
#include <math.h>

#include "quarter/learner.h"
#include "quarter/status.h"
#include "support/brute.h"
#include "support/learning.h"
#include "support/random.h"
#include "unity.h"

enum { LONGEST = QTR_MAX_CELLS < 4000 ? QTR_MAX_CELLS : 4000 };

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_learner *learner;
static qtr_learner_config config;
static qtr_certificate certificate;
static brute_game brute;

void setUp(void) {
  qtr_learner_config_default(&config);
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* A corridor of cells that take `cost` steps each. */
static void draw_corridor(unsigned cells, unsigned cost) {
  qtr_mission_default(&mission);
  mission.columns = (uint16_t)cells;
  mission.rows = 1;
  for (unsigned cell = 0; cell < cells; cell++) mission.cost[cell] = (uint8_t)cost;
}

static void put_place(qtr_cell cell, double weight) {
  mission.weight[mission.places] = weight;
  mission.place[mission.places++] = cell;
}

static bool is_taken_by_a_place(qtr_cell cell) {
  for (unsigned place = 0; place < mission.places; place++)
    if (mission.place[place] == cell) return true;
  return false;
}

static long corridor_way(qtr_cell a, qtr_cell b) {
  return (long)mission.cost[0] * labs((long)a - (long)b);
}

/* Ways by subtraction: a flood would take too long here. */
static void set_up_brute(void) {
  double sum = 0.0;
  brute = (brute_game){.places = mission.places,
                       .seekers = mission.seekers,
                       .time = mission.aim.kind == QTR_TIME,
                       .gamma = mission.aim.gamma};
  for (int p = 0; p < brute.places; p++) sum += mission.weight[p];
  for (int p = 0; p < brute.places; p++) {
    brute.probability[p] = mission.weight[p] / sum;
    for (int q = 0; q < brute.places; q++) brute.way[q][p] = corridor_way(mission.place[q], mission.place[p]);
    for (int i = 0; i < brute.seekers; i++)
      brute.way[brute.places + i][p] = corridor_way(mission.start[i], mission.place[p]);
  }
  for (int i = 0; i < brute.seekers; i++) brute.start[i] = brute.places + i;
}

static long nearest_way(void) {
  long nearest = LONG_MAX;
  for (int i = 0; i < brute.seekers; i++)
    for (int p = 0; p < brute.places; p++)
      if (brute.way[brute.places + i][p] < nearest) nearest = brute.way[brute.places + i][p];
  return nearest;
}

static int begin(void) {
  int status = qtr_mission_check(&mission, NULL);
  if (status == QTR_OK) status = qtr_game_init(&game, &mission, &travel, NULL);
  if (status == QTR_OK) status = ground_init(&ground, &game, &travel);
  return status == QTR_OK ? learner_init(&learner, ground, NULL, &config) : status;
}

static enum qtr_learning learn(void) {
  enum qtr_learning state;
  while ((state = qtr_learner_step(learner)) == QTR_LEARNING) {}
  qtr_learner_certificate(learner, &certificate);
  return state;
}

static void draw_case(test_random *random) {
  static const double gammas[] = {0.1, 0.3, 0.5, 0.9, 0.95, 0.99, 0.999, 0.9999, 0.99999, 0.999999};
  const unsigned cells = random_in(random, 6, (unsigned)exp(log(6.0) + random_unit(random) * log(LONGEST / 6.0)));
  draw_corridor(cells, random_chance(random, 50) ? 1 : random_in(random, 1, 255));
  const unsigned places = random_in(random, 1, 5);
  while (mission.places < places) {
    const qtr_cell cell = (qtr_cell)random_below(random, cells);
    if (!is_taken_by_a_place(cell)) put_place(cell, random_in(random, 1, 9));
  }
  mission.seekers = (uint8_t)random_in(random, 1, 2);
  for (unsigned i = 0; i < mission.seekers; i++)
    mission.start[i] = random_chance(random, 40) ? 0 : (qtr_cell)random_below(random, cells);
  mission.aim.gamma = gammas[random_below(random, 10)];
}

static void expect_true_certificate(void) {
  const double optimum = brute_optimum(&brute);
  TEST_ASSERT_TRUE_MESSAGE(certificate.bound >= optimum * (1.0 - 1e-9), case_note);
  TEST_ASSERT_TRUE_MESSAGE(certificate.objective <= optimum * (1.0 + 1e-9), case_note);
  TEST_ASSERT_TRUE_MESSAGE(certificate.objective >= optimum * (1.0 - 2e-5), case_note);
  if (certificate.gap < QTR_NEGLIGIBLE)
    TEST_ASSERT_TRUE_MESSAGE(certificate.objective >= optimum * (1.0 - 2e-9), case_note);
}

static void test_every_discount_and_distance_is_certified_truly_or_refused(void) {
  unsigned refused = 0;
  unsigned certified = 0;
  unsigned negligible = 0;
  for (unsigned number = 0; number < 400; number++) {
    test_random random = random_case("discounts", number);
    draw_case(&random);
    set_up_brute();
    const long nearest = nearest_way();
    const bool lost = nearest > 1 && pow(mission.aim.gamma, (double)(nearest - 1)) < QTR_OBJECTIVE_LEAST_POWER;
    const int status = begin();
    TEST_ASSERT_EQUAL_INT_MESSAGE(lost ? QTR_ERR_DISCOUNT : QTR_OK, status, case_note);
    refused += lost;
    if (lost) continue;
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_CERTIFIED, learn(), case_note);
    expect_true_certificate();
    certified++;
    negligible += certificate.negligible_places > 0;
  }
  TEST_ASSERT_GREATER_THAN(30, refused);
  TEST_ASSERT_GREATER_THAN(100, certified);
  TEST_ASSERT_GREATER_THAN(30, negligible);
}

static void test_expected_time_is_never_refused(void) {
  draw_corridor(LONGEST, 255);
  put_place(LONGEST - 1, 1);
  put_place(LONGEST / 2, 2);
  mission.seekers = 1;
  mission.aim.gamma = 0.1;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_DISCOUNT, begin());
  mission.aim.kind = QTR_TIME;
  TEST_ASSERT_EQUAL_INT(QTR_OK, begin());
  TEST_ASSERT_EQUAL_INT(QTR_CERTIFIED, learn());
  TEST_ASSERT_EQUAL_UINT16(0, certificate.negligible_places);
}

static void test_refusal_names_the_nearest_place(void) {
  int culprit = -1;
  draw_corridor(1000, 1);
  put_place(999, 5);
  put_place(200, 1);
  put_place(500, 1);
  mission.seekers = 1;
  mission.aim.gamma = 0.5;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_DISCOUNT, qtr_game_init(&game, &mission, &travel, &culprit));
  TEST_ASSERT_EQUAL_INT(1, culprit);
}

/* One place next door and the others so far off that no sum of doubles notices them: their order still is the one that
 * takes least time, and the certificate says that it does not cover it. */
static void test_what_is_discounted_away_goes_by_expected_time_and_is_said(void) {
  draw_corridor(1000, 3);
  put_place(1, 1);
  for (unsigned place = 0; place < 5; place++) put_place((qtr_cell)(500 + 110 * place), place + 2);
  mission.start[0] = mission.start[1] = 0;
  mission.seekers = 2;
  mission.aim.gamma = 0.5;
  TEST_ASSERT_EQUAL_INT(QTR_OK, begin());
  TEST_ASSERT_EQUAL_INT(QTR_CERTIFIED, learn());
  TEST_ASSERT_EQUAL_UINT16(5, certificate.negligible_places);
  const double found = certificate.expected_time;
  mission.aim.kind = QTR_TIME;
  TEST_ASSERT_EQUAL_INT(QTR_OK, begin());
  TEST_ASSERT_EQUAL_INT(QTR_CERTIFIED, learn());
  TEST_ASSERT_DOUBLE_WITHIN(1e-9 * found, certificate.expected_time, found);
}

static void test_hardly_likely_place_is_counted_as_negligible_under_either_objective(void) {
  for (uint8_t objective = 0; objective < 2; objective++) {
    draw_corridor(20, 1);
    put_place(3, 1.0);
    put_place(17, 1e-13);
    mission.start[0] = 10;
    mission.seekers = 1;
    mission.aim.kind = objective;
    TEST_ASSERT_EQUAL_INT(QTR_OK, begin());
    TEST_ASSERT_EQUAL_INT(QTR_CERTIFIED, learn());
    TEST_ASSERT_EQUAL_UINT16(1, certificate.negligible_places);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_discount_and_distance_is_certified_truly_or_refused);
  RUN_TEST(test_expected_time_is_never_refused);
  RUN_TEST(test_refusal_names_the_nearest_place);
  RUN_TEST(test_what_is_discounted_away_goes_by_expected_time_and_is_said);
  RUN_TEST(test_hardly_likely_place_is_counted_as_negligible_under_either_objective);
  return UNITY_END();
}
