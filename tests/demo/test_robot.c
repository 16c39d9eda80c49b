/* A robot: what it heeds, what it does about it, and that it says nothing but commands and signals. */
#include <float.h>
#include <limits.h>

#include "robot.h"
#include "support/tables.h"

enum { TICK = 50000, MOST = 64 };

static qtr_policy policy;
static qtr_seeker seeker;
static robot r;

/* What it said since the last act(). */
static message_command command[MOST];
static message_terminate signal[MOST];
static int commands, signals;

static void hear_command(void *user, const message_command *m) {
  TEST_ASSERT_EQUAL_PTR(&r, user);
  TEST_ASSERT_LESS_THAN(MOST, commands);
  command[commands++] = *m;
}

static void hear_signal(void *user, const message_terminate *m) {
  TEST_ASSERT_EQUAL_PTR(&r, user);
  TEST_ASSERT_LESS_THAN(MOST, signals);
  signal[signals++] = *m;
}

static void begin(int self, bool clear_all) {
  table_open(&policy);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_seeker_init(&seeker, &policy, (unsigned)self, NULL, 5));
  robot_init(&r, &policy, self, clear_all, robot_pilot_of_plan(&seeker), (robot_voice){&r, hear_command, hear_signal});
}

/* Two robots that start together between two places: each has one place of its own. */
void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  table_draw("1...S...2", 2);
  begin(0, false);
}

void tearDown(void) {
}

static void place_at(qtr_cell cell, double dx, int64_t utime) {
  const ground ground = ground_of(&policy);
  const point middle = ground_centre(&ground, cell);
  const message_pose m = {utime, r.self, ground_x_m(&ground, middle) + dx, ground_y_m(&ground, middle), 0.0};
  robot_hear_pose(&r, &m);
}

enum reading { UNREAD, CLEAR, MINE };

/* A scan with nothing around, but for `range` on every ray. */
static void act_amid(int64_t utime, enum reading reading, float range) {
  message_scan m = {.utime = utime, .robot = r.self, .read = reading != UNREAD, .mine = reading == MINE};
  for (int ray = 0; ray < DEMO_RAYS; ray++) m.range[ray] = range;
  commands = signals = 0;
  robot_hear_scan(&r, &m);
}

static void act(int64_t utime, enum reading reading) {
  act_amid(utime, reading, 1.5f);
}

static void hear(int sender, int what, int territory) {
  const message_terminate m = {0, sender, what, territory, seeker.identity, 5};
  robot_hear_terminate(&r, &m);
}

static bool drives(void) {
  TEST_ASSERT_EQUAL_INT(1, commands);
  return command[0].left != 0.0 || command[0].right != 0.0;
}

static uint16_t target(void) {
  return qtr_seeker_target(&seeker);
}

static qtr_cell start_cell(void) {
  return 4;
}

static bool visited(uint16_t place) {
  return qtr_places_has(&seeker.visited, place);
}

/* Come to the target, ask for the sensor to be read, and hear what it says. */
static void read_at_target(enum reading reading) {
  const qtr_cell cell = qtr_policy_cell(&policy, target());
  place_at(cell, 0.0, 0);
  act(0, UNREAD);
  place_at(cell, 0.0, TICK);
  act(TICK, reading);
}

/* ---- arriving ---- */

static void test_before_it_knows_where_it_is_it_commands_nothing(void) {
  act(0, UNREAD);
  TEST_ASSERT_EQUAL_INT(0, commands);
  TEST_ASSERT_EQUAL_INT(0, signals);
}

static void test_it_asks_for_its_sensor_near_the_middle_of_its_target_only(void) {
  static const double off[] = {0.6, 0.4, 0.2, 0.05, 0.0};
  const qtr_cell cell = qtr_policy_cell(&policy, target());
  for (int i = 0; i < 5; i++) {
    place_at(cell, off[i], i);
    act(i, UNREAD);
    TEST_ASSERT_EQUAL_INT(1, commands);
    TEST_ASSERT_EQUAL_INT(off[i] < 0.1, command[0].read);
  }
}

