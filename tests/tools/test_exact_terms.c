/* The exact solver under the field's terms, against games worked out by hand, against an enumeration of all plans, and
 * that against the game played by the rules. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "exact.h"
#include "support/terms_games.h"
#include "support/terms_play.h"
#include "unity.h"

enum { GAMES = 500 }; /* of each feature, and mixed */

static qtr_mission mission;
static qtr_travel travel;
static exact_solution solution;
static fault why;

void setUp(void) {
  memset(&why, 0, sizeof why);
}

void tearDown(void) {
}

static bool is_near(double expected, double actual) {
  return fabs(expected - actual) <= 1e-9 * fmax(1, fabs(expected));
}

static void assert_near(double expected, double actual, const char *note) {
  char text[300];
  snprintf(text, sizeof text, "%s: %.12f expected, %.12f found", note, expected, actual);
  TEST_ASSERT_TRUE_MESSAGE(is_near(expected, actual), text);
}

static void solve(const char *note) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_mission_check(&mission, NULL), note);
  const int status = exact_solve(&solution, &mission, &travel, &why);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, why.text);
}

/* ---- worked out by hand: corridors, one step a cell ---- */

/* Where every place has one look that finds, and a class of its own for each robot. */
static void corridor(const char *rows, int kind) {
  mission_draw(&mission, rows);
  mission.aim.kind = (uint8_t)kind;
  mission.classes = mission.seekers;
  for (int i = 0; i < mission.seekers; i++) mission.class_of[i] = (uint8_t)i;
}

static void expect(double objective, double found) {
  solve("by hand");
  assert_near(objective, solution.objective, "objective");
  assert_near(found, solution.found_probability, "found");
}

static void test_later_looks_count_what_the_earlier_ones_missed(void) {
  corridor("S1", QTR_TIME);
  mission.detection[0] = 0.5;
  mission.looks[0] = 2;
  mission.robot_class[0].scan[0] = 1;
  expect((0.5 * 2 + 0.25 * 3) / 0.75, 0.75);
  TEST_ASSERT_EQUAL_INT(2, solution.length[0]);
  TEST_ASSERT_EQUAL_UINT8(2, solution.look[0][1]);
  mission.aim.kind = QTR_DISCOUNTED;
  expect(10 * (0.5 * 0.99 + 0.25 * 0.99 * 0.99), 0.75);
}

static void test_looks_of_two_robots_are_told_apart_by_time_alone(void) {
  corridor("S1.S", QTR_TIME);
  mission.detection[0] = 0.5;
  mission.looks[0] = 2;
  for (int i = 0; i < 2; i++) mission.robot_class[i].scan[0] = 5;
  expect((0.5 * 6 + 0.25 * 7) / 0.75, 0.75);
  TEST_ASSERT_EQUAL_UINT8(1, solution.look[0][0]);
  TEST_ASSERT_EQUAL_UINT8(2, solution.look[1][0]);
}

static void test_second_look_where_the_first_finds_is_none(void) {
  corridor("S1", QTR_TIME);
  mission.looks[0] = 3;
  mission.robot_class[0].scan[0] = 1;
  mission.aim.home_weight = 1;
  expect(2 + 3, 1);
  TEST_ASSERT_EQUAL_INT(1, solution.length[0]);
}

static void test_classes_differ_in_speed_ground_and_places(void) {
  corridor("S.1...S", QTR_TIME);
  expect(2, 1);
  mission.robot_class[0].cell_steps = 3;
  expect(4, 1);
  mission.robot_class[1].scan[0] = 1;
  expect(5, 1);
  qtr_places_add(&mission.robot_class[1].avoided, 0);
  expect(6, 1);
  mission.robot_class[1].avoided = (qtr_places){{0}};
  mission.cost[1] = 2;
  mission.robot_class[0] = mission.robot_class[1];
  mission.robot_class[0].scan[0] = 0;
  expect(3, 1);
  mission.robot_class[0].smooth_only = true;
  expect(5, 1);
}

