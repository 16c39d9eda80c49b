/* profiles: host mcu */
/* The mission as a game: travel times, rewards and their backup by hand (Eq. 4.7), and rewards that add up to the score
 * whatever is played. */
#include <math.h>
#include <string.h>

#include "quarter/game.h"
#include "support/missions.h"
#include "support/random.h"
#include "unity.h"

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_state state;
static qtr_outcome outcome;

void setUp(void) {
  memset(&game, 0xA5, sizeof game);
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void set_up(void) {
  int culprit;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_mission_check(&mission, &culprit), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, &culprit), case_note);
  qtr_game_start(&game, &state);
}

static void near(double expected, double actual) {
  TEST_ASSERT_TRUE_MESSAGE(fabs(expected - actual) <= 1e-12 * fmax(1.0, fabs(expected)), case_note);
}

/* ---- set-up ---- */

static void test_weights_become_probabilities(void) {
  mission_draw(&mission, "1S.5/..2.");
  set_up();
  near(0.125, game.probability[0]);
  near(0.625, game.probability[1]);
  near(0.25, game.probability[2]);
}

static void test_seekers_on_one_cell_share_a_start(void) {
  mission_draw(&mission, "S.1.S.S");
  mission.start[2] = mission.start[0];
  set_up();
  TEST_ASSERT_EQUAL(2, game.board.starts);
  TEST_ASSERT_EQUAL(0, game.board.start_of[0]);
  TEST_ASSERT_EQUAL(1, game.board.start_of[1]);
  TEST_ASSERT_EQUAL(0, game.board.start_of[2]);
  TEST_ASSERT_EQUAL_UINT32(2, qtr_board_steps(&game.board, 0, 1, 0));
  TEST_ASSERT_EQUAL_UINT32(2, qtr_board_steps(&game.board, 0, 2, 0));
}

static void test_travel_times_are_those_of_the_map(void) {
  static long steps[QTR_MAX_CELLS];
  for (unsigned number = 0; number < 100; number++) {
    test_random random = random_case("travel", number);
    mission_random(&mission, &random, (mission_size){12, 12, 6, 3});
    set_up();
    for (unsigned node = 0; node < (unsigned)mission.places + game.board.starts; node++) {
      const unsigned start = node - mission.places;
      flood(steps, &mission, node < mission.places ? mission.place[node] : mission.start[game.first_at[start]]);
      for (unsigned place = 0; place < mission.places; place++) {
        const long way = steps[mission.place[place]];
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(way < 0 ? QTR_NEVER : (qtr_steps)way,
                                         qtr_board_steps(&game.board, 0, node, place), case_note);
      }
    }
  }
}

static void test_place_out_of_everyones_reach_is_named(void) {
  int culprit = -1;
  mission_draw(&mission, "1S.#3#S2");
  TEST_ASSERT_EQUAL_INT(QTR_ERR_UNREACHABLE, qtr_game_init(&game, &mission, &travel, &culprit));
  TEST_ASSERT_EQUAL_INT(1, culprit);
  TEST_ASSERT_FALSE(qtr_game_reachable(&game, 1));
  TEST_ASSERT_TRUE(qtr_game_reachable(&game, 0));
  TEST_ASSERT_TRUE(qtr_game_reachable(&game, 2));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_UNREACHABLE, qtr_game_init(&game, &mission, &travel, NULL));
}

/* ---- rewards by hand ---- */

static void test_worth_of_a_visit(void) {
  mission_draw(&mission, "1S.3");
  set_up();
  near(10.0 * 0.25, qtr_game_worth(&game, 0, 0));
  near(10.0 * 0.25, qtr_game_worth(&game, 0, 1));
  near(10.0 * 0.25 * 0.99, qtr_game_worth(&game, 0, 2));
  near(10.0 * 0.75 * pow(0.99, 99), qtr_game_worth(&game, 1, 100));
  mission.aim.kind = QTR_TIME;
  set_up();
  near(0.0, qtr_game_worth(&game, 0, 0));
  near(-25.0, qtr_game_worth(&game, 0, 100));
}

static void test_score_gives_both_objectives(void) {
  const qtr_steps visit[2] = {3, 2};
  qtr_score score;
  mission_draw(&mission, "1S.3");
  set_up();
  qtr_game_score(&game, visit, 0, &score);
  near(10.0 * (0.25 * 0.99 * 0.99 + 0.75 * 0.99), score.value);
  near(0.25 * 3 + 0.75 * 2, score.expected_time);
  near(score.value, score.worth);
  mission.aim.kind = QTR_TIME;
  set_up();
  qtr_game_score(&game, visit, 0, &score);
  near(-score.expected_time, score.worth);
}