static void test_a_place_that_is_not_its_target_is_passed_by(void) {
  const uint16_t own = target();
  place_at(qtr_policy_cell(&policy, own == 0 ? 1 : 0), 0.0, 0);
  act(0, UNREAD);
  TEST_ASSERT_EQUAL_INT(own, target());
  TEST_ASSERT_TRUE(drives());
  TEST_ASSERT_FALSE(command[0].read);
}

static void test_only_a_reading_makes_a_place_scanned(void) {
  const uint16_t place = target();
  read_at_target(UNREAD);
  TEST_ASSERT_FALSE(visited(place));
  TEST_ASSERT_TRUE_MESSAGE(command[0].read, "it asks again");
  place_at(qtr_policy_cell(&policy, place), 0.0, 2 * TICK);
  act(2 * TICK, CLEAR);
  TEST_ASSERT_TRUE(visited(place));
  TEST_ASSERT_NOT_EQUAL_INT(place, target());
}

/* With messages lost, the pose may be that of another moment: then nobody knows where the sensor was read. */
static void test_a_reading_counts_only_with_a_pose_of_the_same_moment(void) {
  const uint16_t place = target();
  const qtr_cell cell = qtr_policy_cell(&policy, place);
  place_at(cell, 0.0, 5);
  act(6, UNREAD);
  TEST_ASSERT_FALSE_MESSAGE(command[0].read, "it does not ask where it may not be");
  act(5, UNREAD);
  TEST_ASSERT_TRUE(command[0].read);
  act(6, CLEAR);
  TEST_ASSERT_FALSE(visited(place));
  place_at(cell, 0.0, 7);
  act(7, UNREAD);
  place_at(cell, 0.0, 8);
  act(8, CLEAR);
  TEST_ASSERT_TRUE(visited(place));
}

/* Between asking and reading it drove on, off the place. */
static void test_a_reading_too_far_from_the_target_scans_nothing(void) {
  const uint16_t place = target();
  const qtr_cell cell = qtr_policy_cell(&policy, place);
  place_at(cell, 0.1, 0);
  act(0, UNREAD);
  TEST_ASSERT_TRUE(command[0].read);
  place_at(cell, 0.5, TICK);
  act(TICK, CLEAR);
  TEST_ASSERT_FALSE(visited(place));
  TEST_ASSERT_EQUAL_INT(place, target());
}

static void test_a_reading_that_it_did_not_ask_for_scans_no_place(void) {
  const uint16_t own = target();
  place_at(start_cell(), 0.0, 0);
  act(0, CLEAR);
  TEST_ASSERT_EQUAL_INT(own, target());
  TEST_ASSERT_FALSE(visited(0) || visited(1));
}

/* A robot that was lost on the place keeps others from its middle. */
static void test_where_something_stands_on_the_place_it_asks_from_beside(void) {
  place_at(qtr_policy_cell(&policy, target()), 0.3, 0);
  act_amid(0, UNREAD, 0.2f);
  TEST_ASSERT_TRUE(command[0].read);
  act_amid(1, UNREAD, 1.5f);
  TEST_ASSERT_FALSE(command[0].read);
}

static void test_a_territory_finished_is_announced_at_once(void) {
  read_at_target(CLEAR);
  TEST_ASSERT_EQUAL_INT(1, signals);
  TEST_ASSERT_EQUAL_INT(QTR_SIGNAL_TERRITORY_DONE, signal[0].signal);
  TEST_ASSERT_EQUAL_INT(0, signal[0].territory);
  TEST_ASSERT_EQUAL_INT(0, signal[0].sender);
}

/* ---- finding ---- */

static void test_on_a_mine_it_stops_and_says_so_at_once(void) {
  const uint16_t place = target();
  read_at_target(MINE);
  TEST_ASSERT_TRUE(robot_stopped(&r));
  TEST_ASSERT_FALSE(drives());
  TEST_ASSERT_FALSE(visited(place));
  TEST_ASSERT_EQUAL_INT(1, signals);
  TEST_ASSERT_EQUAL_INT(QTR_SIGNAL_FOUND, signal[0].signal);
  act(2 * TICK, UNREAD);
  TEST_ASSERT_FALSE_MESSAGE(drives(), "it stays where it is");
}

static void test_a_mine_in_a_scan_that_was_not_read_is_none(void) {
  message_scan m = {.robot = 0, .mine = true};
  place_at(start_cell(), 0.0, 0);
  robot_hear_scan(&r, &m);
  TEST_ASSERT_FALSE(robot_stopped(&r));
}

