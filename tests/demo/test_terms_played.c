/* The field's terms in the demo's world: robots of several speeds, with sensors that miss, scans that take time,
 * batteries that end and ready times play what was planned for them, and announce only what they have done. */
#include "play.h"

/* A ladder of ground, 2 m a cell: '~' is rough. */
static const char ladder[] = "..........\n.##.~~.##.\n..........\n.##.~~.##.\n..........\n";

static const char two_classes[] = "map: ground.txt\n"
                                  "cell_size: 2\n"
                                  "objective: time\n"
                                  "robots:\n"
                                  "  - {column: 0, row: 4, name: Rex, class: dog}\n"
                                  "  - {column: 9, row: 4, name: Ines, class: deminer, ready_seconds: 12}\n"
                                  "classes:\n"
                                  "  dog: {speed: 1, scan_seconds: 10, endurance_seconds: 240, rough: false}\n"
                                  "  deminer: {speed: 0.4, scan_seconds: 20, endurance_seconds: 600}\n"
                                  "detection: 0.7\n"
                                  "places:\n"
                                  "  - {column: 0, row: 0, weight: 4, looks: 2}\n"
                                  "  - {column: 4, row: 2, weight: 3, looks: 2}\n"
                                  "  - {column: 4, row: 1, weight: 2}\n"
                                  "  - {column: 9, row: 0, weight: 2}\n"
                                  "  - {column: 8, row: 2, weight: 1}\n";

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void prepare(const char *mission) {
  write_file("ground.txt", ladder);
  write_file("mission.yaml", mission);
  play_prepare("mission.yaml", 0);
}

static int events_of(int kind, int robot) {
  int count = 0;
  for (int i = 0; i < play_arena.events; i++)
    count += play_arena.event[i].kind == kind && (robot < 0 || play_arena.event[i].robot == robot);
  return count;
}

/* Of the mission's seconds; below 0: it did not happen. */
static double time_of(int kind, int robot) {
  for (int i = 0; i < play_arena.events; i++)
    if (play_arena.event[i].kind == kind && play_arena.event[i].robot == robot)
      return play_arena.event[i].at * game_pace(&play_plan.t);
  return -1.0;
}

static game_setup without_mine(uint64_t seed) {
  game_setup setup = play_setup(seed);
  setup.arena.mine = -2;
  setup.arena.time_limit = game_limit_seconds(&play_plan.t, NULL);
  return setup;
}

/* ---- as planned ---- */

static void test_the_worlds_clock_is_the_fastest_robots_and_seconds_are_the_missions(void) {
  prepare(two_classes);
  TEST_ASSERT_DOUBLE_WITHIN(0.02, 2.0, game_pace(&play_plan.t)); /* 2 m at 1 m/s */
  const robot_body dog = body_of(&play_plan.t.policy, 0), deminer = body_of(&play_plan.t.policy, 1);
  TEST_ASSERT_EQUAL_DOUBLE(1.0, dog.speed);
  TEST_ASSERT_DOUBLE_WITHIN(0.01, 0.4, deminer.speed);
  TEST_ASSERT_INT_WITHIN(100000, 6000000, deminer.ready);
  TEST_ASSERT_INT_WITHIN(100000, 5000000, body_scan(&dog, 0));
  TEST_ASSERT_INT_WITHIN(200000, 10000000, body_scan(&deminer, 0));
  TEST_ASSERT_TRUE(dog.back_by > 120000000 && dog.empty > dog.back_by && deminer.back_by > dog.empty);
}

/* What a robot drives is longer than its plan by what it turns and rounds corners, or shorter: never by much. */
static void assert_near_the_plan(int place, int n, double at) {
  const double planned = plan_look_step(&play_plan, place, n) * game_step_seconds(&play_plan.t);
  char text[sizeof case_note + 100];
  snprintf(text, sizeof text, "%s; look %d at place %d: planned %.2f, was %.2f", case_note, n, place, planned, at);
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(2.0 + 0.05 * planned, planned, at, text);
}

