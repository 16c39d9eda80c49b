/* profiles: host mcu */
/* The map as cells: neighbours at its edges, both encodings, and where its cells lie in the world. */
#include "quarter/grid.h"
#include "support/random.h"
#include "unity.h"
#include <math.h>

void setUp(void) {
}

void tearDown(void) {
}

static qtr_grid grid_of(unsigned columns, unsigned rows) {
  const qtr_grid grid = {(uint16_t)columns, (uint16_t)rows, QTR_GRID_BYTES, NULL};
  return grid;
}

static void expect_neighbours(const qtr_grid *grid, qtr_cell cell, qtr_cell north, qtr_cell east, qtr_cell south,
                              qtr_cell west) {
  TEST_ASSERT_EQUAL_UINT32(north, qtr_grid_neighbour(grid, cell, QTR_NORTH));
  TEST_ASSERT_EQUAL_UINT32(east, qtr_grid_neighbour(grid, cell, QTR_EAST));
  TEST_ASSERT_EQUAL_UINT32(south, qtr_grid_neighbour(grid, cell, QTR_SOUTH));
  TEST_ASSERT_EQUAL_UINT32(west, qtr_grid_neighbour(grid, cell, QTR_WEST));
}

/*  0  1  2  3
 *  4  5  6  7
 *  8  9 10 11 */
static void test_neighbours_end_at_the_edges(void) {
  const qtr_grid grid = grid_of(4, 3);
  expect_neighbours(&grid, 5, 1, 6, 9, 4);
  expect_neighbours(&grid, 0, QTR_NO_CELL, 1, 4, QTR_NO_CELL);
  expect_neighbours(&grid, 3, QTR_NO_CELL, QTR_NO_CELL, 7, 2);
  expect_neighbours(&grid, 4, 0, 5, 8, QTR_NO_CELL);
  expect_neighbours(&grid, 7, 3, QTR_NO_CELL, 11, 6);
  expect_neighbours(&grid, 8, 4, 9, QTR_NO_CELL, QTR_NO_CELL);
  expect_neighbours(&grid, 11, 7, QTR_NO_CELL, QTR_NO_CELL, 10);
}

static void test_neighbours_in_a_single_row_column_or_cell(void) {
  const qtr_grid row = grid_of(3, 1);
  const qtr_grid column = grid_of(1, 3);
  const qtr_grid cell = grid_of(1, 1);
  expect_neighbours(&row, 0, QTR_NO_CELL, 1, QTR_NO_CELL, QTR_NO_CELL);
  expect_neighbours(&row, 2, QTR_NO_CELL, QTR_NO_CELL, QTR_NO_CELL, 1);
  expect_neighbours(&column, 0, QTR_NO_CELL, QTR_NO_CELL, 1, QTR_NO_CELL);
  expect_neighbours(&column, 2, 1, QTR_NO_CELL, QTR_NO_CELL, QTR_NO_CELL);
  expect_neighbours(&cell, 0, QTR_NO_CELL, QTR_NO_CELL, QTR_NO_CELL, QTR_NO_CELL);
}

static void test_neighbours_in_the_largest_grids(void) {
  const unsigned longest = QTR_MAX_CELLS < 65535 ? QTR_MAX_CELLS : 65535;
  const qtr_grid row = grid_of(longest, 1);
  const qtr_grid column = grid_of(1, longest);
  const qtr_cell last = (qtr_cell)(longest - 1);
  expect_neighbours(&row, last, QTR_NO_CELL, QTR_NO_CELL, QTR_NO_CELL, (qtr_cell)(last - 1));
  expect_neighbours(&column, last, (qtr_cell)(last - 1), QTR_NO_CELL, QTR_NO_CELL, QTR_NO_CELL);
#if QTR_MAX_CELLS >= 1024 * 1024
  const qtr_grid square = grid_of(1024, 1024);
  expect_neighbours(&square, 1048575, 1047551, QTR_NO_CELL, QTR_NO_CELL, 1048574);
#endif
}

static void test_direction_that_is_none_leads_nowhere(void) {
  const qtr_grid grid = grid_of(3, 3);
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_grid_neighbour(&grid, 4, (enum qtr_direction)4));
}

