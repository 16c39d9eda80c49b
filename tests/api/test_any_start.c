/* profiles: host mcu */
/* Tables for any start and any progress: which games are learnt, what is recorded of them, and what robots find in
 * them. */
#include <math.h>
#include <string.h>

#include "quarter/any_start.h"
#include "quarter/deployment.h"
#include "quarter/rest.h"
#include "quarter/start_trials.h"
#include "support/tables.h"

enum { ROOM = 512 * 1024 };

static qtr_mission mission;
static qtr_game game;
static qtr_routes own_routes;
static qtr_certificate own_certificate;
static qtr_regions regions;
static uint64_t regions_scratch[(QTR_REGIONS_SCRATCH_BYTES + 7) / 8];

static uint8_t steps[64 * 1024];
static qtr_cell start[256];
static uint16_t region[256];
static uint8_t entries[ROOM];
static uint8_t large_table[ROOM];
static qtr_any_start any;
static qtr_policy policy;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* ---- set-up: the mission learnt, its map divided ---- */

static bool learn_rest(void) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  if (qtr_rest_game(&table_game, &table_mission, &table_travel) != QTR_OK) return false;
  TEST_ASSERT_EQUAL_INT(QTR_OK, ground_init(&table_ground, &table_game, &table_travel));
  TEST_ASSERT_EQUAL_INT(QTR_OK, learner_init(&table_learner, table_ground, NULL, &config));
  while (qtr_learner_step(table_learner) == QTR_LEARNING) {}
  return true;
}

static void take_routes(qtr_routes *routes) {
  qtr_play_to_routes(qtr_learner_best(table_learner), &table_game, routes);
}

static void learn_own(void) {
  table_mission = mission;
  TEST_ASSERT_TRUE(learn_rest());
  take_routes(&own_routes);
  qtr_learner_certificate(table_learner, &own_certificate);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_game_init(&game, &mission, &table_travel, NULL));
}

/* Regions of at most `most` cells; 0: none. */
static qtr_any_start_asked ask(unsigned most, bool any_cleared) {
  const qtr_grid grid = qtr_mission_grid(&mission);
  qtr_regions_config config;
  qtr_regions_default(&config);
  config.max_size = most;
  if (most > 0)
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_regions_build(&regions, &grid, &config, regions_scratch, sizeof regions_scratch));
  const qtr_any_start_asked asked = {&game, most > 0 ? &regions : NULL, any_cleared};
  return asked;
}

static void begin(unsigned most, bool any_cleared, size_t room) {
  const qtr_any_start_asked asked = ask(most, any_cleared);
  const qtr_any_start_blocks blocks = {steps, start, region, entries, room};
  qtr_any_start_sizes sizes;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_needs(&sizes, &asked));
  TEST_ASSERT_LESS_OR_EQUAL(sizeof steps, sizes.steps);
  TEST_ASSERT_LESS_OR_EQUAL(sizeof start, sizes.start);
  TEST_ASSERT_LESS_OR_EQUAL(sizeof region, sizes.region);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_init(&any, &asked, &blocks, &table_travel));
}

/* The routes of the game under way; false if it cannot be played. */
static bool find_routes(qtr_routes *routes, uint16_t *number) {
  for (uint16_t place = 0; place < mission.places; place++) number[place] = place;
  *routes = own_routes;
  if (any.is_whole) return true;
  qtr_any_start_rest(&any, &table_mission, number);
  if (!learn_rest()) return false;
  take_routes(routes);
  return true;
}

static void write(void) {
  qtr_any_start_finish(&any);
  const qtr_table_content content = qtr_any_start_content(&any, &own_certificate, 1);
  const int32_t written = qtr_table_write(&content, large_table, sizeof large_table);
  TEST_ASSERT_EQUAL_INT32_MESSAGE(qtr_table_size(&content), written, case_note);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, large_table, (uint32_t)written));
}