static void test_looks_end_when_they_were_planned_to(void) {
  prepare(two_classes);
  for (uint64_t seed = 1; seed <= 10; seed++) {
    int looks[8] = {0};
    snprintf(case_note, sizeof case_note, "seed %llu", (unsigned long long)seed);
    play(without_mine(seed));
    TEST_ASSERT_EQUAL_INT_MESSAGE(play_plan.t.policy.board.places, play_arena.counted, case_note);
    for (int i = 0; i < play_arena.counted; i++)
      assert_near_the_plan(play_arena.look_place[i], ++looks[play_arena.look_place[i]], play_arena.look_at[i]);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_result.deadlocks, case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(5, play_result.scanned, case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(2, events_of(EVENT_LOOKED, -1), case_note);
  }
}

/* Who is done early helps with another's places, so a look may come sooner; none comes later. */
static void assert_no_look_is_late(const char *mission) {
  play_prepare_named(mission);
  for (uint64_t seed = 1; seed <= 3; seed++) {
    static int looks[QTR_MAX_PLACES];
    memset(looks, 0, sizeof looks);
    snprintf(case_note, sizeof case_note, "%s, seed %llu", mission, (unsigned long long)seed);
    play(without_mine(seed));
    TEST_ASSERT_EQUAL_INT_MESSAGE(play_plan.t.policy.board.places, play_arena.counted, case_note);
    for (int i = 0; i < play_arena.counted; i++) {
      const int place = play_arena.look_place[i];
      const double planned = plan_look_step(&play_plan, place, ++looks[place]) * game_step_seconds(&play_plan.t);
      TEST_ASSERT_TRUE_MESSAGE(play_arena.look_at[i] <= 2.0 + 1.05 * planned, case_note);
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(play_arena.robots, events_of(EVENT_HOME, -1), case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, events_of(EVENT_EMPTY, -1) + play_result.deadlocks, case_note);
  }
}

static void test_the_shipped_missions_are_played_as_planned(void) {
  assert_no_look_is_late("demining");
  assert_no_look_is_late("flat");
}

static double away_from_start[2];

static void watch_starts(void *user, const arena *a) {
  const qtr_policy *policy = &a->t->policy;
  (void)user;
  for (int i = 0; i < 2; i++) {
    const point start =
        ground_centre(&a->g, qtr_policy_cell(policy, (unsigned)policy->board.places + policy->board.start_of[i]));
    const point at = world_pose_of(a->w, i).at;
    away_from_start[i] = hypot(at.x - start.x, at.y - start.y);
  }
}

static void test_all_go_home_in_time(void) {
  prepare(two_classes);
  game_setup setup = without_mine(1);
  setup.watch = watch_starts;
  play(setup);
  for (int i = 0; i < 2; i++) {
    const qtr_steps end = qtr_board_end(&play_plan.t.policy.board, (unsigned)i);
    TEST_ASSERT_EQUAL_INT(1, events_of(EVENT_HOME, i));
    TEST_ASSERT_TRUE(time_of(EVENT_HOME, i) / game_pace(&play_plan.t) <= end * game_step_seconds(&play_plan.t));
  }
  for (int i = 0; i < 2; i++) TEST_ASSERT_TRUE(away_from_start[i] < 0.6);
  TEST_ASSERT_EQUAL_INT(0, events_of(EVENT_TIRED, -1));
  TEST_ASSERT_EQUAL_INT(2, play_territories_done());
}

static point first_at;
static bool waited, kept_off;

static void watch_robots(void *user, const arena *a) {
  const point dog = world_pose_of(a->w, 0).at, deminer = world_pose_of(a->w, 1).at;
  (void)user;
  if (a->ticks == 1) first_at = deminer;
  waited = waited && (a->now > 5.9 || hypot(deminer.x - first_at.x, deminer.y - first_at.y) < 0.01);
  kept_off = kept_off && ground_slowness(&a->g, dog) == 1;
}

static void test_who_is_ready_later_waits_and_who_keeps_off_rough_ground_does(void) {
  prepare(two_classes);
  game_setup setup = without_mine(2);
  waited = kept_off = true;
  setup.watch = watch_robots;
  play(setup);
  TEST_ASSERT_TRUE(waited);
  TEST_ASSERT_TRUE(kept_off);
  TEST_ASSERT_EQUAL_INT(1, events_of(EVENT_READY, 1));
  TEST_ASSERT_EQUAL_INT(0, events_of(EVENT_READY, 0));
  TEST_ASSERT_DOUBLE_WITHIN(0.6, 12.0, time_of(EVENT_READY, 1));
}

/* ---- misses ---- */

static void test_a_place_is_found_at_the_look_that_the_seed_says_and_missed_before(void) {
  int first = 0, second = 0, never = 0;
  prepare(two_classes);
  for (uint64_t seed = 1; seed <= 60; seed++) {
    game_setup setup = without_mine(seed);
    setup.arena.mine = 0;
    snprintf(case_note, sizeof case_note, "seed %llu", (unsigned long long)seed);
    play(setup);
    const int needed = play_result.looks_needed;
    TEST_ASSERT_EQUAL_INT_MESSAGE(needed <= 2, play_result.found_at >= 0.0, case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(needed <= 2 ? needed - 1 : 2, events_of(EVENT_MISSED, -1), case_note);
    if (needed <= 2) assert_near_the_plan(0, needed, play_result.found_at);
    first += needed == 1;
    second += needed == 2;
    never += needed > 2;
  }
  TEST_ASSERT_INT_WITHIN(11, 42, first); /* of 60 with probability 0.7: three standard deviations */
  TEST_ASSERT_INT_WITHIN(10, 13, second);
  TEST_ASSERT_GREATER_THAN_INT(0, never);
}

/* ---- batteries ---- */

/* The dog is held up: it gives up what it cannot make any more, says nothing of its territory, and comes home. */
static void test_a_robot_whose_battery_does_not_last_goes_home_and_leaves_its_territory_unannounced(void) {
  const fault_script stuck = {2, {{1.0, FAULT_STUCK, 0, 0.0, 0}, {95.0, FAULT_UNSTUCK, 0, 0.0, 0}}};
  prepare(two_classes);
  game_setup setup = without_mine(3);
  setup.arena.faults = &stuck;
  play(setup);
  TEST_ASSERT_EQUAL_INT(1, events_of(EVENT_TIRED, 0));
  TEST_ASSERT_EQUAL_INT(1, events_of(EVENT_HOME, 0));
  TEST_ASSERT_EQUAL_INT(0, events_of(EVENT_EMPTY, -1));
  for (int i = 0; i < play_arena.events; i++)
    if (play_arena.event[i].kind == EVENT_DONE && play_arena.event[i].robot == 0)
      TEST_ASSERT_EQUAL_INT_MESSAGE(1, play_arena.event[i].territory, "its own it has not scanned");
}

static void test_a_robot_that_is_held_up_for_too_long_runs_empty_and_is_lost(void) {
  const fault_script stuck = {1, {{1.0, FAULT_STUCK, 0, 0.0, 0}}};
  prepare(two_classes);
  game_setup setup = without_mine(4);
  setup.arena.faults = &stuck;
  play(setup);
  TEST_ASSERT_EQUAL_INT(1, events_of(EVENT_EMPTY, 0));
  TEST_ASSERT_DOUBLE_WITHIN(3.0, 240 * (1 + 2 * BODY_RESERVE), time_of(EVENT_EMPTY, 0));
  TEST_ASSERT_EQUAL_INT(STATE_LOST, play_arena.robot[0].state);
}

/* Whatever goes wrong: who announces a territory has made every look there itself. */
static void assert_only_what_was_scanned_is_announced(void) {
  for (int i = 0; i < play_arena.events; i++) {
    const arena_event *e = &play_arena.event[i];
    if (e->kind != EVENT_DONE) continue;
    for (int place = 0; place < play_plan.places; place++)
      if (play_plan.territory[place] == e->territory)
        TEST_ASSERT_TRUE_MESSAGE(qtr_places_has(&play_arena.robot[e->robot].scanned, (unsigned)place), case_note);
  }
}

static void test_whatever_happens_only_what_was_scanned_is_announced(void) {
  prepare(two_classes);
  for (uint64_t seed = 1; seed <= 20; seed++) {
    const double at = 2.0 + 3.0 * (double)seed;
    const fault_script faults = {3,
                                 {{at, FAULT_STUCK, (int)(seed % 2), 0.0, 0},
                                  {at + 40.0, FAULT_UNSTUCK, (int)(seed % 2), 0.0, 0},
                                  {at + 50.0, FAULT_RESET, (int)((seed + 1) % 2), 0.0, 0}}};
    fault_script script = faults;
    faults_add(&script, (fault_event){at + 53.0, FAULT_RESTART, (int)((seed + 1) % 2), 0.0, 0});
    snprintf(case_note, sizeof case_note, "seed %llu", (unsigned long long)seed);
    game_setup setup = without_mine(seed);
    setup.arena.faults = &script;
    play(setup);
    assert_only_what_was_scanned_is_announced();
  }
}

/* ---- a plan that knows nothing of it ---- */

static void test_robots_by_a_plan_without_the_terms_look_as_often_and_are_what_they_are(void) {
  table plain;
  prepare(two_classes);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, plan_make_plain(&plain, &play_plan, 0, PLAY_LEARN_LIMIT, &play_why), play_why.text);
  TEST_ASSERT_EQUAL_INT(5, plain.policy.board.places);
  game_setup setup = without_mine(5);
  setup.strategy = STRATEGY_PLAIN;
  setup.plain = &plain;
  waited = kept_off = true;
  setup.watch = watch_robots;
  play(setup);
  TEST_ASSERT_EQUAL_INT(play_plan.t.policy.board.places, play_arena.counted);
  TEST_ASSERT_TRUE(waited);
  TEST_ASSERT_TRUE_MESSAGE(kept_off, "the plan sends it there all the same");
  TEST_ASSERT_EQUAL_INT(0, events_of(EVENT_EMPTY, -1));
  table_free(&plain);
}

static void test_without_a_plan_all_is_looked_at_as_often(void) {
  prepare(two_classes);
  game_setup setup = without_mine(6);
  setup.strategy = STRATEGY_NEAREST;
  play(setup);
  TEST_ASSERT_EQUAL_INT(5, play_result.scanned);
  TEST_ASSERT_EQUAL_INT(0, play_result.deadlocks);
}

/* ---- what is not the mission's ---- */

static void test_a_table_of_robots_of_another_kind_is_refused(void) {
  char other[sizeof two_classes + 16];
  prepare(two_classes);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_make("mission.yaml", NULL, 0, "own.qtr"), play_why.text);
  snprintf(other, sizeof other, "%s", two_classes);
  memcpy(strstr(other, "scan_seconds: 10"), "scan_seconds: 18", 16);
  write_file("other.yaml", other);
  TEST_ASSERT_EQUAL_INT(-1, play_make("other.yaml", "own.qtr", 0, NULL));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "its robots are others"), play_why.text);
  snprintf(other, sizeof other, "%s", two_classes);
  memcpy(strstr(other, "looks: 2"), "looks: 1", 8);
  write_file("other.yaml", other);
  TEST_ASSERT_EQUAL_INT(-1, play_make("other.yaml", "own.qtr", 0, NULL));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(play_why.text, "it has other places"), play_why.text);
}