static void test_robot_leaves_its_rough_start_and_comes_home_to_it(void) {
  corridor("S.1", QTR_TIME);
  mission.cost[0] = 7;
  mission.robot_class[0].smooth_only = true;
  mission.aim.home_weight = 1;
  expect(2 + (2 + 1 + 7), 1);
}

static void test_robot_goes_when_it_is_ready(void) {
  corridor("S.1...S", QTR_TIME);
  mission.ready[0] = 1;
  expect(3, 1);
  mission.ready[0] = 9;
  expect(4, 1);
}

static void test_what_endurance_leaves_out_counts_as_found_at_its_end(void) {
  corridor("2S.....1", QTR_TIME);
  mission.robot_class[0].endurance = 4;
  expect((2 * 1 + 1 * 4) / 3.0, 2 / 3.0);
  mission.ready[0] = 10; /* it counts from there */
  expect((2 * 11 + 1 * 14) / 3.0, 2 / 3.0);
  mission.robot_class[0].endurance = 14; /* 1, then 7 on, 6 home */
  expect((2 * 11 + 1 * 18) / 3.0, 1);
  mission.aim.kind = QTR_DISCOUNTED;
  mission.robot_class[0].endurance = 13;
  expect(10 * 2 / 3.0 * pow(0.99, 10), 2 / 3.0);
}

static void test_deadline_counts_what_is_found_until_then(void) {
  corridor("1S.2", QTR_DEADLINE);
  mission.aim.deadline = 2;
  expect(2 / 3.0, 2 / 3.0);
  mission.aim.deadline = 4;
  expect(1, 1);
}

/* 2 + 5, and 10 at home: the minimum latency, divided by the places' weights. */
static void test_coming_home_counts_as_much_as_it_weighs(void) {
  corridor("S.1..1", QTR_TIME);
  mission.aim.home_weight = 1;
  expect((2 + 5 + 10) / 2.0, 1);
  mission.aim.home_weight = 0.5;
  expect((2 + 5 + 0.5 * 10) / 2.0, 1);
}

static void test_robot_that_stays_at_home_is_home_when_it_is_ready(void) {
  corridor("S1......S", QTR_TIME);
  mission.aim.home_weight = 1;
  mission.ready[1] = 3;
  expect(1 + 2 + 3, 1);
}

/* ---- refusals ---- */

static void expect_refusal(const char *words) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, exact_solve(&solution, &mission, &travel, &why), words);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, words), why.text);
}

static void test_what_cannot_be_played_or_solved_is_refused(void) {
  corridor("S1......S", QTR_OBJECTIVES);
  expect_refusal("objective");
  corridor("S1......S", QTR_DEADLINE);
  expect_refusal("by the deadline");
  mission.rule = QTR_RULE_PAPER;
  expect_refusal("--rule free");
  corridor("S1......S", QTR_TIME);
  mission.robot_class[0].endurance = 5;
  expect_refusal("all robots have endurance or none");
  mission.robot_class[1].endurance = 5;
  mission.robot_class[0].endurance = 1;
  expect_refusal("within its endurance");
  corridor("S1......S", QTR_TIME);
  for (int i = 0; i < 2; i++) qtr_places_add(&mission.robot_class[i].avoided, 0);
  expect_refusal("no seeker can reach place 0");
  corridor("S1......S", QTR_TIME);
  mission.detection[0] = 0.5;
  mission.looks[0] = 11;
  expect_refusal("10 looks");
}

static void test_travel_times_alone_do_not_tell_the_terms(void) {
  static const qtr_steps steps[4] = {1, 0};
  corridor("S1", QTR_TIME);
  TEST_ASSERT_EQUAL_INT(0, exact_solve_plain(&solution, &mission, steps, &why));
  mission.ready[0] = 1;
  TEST_ASSERT_EQUAL_INT(-1, exact_solve_plain(&solution, &mission, steps, &why));
}

/* ---- random games ---- */

