/* profiles: host mcu */
/* Hiding spots: which places are together, against the limits and against all ways there are of grouping them. */
#include <math.h>
#include <string.h>

#include "quarter/spots.h"
#include "support/settings.h"
#include "support/spot_ground.h"
#include "unity.h"

enum { SMALL = 10 };

static qtr_spots_config config;
static qtr_spots spots, again, scratch;

void setUp(void) {
  memset(&spots, 0xA5, sizeof spots);
  config = spot_limits(QTR_MAX_SPOT_SIZE, 10, 0.0);
}

void tearDown(void) {
}

static void build(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_spots_build(&spots, &ground, &config, &scratch), case_note);
}

/* ---- what a spot may be, from the header's words ---- */

static bool may_be_together(unsigned p, unsigned q) {
  const double more = fmax(mission.weight[p], mission.weight[q]);
  const double less = fmin(mission.weight[p], mission.weight[q]);
  const double distance = fmax(way_of(p, q), way_of(q, p));
  return distance <= config.diameter && distance * (1 + config.likelihood * (more / less - 1)) <= config.diameter;
}

static void expect_partition(void) {
  unsigned seen = 0;
  unsigned lowest_before = 0;
  for (unsigned s = 0; s < spots.count; s++) {
    TEST_ASSERT_TRUE_MESSAGE(spots.size[s] >= 1 && spots.size[s] <= config.size, case_note);
    TEST_ASSERT_TRUE_MESSAGE(s == 0 || spots.place[s][0] > lowest_before, case_note);
    lowest_before = spots.place[s][0];
    for (unsigned i = 0; i < spots.size[s]; i++) {
      TEST_ASSERT_TRUE_MESSAGE(i == 0 || spots.place[s][i] > spots.place[s][i - 1], case_note);
      TEST_ASSERT_TRUE_MESSAGE(spots.place[s][i] < ground.places, case_note);
      TEST_ASSERT_EQUAL_UINT_MESSAGE(s, spots.spot_of[spots.place[s][i]], case_note);
      seen++;
    }
  }
  TEST_ASSERT_EQUAL_UINT_MESSAGE(ground.places, seen, case_note);
}

static void expect_limits_kept(void) {
  for (unsigned p = 0; p < ground.places; p++)
    for (unsigned q = 0; q < ground.places; q++)
      if (p != q && spots.spot_of[p] == spots.spot_of[q]) TEST_ASSERT_TRUE_MESSAGE(may_be_together(p, q), case_note);
}

static bool are_one_spot(unsigned s, unsigned t) {
  if (spots.size[s] + spots.size[t] > config.size) return false;
  for (unsigned i = 0; i < spots.size[s]; i++)
    for (unsigned j = 0; j < spots.size[t]; j++)
      if (!may_be_together(spots.place[s][i], spots.place[t][j])) return false;
  return true;
}

/* ---- invariants ---- */

static void random_config(test_random *random) {
  config.size = (uint8_t)random_in(random, 1, QTR_MAX_SPOT_SIZE);
  config.diameter = random_in(random, 1, 60);
  config.likelihood = random_chance(random, 50) ? 0.0 : 2.0 * random_unit(random);
}

static void test_every_place_is_in_one_spot_within_the_limits_on_any_map(void) {
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("spots of random maps", number);
    mission_random(&mission, &random, (mission_size){20, 20, 16, 2});
    measure();
    random_config(&random);
    build();
    expect_partition();
    expect_limits_kept();
  }
}

static void test_no_two_spots_could_be_one(void) {
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("spots that are apart", number);
    mission_random(&mission, &random, (mission_size){20, 20, 16, 2});
    measure();
    random_config(&random);
    build();
    for (unsigned s = 0; s < spots.count; s++)
      for (unsigned t = 0; t < s; t++) TEST_ASSERT_FALSE_MESSAGE(are_one_spot(s, t), case_note);
  }
}

static void test_many_places(void) {
  test_random random = random_case("all places", 1);
  scatter(&random, QTR_MAX_PLACES < 200 ? QTR_MAX_PLACES : 200, 40);
  config.diameter = 25;
  build();
  expect_partition();
  expect_limits_kept();
}

static void test_building_twice_gives_the_same(void) {
  test_random random = random_case("twice", 1);
  scatter(&random, QTR_MAX_PLACES < 200 ? QTR_MAX_PLACES : 200, 40);
  config = spot_limits(QTR_MAX_SPOT_SIZE, 30, 0.3);
  build();
  again = spots;
  memset(&spots, 0x5A, sizeof spots);
  build();
  TEST_ASSERT_EQUAL_UINT(again.count, spots.count);
  TEST_ASSERT_EQUAL_MEMORY(again.spot_of, spots.spot_of, ground.places * sizeof *spots.spot_of);
}

/* ---- few spots ---- */

