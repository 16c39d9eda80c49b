/* Games in which doors are shut and robots' power fails: nothing is announced that nobody scanned, and all come to an
 * end. */
#include "baselines.h"
#include "play.h"

#define NO_MINE (-2)

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static const fault_script *faults_of(fault_event first, fault_event second) {
  static fault_script script;
  script.count = 0;
  faults_add(&script, first);
  faults_add(&script, second);
  return &script;
}

/* Clear-all without a mine: every place is to be scanned, every territory to be announced. */
static void play_all(const fault_script *faults, uint64_t seed) {
  game_setup setup = play_setup(seed);
  setup.arena.mine = NO_MINE;
  setup.arena.clear_all = true;
  setup.arena.faults = faults;
  setup.arena.time_limit += game_door_seconds(&play_plan.t, faults);
  play(setup);
}

/* ---- doors ---- */

static void assert_only_missing(int missing) {
  for (int place = 0; place < play_arena.places; place++)
    TEST_ASSERT_EQUAL_INT_MESSAGE(place != missing, play_arena.scanned_by[place] >= 0, case_note);
  for (int i = 0; i < play_arena.robots; i++)
    TEST_ASSERT_EQUAL_INT_MESSAGE(i != play_plan.territory[missing], play_arena.done[i], case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at >= 0.0, case_note);
}

/* One after the other, from the start: the others are scanned and announced, its own territory by nobody, and all
 * stand. */
static void test_a_shut_place_is_announced_by_nobody_and_the_others_end(void) {
  play_prepare_drawn("1..S..2/...S.../3..S..4", 0);
  for (int place = 0; place < 4; place++) {
    const qtr_cell cell = qtr_policy_cell(&play_plan.t.policy, (unsigned)place);
    const fault_event shut = {0.0, FAULT_SHUT, -1, 0.0, cell};
    snprintf(case_note, sizeof case_note, "place %d is shut", place);
    play_all(faults_of(shut, shut), 1);
    assert_only_missing(place);
  }
}

static void test_a_door_on_the_way_shuts_off_what_lies_behind_it(void) {
  play_prepare_drawn("1..S.#####/...S....2#/3..S.#####", 0);
  const qtr_cell door = table_cell(&play_plan.t, 6, 1);
  TEST_ASSERT_NOT_EQUAL_UINT(QTR_NO_CELL, door);
  const fault_event shut = {0.0, FAULT_SHUT, -1, 0.0, door};
  play_all(faults_of(shut, shut), 1);
  assert_only_missing(1);
}

/* It is lost on the door's cell at a second and a half, and stays there. */
static void test_a_door_does_not_shut_on_a_robot(void) {
  play_prepare_drawn("S....1", 0);
  play_all(faults_of((fault_event){1.5, FAULT_LOST, 0, 0.0, 0}, (fault_event){1.5, FAULT_SHUT, -1, 0.0, 1}), 1);
  for (int i = 0; i < play_arena.events; i++)
    TEST_ASSERT_NOT_EQUAL_INT_MESSAGE(EVENT_SHUT, play_arena.event[i].kind, case_note);
}

/* ---- resets ---- */

static int count_events(int kind) {
  int count = 0;
  for (int i = 0; i < play_arena.events; i++) count += play_arena.event[i].kind == kind;
  return count;
}

static void assert_all_scanned_and_announced(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(play_arena.places, play_result.scanned, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(play_arena.robots, play_territories_done(), case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at >= 0.0, case_note);
}

/* Its power fails and is there again at once: all that it had in memory but its save is gone, and it makes no
 * difference. */
static void test_a_robot_reset_at_any_time_visits_what_its_twin_visits(void) {
  play_prepare_drawn("1..S..2.3/.#.S.#.../4..S..5.6", 0);
  play_all(NULL, 1);
  assert_all_scanned_and_announced();
  const arena twin = play_arena;
  for (double at = 0.0; at < twin.now; at += 0.65)
    for (int robot = 0; robot < twin.robots; robot++) {
      snprintf(case_note, sizeof case_note, "robot %d is reset at %.2f s", robot, at);
      play_all(faults_of((fault_event){at, FAULT_RESET, robot, 0.0, 0},
                         (fault_event){at + ARENA_TICK, FAULT_RESTART, robot, 0.0, 0}),
               1);
      assert_all_scanned_and_announced();
      TEST_ASSERT_EQUAL_INT_MESSAGE(1, count_events(EVENT_RESTARTED), case_note);
      for (int i = 0; i < twin.robots; i++)
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&twin.robot[i].scanned, &play_arena.robot[i].scanned, sizeof(qtr_places),
                                         case_note);
    }
}