static void test_hearing_of_a_find_it_stops_and_passes_it_on(void) {
  place_at(start_cell(), 0.0, 0);
  commands = signals = 0;
  hear(1, QTR_SIGNAL_FOUND, INT_MAX); /* its territory counts for nothing */
  TEST_ASSERT_TRUE(robot_stopped(&r));
  TEST_ASSERT_FALSE(drives());
  TEST_ASSERT_EQUAL_INT(1, signals);
  TEST_ASSERT_EQUAL_INT(QTR_SIGNAL_FOUND, signal[0].signal);
  TEST_ASSERT_EQUAL_INT(0, signal[0].sender);
}

static void test_in_clear_all_a_find_stops_nobody_and_the_place_counts_as_scanned(void) {
  begin(0, true);
  const uint16_t place = target();
  hear(1, QTR_SIGNAL_FOUND, 0);
  read_at_target(MINE);
  TEST_ASSERT_FALSE(robot_stopped(&r));
  TEST_ASSERT_TRUE(drives());
  TEST_ASSERT_TRUE(visited(place));
  for (int i = 0; i < signals; i++) TEST_ASSERT_EQUAL_INT(QTR_SIGNAL_TERRITORY_DONE, signal[i].signal);
}

/* ---- hearing ---- */

static bool goes_east(int tick) {
  place_at(start_cell(), 0.0, (int64_t)tick * TICK);
  act((int64_t)tick * TICK, UNREAD);
  return command[0].left > command[0].right; /* heading 0: the aim on the right lane of the way east */
}

/* It stands in its start cell for 10 seconds, as if something held it. */
static void test_who_makes_no_way_tries_the_other_side_of_the_road(void) {
  hear(1, QTR_SIGNAL_TERRITORY_DONE, target() == 0 ? 0 : 1);
  if (target() == 0) hear(1, QTR_SIGNAL_TERRITORY_DONE, 1);
  TEST_ASSERT_EQUAL_INT(1, target()); /* in the east */
  TEST_ASSERT_TRUE(goes_east(0));
  int tick = 1;
  while (tick < 200 && goes_east(tick)) tick++;
  TEST_ASSERT_TRUE(tick > 20 && tick < 200);
}

/* Held in its start cell until its target is another; returns the seconds that took. */
static int hold_until_it_gives_up(int *tick) {
  const uint16_t before = target();
  const int begin = *tick;
  for (; target() == before; (*tick)++) {
    TEST_ASSERT_LESS_THAN(20 * 1000, *tick);
    goes_east(*tick);
  }
  return (*tick - begin) * TICK / 1000000;
}

/* A place that it does not get to for long is left out, tried once more, and not announced. */
static void test_a_place_that_it_does_not_get_to_is_left_out_and_tried_once_more(void) {
  const uint16_t own = target();
  int tick = 0;
  TEST_ASSERT_INT_WITHIN(2, HOPE_PATIENCE / 1000000, hold_until_it_gives_up(&tick));
  TEST_ASSERT_EQUAL_INT(1 - own, target());
  hold_until_it_gives_up(&tick);
  TEST_ASSERT_EQUAL_INT_MESSAGE(own, target(), "once more");
  hold_until_it_gives_up(&tick);
  hold_until_it_gives_up(&tick);
  TEST_ASSERT_EQUAL(QTR_STANDS_BLOCKED, qtr_seeker_standing(&seeker));
  act((int64_t)tick * TICK, UNREAD);
  TEST_ASSERT_TRUE(robot_stopped(&r));
  TEST_ASSERT_FALSE(drives());
  TEST_ASSERT_EQUAL_INT(0, signals);
}

static void test_a_territory_done_by_another_sends_it_on(void) {
  const uint16_t own = target();
  place_at(start_cell(), 0.0, 0);
  hear(1, QTR_SIGNAL_TERRITORY_DONE, 0);
  TEST_ASSERT_EQUAL_INT(1 - own, target());
  act(0, UNREAD);
  TEST_ASSERT_TRUE(drives());
  hear(1, QTR_SIGNAL_TERRITORY_DONE, 1);
  TEST_ASSERT_EQUAL_INT(QTR_STAND_DOWN, target());
  act(1, UNREAD);
  TEST_ASSERT_TRUE(robot_stopped(&r));
  TEST_ASSERT_FALSE(drives());
}

