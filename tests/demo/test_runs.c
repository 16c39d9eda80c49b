/* Many games in figures: the same as those games one by one, and robots without a plan to compare with. */
#include "baselines.h"
#include "play.h"
#include "runs.h"

enum { GAMES = 12, FIRST_SEED = 20 };

static runs_figures f;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  play_prepare_drawn("1...S...2/.###.###./3.......4", 3);
}

void tearDown(void) {
  runs_free(&f);
  memset(&f, 0, sizeof f);
}

static void play_games(game_setup setup, bool lose_one) {
  const int status = runs_play(&f, &play_plan, &setup, GAMES, lose_one, NULL, true, &play_why);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, play_why.text);
  TEST_ASSERT_EQUAL_INT(GAMES, f.games);
}

static void test_figures_are_those_of_the_single_games(void) {
  double sum = 0.0, planned = 0.0, simulated = 0.0;
  int scanned = 0;
  play_games(play_setup(FIRST_SEED), false);
  for (int i = 0; i < GAMES; i++) {
    play(play_setup(FIRST_SEED + (uint64_t)i));
    sum += play_result.found_at;
    planned += play_plan.step[play_result.mine]; /* a step is a second */
    simulated += play_result.duration;
    scanned += play_result.scanned;
  }
  TEST_ASSERT_EQUAL_INT(GAMES, f.found);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, sum / GAMES, f.mean);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, planned / GAMES, f.planned_mean);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, simulated, f.simulated);
  TEST_ASSERT_EQUAL_UINT64(scanned, f.scanned);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, play_plan.expected_step, f.expected);
}

static void test_times_rise_and_quantiles_are_among_them(void) {
  play_games(play_setup(FIRST_SEED), false);
  for (int i = 1; i < f.found; i++) TEST_ASSERT_TRUE(f.found_at[i - 1] <= f.found_at[i]);
  TEST_ASSERT_EQUAL_DOUBLE(f.found_at[0], runs_quantile(&f, 0.0));
  TEST_ASSERT_EQUAL_DOUBLE(f.found_at[6], runs_quantile(&f, 0.5));
  TEST_ASSERT_EQUAL_DOUBLE(f.found_at[GAMES - 1], runs_quantile(&f, 1.0));
}

static void test_with_one_robot_lost_it_is_found_all_the_same(void) {
  play_games(play_setup(FIRST_SEED), true);
  TEST_ASSERT_EQUAL_INT(GAMES, f.found);
}

static void test_without_a_mine_nothing_is_found_and_every_place_is_visited(void) {
  game_setup setup = play_setup(FIRST_SEED);
  setup.arena.mine = -2;
  play_games(setup, false);
  TEST_ASSERT_EQUAL_INT(0, f.found);
  TEST_ASSERT_DOUBLE_IS_NAN(runs_quantile(&f, 0.5));
  TEST_ASSERT_DOUBLE_IS_NAN(f.mean);
  TEST_ASSERT_DOUBLE_IS_NAN(f.planned_mean);
  for (int place = 0; place < 4; place++) TEST_ASSERT_GREATER_OR_EQUAL_UINT64(GAMES, f.visits[place]);
}

/* ---- robots without a plan ---- */

/* They hear of finds, but not of what another has scanned: each scans all. */
static void test_blind_robots_scan_everything_each(void) {
  game_setup setup = play_setup(1);
  setup.strategy = STRATEGY_NEAREST;
  setup.arena.mine = -2;
  play(setup);
  TEST_ASSERT_EQUAL_INT_MESSAGE(4, play_result.scanned, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(2 * 4, play_result.duplicates, case_note);
}

static void test_informed_robots_scan_everything_once(void) {
  game_setup setup = play_setup(1);
  setup.strategy = STRATEGY_INFORMED;
  setup.arena.mine = -2;
  play(setup);
  TEST_ASSERT_EQUAL_INT_MESSAGE(4, play_result.scanned, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_result.duplicates, case_note);
}

static void test_a_blind_robot_goes_to_the_nearest_place_then_to_the_nearest_from_there(void) {
  static baseline b;
  play_prepare_drawn("2....S.1..3", 0); /* places 0, 1, 2 at 5, 2 and 5 steps; from place 1 they are at 7 and 3 */
  baseline_init(&b, &play_plan.t.policy, 0, NULL);
  const robot_pilot pilot = baseline_pilot(&b);
  TEST_ASSERT_EQUAL_INT(1, pilot.target(pilot.self));
  pilot.visited(pilot.self, 1);
  TEST_ASSERT_EQUAL_INT(2, pilot.target(pilot.self));
  pilot.visited(pilot.self, 2);
  TEST_ASSERT_EQUAL_INT(0, pilot.target(pilot.self));
  pilot.visited(pilot.self, 0);
  TEST_ASSERT_EQUAL_INT(QTR_STAND_DOWN, pilot.target(pilot.self));
}

static void test_a_find_stops_a_robot_without_a_plan(void) {
  static baseline b;
  qtr_signal signal = {0, 0, QTR_SIGNAL_TERRITORY_DONE, 0};
  baseline_init(&b, &play_plan.t.policy, 0, NULL);
  const robot_pilot pilot = baseline_pilot(&b);
  pilot.hear(pilot.self, &signal);
  TEST_ASSERT_NOT_EQUAL_INT(QTR_STAND_DOWN, pilot.target(pilot.self));
  signal.kind = QTR_SIGNAL_FOUND;
  pilot.hear(pilot.self, &signal);
  TEST_ASSERT_EQUAL_INT(QTR_STAND_DOWN, pilot.target(pilot.self));
  TEST_ASSERT_FALSE(pilot.announce(pilot.self, &signal));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_figures_are_those_of_the_single_games);
  RUN_TEST(test_times_rise_and_quantiles_are_among_them);
  RUN_TEST(test_with_one_robot_lost_it_is_found_all_the_same);
  RUN_TEST(test_without_a_mine_nothing_is_found_and_every_place_is_visited);
  RUN_TEST(test_blind_robots_scan_everything_each);
  RUN_TEST(test_informed_robots_scan_everything_once);
  RUN_TEST(test_a_blind_robot_goes_to_the_nearest_place_then_to_the_nearest_from_there);
  RUN_TEST(test_a_find_stops_a_robot_without_a_plan);
  plan_free(&play_plan);
  return UNITY_END();
}