/* The routes are a plan that the rules allow, with the looks numbered by time, and worth what the solver says. */
static void check_routes(void) {
  static terms_ways ways;
  terms_plan plan = {.length = {0}};
  unsigned numbers[TERMS_MOST_LOOKS] = {0};
  terms_measure(&ways, &mission);
  for (int i = 0; i < mission.seekers; i++) {
    long now = (long)mission.ready[i];
    int node = mission.places;
    for (int v = 0; v < solution.length[i]; v++) {
      const int place = solution.route[i][v];
      now = terms_arrival(&ways, i, node, now, place);
      TEST_ASSERT_EQUAL_INT_MESSAGE(now, solution.step[i][v], case_note);
      TEST_ASSERT_EQUAL_INT_MESSAGE(0, numbers[place] >> solution.look[i][v] & 1u, case_note);
      numbers[place] |= 1u << solution.look[i][v];
      plan.look[i][plan.length[i]++] = (terms_look){node = place, now};
    }
  }
  const double worth = terms_worth(&ways, &plan);
  assert_near(mission.aim.kind == QTR_TIME ? -worth : worth, solution.objective, case_note);
}

static void compare(unsigned seed, unsigned features) {
  terms_game_make(&mission, seed, features);
  solve(case_note);
  assert_near(brute_force_value(&mission), solution.objective, case_note);
  check_routes();
}

static void test_equals_enumeration_with_each_feature(void) {
  for (int feature = 0; feature < TERMS_FEATURES; feature++)
    for (unsigned seed = 1; seed <= GAMES; seed++) compare(seed, 1u << feature);
}

static void test_equals_enumeration_with_features_mixed(void) {
  for (unsigned seed = 1; seed <= GAMES; seed++) compare(seed, terms_mix(seed));
}

static void test_terms_at_their_defaults_are_the_plain_game(void) {
  for (unsigned seed = 1; seed <= GAMES; seed++) compare(seed, 0);
}

/* ---- the rules of play ---- */

static void compare_play(unsigned seed, unsigned features, bool always_leave) {
  static terms_game game;
  terms_game_make(&mission, seed, features);
  terms_set_up(&game, &mission);
  game.always_leave = always_leave;
  assert_near(brute_force_value(&mission), terms_play_value(&game), case_note);
}

/* Copies for looks, one chooser after another, and nobody standing down who alone can search a place. */
static void test_rules_of_play_cost_nothing(void) {
  for (unsigned seed = 1; seed <= GAMES; seed++) {
    for (int feature = 0; feature < TERMS_FEATURES; feature++) compare_play(seed, 1u << feature, false);
    compare_play(seed, terms_mix(seed), false);
    compare_play(seed, terms_mix(seed), true);
    compare_play(seed, (terms_mix(seed) | TERMS_HOME | TERMS_CLASSES) & ~(unsigned)TERMS_DEADLINE, false);
    compare_play(seed, (terms_mix(seed) | TERMS_HOME | TERMS_ENDURANCE) & ~(unsigned)TERMS_DEADLINE, false);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_later_looks_count_what_the_earlier_ones_missed);
  RUN_TEST(test_looks_of_two_robots_are_told_apart_by_time_alone);
  RUN_TEST(test_second_look_where_the_first_finds_is_none);
  RUN_TEST(test_classes_differ_in_speed_ground_and_places);
  RUN_TEST(test_robot_leaves_its_rough_start_and_comes_home_to_it);
  RUN_TEST(test_robot_goes_when_it_is_ready);
  RUN_TEST(test_what_endurance_leaves_out_counts_as_found_at_its_end);
  RUN_TEST(test_deadline_counts_what_is_found_until_then);
  RUN_TEST(test_coming_home_counts_as_much_as_it_weighs);
  RUN_TEST(test_robot_that_stays_at_home_is_home_when_it_is_ready);
  RUN_TEST(test_what_cannot_be_played_or_solved_is_refused);
  RUN_TEST(test_travel_times_alone_do_not_tell_the_terms);
  RUN_TEST(test_equals_enumeration_with_each_feature);
  RUN_TEST(test_equals_enumeration_with_features_mixed);
  RUN_TEST(test_terms_at_their_defaults_are_the_plain_game);
  RUN_TEST(test_rules_of_play_cost_nothing);
  return UNITY_END();
}
