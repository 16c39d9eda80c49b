/* profiles: host mcu */
/* The price bound: never below the truth, in any state of any small game, whatever prices are in force. */
#include <math.h>
#include <string.h>

#include "quarter/game.h"
#include "search/bound.h"
#include "support/brute.h"
#include "support/learning.h"
#include "support/random.h"
#include "unity.h"

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_bound bound;
static double gains[QTR_GAINS_BYTES(1) / sizeof(double) + 1];
static brute_game brute;
static long states_seen;
static double tightest; /* the least slack seen */

void setUp(void) {
  states_seen = 0;
  tightest = HUGE_VAL;
}

void tearDown(void) {
}

static void set_up_game(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_mission_check(&mission, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  brute_set_up(&brute, &mission);
}

/* A game played without a plan, for the bound to start from. */
static void play_at_random(test_random *random, qtr_steps *visit) {
  brute_state state;
  brute_begin(&brute, &state);
  for (bool on = true; on;) {
    const int seeker = brute_chooser(&brute, &state);
    const unsigned before = state.visited;
    if (seeker < 0) {
      brute_pass(&brute, &state, &on);
    } else {
      const unsigned choices = brute_choices(&brute, &state, state.node[seeker]);
      int place = (int)random_below(random, mission.places);
      while (!(choices >> place & 1u)) place = (place + 1) % mission.places;
      brute_choose(&brute, &state, seeker, place);
    }
    for (int place = 0; place < mission.places; place++)
      if ((state.visited & ~before) >> place & 1u) visit[place] = (qtr_steps)state.now;
  }
}

/* ---- every state of a game ---- */

static void joint_of(qtr_joint *joint, double *unvisited, const brute_state *state) {
  memset(joint, 0, sizeof *joint);
  *unvisited = 0.0;
  for (unsigned place = 0; place < mission.places; place++) {
    if (state->visited >> place & 1u) {
      qtr_places_add(&joint->visited, place);
    } else {
      joint->unvisited++;
      *unvisited += game.probability[place];
    }
    if (brute_bound(&brute, state) >> place & 1u) qtr_places_add(&joint->bound, place);
  }
  for (unsigned i = 0; i < mission.seekers; i++) {
    joint->node[i] = state->node[i] == BRUTE_GONE ? QTR_STAND_DOWN : (uint16_t)state->node[i];
    joint->remaining[i] = (qtr_steps)state->left[i];
  }
}

/* The bound in a joint state that is reached at some step. */
static double bound_of(const qtr_joint *joint, qtr_steps now, double unvisited) {
  qtr_situation situation;
  memset(&situation, 0, sizeof situation);
  situation.joint = *joint;
  situation.joint.now = now;
  situation.unvisited = unvisited;
  for (unsigned i = 0; i < mission.seekers; i++) situation.at[i] = joint->node[i];
  return qtr_bound_state(&bound, &situation);
}

static void expect_bound_above(const brute_game *played, const brute_state *after, double best) {
  qtr_joint joint;
  double unvisited;
  (void)played;
  states_seen++;
  if (best == -HUGE_VAL) return; /* places were given up: the core allows no such state */
  joint_of(&joint, &unvisited, after);
  const double from_now = mission.aim.kind == QTR_TIME ? best + (double)after->now * unvisited
                                                       : best / pow(mission.aim.gamma, (double)after->now);
  const double most = bound_of(&joint, (qtr_steps)after->now, unvisited);
  if (isnan(from_now) || isinf(from_now)) return;
  if (most - from_now < tightest) tightest = most - from_now;
  TEST_ASSERT_TRUE_MESSAGE(most >= from_now - 1e-9 * fmax(1.0, fabs(from_now)), case_note);
}

static double look_at_all_states(void) {
  brute.look = expect_bound_above;
  const double optimum = brute_optimum(&brute);
  brute.look = NULL;
  return optimum;
}

static void expect_upper_above(double optimum) {
  TEST_ASSERT_TRUE_MESSAGE(bound.upper >= optimum - 1e-9 * fmax(1.0, fabs(optimum)), case_note);
}

/* With the first prices, some way into the tuning, and at its end. */
static void check_game(test_random *random) {
  qtr_steps visit[QTR_MAX_PLACES] = {0};
  play_at_random(random, visit);
  qtr_bound_init(&bound, gains, ground, visit);
  const double optimum = look_at_all_states();
  expect_upper_above(optimum);
  const unsigned midway = random_below(random, 30);
  bool on = true;
  for (unsigned step = 0; on && step < 2000; step++) {
    const double before = bound.upper;
    on = qtr_bound_improve(&bound, optimum);
    TEST_ASSERT_TRUE_MESSAGE(bound.upper <= before, case_note);
    expect_upper_above(optimum);
    if (step != midway) continue;
    qtr_bound_settle(&bound);
    look_at_all_states();
  }
  TEST_ASSERT_FALSE_MESSAGE(on, case_note);
  qtr_bound_settle(&bound);
  look_at_all_states();
}

static void test_bound_is_never_below_the_optimum_in_any_state(void) {
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("small games", number);
    const bool crowd = random_chance(&random, 50);
    mission_random(&mission, &random, (mission_size){8, 6, crowd ? 4 : 5, crowd ? 3 : 2});
    set_up_game();
    check_game(&random);
  }
  TEST_ASSERT_GREATER_THAN(10000, states_seen);
  /* A bound that is always far above would prove nothing. */
  TEST_ASSERT_TRUE(tightest < 1e-6);
}