static bool is_a_spot(unsigned set) {
  unsigned members = 0;
  for (unsigned p = 0; p < ground.places; p++) {
    if (!(set >> p & 1u)) continue;
    members++;
    for (unsigned q = 0; q < p; q++)
      if ((set >> q & 1u) && !may_be_together(p, q)) return false;
  }
  return members <= config.size;
}

/* The fewest spots there can be, by going through all sets of places. */
static unsigned fewest(void) {
  static uint8_t least[1 << SMALL];
  static bool fits[1 << SMALL];
  for (unsigned set = 1; set < 1u << ground.places; set++) {
    fits[set] = is_a_spot(set);
    least[set] = UINT8_MAX;
    for (unsigned part = set; part > 0; part = (part - 1) & set)
      if (fits[part] && least[set ^ part] + 1 < least[set]) least[set] = (uint8_t)(least[set ^ part] + 1);
  }
  return least[(1u << ground.places) - 1];
}

static void test_seldom_more_spots_than_need_be_and_never_by_more_than_one(void) {
  unsigned needless = 0;
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("fewest spots", number);
    scatter(&random, SMALL, 30);
    random_config(&random);
    build();
    const unsigned least = fewest();
    TEST_ASSERT_TRUE_MESSAGE(spots.count >= least && spots.count <= least + 1, case_note);
    needless += spots.count - least;
  }
  TEST_ASSERT_LESS_OR_EQUAL_UINT(10, needless);
}

/* A map as that of the paper's Fig. 5.5: 657 free cells, 12 places, size 5, diameter 25. The paper has 8 spots. */
static void test_the_paper_s_setting_gives_no_more_spots_than_the_paper(void) {
  mission_draw(&mission, "..1.........................##/"
                         ".........................1..##/"
                         "............................##/"
                         "............................##/"
                         "...##....1............##....##/"
                         "...###............###.##....##/"
                         ".######......#....###.##.....#/"
                         ".######......#....#######....#/"
                         "..####...########.#######....#/"
                         "1.####.......#........###....#/"
                         "..##.#....####...1...........#/"
                         "..##.#....####...............#/"
                         ".....#.......#.########......./"
                         ".............##.............../"
                         ".............##.............../"
                         ".............##.1............./"
                         ".............##.............../"
                         "........####.##.......1......./"
                         "......######.#####............/"
                         "1....###...1...###............/"
                         "###..###..########....######../"
                         "###..###########......######../"
                         "###...########...............#/"
                         "###...##.###.......###.......#/"
                         "###......###.......######1...#/"
                         "###........1.......######....#/"
                         "..#..................####....#/"
                         "..#####.............1........#/"
                         "...####......................#/"
                         ".............................#");
  unsigned free_cells = 0;
  for (unsigned cell = 0; cell < 900; cell++) free_cells += mission.cost[cell] > 0;
  TEST_ASSERT_EQUAL_UINT(657, free_cells);
  TEST_ASSERT_EQUAL_UINT(12, mission.places);
  measure();
  config = spot_limits(5, 25, 0.0);
  build();
  expect_partition();
  expect_limits_kept();
  TEST_ASSERT_LESS_OR_EQUAL_UINT(8, spots.count);
}

static void test_places_that_are_closer_come_together(void) {
  /* 0 1 . . 4 5 . . . 9 10: pairs, not a pair across a gap */
  corridor(6, (int[]){0, 1, 4, 5, 9, 10}, (double[]){1, 1, 1, 1, 1, 1}, 0);
  config = spot_limits(2, 5, 0.0);
  build();
  TEST_ASSERT_EQUAL_UINT(3, spots.count);
  for (unsigned p = 0; p < 6; p++) TEST_ASSERT_EQUAL_UINT(p / 2, spots.spot_of[p]);
}

static void test_a_spot_is_emptied_into_the_others(void) {
  corridor(6, (int[]){0, 3, 5, 8, 10, 13}, (double[]){1, 1, 1, 1, 1, 1}, 0);
  config = spot_limits(2, 3, 0.0);
  build(); /* joining 3 with 5 and 8 with 10 would leave 0 and 13 alone: four spots */
  TEST_ASSERT_EQUAL_UINT(3, spots.count);
}

static void test_size_one_leaves_every_place_alone(void) {
  corridor(4, (int[]){0, 1, 2, 3}, (double[]){1, 1, 1, 1}, 0);
  config.size = 1;
  build();
  TEST_ASSERT_EQUAL_UINT(4, spots.count);
}

static void test_the_longer_way_counts_where_the_two_differ(void) {
  corridor(2, (int[]){0, 4}, (double[]){1, 1}, 0);
  set_way(0, 1, 11);
  build();
  TEST_ASSERT_EQUAL_UINT(2, spots.count);
  set_way(0, 1, 10);
  build();
  TEST_ASSERT_EQUAL_UINT(1, spots.count);
}