static void test_bits_are_read_from_the_lowest(void) {
  static const uint8_t cells[2] = {0x05, 0x82};
  qtr_grid grid = grid_of(4, 4);
  grid.encoding = QTR_GRID_BITS;
  grid.cells = cells;
  for (qtr_cell cell = 0; cell < 16; cell++)
    TEST_ASSERT_EQUAL(cell == 0 || cell == 2 || cell == 9 || cell == 15, qtr_grid_cost(&grid, cell));
}

static void test_bytes_are_the_costs(void) {
  static const uint8_t cells[4] = {0, 1, 3, 255};
  qtr_grid grid = grid_of(2, 2);
  grid.cells = cells;
  for (qtr_cell cell = 0; cell < 4; cell++) TEST_ASSERT_EQUAL(cells[cell], qtr_grid_cost(&grid, cell));
}

static void test_size_of_a_grid_in_bytes(void) {
  TEST_ASSERT_EQUAL_UINT32(1, qtr_grid_size(1, QTR_GRID_BITS));
  TEST_ASSERT_EQUAL_UINT32(1, qtr_grid_size(8, QTR_GRID_BITS));
  TEST_ASSERT_EQUAL_UINT32(2, qtr_grid_size(9, QTR_GRID_BITS));
  TEST_ASSERT_EQUAL_UINT32(9, qtr_grid_size(9, QTR_GRID_BYTES));
}

/* Half-metre cells, the lower-left corner of the map at (-1, 2) m. */
static const qtr_frame frame = {500000, -1000000, 2000000, 0, 0};

static void test_row_0_is_the_top_of_the_world(void) {
  const qtr_grid grid = grid_of(4, 3);
  int64_t x;
  int64_t y;
  qtr_frame_centre(&frame, &grid, 8, &x, &y); /* bottom left */
  TEST_ASSERT_EQUAL_INT64(-750000, x);
  TEST_ASSERT_EQUAL_INT64(2250000, y);
  qtr_frame_centre(&frame, &grid, 3, &x, &y); /* top right */
  TEST_ASSERT_EQUAL_INT64(750000, x);
  TEST_ASSERT_EQUAL_INT64(3250000, y);
}

static void test_points_belong_to_the_cell_above_and_right_of_an_edge(void) {
  const qtr_grid grid = grid_of(4, 3);
  TEST_ASSERT_EQUAL_UINT32(8, qtr_frame_cell(&frame, &grid, -1000000, 2000000));
  TEST_ASSERT_EQUAL_UINT32(8, qtr_frame_cell(&frame, &grid, -500001, 2499999));
  TEST_ASSERT_EQUAL_UINT32(9, qtr_frame_cell(&frame, &grid, -500000, 2499999));
  TEST_ASSERT_EQUAL_UINT32(4, qtr_frame_cell(&frame, &grid, -1000000, 2500000));
  TEST_ASSERT_EQUAL_UINT32(3, qtr_frame_cell(&frame, &grid, 999999, 3499999));
}

static void test_points_off_the_map_are_in_no_cell(void) {
  const qtr_grid grid = grid_of(4, 3);
  const int64_t far = QTR_FRAME_LIMIT_UM;
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_frame_cell(&frame, &grid, -1000001, 2500000));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_frame_cell(&frame, &grid, 1000000, 2500000));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_frame_cell(&frame, &grid, 0, 1999999));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_frame_cell(&frame, &grid, 0, 3500000));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_frame_cell(&frame, &grid, far, far));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_frame_cell(&frame, &grid, -far, -far));
}

/* A quarter turn to the left: the map's right is the world's up. Its origin stays where it is. */
static void test_a_turned_map_lies_where_its_angle_says(void) {
  const qtr_grid grid = grid_of(4, 3);
  const qtr_frame turned = {500000, -1000000, 2000000, 0, QTR_FRAME_ONE};
  int64_t x;
  int64_t y;
  TEST_ASSERT_TRUE(qtr_frame_centre(&turned, &grid, 8, &x, &y)); /* bottom left of the map */
  TEST_ASSERT_EQUAL_INT64(-1250000, x);
  TEST_ASSERT_EQUAL_INT64(2250000, y);
  TEST_ASSERT_TRUE(qtr_frame_centre(&turned, &grid, 3, &x, &y)); /* top right */
  TEST_ASSERT_EQUAL_INT64(-2250000, x);
  TEST_ASSERT_EQUAL_INT64(3750000, y);
  TEST_ASSERT_EQUAL_UINT32(3, qtr_frame_cell(&turned, &grid, -2000001, 3999999));
  TEST_ASSERT_EQUAL_UINT32(QTR_NO_CELL, qtr_frame_cell(&turned, &grid, -999999, 2250000));
}

