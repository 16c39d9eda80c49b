/* profiles: host mcu */
/* Regions that starts are told apart by: held against travel times and distances that are worked out on their own. */
#include <math.h>
#include <string.h>

#include "quarter/start_regions.h"
#include "support/missions.h"
#include "unity.h"

enum { CASES = 30 };

static qtr_mission mission;
static qtr_game game;
static qtr_travel travel;
static qtr_regions regions, again;
static uint64_t scratch[1 << 14];

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static int build(qtr_regions *into, uint32_t most) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_LESS_OR_EQUAL_size_t(sizeof scratch, qtr_start_regions_bytes(&game, most));
  return qtr_start_regions_build(into, &game, most, &travel, scratch, sizeof scratch);
}

static unsigned cells(void) {
  return (unsigned)mission.columns * mission.rows;
}

/* ---- travel times of their own ---- */

static long way[200][QTR_MAX_PLACES]; /* from each cell to each place; -1: none */

static void measure(void) {
  static long steps[QTR_MAX_CELLS];
  TEST_ASSERT_LESS_OR_EQUAL_UINT(200, cells());
  for (unsigned cell = 0; cell < cells(); cell++) {
    if (mission.cost[cell] == 0) continue;
    flood(steps, &mission, (qtr_cell)cell);
    for (unsigned place = 0; place < mission.places; place++) way[cell][place] = steps[mission.place[place]];
  }
}

static bool reach_the_same(unsigned a, unsigned b) {
  for (unsigned place = 0; place < mission.places; place++)
    if ((way[a][place] < 0) != (way[b][place] < 0)) return false;
  return true;
}

static bool reaches_any(unsigned cell) {
  for (unsigned place = 0; place < mission.places; place++)
    if (way[cell][place] >= 0) return true;
  return false;
}

/* Squared, of two that reach the same places. */
static double distance(unsigned a, unsigned b) {
  double sum = 0.0;
  for (unsigned place = 0; place < mission.places; place++) {
    if (way[a][place] < 0) continue;
    const double apart = sqrt(game.probability[place] * way[a][place]) - sqrt(game.probability[place] * way[b][place]);
    sum += apart * apart;
  }
  return sum;
}

/* ---- what they must be ---- */

static void expect_in_order(void) {
  for (unsigned cell = 0; cell < cells(); cell++) {
    const qtr_region region = qtr_regions_of(&regions, (qtr_cell)cell);
    TEST_ASSERT_EQUAL_MESSAGE(mission.cost[cell] == 0, region == QTR_NO_REGION, case_note);
    if (region == QTR_NO_REGION) continue;
    const qtr_cell standing = regions.representative[region];
    TEST_ASSERT_EQUAL_UINT_MESSAGE(region, qtr_regions_of(&regions, standing), case_note);
    TEST_ASSERT_TRUE_MESSAGE(reach_the_same(cell, standing), case_note);
    if (!reaches_any(cell)) TEST_ASSERT_EQUAL_UINT_MESSAGE(regions.count - 1, region, case_note);
  }
}

/* Coordinates are floats: what is nearer by less than they tell apart is as near. */
static void expect_nearest(void) {
  for (unsigned cell = 0; cell < cells(); cell++) {
    const qtr_cell standing = qtr_regions_standing(&regions, (qtr_cell)cell);
    for (uint32_t r = 0; standing != QTR_NO_CELL && r < regions.count; r++) {
      const qtr_cell other = regions.representative[r];
      if (!reach_the_same(cell, other)) continue;
      TEST_ASSERT_TRUE_MESSAGE(distance(cell, standing) <= distance(cell, other) + 1e-4, case_note);
    }
  }
}

static void test_cells_go_by_the_nearest_that_reaches_what_they_reach(void) {
  for (unsigned number = 0; number < CASES; number++) {
    test_random random = random_case("regions", number);
    mission_random(&mission, &random, (mission_size){12, 12, 6, 3});
    measure();
    if (build(&regions, random_in(&random, 4, 20)) == QTR_ERR_LIMIT) continue;
    expect_in_order();
    expect_nearest();
  }
}

static void test_with_regions_enough_all_cells_of_one_are_as_far_from_all_places(void) {
  for (unsigned number = 0; number < CASES; number++) {
    test_random random = random_case("enough", number);
    mission_random(&mission, &random, (mission_size){9, 9, 5, 3});
    measure();
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, build(&regions, cells()), case_note);
    for (unsigned cell = 0; cell < cells(); cell++) {
      const qtr_cell standing = qtr_regions_standing(&regions, (qtr_cell)cell);
      if (standing == QTR_NO_CELL) continue;
      TEST_ASSERT_EQUAL_MEMORY_MESSAGE(way[standing], way[cell], mission.places * sizeof way[cell][0], case_note);
    }
  }
}