static void test_no_way_back_is_no_spot(void) {
  corridor(2, (int[]){0, 4}, (double[]){1, 1}, 0);
  set_way(1, 0, QTR_NEVER);
  config.diameter = QTR_NEVER - 1;
  build();
  TEST_ASSERT_EQUAL_UINT(2, spots.count);
}

/* ---- likelihood ---- */

static void test_likely_places_are_not_held_back_by_an_unlikely_one_between(void) {
  corridor(3, (int[]){0, 2, 4}, (double[]){9, 1, 9}, 0);
  config.diameter = 6;
  build();
  TEST_ASSERT_EQUAL_UINT(1, spots.count); /* by distance alone */
  config.likelihood = 1.0;
  build(); /* 2 steps at nine times the likelihood are 18; the likely two are 4 apart */
  TEST_ASSERT_EQUAL_UINT(2, spots.count);
  TEST_ASSERT_EQUAL_UINT(spots.spot_of[0], spots.spot_of[2]);
  TEST_ASSERT_EQUAL_UINT(1, spots.spot_of[1]);
  config.likelihood = 0.25;
  build(); /* 2 * (1 + 0.25 * 8) = 6 */
  TEST_ASSERT_EQUAL_UINT(1, spots.count);
}

static void test_equal_places_are_held_apart_by_no_weight(void) {
  corridor(3, (int[]){0, 5, 10}, (double[]){0.2, 0.2, 0.2}, 0);
  config.likelihood = 1e300;
  build();
  TEST_ASSERT_EQUAL_UINT(1, spots.count);
}

static void test_distance_alone_needs_no_likelihoods(void) {
  corridor(3, (int[]){0, 5, 10}, (double[]){1, 1, 1}, 0);
  ground.probability = NULL;
  build();
  TEST_ASSERT_EQUAL_UINT(1, spots.count);
}

/* ---- refusals ---- */

static void expect_refusal(int status, qtr_spots_config wrong) {
  TEST_ASSERT_EQUAL_INT(status, qtr_spots_build(&spots, &ground, &wrong, &scratch));
}

static void test_sizes_diameters_and_weights_out_of_range_are_refused(void) {
  corridor(2, (int[]){0, 4}, (double[]){1, 1}, 0);
  expect_refusal(QTR_ERR_ARGUMENT, spot_limits(0, 10, 0.0));
  expect_refusal(QTR_ERR_LIMIT, spot_limits(QTR_MAX_SPOT_SIZE + 1, 10, 0.0));
  expect_refusal(QTR_ERR_ARGUMENT, spot_limits(1, 0, 0.0));
  expect_refusal(QTR_ERR_ARGUMENT, spot_limits(1, QTR_NEVER, 0.0));
  expect_refusal(QTR_ERR_ARGUMENT, spot_limits(1, 10, -0.1));
  expect_refusal(QTR_ERR_ARGUMENT, spot_limits(1, 10, (double)NAN));
  expect_refusal(QTR_ERR_ARGUMENT, spot_limits(1, 10, (double)INFINITY));
}

static void test_grounds_that_are_none_are_refused(void) {
  corridor(2, (int[]){0, 4}, (double[]){1, 0}, 0);
  expect_refusal(QTR_OK, spot_limits(1, 10, 0.0));
  expect_refusal(QTR_ERR_WEIGHT, spot_limits(1, 10, 1.0));
  ground.places = 0;
  expect_refusal(QTR_ERR_ARGUMENT, config);
  ground.places = QTR_MAX_PLACES + 1;
  expect_refusal(QTR_ERR_LIMIT, config);
  ground.places = 2;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CONFIG, qtr_spots_build_sized(&spots, &ground, &config, &scratch, QTR_CONFIG_ID + 1u));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_place_is_in_one_spot_within_the_limits_on_any_map);
  RUN_TEST(test_no_two_spots_could_be_one);
  RUN_TEST(test_many_places);
  RUN_TEST(test_building_twice_gives_the_same);
  RUN_TEST(test_seldom_more_spots_than_need_be_and_never_by_more_than_one);
  RUN_TEST(test_the_paper_s_setting_gives_no_more_spots_than_the_paper);
  RUN_TEST(test_places_that_are_closer_come_together);
  RUN_TEST(test_a_spot_is_emptied_into_the_others);
  RUN_TEST(test_size_one_leaves_every_place_alone);
  RUN_TEST(test_the_longer_way_counts_where_the_two_differ);
  RUN_TEST(test_no_way_back_is_no_spot);
  RUN_TEST(test_likely_places_are_not_held_back_by_an_unlikely_one_between);
  RUN_TEST(test_equal_places_are_held_apart_by_no_weight);
  RUN_TEST(test_distance_alone_needs_no_likelihoods);
  RUN_TEST(test_sizes_diameters_and_weights_out_of_range_are_refused);
  RUN_TEST(test_grounds_that_are_none_are_refused);
  return UNITY_END();
}