/* One seeker between two places, 2 steps to one and 3 to the other. Going left and then right:
 * Q(left) = gamma^1 R(left) + gamma^2 Q(right), Q(right) = gamma^4 R(right). */
static void test_outcome_is_the_backup_of_one_choice(void) {
  mission_draw(&mission, "1.S..3");
  set_up();
  near(0.0, qtr_game_choose(&game, &state, 0, 0));
  qtr_game_pass(&game, &state, &outcome);
  TEST_ASSERT_EQUAL_UINT32(2, state.joint.now);
  near(0.75, state.unvisited);
  near(0.99 * 2.5, outcome.reward);
  near(0.99 * 0.99, outcome.discount);
  qtr_game_choose(&game, &state, 0, 1);
  qtr_game_pass(&game, &state, &outcome);
  TEST_ASSERT_EQUAL_UINT32(7, state.joint.now);
  near(pow(0.99, 4) * 7.5, outcome.reward);
  near(pow(0.99, 5), outcome.discount);
}

/* The same under expected time: W = tau * unvisited mass + W'. */
static void test_outcome_under_expected_time(void) {
  mission_draw(&mission, "1.S..3");
  mission.aim.kind = QTR_TIME;
  set_up();
  qtr_game_choose(&game, &state, 0, 0);
  qtr_game_pass(&game, &state, &outcome);
  near(-2.0, outcome.reward);
  near(1.0, outcome.discount);
  qtr_game_choose(&game, &state, 0, 1);
  qtr_game_pass(&game, &state, &outcome);
  near(-5.0 * 0.75, outcome.reward);
  near(1.0, outcome.discount);
}

static void test_no_time_passes_while_another_is_to_choose(void) {
  mission_draw(&mission, "1.S..3");
  mission_crew(&mission, 2);
  set_up();
  qtr_game_choose(&game, &state, 0, 0);
  qtr_game_pass(&game, &state, &outcome);
  TEST_ASSERT_EQUAL_UINT32(0, state.joint.now);
  near(0.0, outcome.reward);
  near(1.0, outcome.discount);
}

/* Nobody is to choose any more: both arrivals belong to the one outcome. */
static void test_outcome_runs_on_over_arrivals_without_a_choice(void) {
  mission_draw(&mission, "1.S..3");
  mission_crew(&mission, 2);
  set_up();
  qtr_game_choose(&game, &state, 0, 0);
  qtr_game_pass(&game, &state, &outcome);
  qtr_game_choose(&game, &state, 1, 1);
  qtr_game_pass(&game, &state, &outcome);
  TEST_ASSERT_EQUAL_UINT32(3, state.joint.now);
  near(2.5 * 0.99 + 7.5 * 0.99 * 0.99, outcome.reward);
  near(pow(0.99, 3), outcome.discount);
}

static void test_place_on_the_start_is_rewarded_at_once(void) {
  mission_draw(&mission, "1.S..3");
  mission.start[0] = mission.place[1];
  set_up();
  near(7.5, qtr_game_choose(&game, &state, 0, 1));
  near(0.25, state.unvisited);
  TEST_ASSERT_EQUAL_UINT32(0, state.joint.now);
  mission.aim.kind = QTR_TIME;
  set_up();
  near(0.0, qtr_game_choose(&game, &state, 0, 1));
}

/* ---- powers ---- */

static void test_powers_go_on_beyond_those_kept_ready(void) {
  static const qtr_steps n[] = {0,
                                1,
                                2,
                                100,
                                QTR_OBJECTIVE_POWERS - 1,
                                QTR_OBJECTIVE_POWERS,
                                QTR_OBJECTIVE_POWERS + 1,
                                8191,
                                8192,
                                12287,
                                12288,
                                5 * QTR_OBJECTIVE_POWERS + 3,
                                100000,
                                1000000};
  mission_draw(&mission, "1S");
  mission.aim.gamma = 0.9999;
  set_up();
  for (unsigned i = 0; i < sizeof n / sizeof n[0]; i++) {
    const double expected = pow(0.9999, n[i]);
    TEST_ASSERT_TRUE(fabs(qtr_objective_power(&game.objective, n[i]) / expected - 1.0) < 1e-10);
  }
}

