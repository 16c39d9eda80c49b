#include "hope.h"

#include "quarter/robot.h"
#include "unity.h"

enum { COLUMNS = 6, ROWS = 3, SECOND = 1000000 };

static uint8_t cost[COLUMNS * ROWS];
static ground g;
static qtr_field way;
static hope h;

/* The way to the last cell of the upper row; the middle one is a wall, the lower one slow. */
void setUp(void) {
  for (int i = 0; i < COLUMNS; i++) {
    cost[i] = 1;
    cost[COLUMNS + i] = 0;
    cost[2 * COLUMNS + i] = 3;
  }
  g = (ground){.grid = {COLUMNS, ROWS, QTR_GRID_BYTES, cost}, .cell_size = 1.0, .cosine = 1.0};
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_field_fill(&way, &g.grid, COLUMNS - 1));
  hope_begin(&h, 0);
}

void tearDown(void) {
}

static bool hopes_at(double x, double y, int64_t seconds) {
  return hope_left(&h, &way, &g, (point){x, y}, 1.0, seconds * SECOND);
}

static void test_who_comes_nearer_hopes_on(void) {
  for (int i = 0; i < COLUMNS; i++) TEST_ASSERT_TRUE(hopes_at(0.5 + i, 2.5, 59 * i));
}

static void test_who_comes_no_nearer_gives_up_however_it_moves(void) {
  TEST_ASSERT_TRUE(hopes_at(2.5, 2.5, 0));
  for (int second = 1; second <= 60; second++) TEST_ASSERT_TRUE(hopes_at(0.5 + second % 3, 2.5, second));
  TEST_ASSERT_FALSE(hopes_at(1.5, 2.5, 61));
  hope_begin(&h, 61 * (int64_t)SECOND);
  TEST_ASSERT_TRUE(hopes_at(1.5, 2.5, 62));
}

static void test_where_there_is_no_way_there_is_no_hope(void) {
  TEST_ASSERT_FALSE(hopes_at(2.5, 0.5, 0));
}

static void test_who_was_pushed_off_its_way_hopes_on(void) {
  TEST_ASSERT_TRUE(hopes_at(2.5, 1.5, 0));
  TEST_ASSERT_TRUE(hopes_at(-3.0, 99.0, 0));
}

static void test_on_slow_ground_patience_is_longer(void) {
  for (int i = 0; i < COLUMNS; i++) cost[i] = 3;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_field_fill(&way, &g.grid, COLUMNS - 1));
  TEST_ASSERT_TRUE(hopes_at(0.5, 2.5, 0));
  TEST_ASSERT_TRUE(hopes_at(0.5, 2.5, 180));
  TEST_ASSERT_FALSE(hopes_at(0.5, 2.5, 181));
}

static void test_a_clock_set_back_begins_anew(void) {
  hope_begin(&h, 1000 * (int64_t)SECOND);
  TEST_ASSERT_TRUE(hopes_at(0.5, 2.5, 10));
  TEST_ASSERT_TRUE(hopes_at(0.5, 2.5, 70));
  TEST_ASSERT_FALSE(hopes_at(0.5, 2.5, 71));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_who_comes_nearer_hopes_on);
  RUN_TEST(test_who_comes_no_nearer_gives_up_however_it_moves);
  RUN_TEST(test_where_there_is_no_way_there_is_no_hope);
  RUN_TEST(test_who_was_pushed_off_its_way_hopes_on);
  RUN_TEST(test_on_slow_ground_patience_is_longer);
  RUN_TEST(test_a_clock_set_back_begins_anew);
  return UNITY_END();
}
