/* profiles: host mcu */
/* Topological aggregation: regions in order on any map, by all-pairs distances worked out on their own; and fewer and
 * tighter than a plain greedy makes them. */
#include <math.h>
#include <string.h>

#include "aggregate/division.h"
#include "quarter/regions.h"
#include "support/distances.h"
#include "unity.h"

static qtr_regions_config config;
static qtr_regions regions, again;
static uint64_t scratch[(QTR_REGIONS_SCRATCH_BYTES + 7) / 8];

void setUp(void) {
  begin_map();
  qtr_regions_default(&config);
  snprintf(case_note, sizeof case_note, "%s", "");
}

void tearDown(void) {
}

static void build(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch),
                                case_note);
}

/* Rooms of 3 to 8 cells a side, whose walls have a gap here and there. */
static void build_rooms(test_random *random, unsigned side) {
  const unsigned room = random_in(random, 4, 9);
  scatter(random, side, side, 0, 1);
  for (unsigned cell = 0; cell < side * side; cell++)
    if ((cell % side % room == 0 || cell / side % room == 0) && !random_chance(random, 12)) cost[cell] = 0;
}

/* ---- what a division must be ---- */

typedef struct {
  int cell[CELLS], size;
} members;

static void gather(members *found, uint32_t region) {
  found->size = 0;
  for (int i = 0; i < free_count; i++)
    if (qtr_regions_of(&regions, (qtr_cell)free_cell[i]) == region) found->cell[found->size++] = free_cell[i];
}

static long sum_of(const members *of, int from) {
  long sum = 0;
  for (int i = 0; i < of->size; i++) sum += apart[from][of->cell[i]];
  return sum;
}

/* The first member with the least sum. */
static int median_of(const members *of) {
  int median = of->cell[0];
  for (int i = 1; i < of->size; i++)
    if (sum_of(of, of->cell[i]) < sum_of(of, median)) median = of->cell[i];
  return median;
}

/* Spread from the first member until nothing is added. */
static bool is_connected(const members *of) {
  bool in[CELLS] = {true};
  int count = 1;
  for (int before = 0; before < count;) {
    before = count;
    for (int i = 0; i < of->size * of->size; i++) {
      const int a = i / of->size;
      const int b = i % of->size;
      if (!in[a] || in[b] || !are_beside(of->cell[a], of->cell[b])) continue;
      in[b] = true;
      count++;
    }
  }
  return count == of->size;
}

static int width_of(const members *of) {
  int widest = 0;
  for (int i = 0; i < of->size; i++)
    for (int k = 0; k < i; k++)
      if (apart[of->cell[i]][of->cell[k]] > widest) widest = apart[of->cell[i]][of->cell[k]];
  return widest;
}