static void test_a_list_of_faults_goes_by_the_missions_seconds(void) {
  fault_script script;
  prepare(two_classes);
  write_file("faults.yaml", "faults:\n  - {at: 30, stuck: Rex, for: 8}\n");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, faults_read(&script, "faults.yaml", &play_plan.t, &play_why), play_why.text);
  TEST_ASSERT_DOUBLE_WITHIN(0.2, 15.0, script.event[0].at);
  TEST_ASSERT_DOUBLE_WITHIN(0.2, 19.0, script.event[1].at);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_worlds_clock_is_the_fastest_robots_and_seconds_are_the_missions);
  RUN_TEST(test_looks_end_when_they_were_planned_to);
  RUN_TEST(test_the_shipped_missions_are_played_as_planned);
  RUN_TEST(test_all_go_home_in_time);
  RUN_TEST(test_who_is_ready_later_waits_and_who_keeps_off_rough_ground_does);
  RUN_TEST(test_a_place_is_found_at_the_look_that_the_seed_says_and_missed_before);
  RUN_TEST(test_a_robot_whose_battery_does_not_last_goes_home_and_leaves_its_territory_unannounced);
  RUN_TEST(test_a_robot_that_is_held_up_for_too_long_runs_empty_and_is_lost);
  RUN_TEST(test_whatever_happens_only_what_was_scanned_is_announced);
  RUN_TEST(test_robots_by_a_plan_without_the_terms_look_as_often_and_are_what_they_are);
  RUN_TEST(test_without_a_plan_all_is_looked_at_as_often);
  RUN_TEST(test_a_list_of_faults_goes_by_the_missions_seconds);
  RUN_TEST(test_a_table_of_robots_of_another_kind_is_refused);
  plan_free(&play_plan);
  return UNITY_END();
}
