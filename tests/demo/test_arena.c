/* The arena: robots that meet, crowds, signals lost, wheels stuck, and who counts as stopped. */
#include "play.h"

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static int events_of(int kind) {
  int count = 0;
  for (int i = 0; i < play_arena.events; i++) count += play_arena.event[i].kind == kind;
  return count;
}

static double time_of(int kind, int robot) {
  for (int i = 0; i < play_arena.events; i++)
    if (play_arena.event[i].kind == kind && play_arena.event[i].robot == robot) return play_arena.event[i].at;
  return -1.0;
}

/* ---- meeting ---- */

/* Without a plan each goes to the place near it and then to the other's: they meet head-on in the middle, and pass. */
static void test_two_robots_head_on_in_a_corridor_one_cell_wide_pass(void) {
  play_prepare_drawn("################/#1.S........S.2#/################", 0);
  for (uint64_t seed = 1; seed <= 20; seed++) {
    snprintf(case_note, sizeof case_note, "head-on, seed %llu", (unsigned long long)seed);
    game_setup setup = play_setup(seed);
    setup.strategy = STRATEGY_NEAREST;
    setup.arena.mine = -2;
    play(setup);
    TEST_ASSERT_EQUAL_INT_MESSAGE(2, play_result.scanned, case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(2, play_result.duplicates, case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_result.deadlocks, case_note);
    TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at > 0.0 && play_result.all_stopped_at < 40.0, case_note);
  }
}