static void make_all(unsigned most, bool any_cleared) {
  qtr_routes routes;
  uint16_t number[QTR_MAX_PLACES];
  learn_own();
  begin(most, any_cleared, sizeof entries);
  while (qtr_any_start_next(&any))
    if (find_routes(&routes, number)) TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_add(&any, &routes, number));
  write();
}

/* ---- which games ---- */

static void test_every_crew_comes_once_and_none_twice(void) {
  mission_draw(&mission, "1..S..2/......./S......");
  learn_own();
  begin(4, false, sizeof entries);
  const unsigned count = any.regions;
  unsigned seen = 0;
  TEST_ASSERT_TRUE(qtr_any_start_next(&any));
  TEST_ASSERT_TRUE(any.is_whole);
  TEST_ASSERT_EQUAL_UINT16(count + 0, any.start_of[0]);
  TEST_ASSERT_EQUAL_UINT16(count + 1, any.start_of[1]);
  for (unsigned low = 0; low < count; low++)
    for (unsigned high = low; high < count; high++, seen++) {
      TEST_ASSERT_TRUE(qtr_any_start_next(&any));
      TEST_ASSERT_FALSE(any.is_own);
      TEST_ASSERT_EQUAL_UINT16(low, any.start_of[0]);
      TEST_ASSERT_EQUAL_UINT16(high, any.start_of[1]);
    }
  TEST_ASSERT_FALSE(qtr_any_start_next(&any));
  TEST_ASSERT_GREATER_THAN_UINT(3, count);
  TEST_ASSERT_TRUE(qtr_any_start_count_crews(&any) == (double)seen);
  TEST_ASSERT_TRUE(any.crews == (double)seen);
}

static unsigned bits_of(const qtr_places *set) {
  return set->word[0];
}

static void test_every_set_of_places_is_cleared_but_that_of_all(void) {
  mission_draw(&mission, "1..S.3.2");
  learn_own();
  begin(0, true, sizeof entries);
  for (unsigned cleared = 0; cleared < 7; cleared++) {
    TEST_ASSERT_TRUE(qtr_any_start_next(&any));
    TEST_ASSERT_EQUAL(cleared == 0, any.is_whole);
    TEST_ASSERT_EQUAL_HEX(cleared, bits_of(&any.cleared));
  }
  TEST_ASSERT_FALSE(qtr_any_start_next(&any));
  TEST_ASSERT_TRUE(qtr_any_start_count_games(&any) == 7.0);
}

/* A place alone is never cleared: nothing would be left. */
static void test_both_together_are_every_crew_with_every_set(void) {
  mission_draw(&mission, "1..S.2");
  learn_own();
  begin(2, true, sizeof entries);
  unsigned games = 0;
  while (qtr_any_start_next(&any)) games++;
  TEST_ASSERT_EQUAL_UINT(3 + 3 * any.regions, games);
  mission_draw(&mission, "1..S..");
  learn_own();
  begin(0, true, sizeof entries);
  TEST_ASSERT_TRUE(qtr_any_start_next(&any));
  TEST_ASSERT_FALSE(qtr_any_start_next(&any));
}

/* ---- what is left ---- */

static void test_rest_has_the_places_that_are_left_and_starts_where_the_crew_does(void) {
  uint16_t number[QTR_MAX_PLACES];
  qtr_places cleared;
  const qtr_cell from = 2;
  mission_draw(&mission, "1..S.3.2");
  table_mission = mission;
  qtr_places_clear(&cleared);
  qtr_places_add(&cleared, 1);
  qtr_rest_make(&table_mission, number, &mission, &from, &cleared);
  TEST_ASSERT_EQUAL_UINT16(2, table_mission.places);
  TEST_ASSERT_EQUAL_UINT16(0, number[0]);
  TEST_ASSERT_EQUAL_UINT16(2, number[1]);
  TEST_ASSERT_EQUAL_UINT32(7, table_mission.place[1]);
  TEST_ASSERT_TRUE(table_mission.weight[1] == 2.0);
  TEST_ASSERT_EQUAL_UINT32(2, table_mission.start[0]);
  qtr_rest_make(&table_mission, number, &mission, &from, NULL);
  TEST_ASSERT_EQUAL_UINT16(3, table_mission.places);
}