static void test_it_turns_to_its_new_target_at_once(void) {
  place_at(start_cell(), 0.0, 0);
  act(0, UNREAD);
  const double before = command[0].right - command[0].left;
  hear(1, QTR_SIGNAL_TERRITORY_DONE, 0);
  act(1, UNREAD);
  TEST_ASSERT_TRUE(before != command[0].right - command[0].left);
}

static void test_its_own_echo_is_without_effect(void) {
  const uint16_t own = target();
  hear(0, QTR_SIGNAL_FOUND, 0);
  hear(0, QTR_SIGNAL_TERRITORY_DONE, 0);
  hear(0, QTR_SIGNAL_TERRITORY_DONE, 1);
  TEST_ASSERT_EQUAL_INT(own, target());
  place_at(start_cell(), 0.0, 0);
  act(0, UNREAD);
  TEST_ASSERT_TRUE(drives());
  TEST_ASSERT_EQUAL_INT(0, signals);
}

/* Of another table, other starts, or yesterday's search: not believed, and not passed on. */
static void test_what_is_of_another_search_is_without_effect(void) {
  const message_terminate other_table = {0, 1, QTR_SIGNAL_FOUND, 0, seeker.identity ^ 1u, 5};
  const message_terminate other_run = {0, 1, QTR_SIGNAL_TERRITORY_DONE, 0, seeker.identity, 4};
  const uint16_t own = target();
  robot_hear_terminate(&r, &other_table);
  robot_hear_terminate(&r, &other_run);
  TEST_ASSERT_EQUAL_INT(own, target());
  TEST_ASSERT_EQUAL_UINT32(2, qtr_seeker_foreign(&seeker));
  place_at(start_cell(), 0.0, 0);
  act(0, UNREAD);
  TEST_ASSERT_TRUE(drives());
  TEST_ASSERT_EQUAL_INT(0, signals);
}

static void test_what_is_no_signal_is_without_effect(void) {
  static const int whats[] = {INT_MIN, -1, 0, 3, INT_MAX, QTR_SIGNAL_TERRITORY_DONE, QTR_SIGNAL_TERRITORY_DONE};
  static const int territories[] = {0, 0, 0, 0, 0, -1, DEMO_MOST_ROBOTS};
  const uint16_t own = target();
  for (unsigned i = 0; i < sizeof whats / sizeof whats[0]; i++) hear(1, whats[i], territories[i]);
  place_at(start_cell(), 0.0, 0);
  act(0, UNREAD);
  TEST_ASSERT_EQUAL_INT(own, target());
  TEST_ASSERT_EQUAL_INT(0, signals);
  TEST_ASSERT_TRUE(drives());
}

/* ---- saying ---- */

static void test_wheels_are_told_in_metres(void) {
  place_at(start_cell(), 0.0, 0);
  act(0, UNREAD);
  const message_command in_cells = command[0];
  table_mission.frame = (qtr_frame){250000, 3000000, -2000000, 0, 0};
  table_export();
  table_open(&policy);
  robot_init(&r, &policy, 0, false, robot_pilot_of_plan(&seeker), r.voice);
  place_at(start_cell(), 0.0, 0);
  act(0, UNREAD);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, in_cells.left / 4, command[0].left);
  TEST_ASSERT_DOUBLE_WITHIN(1e-6, in_cells.right / 4, command[0].right);
}

static double random_extreme(test_random *random) {
  static const double extremes[] = {0.0, 1e-300, 3.0, 1e9, 1e300, DBL_MAX};
  const double value = random_chance(random, 70) ? 9 * random_unit(random) : extremes[random_below(random, 6)];
  return random_chance(random, 30) ? -value : value;
}

