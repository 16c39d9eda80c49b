/* Walls: rectangles that cover what is blocked, once, and nothing else, and few of them. */
#include <string.h>

#include "support/random.h"
#include "unity.h"
#include "walls.h"

enum { SIDE = 40 };

static uint8_t cells[SIDE * SIDE];
static uint8_t covered[SIDE * SIDE]; /* by how many walls */
static qtr_grid grid;
static wall *walls;
static int count;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
  free(walls);
  walls = NULL;
}

/* Rows separated by '/', '#' blocked. */
static void draw(const char *rows) {
  unsigned at = 0;
  grid = (qtr_grid){(uint16_t)strcspn(rows, "/"), 0, QTR_GRID_BYTES, cells};
  for (const char *c = rows; *c != '\0'; c++)
    if (*c != '/') cells[at++] = *c != '#';
  grid.rows = (uint16_t)(at / grid.columns);
}

static void build(void) {
  free(walls);
  count = walls_make(&walls, &grid);
}

static void cover(const wall *w) {
  TEST_ASSERT_TRUE_MESSAGE(w->column + w->columns <= grid.columns, case_note);
  TEST_ASSERT_TRUE_MESSAGE(w->row + w->rows <= grid.rows, case_note);
  for (int row = w->row; row < w->row + w->rows; row++)
    for (int column = w->column; column < w->column + w->columns; column++) covered[row * grid.columns + column]++;
}

static void test_every_blocked_cell_lies_in_one_wall_and_no_free_one_does(void) {
  for (unsigned number = 0; number < 400; number++) {
    test_random random = random_case("walls", number);
    const unsigned percent = random_below(&random, 101);
    const uint8_t encoding = number % 2 == 0 ? QTR_GRID_BYTES : QTR_GRID_BITS;
    grid = (qtr_grid){(uint16_t)random_in(&random, 1, SIDE), (uint16_t)random_in(&random, 1, SIDE), encoding, cells};
    for (unsigned i = 0; i < sizeof cells; i++)
      cells[i] = random_chance(&random, percent) ? 0 : (uint8_t)random_bits(&random);
    memset(covered, 0, sizeof covered);
    build();
    for (int i = 0; i < count; i++) cover(&walls[i]);
    for (unsigned cell = 0; cell < (unsigned)grid.columns * grid.rows; cell++)
      TEST_ASSERT_EQUAL_INT_MESSAGE(qtr_grid_cost(&grid, (qtr_cell)cell) == 0, covered[cell], case_note);
  }
}

static void test_a_map_without_walls_has_none(void) {
  draw("..../....");
  build();
  TEST_ASSERT_EQUAL_INT(0, count);
}

static void test_what_is_a_rectangle_is_one_wall(void) {
  draw("......./..####./..####./..####./.......");
  build();
  TEST_ASSERT_EQUAL_INT(1, count);
  TEST_ASSERT_EQUAL_INT(2, walls[0].column);
  TEST_ASSERT_EQUAL_INT(1, walls[0].row);
  TEST_ASSERT_EQUAL_INT(4, walls[0].columns);
  TEST_ASSERT_EQUAL_INT(3, walls[0].rows);
  draw("####/####");
  build();
  TEST_ASSERT_EQUAL_INT(1, count);
}

static void test_a_border_is_four_walls(void) {
  draw("########/#......#/#......#/#......#/########");
  build();
  TEST_ASSERT_EQUAL_INT(4, count);
}

/* Cells that touch at corners only cannot share a wall. */
static void test_a_chessboard_is_a_wall_for_each_black_cell(void) {
  draw("#.#.#/.#.#./#.#.#");
  build();
  TEST_ASSERT_EQUAL_INT(8, count);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_blocked_cell_lies_in_one_wall_and_no_free_one_does);
  RUN_TEST(test_a_map_without_walls_has_none);
  RUN_TEST(test_what_is_a_rectangle_is_one_wall);
  RUN_TEST(test_a_border_is_four_walls);
  RUN_TEST(test_a_chessboard_is_a_wall_for_each_black_cell);
  return UNITY_END();
}