/* gamma^t of the only place is next to nothing: the objective gives way, and comes back with the next rest. */
static void test_rest_too_far_away_to_discount_is_played_for_time(void) {
  uint16_t number[QTR_MAX_PLACES];
  const qtr_cell far = 0;
  const qtr_cell near = 9;
  mission_draw(&mission, "S........1");
  mission.aim.gamma = 1e-6;
  table_mission = mission;
  qtr_rest_make(&table_mission, number, &mission, &far, NULL);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_rest_game(&table_game, &table_mission, &table_travel));
  TEST_ASSERT_EQUAL_UINT8(QTR_TIME, table_mission.aim.kind);
  qtr_rest_make(&table_mission, number, &mission, &near, NULL);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_rest_game(&table_game, &table_mission, &table_travel));
  TEST_ASSERT_EQUAL_UINT8(QTR_DISCOUNTED, table_mission.aim.kind);
}

/* ---- what robots find ---- */

static uint32_t play_off_table(const qtr_deployment *deployment) {
  uint32_t off_table = 0;
  for (int seeker = 0; seeker < policy.board.seekers; seeker++) {
    qtr_joint joint;
    qtr_joint_start(&joint, &policy.board, deployment->start_of, &deployment->cleared);
    while (qtr_policy_play(&policy, &joint, seeker, NULL, &off_table) != QTR_STAND_DOWN) {}
  }
  return off_table;
}

/* The n-th way to put the seekers on free cells, lower regions first: seekers are alike, crews are recorded sorted. */
static bool put(qtr_cell *cells, unsigned n) {
  const unsigned all = (unsigned)mission.columns * mission.rows;
  for (unsigned i = 0; i < mission.seekers; i++, n /= all) {
    cells[i] = (qtr_cell)(n % all);
    if (mission.cost[cells[i]] == 0) return false;
  }
  return n == 0;
}

static void expect_all_on_table(bool any_cleared) {
  const unsigned cells = (unsigned)mission.columns * mission.rows;
  const unsigned sets = any_cleared ? (1u << mission.places) - 1 : 1;
  unsigned ways = 1;
  for (unsigned i = 0; i < mission.seekers; i++) ways *= cells;
  for (unsigned n = 0; n < ways; n++) {
    qtr_cell from[QTR_MAX_SEEKERS];
    if (!put(from, n)) continue;
    for (unsigned cleared = 0; cleared < sets; cleared++) {
      qtr_deployment deployment;
      qtr_places set;
      qtr_places_clear(&set);
      set.word[0] = cleared;
      TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, &policy, from, &set));
      snprintf(case_note, sizeof case_note, "way %u, cleared %u", n, cleared);
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(0, play_off_table(&deployment), case_note);
    }
  }
}

static void test_no_robot_is_off_the_table_wherever_it_starts_and_whatever_is_cleared(void) {
  mission_draw(&mission, "1..S#..2/..~.#.../..S....3");
  make_all(6, true);
  TEST_ASSERT_GREATER_THAN_UINT(2, any.regions);
  TEST_ASSERT_TRUE(qtr_any_start_count_games(&any) + 7.0 == (double)any.games);
  expect_all_on_table(true);
}

/* Crews of one part of the map alone play for its place. */
static void test_part_of_the_map_that_a_crew_cannot_reach_is_left_out(void) {
  mission_draw(&mission, "1.S#S.2");
  make_all(1, false);
  TEST_ASSERT_EQUAL_UINT(6, any.regions);
  TEST_ASSERT_EQUAL_UINT64(1 + 21, any.games);
  expect_all_on_table(false);
}