static void test_a_turn_that_is_none_is_no_frame(void) {
  const qtr_frame frames[] = {{500000, 0, 0, QTR_FRAME_ONE / 2, 0},
                              {500000, 0, 0, 1, 0},
                              {0, 0, 0, QTR_FRAME_ONE, 0},
                              {500000, QTR_FRAME_LIMIT_UM, 0, 0, 0},
                              {500000, 0, 0, INT32_MIN, INT32_MIN}};
  for (unsigned i = 0; i < sizeof frames / sizeof frames[0]; i++) TEST_ASSERT_FALSE(qtr_frame_is_one(&frames[i]));
  TEST_ASSERT_TRUE(qtr_frame_is_one(&(qtr_frame){500000, 0, 0, -QTR_FRAME_ONE, 0}));
  TEST_ASSERT_TRUE(qtr_frame_is_one(&(qtr_frame){0, 0, 0, 0, 0}));
}

static void test_a_box_is_as_wide_as_what_it_holds(void) {
  const qtr_grid grid = grid_of(5, 4);
  qtr_box box = {0, 0, 0, 0};
  qtr_box_add(&box, &grid, 7);
  TEST_ASSERT_TRUE(box.left == 2 && box.right == 3 && box.top == 1 && box.bottom == 2);
  qtr_box_add(&box, &grid, 15);
  TEST_ASSERT_TRUE(box.left == 0 && box.right == 3 && box.top == 1 && box.bottom == 4);
}

static void test_every_cell_is_found_again_from_its_middle(void) {
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("frames", number);
    const qtr_grid grid = grid_of(random_in(&random, 1, 32), random_in(&random, 1, 32));
    qtr_frame placed = {random_in(&random, 3, 5000000), (int64_t)random_below(&random, 2000000000) - 1000000000,
                        (int64_t)random_below(&random, 2000000000) - 1000000000, 0, 0};
    if (random_chance(&random, 70)) {
      const double angle = random_below(&random, 6284) / 1000.0;
      placed.cosine = (int32_t)lround(cos(angle) * QTR_FRAME_ONE);
      placed.sine = (int32_t)lround(sin(angle) * QTR_FRAME_ONE);
      placed.cell_size_um += 10;
    }
    for (unsigned cell = 0; cell < (unsigned)grid.columns * grid.rows; cell++) {
      int64_t x;
      int64_t y;
      qtr_frame_centre(&placed, &grid, (qtr_cell)cell, &x, &y);
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(cell, qtr_frame_cell(&placed, &grid, x, y), case_note);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_neighbours_end_at_the_edges);
  RUN_TEST(test_neighbours_in_a_single_row_column_or_cell);
  RUN_TEST(test_neighbours_in_the_largest_grids);
  RUN_TEST(test_direction_that_is_none_leads_nowhere);
  RUN_TEST(test_bits_are_read_from_the_lowest);
  RUN_TEST(test_bytes_are_the_costs);
  RUN_TEST(test_size_of_a_grid_in_bytes);
  RUN_TEST(test_row_0_is_the_top_of_the_world);
  RUN_TEST(test_points_belong_to_the_cell_above_and_right_of_an_edge);
  RUN_TEST(test_points_off_the_map_are_in_no_cell);
  RUN_TEST(test_a_turned_map_lies_where_its_angle_says);
  RUN_TEST(test_a_turn_that_is_none_is_no_frame);
  RUN_TEST(test_a_box_is_as_wide_as_what_it_holds);
  RUN_TEST(test_every_cell_is_found_again_from_its_middle);
  return UNITY_END();
}
