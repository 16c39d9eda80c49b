/* What a world makes of robots that go away, and of strangers who say that they are robots. */
#include "play.h"
#include "quarter/seeker.h"

static bus *b;
static arena a;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  play_prepare_drawn("1.S..../....S.2", 0);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, bus_open(&b, BUS_IN_PROCESS, &play_why), play_why.text);
}

void tearDown(void) {
  arena_close(&a);
  bus_close(b);
}

static void open_arena(const fault_script *faults) {
  const arena_setup setup = {1, false, -2, faults, 1e6, 3, NULL};
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, arena_open(&a, &play_plan.t, b, &setup, &play_why), play_why.text);
}

static void command(int robot, double speed) {
  bus_send_command(b, &(message_command){.robot = robot, .left = speed, .right = speed});
}

static void advance(double seconds) {
  for (const double end = a.now + seconds; a.now < end - 1e-9;) {
    bus_drain(b);
    arena_advance(&a);
  }
}

static void test_a_game_whose_robots_all_fell_silent_is_abandoned_and_not_stopped(void) {
  open_arena(NULL);
  for (int robot = 0; robot < 2; robot++) command(robot, 1.0);
  advance(ARENA_SILENCE - 1.0);
  TEST_ASSERT_FALSE(arena_over(&a));
  advance(2.0);
  TEST_ASSERT_EQUAL_INT(2, arena_silent(&a));
  TEST_ASSERT_TRUE(arena_abandoned(&a));
  TEST_ASSERT_TRUE(arena_over(&a));
  TEST_ASSERT_TRUE(arena_all_stopped_at(&a) < 0.0);
}

static void test_a_game_that_one_robot_plays_to_the_end_is_not_abandoned(void) {
  open_arena(NULL);
  for (int robot = 0; robot < 2; robot++) command(robot, 1.0);
  for (int second = 0; second < 12; second++) {
    command(0, second < 11 ? 1.0 : 0.0);
    advance(1.0);
  }
  command(0, 0.0);
  advance(2.0);
  TEST_ASSERT_EQUAL_INT(1, arena_silent(&a));
  TEST_ASSERT_FALSE(arena_abandoned(&a));
  TEST_ASSERT_TRUE(arena_over(&a));
  TEST_ASSERT_TRUE(arena_all_stopped_at(&a) > 10.0);
}

/* They are lost as the script says: that game was played to its end, but nobody stopped. */
static void test_a_game_whose_robots_are_all_lost_by_the_script_is_over_and_not_abandoned(void) {
  const fault_script faults = {2, {{1.0, FAULT_LOST, 0, 0.0, 0}, {2.0, FAULT_LOST, 1, 0.0, 0}}};
  open_arena(&faults);
  for (int robot = 0; robot < 2; robot++) command(robot, 1.0);
  advance(1.5);
  TEST_ASSERT_FALSE(arena_over(&a));
  advance(1.0);
  TEST_ASSERT_TRUE(arena_over(&a));
  TEST_ASSERT_FALSE(arena_abandoned(&a));
  TEST_ASSERT_TRUE(arena_all_stopped_at(&a) < 0.0);
}

static void send(int sender, int territory, uint32_t identity, uint32_t run) {
  bus_send_terminate(b, &(message_terminate){0, sender, QTR_SIGNAL_TERRITORY_DONE, territory, identity, run});
}

static void test_a_stranger_announces_no_territory(void) {
  open_arena(NULL);
  for (int sender = 2; sender < DEMO_MOST_ROBOTS; sender++) send(sender, 0, a.identity, 3);
  for (int territory = 2; territory < DEMO_MOST_ROBOTS; territory++) send(1, territory, a.identity, 3);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(0, a.events);
  send(1, 0, a.identity, 3);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(1, a.events);
}

static void test_a_robot_of_another_table_or_run_is_known_and_not_believed(void) {
  open_arena(NULL);
  send(7, 0, a.identity + 1, 3); /* of somebody else's game */
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(-1, a.stranger);
  send(1, 0, a.identity + 1, 3);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(1, a.stranger);
  send(0, 0, a.identity, 2);
  bus_drain(b);
  TEST_ASSERT_EQUAL_INT(0, a.stranger);
  TEST_ASSERT_EQUAL_INT(0, a.events);
}

/* A robot that stops and drives on again and again. */
static void test_more_events_than_are_kept_are_left_out_and_the_last_one_says_so(void) {
  open_arena(NULL);
  for (int times = 0; times < ARENA_EVENTS + 100; times++) {
    for (int robot = 0; robot < 2; robot++) command(robot, 0.0);
    advance(0.6);
    for (int robot = 0; robot < 2; robot++) command(robot, 0.1);
    advance(ARENA_TICK);
  }
  TEST_ASSERT_EQUAL_INT(ARENA_EVENTS, a.events);
  TEST_ASSERT_EQUAL_INT(EVENT_STOPPED, a.event[ARENA_EVENTS - 2].kind);
  TEST_ASSERT_EQUAL_INT(EVENT_MORE, a.event[ARENA_EVENTS - 1].kind);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_game_whose_robots_all_fell_silent_is_abandoned_and_not_stopped);
  RUN_TEST(test_a_game_that_one_robot_plays_to_the_end_is_not_abandoned);
  RUN_TEST(test_a_game_whose_robots_are_all_lost_by_the_script_is_over_and_not_abandoned);
  RUN_TEST(test_a_stranger_announces_no_territory);
  RUN_TEST(test_a_robot_of_another_table_or_run_is_known_and_not_believed);
  RUN_TEST(test_more_events_than_are_kept_are_left_out_and_the_last_one_says_so);
  return UNITY_END();
}