/* From home the mission's own play, to the last step, though a region's crew meets its states too. */
static void test_mission_itself_is_played_as_certified(void) {
  for (unsigned number = 0; number < 12; number++) {
    test_random random = random_case("home", number);
    qtr_play play;
    mission_random(&mission, &random, (mission_size){5, 4, 4, 2});
    mission.rule = QTR_RULE_FREE;
    make_all(1, number % 2 == 0);
    for (unsigned place = 0; place < mission.places; place++) play.visit[place] = QTR_NEVER;
    for (int seeker = 0; seeker < mission.seekers; seeker++) {
      unsigned node = (unsigned)mission.places + policy.board.start_of[seeker];
      qtr_steps now = 0;
      qtr_joint joint;
      uint16_t place;
      qtr_joint_start(&joint, &policy.board, NULL, NULL);
      while ((place = qtr_policy_play(&policy, &joint, seeker, &now, NULL)) != QTR_STAND_DOWN) {
        play.visit[place] = now + qtr_board_steps(&policy.board, (unsigned)seeker, node, place);
        node = place;
      }
    }
    qtr_game_score(&game, play.visit, 0, &play.score);
    TEST_ASSERT_TRUE_MESSAGE(fabs(play.score.value - own_certificate.value) <= 1e-9 * own_certificate.value, case_note);
  }
}

/* From the first place on the mission's own route goes another way than those from elsewhere, which come by there too:
 * it is the one that is kept. */
static void test_in_a_state_of_several_games_the_own_one_decides(void) {
  static const uint16_t detour[3] = {0, 2, 1};
  qtr_routes routes;
  uint16_t number[QTR_MAX_PLACES];
  uint16_t choice;
  qtr_joint joint;
  mission_draw(&mission, "9..S.1..1");
  learn_own();
  memcpy(own_routes.place[0], detour, sizeof detour);
  begin(1, false, sizeof entries);
  while (qtr_any_start_next(&any)) {
    TEST_ASSERT_TRUE(find_routes(&routes, number));
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_add(&any, &routes, number));
  }
  write();
  qtr_joint_start(&joint, &policy.board, NULL, NULL);
  TEST_ASSERT_FALSE(qtr_joint_choose(&joint, &policy.board, 0, 0));
  qtr_joint_advance(&joint, &policy.board, NULL);
  TEST_ASSERT_TRUE(qtr_policy_lookup(&policy, &joint, &choice));
  TEST_ASSERT_EQUAL_UINT16(2, choice);
}

/* ---- room ---- */

static void test_game_without_room_is_recorded_once_there_is(void) {
  static uint8_t small[ROOM];
  uint16_t number[QTR_MAX_PLACES];
  qtr_routes routes;
  mission_draw(&mission, "1..S..2/...S...");
  make_all(3, true);
  const uint32_t size = qtr_any_start_content(&any, &own_certificate, 1).record_count;
  static uint8_t expected[ROOM];
  memcpy(expected, large_table, sizeof expected);
  begin(3, true, 0);
  size_t room = 0;
  unsigned refused = 0;
  while (qtr_any_start_next(&any)) {
    TEST_ASSERT_TRUE(find_routes(&routes, number));
    for (uint32_t before = any.count; qtr_any_start_add(&any, &routes, number) != QTR_OK; refused++) {
      TEST_ASSERT_EQUAL_UINT32(before, any.count);
      room += 7;
      memcpy(small, any.blocks.entries, any.blocks.entry_room);
      qtr_any_start_move(&any, small, room);
    }
  }
  TEST_ASSERT_GREATER_THAN_UINT(10, refused);
  write();
  TEST_ASSERT_EQUAL_UINT32(size, policy.records);
  TEST_ASSERT_EQUAL_MEMORY(expected, large_table, (size_t)(policy.grid.cells - large_table));
}

