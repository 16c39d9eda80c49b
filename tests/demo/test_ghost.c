/* The game without a plan that a replay shows beside the planned one: it is that very game, kept in a bounded size. */
#include "ghost.h"
#include "play.h"

static ghost g;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void haunt(const game_setup *setup) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, ghost_play(&g, &play_plan.t, &setup->arena, NULL, &play_why), play_why.text);
}

static void test_it_finds_the_same_mine_when_robots_without_a_plan_do(void) {
  play_prepare_drawn("1...S...2/.#~..###./3.......4", 3);
  for (uint64_t seed = 1; seed <= 6; seed++) {
    game_setup setup = play_setup(seed);
    haunt(&setup);
    setup.strategy = STRATEGY_NEAREST;
    play(setup);
    TEST_ASSERT_EQUAL_DOUBLE(play_result.found_at, g.finished_at);
    TEST_ASSERT_EQUAL_INT(play_arena.mine, g.scan[g.scans - 1].place);
    TEST_ASSERT_EQUAL_DOUBLE(g.finished_at, g.scan[g.scans - 1].at);
  }
}

static void test_it_ends_soon_after_its_finish(void) {
  play_prepare_drawn("1...S...2/.#~..###./3.......4", 3);
  const game_setup setup = play_setup(3);
  haunt(&setup);
  TEST_ASSERT_DOUBLE_WITHIN(2 * ARENA_TICK, g.finished_at, g.duration);
}

static void test_where_no_find_ends_the_search_the_last_place_does(void) {
  play_prepare_drawn("1...S...2/.#~..###./3.......4", 3);
  for (int clear = 0; clear < 2; clear++) {
    game_setup setup = play_setup(5);
    setup.arena.clear_all = clear == 1;
    setup.arena.mine = clear == 1 ? 0 : -2;
    haunt(&setup);
    TEST_ASSERT_EQUAL_INT(4, g.scans);
    TEST_ASSERT_EQUAL_DOUBLE(g.scan[3].at, g.finished_at);
    for (int i = 1; i < g.scans; i++) TEST_ASSERT_TRUE(g.scan[i - 1].at <= g.scan[i].at);
  }
}

static void test_it_has_the_games_faults(void) {
  const fault_script faults = {1, {{0.0, FAULT_LOST, -1, 0.0, 0}}};
  play_prepare_drawn("1...S...2", 2);
  game_setup setup = play_setup(5);
  setup.arena.faults = &faults;
  haunt(&setup);
  TEST_ASSERT_EQUAL_INT(0, g.scans);
  TEST_ASSERT_TRUE(g.finished_at < 0.0);
}

/* A corridor of 300 cells, in seconds at least as many. */
static void test_a_long_game_is_sampled_less_often(void) {
  char rows[310];
  memset(rows, '.', 300);
  memcpy(rows, "S", 1);
  memcpy(rows + 299, "1", 2);
  play_prepare_drawn(rows, 0);
  const game_setup setup = play_setup(5);
  haunt(&setup);
  TEST_ASSERT_TRUE(g.finished_at > 250.0);
  TEST_ASSERT_TRUE(g.tick == 4 * GHOST_TICK && g.samples <= GHOST_SAMPLES && 2 * g.samples > GHOST_SAMPLES);
  TEST_ASSERT_INT_WITHIN(2, (int)(g.duration / g.tick), g.samples);
  TEST_ASSERT_INT32_WITHIN(10, 50, g.track[0][0].x);
  TEST_ASSERT_INT32_WITHIN(10, 50, g.track[0][0].y);
  /* A cell a second: what was thinned out is still where the robot was then. */
  for (int i = 10; i < g.samples - 10; i++)
    TEST_ASSERT_INT32_WITHIN(800, (int32_t)lround(100 * i * g.tick), g.track[0][i].x);
}

static void test_it_can_be_interrupted(void) {
  const volatile int interrupted = 130;
  play_prepare_drawn("1...S...2", 2);
  const game_setup setup = play_setup(5);
  TEST_ASSERT_EQUAL_INT(0, ghost_play(&g, &play_plan.t, &setup.arena, &interrupted, &play_why));
  TEST_ASSERT_DOUBLE_WITHIN(2 * ARENA_TICK, 0.0, g.duration);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_it_finds_the_same_mine_when_robots_without_a_plan_do);
  RUN_TEST(test_it_ends_soon_after_its_finish);
  RUN_TEST(test_where_no_find_ends_the_search_the_last_place_does);
  RUN_TEST(test_it_has_the_games_faults);
  RUN_TEST(test_a_long_game_is_sampled_less_often);
  RUN_TEST(test_it_can_be_interrupted);
  plan_free(&play_plan);
  return UNITY_END();
}