static void test_they_are_no_more_than_asked_for_but_for_cells_cut_off(void) {
  mission_draw(&mission, "1..S....#.#/......2.#.#/........#.#");
  for (uint32_t most = 1; most < 12; most++) {
    TEST_ASSERT_EQUAL_INT(QTR_OK, build(&regions, most));
    TEST_ASSERT_EQUAL_UINT32(most + 1, regions.count);
    TEST_ASSERT_EQUAL_UINT(most, qtr_regions_of(&regions, 9));
    TEST_ASSERT_EQUAL_UINT16(3, regions.size[most]);
  }
}

static void test_map_of_more_parts_than_regions_is_refused(void) {
  mission_draw(&mission, "1.S#S.2#S.3");
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, build(&regions, 2));
  TEST_ASSERT_EQUAL_INT(QTR_OK, build(&regions, 3));
  measure();
  expect_in_order();
}

static void test_same_input_gives_the_same_regions(void) {
  mission_draw(&mission, "1..S....#../......2.#../...~~...#..");
  TEST_ASSERT_EQUAL_INT(QTR_OK, build(&regions, 5));
  memset(scratch, 0xA5, sizeof scratch);
  TEST_ASSERT_EQUAL_INT(QTR_OK, build(&again, 5));
  TEST_ASSERT_EQUAL_MEMORY(regions.of, again.of, cells() * sizeof regions.of[0]);
  TEST_ASSERT_EQUAL_MEMORY(regions.representative, again.representative, 5 * sizeof regions.representative[0]);
}

#if QTR_TERMS
/* Rough ground from which one of two classes has no way, and smooth ground from which both have. */
static void test_ground_of_one_class_alone_is_told_apart(void) {
  mission_draw(&mission, "1..S..~~~2");
  mission_crew(&mission, 2);
  mission.classes = 2;
  qtr_robot_class_default(&mission.robot_class[1]);
  mission.robot_class[1].smooth_only = true;
  mission.class_of[1] = 1;
  TEST_ASSERT_EQUAL_INT(QTR_OK, build(&regions, 3));
  TEST_ASSERT_TRUE(qtr_regions_of(&regions, 5) != qtr_regions_of(&regions, 6));
  TEST_ASSERT_TRUE(qtr_regions_of(&regions, 8) != qtr_regions_of(&regions, 9));
  TEST_ASSERT_EQUAL_UINT(qtr_regions_of(&regions, 6), qtr_regions_of(&regions, 8));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, build(&regions, 2));
}
#endif

static bool never(void *nothing) {
  (void)nothing;
  return false;
}

static void test_what_cannot_be_built_is_refused(void) {
  mission_draw(&mission, "1..S....2");
  TEST_ASSERT_EQUAL_INT(QTR_OK, build(&regions, 3));
  const size_t bytes = qtr_start_regions_bytes(&game, 3);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_start_regions_build(&regions, &game, 3, &travel, scratch, bytes));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_SPACE, qtr_start_regions_build(&regions, &game, 3, &travel, scratch, bytes - 1));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT,
                        qtr_start_regions_build(&regions, &game, 3, &travel, (uint8_t *)scratch + 1, bytes));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_start_regions_build(&regions, &game, 0, &travel, scratch, bytes));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CONFIG, qtr_start_regions_build_built(&regions, &game, 3, &travel, scratch, bytes, 1));
  mission.watch = (qtr_watch){never, NULL};
  TEST_ASSERT_EQUAL_INT(QTR_ERR_STOPPED, qtr_start_regions_build(&regions, &game, 3, &travel, scratch, bytes));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_cells_go_by_the_nearest_that_reaches_what_they_reach);
  RUN_TEST(test_with_regions_enough_all_cells_of_one_are_as_far_from_all_places);
  RUN_TEST(test_they_are_no_more_than_asked_for_but_for_cells_cut_off);
  RUN_TEST(test_map_of_more_parts_than_regions_is_refused);
  RUN_TEST(test_same_input_gives_the_same_regions);
#if QTR_TERMS
  RUN_TEST(test_ground_of_one_class_alone_is_told_apart);
#endif
  RUN_TEST(test_what_cannot_be_built_is_refused);
  return UNITY_END();
}