/* The map's distances must have been worked out. */
static void expect_order(void) {
  static members of;
  int covered = 0;
  int lowest = -1;
  for (int cell = 0; cell < grid.columns * grid.rows; cell++)
    TEST_ASSERT_EQUAL_INT_MESSAGE(cost[cell] == 0, regions.of[cell] == QTR_NO_REGION, case_note);
  for (uint32_t region = 0; region < regions.count; region++) {
    gather(&of, region);
    TEST_ASSERT_GREATER_THAN_INT_MESSAGE(0, of.size, case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(of.size, regions.size[region], case_note);
    TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE((int)config.max_size, of.size, case_note);
    TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE((int)config.diameter, width_of(&of), case_note);
    TEST_ASSERT_TRUE_MESSAGE(is_connected(&of), case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(median_of(&of), (int)regions.representative[region], case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(median_of(&of), (int)qtr_regions_standing(&regions, (qtr_cell)of.cell[0]), case_note);
    TEST_ASSERT_GREATER_THAN_INT_MESSAGE(lowest, of.cell[0], case_note);
    lowest = of.cell[0];
    covered += of.size;
  }
  TEST_ASSERT_EQUAL_INT_MESSAGE(free_count, covered, case_note);
}

static void build_and_expect_order(void) {
  build();
  work_out_distances();
  expect_order();
}

static double mean_error(void) {
  long sum = 0;
  for (int i = 0; i < free_count; i++)
    sum += apart[free_cell[i]][qtr_regions_standing(&regions, (qtr_cell)free_cell[i])];
  return (double)sum / free_count;
}

/* ---- a plain greedy: each cell in reading order that has no region starts one, which takes what it meets ---- */

static bool may_join(const members *of, int cell) {
  for (int i = 0; i < of->size; i++)
    if (apart[cell][of->cell[i]] > (int)config.diameter) return false;
  return true;
}

static void fill_plainly(members *of, bool *taken) {
  for (int i = 0; i < of->size; i++)
    for (int k = 0; k < free_count && of->size < (int)config.max_size; k++) {
      const int cell = free_cell[k];
      if (taken[cell] || !are_beside(of->cell[i], cell) || !may_join(of, cell)) continue;
      taken[cell] = true;
      of->cell[of->size++] = cell;
    }
}

/* How many regions, and the mean distance from their medians. */
static int divide_plainly(double *mean) {
  static members of;
  bool taken[CELLS] = {false};
  long sum = 0;
  int count = 0;
  for (int i = 0; i < free_count; i++) {
    if (taken[free_cell[i]]) continue;
    taken[free_cell[i]] = true;
    of.cell[0] = free_cell[i];
    of.size = 1;
    fill_plainly(&of, taken);
    sum += sum_of(&of, median_of(&of));
    count++;
  }
  *mean = (double)sum / free_count;
  return count;
}

/* ---- tests ---- */

static void test_regions_are_in_order_on_small_random_maps(void) {
  static const unsigned costs[4] = {1, 1, 4, 255};
  for (unsigned i = 0; i < 600; i++) {
    test_random random = random_case("small", i);
    const unsigned dearest = costs[random_below(&random, 4)];
    scatter(&random, random_in(&random, 1, 14), random_in(&random, 1, 14), random_below(&random, 60), dearest);
    config.max_size = random_in(&random, 1, 30);
    config.diameter = random_in(&random, 1, 20 * dearest);
    build_and_expect_order();
  }
}

static void test_regions_are_in_order_on_large_random_maps(void) {
  for (unsigned i = 0; i < 10; i++) {
    test_random random = random_case("large", i);
    scatter(&random, 30, 30, 20 + 3 * i, i % 3 == 0 ? 9 : 1);
    config.max_size = random_in(&random, 20, 255);
    config.diameter = random_in(&random, 10, 80);
    build_and_expect_order();
  }
}

static void test_regions_are_in_order_in_rooms(void) {
  for (unsigned i = 0; i < 6; i++) {
    test_random random = random_case("rooms", i);
    build_rooms(&random, 28);
    build_and_expect_order();
  }
}

static void test_the_same_map_gives_the_same_regions(void) {
  test_random random = random_case("same", 0);
  scatter(&random, 30, 30, 25, 3);
  build();
  again = regions;
  memset(scratch, 0xA5, sizeof scratch);
  memset(&regions, 0xA5, sizeof regions);
  build();
  TEST_ASSERT_EQUAL_UINT32(again.count, regions.count);
  TEST_ASSERT_EQUAL_MEMORY(again.of, regions.of, 900 * sizeof *regions.of);
  TEST_ASSERT_EQUAL_MEMORY(again.representative, regions.representative, regions.count * sizeof(qtr_cell));
  TEST_ASSERT_EQUAL_MEMORY(again.size, regions.size, regions.count * sizeof *regions.size);
}

static void test_a_map_of_bits_gives_the_regions_of_its_bytes(void) {
  static uint8_t bits[(CELLS + 7) / 8];
  test_random random = random_case("bits", 0);
  scatter(&random, 29, 31, 30, 1);
  build();
  again = regions;
  for (unsigned cell = 0; cell < 29 * 31; cell++)
    if (cost[cell] != 0) bits[cell / 8] |= (uint8_t)(1u << cell % 8);
  grid.encoding = QTR_GRID_BITS;
  grid.cells = bits;
  build();
  TEST_ASSERT_EQUAL_UINT32(again.count, regions.count);
  TEST_ASSERT_EQUAL_MEMORY(again.of, regions.of, 29 * 31 * sizeof *regions.of);
}

static void test_a_single_cell_is_a_region(void) {
  draw(".");
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(1, regions.count);
}

static void test_a_map_without_free_cells_has_no_regions(void) {
  draw("##/##");
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(0, regions.count);
}

static void test_a_corridor_is_cut_where_the_diameter_ends(void) {
  draw("................................"); /* 32 cells: 16 of them are 15 steps from end to end */
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(2, regions.count);
  TEST_ASSERT_EQUAL_UINT32(7, regions.representative[0]); /* 7 and 8 are medians of 0..15: the lower one counts */
  TEST_ASSERT_EQUAL_UINT32(23, regions.representative[1]);
}

static void test_diameter_1_pairs_cells_that_are_side_by_side(void) {
  draw("....../......");
  config.diameter = 1;
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(6, regions.count);
}

static void test_size_1_makes_every_free_cell_a_region(void) {
  draw("..#/#..");
  config.max_size = 1;
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(4, regions.count);
  TEST_ASSERT_EQUAL_UINT32(5, regions.representative[3]);
}

static void test_pockets_that_cannot_be_reached_are_regions_of_their_own(void) {
  draw(".#./##./.#.");
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(3, regions.count);
}

static void test_with_terrain_the_longer_direction_counts(void) {
  draw(".~"); /* 3 steps to the right, 1 to the left */
  config.diameter = 2;
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(2, regions.count);
  config.diameter = 3;
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(1, regions.count);
}

/* ---- likelihoods ---- */

enum { PLACES = 12 };
static qtr_cell place[PLACES];
static double weight[PLACES];

static void use_places(uint16_t places, double likelihood) {
  config.places = places;
  config.place = place;
  config.weight = weight;
  config.likelihood = likelihood;
}

/* Places on free cells, each on one of its own or with another. */
static void strew_places(test_random *random) {
  if (free_count == 0) return;
  for (unsigned p = 0; p < PLACES; p++) {
    place[p] = (qtr_cell)free_cell[random_below(random, (unsigned)free_count)];
    weight[p] = random_in(random, 1, 9);
  }
  use_places(PLACES, random_in(random, 0, 8) / 4.0);
}

static void expect_likes_together(void) {
  for (unsigned p = 0; p < config.places; p++)
    for (unsigned q = 0; q < p; q++) {
      const double ratio = weight[p] > weight[q] ? weight[p] / weight[q] : weight[q] / weight[p];
      if (regions.of[place[p]] != regions.of[place[q]]) continue;
      TEST_ASSERT_TRUE_MESSAGE(apart[place[p]][place[q]] * (1.0 + config.likelihood * (ratio - 1.0)) <= config.diameter,
                               case_note);
    }
}

static void test_unlike_places_are_kept_apart_and_regions_stay_in_order(void) {
  for (unsigned i = 0; i < 200; i++) {
    test_random random = random_case("likelihood", i);
    scatter(&random, random_in(&random, 1, 14), random_in(&random, 1, 14), random_below(&random, 50), i % 2 ? 4 : 1);
    config.max_size = random_in(&random, 1, 30);
    config.diameter = random_in(&random, 1, 30);
    work_out_distances();
    strew_places(&random);
    build();
    expect_order();
    expect_likes_together();
  }
}

static void test_a_likely_place_parts_from_an_unlikely_one(void) {
  draw(".......");
  place[0] = 1;
  place[1] = 5; /* 4 steps away: with weight 1 counted as 4 * 9, with weight 1/4 as 4 * 3 */
  weight[0] = 9.0;
  weight[1] = 1.0;
  use_places(2, 1.0);
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(2, regions.count);
  TEST_ASSERT_NOT_EQUAL(regions.of[1], regions.of[5]);
  config.likelihood = 0.25;
  build_and_expect_order();
  TEST_ASSERT_EQUAL_UINT32(1, regions.count);
}

static void test_likelihood_0_and_places_that_are_alike_change_nothing(void) {
  test_random random = random_case("blind", 0);
  scatter(&random, 30, 30, 25, 3);
  build();
  again = regions;
  work_out_distances();
  strew_places(&random);
  for (int alike = 0; alike < 2; alike++) {
    config.likelihood = alike ? 1000.0 : 0.0;
    for (unsigned p = 0; alike && p < PLACES; p++) weight[p] = 2.5;
    build();
    TEST_ASSERT_EQUAL_UINT32(again.count, regions.count);
    TEST_ASSERT_EQUAL_MEMORY(again.of, regions.of, 900 * sizeof *regions.of);
    TEST_ASSERT_EQUAL_MEMORY(again.representative, regions.representative, regions.count * sizeof(qtr_cell));
  }
}

static void expect_places_refused(int status) {
  TEST_ASSERT_EQUAL_INT(status, qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch));
}

static void test_places_out_of_range_are_refused(void) {
  draw("...");
  place[0] = 2;
  weight[0] = 1.0;
  use_places(1, 1.0);
  expect_places_refused(QTR_OK);
  place[0] = 3;
  expect_places_refused(QTR_ERR_PLACE);
  place[0] = 2;
  weight[0] = 0.0;
  expect_places_refused(QTR_ERR_WEIGHT);
  weight[0] = HUGE_VAL;
  expect_places_refused(QTR_ERR_WEIGHT);
  config.places = QTR_MAX_PLACES + 1;
  expect_places_refused(QTR_ERR_LIMIT);
  config.likelihood = -1.0;
  expect_places_refused(QTR_ERR_ARGUMENT);
  config.likelihood = NAN;
  expect_places_refused(QTR_ERR_ARGUMENT);
}

static int build_within(uint32_t max_size, uint32_t diameter) {
  config.max_size = max_size;
  config.diameter = diameter;
  TEST_ASSERT_EQUAL_INT(qtr_regions_check(&config),
                        qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch));
  return qtr_regions_check(&config);
}

static void test_limits_out_of_range_are_refused(void) {
  draw("..");
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, build_within(0, 15));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, build_within(25, 0));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, build_within(QTR_MAX_REGION_SIZE + 1, 15));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, build_within(25, QTR_MAX_REGION_DIAMETER + 1));
  TEST_ASSERT_EQUAL_INT(QTR_OK, build_within(QTR_MAX_REGION_SIZE, QTR_MAX_REGION_DIAMETER));
}