static void test_more_starts_than_a_table_tells_apart_are_refused(void) {
  static qtr_regions many;
  qtr_any_start_sizes sizes;
  mission_draw(&mission, "1..S..2");
  learn_own();
  const qtr_any_start_asked asked = {&game, &many, false};
  many.count = QTR_MAX_STARTS - 1;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_needs(&sizes, &asked));
  many.count = QTR_MAX_STARTS;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, qtr_any_start_needs(&sizes, &asked));
}

/* ---- trials ---- */

static void try_all(qtr_start_trials *trials) {
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_start_trials_begin(trials, 1));
  table_mission = mission;
  while (qtr_start_trials_next(trials, &policy, &mission, &table_mission))
    if (learn_rest()) qtr_start_trials_add(trials, &policy, &table_game, qtr_learner_best(table_learner)->score.worth);
}

static void test_where_each_cell_is_a_region_nothing_is_lost(void) {
  qtr_start_trials trials;
  mission_draw(&mission, "1..S#..2/..~.#.../..S....3");
  make_all(1, false);
  try_all(&trials);
  TEST_ASSERT_EQUAL_UINT16(QTR_START_TRIALS, trials.count);
  for (unsigned i = 0; i < trials.count; i++) TEST_ASSERT_TRUE(fabs(trials.loss[i]) <= 1e-5);
}

static void test_regions_that_are_larger_lose_and_losses_are_in_order(void) {
  qtr_start_trials trials;
  mission_draw(&mission, "1..S#..2/..~.#.../..S....3");
  make_all(12, false);
  try_all(&trials);
  TEST_ASSERT_EQUAL_UINT16(QTR_START_TRIALS, trials.count);
  for (unsigned i = 0; i + 1 < trials.count; i++) TEST_ASSERT_TRUE(trials.loss[i] <= trials.loss[i + 1]);
  TEST_ASSERT_TRUE(trials.loss[0] >= -1e-5);
  TEST_ASSERT_TRUE(trials.loss[trials.count - 1] > 0.001);
}

/* A trial that is not added is drawn anew, but not for ever. */
static void test_trials_end_where_nothing_can_be_tried(void) {
  qtr_start_trials trials;
  unsigned drawn = 0;
  mission_draw(&mission, "1..S..2");
  make_all(2, false);
  table_mission = mission;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_start_trials_begin(&trials, 1));
  while (qtr_start_trials_next(&trials, &policy, &mission, &table_mission)) drawn++;
  TEST_ASSERT_EQUAL_UINT(QTR_START_TRIES_MOST, drawn);
  TEST_ASSERT_EQUAL_UINT16(0, trials.count);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_crew_comes_once_and_none_twice);
  RUN_TEST(test_every_set_of_places_is_cleared_but_that_of_all);
  RUN_TEST(test_both_together_are_every_crew_with_every_set);
  RUN_TEST(test_rest_has_the_places_that_are_left_and_starts_where_the_crew_does);
  RUN_TEST(test_rest_too_far_away_to_discount_is_played_for_time);
  RUN_TEST(test_no_robot_is_off_the_table_wherever_it_starts_and_whatever_is_cleared);
  RUN_TEST(test_part_of_the_map_that_a_crew_cannot_reach_is_left_out);
  RUN_TEST(test_mission_itself_is_played_as_certified);
  RUN_TEST(test_in_a_state_of_several_games_the_own_one_decides);
  RUN_TEST(test_game_without_room_is_recorded_once_there_is);
  RUN_TEST(test_more_starts_than_a_table_tells_apart_are_refused);
  RUN_TEST(test_where_each_cell_is_a_region_nothing_is_lost);
  RUN_TEST(test_regions_that_are_larger_lose_and_losses_are_in_order);
  RUN_TEST(test_trials_end_where_nothing_can_be_tried);
  return UNITY_END();
}