static void assert_said_well(int64_t utime) {
  TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(1, commands, case_note);
  for (int i = 0; i < commands; i++) {
    TEST_ASSERT_EQUAL_INT_MESSAGE(r.self, command[i].robot, case_note);
    TEST_ASSERT_TRUE_MESSAGE(command[i].utime == utime, case_note);
    TEST_ASSERT_TRUE_MESSAGE(command[i].left > -2.0 && command[i].left < 2.0, case_note);
    TEST_ASSERT_TRUE_MESSAGE(command[i].right > -2.0 && command[i].right < 2.0, case_note);
  }
  for (int i = 0; i < signals; i++) {
    TEST_ASSERT_EQUAL_INT_MESSAGE(r.self, signal[i].sender, case_note);
    TEST_ASSERT_TRUE_MESSAGE(signal[i].signal == QTR_SIGNAL_FOUND || signal[i].signal == QTR_SIGNAL_TERRITORY_DONE,
                             case_note);
    TEST_ASSERT_TRUE_MESSAGE(signal[i].territory >= 0 && signal[i].territory < DEMO_MOST_ROBOTS, case_note);
    TEST_ASSERT_TRUE_MESSAGE(signal[i].utime == utime, case_note);
  }
}

/* Whatever sound messages say, nothing breaks, and what the robot says is its own, of that moment, within bounds. */
static void test_whatever_it_hears_it_says_only_commands_and_signals_of_its_own(void) {
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("anything heard", number);
    table_random(&random, (mission_size){6, 6, 4, 4});
    table_open(&policy);
    begin((int)random_below(&random, policy.board.seekers), random_chance(&random, 30));
    for (int i = 0; i < 100; i++) {
      const int64_t utime = random_chance(&random, 90) ? (int64_t)i * TICK : (int64_t)(random_bits(&random) >> 2);
      const message_pose pose = {random_chance(&random, 90) ? utime : 0, r.self, random_extreme(&random),
                                 random_extreme(&random), random_extreme(&random)};
      message_scan scan = {.utime = utime, .robot = r.self, .read = random_chance(&random, 10)};
      scan.mine = scan.read && random_chance(&random, 50);
      for (int ray = 0; ray < DEMO_RAYS; ray++)
        scan.range[ray] = random_chance(&random, 5) ? FLT_MAX : (float)random_unit(&random);
      if (random_chance(&random, 80)) robot_hear_pose(&r, &pose);
      if (random_chance(&random, 5))
        hear((int)random_below(&random, 16), (int)random_below(&random, 5), (int)random_below(&random, 20) - 2);
      commands = signals = 0;
      robot_hear_scan(&r, &scan);
      assert_said_well(utime);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_before_it_knows_where_it_is_it_commands_nothing);
  RUN_TEST(test_it_asks_for_its_sensor_near_the_middle_of_its_target_only);
  RUN_TEST(test_a_place_that_is_not_its_target_is_passed_by);
  RUN_TEST(test_only_a_reading_makes_a_place_scanned);
  RUN_TEST(test_a_reading_counts_only_with_a_pose_of_the_same_moment);
  RUN_TEST(test_a_reading_too_far_from_the_target_scans_nothing);
  RUN_TEST(test_a_reading_that_it_did_not_ask_for_scans_no_place);
  RUN_TEST(test_where_something_stands_on_the_place_it_asks_from_beside);
  RUN_TEST(test_a_territory_finished_is_announced_at_once);
  RUN_TEST(test_on_a_mine_it_stops_and_says_so_at_once);
  RUN_TEST(test_a_mine_in_a_scan_that_was_not_read_is_none);
  RUN_TEST(test_hearing_of_a_find_it_stops_and_passes_it_on);
  RUN_TEST(test_in_clear_all_a_find_stops_nobody_and_the_place_counts_as_scanned);
  RUN_TEST(test_who_makes_no_way_tries_the_other_side_of_the_road);
  RUN_TEST(test_a_place_that_it_does_not_get_to_is_left_out_and_tried_once_more);
  RUN_TEST(test_a_territory_done_by_another_sends_it_on);
  RUN_TEST(test_it_turns_to_its_new_target_at_once);
  RUN_TEST(test_its_own_echo_is_without_effect);
  RUN_TEST(test_what_is_of_another_search_is_without_effect);
  RUN_TEST(test_what_is_no_signal_is_without_effect);
  RUN_TEST(test_wheels_are_told_in_metres);
  RUN_TEST(test_whatever_it_hears_it_says_only_commands_and_signals_of_its_own);
  return UNITY_END();
}