static void test_powers_fall_without_a_break(void) {
  mission_draw(&mission, "1S");
  mission.aim.gamma = 0.9999;
  set_up();
  for (qtr_steps n = 1; n < 5 * QTR_OBJECTIVE_POWERS; n++)
    TEST_ASSERT_TRUE(qtr_objective_power(&game.objective, n) < qtr_objective_power(&game.objective, n - 1));
}

static void test_powers_underflow_to_nothing(void) {
  mission_draw(&mission, "1S");
  mission.aim.gamma = 0.5;
  set_up();
  TEST_ASSERT_TRUE(qtr_objective_power(&game.objective, 4000) == 0.0);
  TEST_ASSERT_TRUE(qtr_objective_power(&game.objective, 4000000000u) == 0.0);
}

/* ---- whatever is played ---- */

static uint16_t choose_at_random(test_random *random, int seeker) {
  qtr_places choices;
  const bool may_stand_down = qtr_joint_choices(&state.joint, &game.board, seeker, &choices);
  unsigned choice = random_below(random, mission.places);
  while (!qtr_places_has(&choices, choice)) choice = (choice + 1) % mission.places;
  return may_stand_down && random_chance(random, 15) ? QTR_STAND_DOWN : (uint16_t)choice;
}

/* The step at which each place is seen to be visited. */
static void note_visits(qtr_steps *visit) {
  for (unsigned place = 0; place < mission.places; place++)
    if (visit[place] == QTR_NEVER && qtr_places_has(&state.joint.visited, place)) visit[place] = state.joint.now;
}

static double mass_left(void) {
  double left = 0.0;
  for (unsigned place = 0; place < mission.places; place++)
    if (!qtr_places_has(&state.joint.visited, place)) left += game.probability[place];
  return left;
}

/* When several arrivals fall into one outcome, `now` is the last one's: those before are found by the joint game. */
static void pass_and_note(qtr_steps *visit) {
  qtr_joint joint = state.joint;
  qtr_steps now = state.joint.now;
  qtr_game_pass(&game, &state, &outcome);
  while (now < state.joint.now) {
    qtr_places arrived;
    qtr_places_clear(&arrived);
    now += qtr_joint_advance(&joint, &game.board, &arrived);
    for (unsigned place = 0; place < mission.places; place++)
      if (qtr_places_has(&arrived, place)) visit[place] = now;
  }
}

static void test_rewards_of_any_play_add_up_to_its_score(void) {
  for (unsigned number = 0; number < 1000; number++) {
    test_random random = random_case("plays", number);
    qtr_steps visit[QTR_MAX_PLACES];
    qtr_score score;
    double earned = 0.0;
    double discount = 1.0;
    int seeker;
    mission_random(&mission, &random, (mission_size){12, 8, 9, 4});
    set_up();
    for (unsigned place = 0; place < QTR_MAX_PLACES; place++) visit[place] = QTR_NEVER;
    while ((seeker = qtr_joint_chooser(&state.joint, &game.board)) != QTR_NOBODY) {
      earned += discount * qtr_game_choose(&game, &state, seeker, choose_at_random(&random, seeker));
      note_visits(visit);
      pass_and_note(visit);
      earned += discount * outcome.reward;
      discount *= outcome.discount;
      TEST_ASSERT_TRUE_MESSAGE(fabs(mass_left() - state.unvisited) < 1e-12, case_note);
    }
    qtr_game_score(&game, visit, 0, &score);
    TEST_ASSERT_TRUE_MESSAGE(fabs(earned - score.worth) <= 1e-9 * fmax(1.0, fabs(score.worth)), case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_weights_become_probabilities);
  RUN_TEST(test_seekers_on_one_cell_share_a_start);
  RUN_TEST(test_travel_times_are_those_of_the_map);
  RUN_TEST(test_place_out_of_everyones_reach_is_named);
  RUN_TEST(test_worth_of_a_visit);
  RUN_TEST(test_score_gives_both_objectives);
  RUN_TEST(test_outcome_is_the_backup_of_one_choice);
  RUN_TEST(test_outcome_under_expected_time);
  RUN_TEST(test_no_time_passes_while_another_is_to_choose);
  RUN_TEST(test_outcome_runs_on_over_arrivals_without_a_choice);
  RUN_TEST(test_place_on_the_start_is_rewarded_at_once);
  RUN_TEST(test_powers_go_on_beyond_those_kept_ready);
  RUN_TEST(test_powers_fall_without_a_break);
  RUN_TEST(test_powers_underflow_to_nothing);
  RUN_TEST(test_rewards_of_any_play_add_up_to_its_score);
  return UNITY_END();
}
