/* Whole games on the demo's missions: the mine is found and everybody stops, nothing is scanned twice, nobody gets
 * stuck, and nobody says more than the rules allow. */
#include "lcm_log.h"
#include "play.h"

enum { SEEDS = 6, MISSIONS = 3 };

static const char *const missions[MISSIONS] = {"minefield", "site", "warehouse"};

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void name_case(const char *mission, uint64_t seed) {
  snprintf(case_note, sizeof case_note, "%s, seed %llu", mission, (unsigned long long)seed);
}

/* Losing no signal, robots hear of a find in the tick after it. */
static void assert_found_and_stopped(void) {
  TEST_ASSERT_TRUE_MESSAGE(play_result.found_at >= 0.0, case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at >= play_result.found_at, case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at <= play_result.found_at + 4 * ARENA_TICK, case_note);
}

static void assert_orderly(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_result.deadlocks, case_note);
  TEST_ASSERT_EQUAL_UINT64_MESSAGE(0, play_result.counts.ignored, case_note);
  TEST_ASSERT_EQUAL_UINT64_MESSAGE(0, play_result.counts.lost, case_note);
}

/* ---- what a game says ---- */

/* Robot channels carry robots that there are; the rest is TERMINATE and STATUS. */
static bool is_allowed(const char *channel, int robots) {
  char name[64];
  for (int robot = 0; robot < robots; robot++) {
    static const char *const kinds[] = {"POSE", "SCAN", "COMMAND"};
    for (int kind = 0; kind < 3; kind++) {
      snprintf(name, sizeof name, "QUARTER_R%d_%s", robot, kinds[kind]);
      if (strcmp(name, channel) == 0) return true;
    }
  }
  return strcmp(channel, "QUARTER_TERMINATE") == 0 || strcmp(channel, "QUARTER_STATUS") == 0;
}

static void assert_log_is_allowed(const char *path) {
  static log_event e;
  uint64_t events = 0, sent = 0;
  FILE *file = fopen(path, "rb");
  TEST_ASSERT_NOT_NULL(file);
  for (; log_read(file, &e); events++) {
    TEST_ASSERT_TRUE_MESSAGE(is_allowed(e.channel, play_arena.robots), e.channel);
    TEST_ASSERT_TRUE_MESSAGE(e.time >= 0 && e.time <= (int64_t)(1e6 * play_result.duration), case_note);
  }
  fclose(file);
  for (int kind = 0; kind < KINDS; kind++) sent += play_result.counts.sent[kind];
  TEST_ASSERT_EQUAL_UINT64_MESSAGE(sent, events, case_note);
}

/* ---- what becomes of it ---- */

static void find_the_mine(const char *mission, uint64_t seed) {
  name_case(mission, seed);
  game_setup setup = play_setup(seed);
  setup.log = "game.lcm";
  play(setup);
  assert_found_and_stopped();
  assert_orderly();
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_result.duplicates, case_note);
  assert_log_is_allowed("game.lcm");
}

static void lose_each_robot_alone(const char *mission) {
  for (int robot = 0; robot < play_plan.t.policy.board.seekers; robot++) {
    const fault_script lost = {1, {{0.0, FAULT_LOST, robot, 0.0, 0}}};
    snprintf(case_note, sizeof case_note, "%s, robot %d lost", mission, robot);
    game_setup setup = play_setup(10 + (uint64_t)robot);
    setup.arena.faults = &lost;
    play(setup);
    assert_found_and_stopped();
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, play_result.deadlocks, case_note);
  }
}

/* Who is done walks another's territory from its start, and may scan anew what that one has (docs/DESIGN.md). */
static void clear_all(const char *mission) {
  name_case(mission, 3);
  game_setup setup = play_setup(3);
  setup.arena.clear_all = true;
  play(setup);
  TEST_ASSERT_EQUAL_INT_MESSAGE(play_arena.places, play_result.scanned, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(play_arena.robots, play_territories_done(), case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.found_at >= 0.0 && play_result.all_stopped_at >= play_result.found_at,
                           case_note);
  assert_orderly();
}

static void without_a_mine(const char *mission) {
  name_case(mission, 4);
  game_setup setup = play_setup(4);
  setup.arena.mine = -2;
  play(setup);
  TEST_ASSERT_TRUE_MESSAGE(play_result.found_at < 0.0, case_note);
  TEST_ASSERT_TRUE_MESSAGE(play_result.all_stopped_at > 0.0, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(play_arena.places, play_result.scanned, case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(play_arena.robots, play_territories_done(), case_note);
  assert_orderly();
}

/* One learning for each mission serves all that is asked of it. */
static void play_mission(const char *mission) {
  play_prepare_named(mission);
  for (uint64_t seed = 1; seed <= SEEDS; seed++) find_the_mine(mission, seed);
  lose_each_robot_alone(mission);
  clear_all(mission);
  without_a_mine(mission);
}

static void test_minefield_is_searched_in_order_also_with_any_robot_lost(void) {
  play_mission(missions[0]);
}

static void test_site_is_searched_in_order_also_with_any_robot_lost(void) {
  play_mission(missions[1]);
}

static void test_warehouse_is_searched_in_order_also_with_any_robot_lost(void) {
  play_mission(missions[2]);
}

/* ---- the same again ---- */

static size_t log_bytes(const char *path, uint64_t seed, char **bytes) {
  game_setup setup = play_setup(seed);
  setup.log = path;
  play(setup);
  FILE *file = fopen(path, "rb");
  TEST_ASSERT_NOT_NULL(file);
  fseek(file, 0, SEEK_END);
  const size_t size = (size_t)ftell(file);
  rewind(file);
  *bytes = malloc(size);
  TEST_ASSERT_EQUAL_size_t(size, fread(*bytes, 1, size, file));
  fclose(file);
  return size;
}

static void test_the_same_seed_gives_the_same_log_byte_for_byte_and_another_seed_another(void) {
  char *first, *again, *other;
  play_prepare_drawn("S....1..2/.##.~~.#./S..3.~..4", 0);
  const size_t size = log_bytes("first.lcm", 5, &first);
  const size_t size_again = log_bytes("again.lcm", 5, &again);
  const size_t size_other = log_bytes("other.lcm", 6, &other);
  TEST_ASSERT_EQUAL_size_t(size, size_again);
  TEST_ASSERT_EQUAL_INT(0, memcmp(first, again, size));
  TEST_ASSERT_TRUE(size != size_other || memcmp(first, other, size) != 0);
  free(first);
  free(again);
  free(other);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_minefield_is_searched_in_order_also_with_any_robot_lost);
  RUN_TEST(test_site_is_searched_in_order_also_with_any_robot_lost);
  RUN_TEST(test_warehouse_is_searched_in_order_also_with_any_robot_lost);
  RUN_TEST(test_the_same_seed_gives_the_same_log_byte_for_byte_and_another_seed_another);
  plan_free(&play_plan);
  return UNITY_END();
}