static void test_a_grid_out_of_range_is_refused(void) {
  grid.columns = 1;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch));
  grid.columns = grid.rows = 65535;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch));
}

static void test_more_regions_than_the_build_holds_are_refused(void) {
  test_random random = random_case("many", 0);
  if (QTR_MAX_REGIONS >= QTR_MAX_CELLS) TEST_IGNORE_MESSAGE("this build holds a region for every cell");
  scatter(&random, 1024, QTR_MAX_CELLS / 1024, 0, 1);
  config.max_size = 1;
  TEST_ASSERT_EQUAL_INT(QTR_ERR_LIMIT, qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch));
}

/* Nine times the cells take nine times the work, and somewhat more on a small map, whose edge cuts searches short. No
 * cell's work is more than that of a few searches. */
static void test_work_grows_with_the_cells(void) {
  double work[3];
  const unsigned most = QTR_MAX_CELLS >= 270 * 270 ? 270 : 30;
  config.max_size = config.diameter = 5;
  for (unsigned i = 0, side = most / 9; i < 3; i++, side *= 3) {
    test_random random = random_case("work", i);
    scatter(&random, side, side, 20, 1);
    build();
    work[i] = (double)((const qtr_regions_scratch *)(void *)scratch)->nearby.work / (side * side);
  }
  for (int i = 0; i < 3; i++) TEST_ASSERT_TRUE(work[i] < 80);
  TEST_ASSERT_TRUE(work[2] < 1.5 * work[1]);
}