/* Corridors so long that time is cut into slots of many steps, or ends before the search does. */
static void test_bound_holds_over_long_times(void) {
  unsigned coarse = 0;
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("corridors", number);
    mission_random(&mission, &random, (mission_size){100, 1, 4, 2});
    const bool neighbours = random_chance(&random, 50);
    for (unsigned cell = 0; cell < mission.columns; cell++)
      mission.cost[cell] = neighbours && random_chance(&random, 30) ? 1 : (uint8_t)random_in(&random, 200, 255);
    mission.aim.gamma = random_chance(&random, 50) ? 0.9999 : 0.99;
    set_up_game();
    check_game(&random);
    coarse += bound.gains.slot_steps > 1;
  }
  TEST_ASSERT_GREATER_THAN(1000, states_seen);
  TEST_ASSERT_GREATER_THAN(5, coarse);
}

static void test_time_past_the_last_slot_is_bounded_too(void) {
  unsigned past = 0;
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("past the slots", number);
    mission_random(&mission, &random, (mission_size){12, 4, 4, 2});
    set_up_game();
    qtr_steps visit[QTR_MAX_PLACES] = {0};
    play_at_random(&random, visit);
    qtr_bound_init(&bound, gains, ground, visit);
    /* Fewer slots than the search takes, as an array too small for it would hold. */
    bound.gains.slots = random_in(&random, 1, bound.gains.slots);
    for (unsigned place = 0; place < mission.places; place++)
      past += visit[place] >= bound.gains.slots * bound.gains.slot_steps;
    bound.filling = 0; /* C is of other slots */
    qtr_bound_settle(&bound);
    look_at_all_states();
  }
  TEST_ASSERT_GREATER_THAN(5, past);
}

/* Any prices will do: of either sign under expected time, not below 0 under discounting. */
static void test_bound_holds_under_arbitrary_prices(void) {
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("prices", number);
    mission_random(&mission, &random, (mission_size){8, 6, 4, 3});
    set_up_game();
    qtr_steps visit[QTR_MAX_PLACES] = {0};
    play_at_random(&random, visit);
    qtr_bound_init(&bound, gains, ground, visit);
    for (unsigned place = 0; place < mission.places; place++)
      bound.price[place] =
          mission.aim.kind == QTR_TIME ? 20.0 * random_unit(&random) - 15.0 : 4.0 * random_unit(&random);
    bound.filling = 0; /* C is of other prices */
    qtr_bound_settle(&bound);
    look_at_all_states();
  }
}

/* ---- by hand ---- */

