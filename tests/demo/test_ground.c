/* Cells, points and metres: y up from the bottom edge, the same places whichever way they are said. */
#include <math.h>

#include "ground.h"
#include "support/random.h"
#include "unity.h"

static const uint8_t cells[1]; /* where things lie does not depend on what they are */

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static ground ground_sized(unsigned columns, unsigned rows) {
  return (ground){{(uint16_t)columns, (uint16_t)rows, QTR_GRID_BYTES, cells}, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0};
}

static void assert_point(double x, double y, point p) {
  TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(x, p.x, case_note);
  TEST_ASSERT_EQUAL_DOUBLE_MESSAGE(y, p.y, case_note);
}

static void test_the_top_row_is_the_highest(void) {
  const ground g = ground_sized(4, 3);
  assert_point(0.5, 2.5, ground_centre(&g, 0));
  assert_point(3.5, 2.5, ground_centre(&g, 3));
  assert_point(0.5, 0.5, ground_centre(&g, 8));
  assert_point(3.5, 0.5, ground_centre(&g, 11));
  TEST_ASSERT_EQUAL_UINT(4, ground_cell(&g, (point){0.0, 1.0}));
  TEST_ASSERT_EQUAL_UINT(0, ground_cell(&g, (point){0.99, 2.99}));
  TEST_ASSERT_EQUAL_UINT(11, ground_cell(&g, (point){3.99, 0.01}));
}

static void test_every_point_of_a_cell_is_in_that_cell(void) {
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("points of a cell", number);
    const ground g = ground_sized(random_in(&random, 1, 300), random_in(&random, 1, 300));
    const qtr_cell cell = random_below(&random, (unsigned)g.grid.columns * g.grid.rows);
    const point middle = ground_centre(&g, cell);
    const point p = {middle.x + 0.99 * (random_unit(&random) - 0.5), middle.y + 0.99 * (random_unit(&random) - 0.5)};
    TEST_ASSERT_EQUAL_UINT_MESSAGE(cell, ground_cell(&g, middle), case_note);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(cell, ground_cell(&g, p), case_note);
  }
}

static void test_beyond_the_edges_is_no_cell(void) {
  static const point off[] = {{-1e-9, 1},  {1, -1e-9}, {4, 1},   {1, 3},        {1e300, 1},
                              {1, -1e300}, {NAN, 1},   {1, NAN}, {INFINITY, 1}, {1, -INFINITY}};
  const ground g = ground_sized(4, 3);
  for (unsigned i = 0; i < sizeof off / sizeof off[0]; i++)
    TEST_ASSERT_EQUAL_UINT(QTR_NO_CELL, ground_cell(&g, off[i]));
}

/* The core reckons the same in whole micrometres. */
static void turn(qtr_frame *frame, double angle) {
  frame->cosine = (int32_t)lround(cos(angle) * QTR_FRAME_ONE);
  frame->sine = (int32_t)lround(sin(angle) * QTR_FRAME_ONE);
}

static void test_metres_are_those_of_the_maps_frame(void) {
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("metres", number);
    const qtr_grid grid = ground_sized(random_in(&random, 1, 300), random_in(&random, 1, 300)).grid;
    int64_t x, y;
    qtr_frame frame = {random_in(&random, 1, 5000000), (int64_t)random_below(&random, 200000000) - 100000000,
                       (int64_t)random_below(&random, 200000000) - 100000000, 0, 0};
    if (random_chance(&random, 50)) turn(&frame, random_below(&random, 6284) / 1000.0);
    const ground g = ground_in(&grid, &frame);
    const qtr_cell cell = random_below(&random, (unsigned)g.grid.columns * g.grid.rows);
    const point middle = ground_centre(&g, cell);
    qtr_frame_centre(&frame, &grid, cell, &x, &y);
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(3.5e-6, (double)x / 1e6, ground_x_m(&g, middle), case_note);
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(3.5e-6, (double)y / 1e6, ground_y_m(&g, middle), case_note);
  }
}

static void test_metres_and_back_is_the_same_point(void) {
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("metres and back", number);
    ground g = ground_sized(30, 20);
    g.cell_size = 0.01 + 5.0 * random_unit(&random);
    g.origin_x = 100.0 * random_unit(&random) - 50.0;
    g.origin_y = 100.0 * random_unit(&random) - 50.0;
    const point p = {30.0 * random_unit(&random), 20.0 * random_unit(&random)};
    const point again = ground_point(&g, ground_x_m(&g, p), ground_y_m(&g, p));
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-9, p.x, again.x, case_note);
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-9, p.y, again.y, case_note);
  }
}

static void test_by_hand_half_metre_cells_from_an_origin(void) {
  const qtr_grid grid = ground_sized(4, 3).grid;
  const qtr_frame frame = {.cell_size_um = 500000, .origin_x_um = -1000000, .origin_y_um = 2000000};
  const ground g = ground_in(&grid, &frame);
  const point middle = ground_centre(&g, 0);
  TEST_ASSERT_EQUAL_DOUBLE(-0.75, ground_x_m(&g, middle));
  TEST_ASSERT_EQUAL_DOUBLE(3.25, ground_y_m(&g, middle));
  assert_point(2.0, 1.0, ground_point(&g, 0.0, 2.5));
}

static void test_a_map_without_metres_has_cells_of_one(void) {
  const qtr_grid grid = ground_sized(4, 3).grid;
  const qtr_frame none = {.cell_size_um = 0};
  const ground g = ground_in(&grid, &none);
  TEST_ASSERT_EQUAL_DOUBLE(1.5, ground_x_m(&g, (point){1.5, 2.5}));
  TEST_ASSERT_EQUAL_DOUBLE(2.5, ground_y_m(&g, (point){1.5, 2.5}));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_top_row_is_the_highest);
  RUN_TEST(test_every_point_of_a_cell_is_in_that_cell);
  RUN_TEST(test_beyond_the_edges_is_no_cell);
  RUN_TEST(test_metres_are_those_of_the_maps_frame);
  RUN_TEST(test_metres_and_back_is_the_same_point);
  RUN_TEST(test_by_hand_half_metre_cells_from_an_origin);
  RUN_TEST(test_a_map_without_metres_has_cells_of_one);
  return UNITY_END();
}