static void test_the_papers_map_takes_no_more_regions_than_the_papers(void) {
  double plain;
  draw_file(QUARTER_SOURCE_DIR "/demo/missions/paper/fig53.txt");
  build_and_expect_order();
  TEST_ASSERT_EQUAL_INT(657, free_count);
  const int plainly = divide_plainly(&plain);
  snprintf(case_note, sizeof case_note, "%u regions, mean %.3f; plainly %d, mean %.3f", (unsigned)regions.count,
           mean_error(), plainly, plain);
  TEST_ASSERT_LESS_OR_EQUAL_UINT32_MESSAGE(43, regions.count, case_note);
  TEST_ASSERT_LESS_OR_EQUAL_INT_MESSAGE(plainly, (int)regions.count, case_note);
  TEST_ASSERT_TRUE_MESSAGE(mean_error() < plain, case_note);
  TEST_MESSAGE(case_note);
}

static void test_there_are_fewer_regions_than_a_plain_greedy_makes(void) {
  int ours = 0;
  int plainly = 0;
  double plain, plain_sum = 0.0, our_sum = 0.0;
  for (unsigned i = 0; i < 24; i++) {
    test_random random = random_case("plain", i);
    if (i % 4 == 3)
      build_rooms(&random, 30);
    else
      scatter(&random, 30, 30, 20 + i, 1);
    build();
    work_out_distances();
    ours += (int)regions.count;
    plainly += divide_plainly(&plain);
    plain_sum += plain;
    our_sum += mean_error();
  }
  snprintf(case_note, sizeof case_note, "%d regions, mean %.3f; plainly %d, mean %.3f", ours, our_sum / 24, plainly,
           plain_sum / 24);
  TEST_ASSERT_LESS_THAN_INT_MESSAGE(plainly * 9 / 10, ours, case_note);
  TEST_ASSERT_TRUE_MESSAGE(our_sum < 1.02 * plain_sum, case_note);
  TEST_MESSAGE(case_note);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_regions_are_in_order_on_small_random_maps);
  RUN_TEST(test_regions_are_in_order_on_large_random_maps);
  RUN_TEST(test_regions_are_in_order_in_rooms);
  RUN_TEST(test_the_same_map_gives_the_same_regions);
  RUN_TEST(test_a_map_of_bits_gives_the_regions_of_its_bytes);
  RUN_TEST(test_a_single_cell_is_a_region);
  RUN_TEST(test_a_map_without_free_cells_has_no_regions);
  RUN_TEST(test_a_corridor_is_cut_where_the_diameter_ends);
  RUN_TEST(test_diameter_1_pairs_cells_that_are_side_by_side);
  RUN_TEST(test_size_1_makes_every_free_cell_a_region);
  RUN_TEST(test_pockets_that_cannot_be_reached_are_regions_of_their_own);
  RUN_TEST(test_with_terrain_the_longer_direction_counts);
  RUN_TEST(test_unlike_places_are_kept_apart_and_regions_stay_in_order);
  RUN_TEST(test_a_likely_place_parts_from_an_unlikely_one);
  RUN_TEST(test_likelihood_0_and_places_that_are_alike_change_nothing);
  RUN_TEST(test_places_out_of_range_are_refused);
  RUN_TEST(test_limits_out_of_range_are_refused);
  RUN_TEST(test_a_grid_out_of_range_is_refused);
  RUN_TEST(test_more_regions_than_the_build_holds_are_refused);
  RUN_TEST(test_work_grows_with_the_cells);
  RUN_TEST(test_the_papers_map_takes_no_more_regions_than_the_papers);
  RUN_TEST(test_there_are_fewer_regions_than_a_plain_greedy_makes);
  return UNITY_END();
}