static void test_one_seeker_and_one_place_are_bounded_exactly(void) {
  qtr_steps visit[QTR_MAX_PLACES] = {3};
  snprintf(case_note, sizeof case_note, "by hand");
  mission_draw(&mission, "S..1");
  set_up_game();
  qtr_bound_init(&bound, gains, ground, visit);
  TEST_ASSERT_TRUE(fabs(bound.upper - 10.0 * 0.99 * 0.99) < 1e-12);
  mission.aim.kind = QTR_TIME;
  set_up_game();
  qtr_bound_init(&bound, gains, ground, visit);
  TEST_ASSERT_TRUE(fabs(bound.upper + 3.0) < 1e-12);
}

/* Two places at distance 2 and 3 on either side, one seeker each: both go at once, and no bound need be above that. */
static void test_prices_settle_on_the_optimum_of_two_seekers_apart(void) {
  qtr_steps visit[QTR_MAX_PLACES] = {2, 3};
  snprintf(case_note, sizeof case_note, "by hand");
  mission_draw(&mission, "S.1......1..S");
  mission.aim.kind = QTR_TIME;
  set_up_game();
  qtr_bound_init(&bound, gains, ground, visit);
  while (qtr_bound_improve(&bound, -2.5)) {}
  TEST_ASSERT_TRUE(fabs(bound.upper + 2.5) < 1e-6);
}

static void test_visits_under_way_are_counted_to_the_step(void) {
  qtr_steps visit[QTR_MAX_PLACES] = {3, 4};
  qtr_joint joint;
  snprintf(case_note, sizeof case_note, "by hand");
  mission_draw(&mission, "1...S...3");
  mission_crew(&mission, 2);
  set_up_game();
  qtr_bound_init(&bound, gains, ground, visit);
  qtr_joint_start(&joint, &game.board, NULL, NULL);
  qtr_joint_choose(&joint, &game.board, 0, 0);
  qtr_joint_choose(&joint, &game.board, 1, 1);
  TEST_ASSERT_TRUE(fabs(bound_of(&joint, 0, 1.0) - 10.0 * pow(0.99, 3)) < 1e-12);
  /* The same 7 steps into the game: what is to come is worth as much, counted from then. */
  TEST_ASSERT_TRUE(fabs(bound_of(&joint, 7, 1.0) - 10.0 * pow(0.99, 3)) < 1e-9);
  mission.aim.kind = QTR_TIME;
  set_up_game();
  qtr_bound_init(&bound, gains, ground, visit);
  TEST_ASSERT_TRUE(fabs(bound_of(&joint, 7, 1.0) + 4.0) < 1e-9);
}

static void test_worth_that_underflows_is_still_a_number(void) {
  qtr_steps visit[QTR_MAX_PLACES] = {0};
  qtr_joint joint;
  snprintf(case_note, sizeof case_note, "by hand");
  mission_draw(&mission, "S1....1....1");
  mission.aim.gamma = 0.5;
  set_up_game();
  visit[0] = 1;
  visit[1] = 6;
  visit[2] = 11;
  qtr_bound_init(&bound, gains, ground, visit);
  qtr_joint_start(&joint, &game.board, NULL, NULL);
  qtr_joint_choose(&joint, &game.board, 0, 0);
  const double most = bound_of(&joint, 5000, 1.0);
  TEST_ASSERT_TRUE_MESSAGE(most >= 10.0 / 3.0, "not a bound where gamma^t is 0");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_bound_is_never_below_the_optimum_in_any_state);
  RUN_TEST(test_bound_holds_over_long_times);
  RUN_TEST(test_time_past_the_last_slot_is_bounded_too);
  RUN_TEST(test_bound_holds_under_arbitrary_prices);
  RUN_TEST(test_one_seeker_and_one_place_are_bounded_exactly);
  RUN_TEST(test_prices_settle_on_the_optimum_of_two_seekers_apart);
  RUN_TEST(test_visits_under_way_are_counted_to_the_step);
  RUN_TEST(test_worth_that_underflows_is_still_a_number);
  return UNITY_END();
}