static void assert_crowd_clears(int robots, uint64_t seed) {
  snprintf(case_note, sizeof case_note, "%d robots from one start, seed %llu", robots, (unsigned long long)seed);
  game_setup setup = play_setup(seed);
  setup.arena.clear_all = true;
  play(setup);
  TEST_ASSERT_EQUAL_INT_MESSAGE(robots, play_arena.robots, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(play_arena.places, play_result.scanned, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(robots, play_territories_done(), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_result.deadlocks, case_note);
}

static void test_eight_robots_from_one_start_clear_the_ground(void) {
  play_prepare_drawn("1....2....3/.##.....##./5....S....4/.##.....##./1....2....3", 8);
  for (uint64_t seed = 1; seed <= 5; seed++) assert_crowd_clears(8, seed);
}

static void test_sixteen_robots_from_one_start_clear_the_ground(void) {
  play_prepare_drawn("1....2....3/.##.....##./5....S....4/.##.....##./1....2....3", 16);
  for (uint64_t seed = 1; seed <= 2; seed++) assert_crowd_clears(16, seed);
}

static void test_eight_robots_out_of_a_dead_end_one_cell_wide_clear_the_ground(void) {
  play_prepare_drawn("1..2..3..4/........../#####.####/#####S####", 8);
  for (uint64_t seed = 1; seed <= 3; seed++) assert_crowd_clears(8, seed);
}

/* ---- faults ---- */

static void test_with_signals_lost_all_hear_of_the_find_by_and_by(void) {
  const fault_script loss = {1, {{0.0, FAULT_LOSS, -1, 0.9, 0}}};
  play_prepare_drawn("1...S...2/.###.###./3.......4", 4);
  for (uint64_t seed = 1; seed <= 10; seed++) {
    snprintf(case_note, sizeof case_note, "signals lost, seed %llu", (unsigned long long)seed);
    game_setup setup = play_setup(seed);
    setup.arena.faults = &loss;
    play(setup);
    TEST_ASSERT_TRUE_MESSAGE(play_result.found_at >= 0.0 && play_result.all_stopped_at >= play_result.found_at,
                             case_note);
    TEST_ASSERT_GREATER_THAN_MESSAGE(0, play_result.counts.lost, case_note);
  }
}

static void test_the_world_hears_nobody_more_often_than_it_was_spoken_to(void) {
  play_prepare_drawn("1...S...2", 2);
  play(play_setup(1));
  const uint64_t *sent = play_result.counts.sent;
  const uint64_t heard = sent[KIND_POSE] + sent[KIND_SCAN] + sent[KIND_TERMINATE]; /* of two robots, each the other's */
  TEST_ASSERT_LESS_OR_EQUAL_UINT64(heard, play_arena.commands);
  TEST_ASSERT_EQUAL_UINT64(play_result.counts.sent[KIND_POSE], play_result.counts.sent[KIND_SCAN]);
}

static void test_all_robots_lost_find_nothing_and_the_game_ends(void) {
  const fault_script lost = {1, {{1.0, FAULT_LOST, -1, 0.0, 0}}};
  play_prepare_drawn("1...S...2", 2);
  game_setup setup = play_setup(1);
  setup.arena.faults = &lost;
  play(setup);
  TEST_ASSERT_EQUAL_INT(0, play_result.scanned);
  TEST_ASSERT_EQUAL_INT(2, events_of(EVENT_LOST));
  TEST_ASSERT_TRUE(play_result.duration < 5.0);
}

static void test_a_robot_that_is_stuck_goes_on_afterwards(void) {
  const fault_script stuck = {2, {{2.0, FAULT_STUCK, 0, 0.0, 0}, {12.0, FAULT_UNSTUCK, 0, 0.0, 0}}};
  play_prepare_drawn("S........1", 0);
  play(play_setup(1));
  const double free = play_result.found_at;
  game_setup setup = play_setup(1);
  setup.arena.faults = &stuck;
  play(setup);
  TEST_ASSERT_DOUBLE_WITHIN(1.0, free + 10.0, play_result.found_at);
  TEST_ASSERT_DOUBLE_WITHIN(ARENA_TICK, 2.0, time_of(EVENT_STUCK, 0));
  TEST_ASSERT_DOUBLE_WITHIN(ARENA_TICK, 12.0, time_of(EVENT_UNSTUCK, 0));
}

/* ---- who counts as stopped, and as making no way ---- */

static void test_a_robot_that_cannot_move_makes_no_way_and_is_noted_once(void) {
  const fault_script slip = {1, {{0.0, FAULT_STUCK, 0, 0.0, 0}}};
  play_prepare_drawn("S....1", 0);
  game_setup setup = play_setup(1);
  setup.arena.faults = &slip;
  setup.arena.time_limit = 60.0;
  play(setup);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_result.deadlocks, "stuck is a fault, not a deadlock");
  TEST_ASSERT_TRUE(play_result.all_stopped_at < 0.0);
  TEST_ASSERT_DOUBLE_WITHIN(ARENA_TICK, 60.0, play_result.duration);
}

/* Robot 0 is done at once; long after that its wheels are stuck for a second. It still has stopped, of its own will. */
static void test_who_has_stopped_stays_stopped_when_its_wheels_were_stuck(void) {
  const fault_script stuck = {2, {{10.0, FAULT_STUCK, 0, 0.0, 0}, {11.0, FAULT_UNSTUCK, 0, 0.0, 0}}};
  play_prepare_drawn("1S###S~~~~~~~~~~~~~~2", 0);
  game_setup setup = play_setup(1);
  setup.arena.mine = -2;
  setup.arena.faults = &stuck;
  play(setup);
  TEST_ASSERT_EQUAL_INT(2, play_result.scanned);
  TEST_ASSERT_TRUE_MESSAGE(time_of(EVENT_STOPPED, 0) < 10.0 && play_result.duration > 35.0, case_note);
  TEST_ASSERT_EQUAL_INT(0, play_result.deadlocks);
}

static void test_events_are_in_the_order_of_time(void) {
  play_prepare_drawn("1...S...2/.###.###./3.......4", 4);
  game_setup setup = play_setup(2);
  setup.arena.clear_all = true;
  play(setup);
  TEST_ASSERT_EQUAL_INT(3, events_of(EVENT_SCANNED));
  TEST_ASSERT_EQUAL_INT(1, events_of(EVENT_FOUND));
  TEST_ASSERT_EQUAL_INT(4, events_of(EVENT_DONE));
  TEST_ASSERT_EQUAL_INT(4, events_of(EVENT_STOPPED));
  for (int i = 1; i < play_arena.events; i++) TEST_ASSERT_TRUE(play_arena.event[i - 1].at <= play_arena.event[i].at);
}

static void test_mines_are_drawn_by_their_likelihoods(void) {
  play_prepare_drawn("1..S..9", 0);
  int likely = 0;
  for (uint64_t seed = 0; seed < 100; seed++) {
    bus *b;
    static arena a;
    const arena_setup setup = {.seed = seed, .mine = -1, .time_limit = 1.0};
    TEST_ASSERT_EQUAL_INT(0, bus_open(&b, BUS_IN_PROCESS, &play_why));
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, arena_open(&a, &play_plan.t, b, &setup, &play_why), play_why.text);
    likely += play_plan.likelihood[a.mine] > 0.5;
    arena_close(&a);
    bus_close(b);
  }
  TEST_ASSERT_INT_WITHIN(9, 90, likely); /* of 100 with probability 0.9: three standard deviations */
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_two_robots_head_on_in_a_corridor_one_cell_wide_pass);
  RUN_TEST(test_eight_robots_from_one_start_clear_the_ground);
  RUN_TEST(test_sixteen_robots_from_one_start_clear_the_ground);
  RUN_TEST(test_eight_robots_out_of_a_dead_end_one_cell_wide_clear_the_ground);
  RUN_TEST(test_with_signals_lost_all_hear_of_the_find_by_and_by);
  RUN_TEST(test_the_world_hears_nobody_more_often_than_it_was_spoken_to);
  RUN_TEST(test_all_robots_lost_find_nothing_and_the_game_ends);
  RUN_TEST(test_a_robot_that_is_stuck_goes_on_afterwards);
  RUN_TEST(test_a_robot_that_cannot_move_makes_no_way_and_is_noted_once);
  RUN_TEST(test_who_has_stopped_stays_stopped_when_its_wheels_were_stuck);
  RUN_TEST(test_events_are_in_the_order_of_time);
  RUN_TEST(test_mines_are_drawn_by_their_likelihoods);
  plan_free(&play_plan);
  return UNITY_END();
}