static void test_a_robot_that_has_no_power_for_long_leaves_nothing_unscanned(void) {
  play_prepare_drawn("1..S..2.3/.#.S.#.../4..S..5.6", 0);
  for (double at = 0.0; at < 6.0; at += 0.7)
    for (int robot = 0; robot < 3; robot++) {
      snprintf(case_note, sizeof case_note, "robot %d has no power from %.1f s on", robot, at);
      play_all(faults_of((fault_event){at, FAULT_RESET, robot, 0.0, 0},
                         (fault_event){at + 15.0, FAULT_RESTART, robot, 0.0, 0}),
               1);
      assert_all_scanned_and_announced();
      TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at > at + 15.0, case_note);
    }
}

static int count_scans_after(double at) {
  int count = 0;
  for (int i = 0; i < play_arena.events; i++)
    count += play_arena.event[i].kind == EVENT_SCANNED && play_arena.event[i].at > at;
  return count;
}

static int finder(void) {
  for (int i = 0; i < play_arena.events; i++)
    if (play_arena.event[i].kind == EVENT_FOUND) return play_arena.event[i].robot;
  return -1;
}

static void assert_found_and_left_at_that(double at, int restarted) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(restarted, count_events(EVENT_RESTARTED), case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.found_at >= 0.0 && play_result.found_at < at, case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at >= at, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, count_scans_after(at), case_note);
}

/* Right after the find the power of one robot fails, the finder's too; and then that of all, of which the finder is
 * lost, so that saves alone know of it. It stays found: nobody goes on with its search, and all stand. */
static void test_a_find_outlasts_a_reset(void) {
  play_prepare_drawn("1...S...2/.###.###./3.......4", 4);
  game_setup setup = play_setup(3);
  play(setup);
  const double at = play_result.found_at + ARENA_TICK;
  const int found_by = finder();
  fault_event off = {at, FAULT_RESET, -1, 0.0, 0}, on = {at + 2.0, FAULT_RESTART, -1, 0.0, 0};
  fault_script script = *faults_of(off, on);
  TEST_ASSERT_LESS_THAN_INT_MESSAGE(play_arena.places, play_result.scanned, case_note);
  faults_add(&script, (fault_event){at + 1.0, FAULT_LOST, found_by, 0.0, 0});
  setup.arena.faults = &script;
  snprintf(case_note, sizeof case_note, "all are reset at %.2f s", at);
  play(setup);
  assert_found_and_left_at_that(at, play_arena.robots - 1);
  for (int robot = 0; robot < play_arena.robots; robot++) {
    off.robot = on.robot = robot;
    setup.arena.faults = faults_of(off, on);
    snprintf(case_note, sizeof case_note, "robot %d is reset at %.2f s", robot, at);
    play(setup);
    assert_found_and_left_at_that(at, 1);
  }
}

/* Without the plan there is nothing to save: such a robot is only away for a while. */
static void test_a_robot_without_a_plan_goes_on_after_a_reset(void) {
  play_prepare_drawn("1..S..2/...S...", 0);
  game_setup setup = play_setup(1);
  setup.strategy = STRATEGY_NEAREST;
  setup.arena.mine = NO_MINE;
  setup.arena.faults =
      faults_of((fault_event){1.0, FAULT_RESET, 0, 0.0, 0}, (fault_event){3.0, FAULT_RESTART, 0, 0.0, 0});
  play(setup);
  TEST_ASSERT_EQUAL_INT_MESSAGE(2, play_result.scanned, case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at >= 0.0, case_note);
}

/* Where signals are lost the others may not have heard of it before. */
static void test_a_robot_without_a_plan_tells_of_a_find_after_a_reset(void) {
  static baseline b;
  qtr_signal signal;
  play_prepare_drawn("1..S..2/...S...", 0);
  baseline_init(&b, &play_plan.t.policy, 0, NULL);
  const robot_pilot pilot = baseline_pilot(&b);
  TEST_ASSERT_FALSE(pilot.known(pilot.self, 0, &signal));
  pilot.found(pilot.self);
  TEST_ASSERT_TRUE(pilot.known(pilot.self, 0, &signal));
  TEST_ASSERT_EQUAL_INT(QTR_SIGNAL_FOUND, signal.kind);
  TEST_ASSERT_FALSE(pilot.known(pilot.self, 1, &signal));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_shut_place_is_announced_by_nobody_and_the_others_end);
  RUN_TEST(test_a_door_on_the_way_shuts_off_what_lies_behind_it);
  RUN_TEST(test_a_door_does_not_shut_on_a_robot);
  RUN_TEST(test_a_robot_reset_at_any_time_visits_what_its_twin_visits);
  RUN_TEST(test_a_robot_that_has_no_power_for_long_leaves_nothing_unscanned);
  RUN_TEST(test_a_find_outlasts_a_reset);
  RUN_TEST(test_a_robot_without_a_plan_goes_on_after_a_reset);
  RUN_TEST(test_a_robot_without_a_plan_tells_of_a_find_after_a_reset);
  plan_free(&play_plan);
  return UNITY_END();
}
