/* The cells of a polygon against points: many in each cell, and along each edge. */
#include <math.h>
#include <string.h>

#include "host/input/polygon.h"
#include "support/random.h"
#include "unity.h"

#define COLUMNS 12
#define ROWS 9
#define CELLS (COLUMNS * ROWS)
#define POINTS 16  /* a side of a cell */
#define STEPS 4000 /* along an edge */

static polygon p;
static qtr_mission mission;
static int strays, all; /* cells that tell of an edge where no point of it was tried, of so many */
static uint8_t cuts[CELLS], middles[CELLS], holds[CELLS], edges[CELLS];

void setUp(void) {
  memset(&p, 0, sizeof p);
  mission.columns = COLUMNS;
  mission.rows = ROWS;
}

void tearDown(void) {
}

static double between(test_random *random, double least, double most) {
  return least + (most - least) * random_unit(random);
}

/* Corners in their order around a middle: such a polygon never crosses itself. */
static void make_star(test_random *random) {
  const double across = between(random, 0.0, COLUMNS), up = between(random, 0.0, ROWS);
  const int corners = (int)random_in(random, 3, 10);
  p.corners = 0;
  for (int i = 0; i < corners; i++) {
    const double turn = 6.283185307179586 * (i + between(random, 0.1, 0.9)) / corners, far = between(random, 0.3, 6.0);
    TEST_ASSERT_TRUE(polygon_add(&p, (frame_point){across + far * cos(turn), up + far * sin(turn)}));
  }
}

static bool is_inside(double across, double up) {
  bool inside = false;
  for (int i = 0, j = p.corners - 1; i < p.corners; j = i++) {
    const frame_point a = p.corner[i], b = p.corner[j];
    if ((a.up > up) != (b.up > up) && across < a.across + (up - a.up) * (b.across - a.across) / (b.up - a.up))
      inside = !inside;
  }
  return inside;
}

static int cell_at(double across, double up) {
  if (across < 0.0 || across >= COLUMNS || up < 0.0 || up >= ROWS) return -1;
  return (ROWS - 1 - (int)up) * COLUMNS + (int)across;
}

static void mark_edges(void) {
  memset(edges, 0, sizeof edges);
  for (int i = 0; i < p.corners; i++) {
    const frame_point a = p.corner[i], b = p.corner[(i + 1) % p.corners];
    for (int s = 0; s <= STEPS; s++) {
      const double t = (double)s / STEPS;
      const int cell = cell_at(a.across + t * (b.across - a.across), a.up + t * (b.up - a.up));
      if (cell >= 0) edges[cell] = 1;
    }
  }
}

static bool has_point_inside(int cell) {
  const double across = cell % COLUMNS, up = ROWS - 1 - cell / COLUMNS;
  for (int i = 0; i < POINTS * POINTS; i++)
    if (is_inside(across + (i % POINTS + 0.5) / POINTS, up + (i / POINTS + 0.5) / POINTS)) return true;
  return false;
}

static void expect_cells(void) {
  for (int cell = 0; cell < CELLS; cell++) {
    const double across = cell % COLUMNS + 0.5, up = ROWS - 1 - cell / COLUMNS + 0.5;
    TEST_ASSERT_EQUAL_INT_MESSAGE(is_inside(across, up), middles[cell], case_note);
    if (edges[cell] || has_point_inside(cell)) TEST_ASSERT_EQUAL_INT_MESSAGE(1, cuts[cell], case_note);
    if (edges[cell]) TEST_ASSERT_EQUAL_INT_MESSAGE(0, holds[cell], case_note);
    if (holds[cell]) TEST_ASSERT_EQUAL_INT_MESSAGE(1, middles[cell], case_note);
    strays += cuts[cell] != (middles[cell] || edges[cell]) || holds[cell] != (middles[cell] && !edges[cell]);
    all++;
  }
}

static size_t mark(uint8_t *mask, enum polygon_cells which) {
  memset(mask, 0, CELLS);
  const size_t count = polygon_mark(mask, &p, &mission, which);
  size_t set = 0;
  for (int cell = 0; cell < CELLS; cell++) set += mask[cell];
  TEST_ASSERT_EQUAL_size_t(set, count);
  return count;
}

static void test_cells_are_those_that_points_fall_into(void) {
  char wrong[POLYGON_WRONG];
  for (unsigned i = 0; i < 400; i++) {
    test_random random = random_case("stars", i);
    make_star(&random);
    if (polygon_check(&p, wrong) != NULL) continue; /* a middle outside of the corners' round */
    mark_edges();
    mark(cuts, POLYGON_CUTS);
    mark(middles, POLYGON_MIDDLES);
    mark(holds, POLYGON_HOLDS);
    expect_cells();
  }
  TEST_ASSERT_GREATER_THAN_INT(20000, all);
  TEST_ASSERT_LESS_THAN_INT(all / 1000, strays);
}

static void make(int corners, const double (*at)[2]) {
  p.corners = 0;
  for (int i = 0; i < corners; i++) polygon_add(&p, (frame_point){at[i][0], at[i][1]});
}

/* Of a fine grid around the map. */
static void test_areas_are_those_of_many_points(void) {
  enum { FINE = 10, AROUND = 7 }; /* points a cell's side, and cells around the map */
  char wrong[POLYGON_WRONG];
  for (unsigned i = 0; i < 100; i++) {
    test_random random = random_case("areas", i);
    double on = 0.0, whole = 0.0;
    make_star(&random);
    if (polygon_check(&p, wrong) != NULL) continue;
    for (int x = -AROUND * FINE; x < (COLUMNS + AROUND) * FINE; x++)
      for (int y = -AROUND * FINE; y < (ROWS + AROUND) * FINE; y++) {
        if (!is_inside((x + 0.5) / FINE, (y + 0.5) / FINE)) continue;
        whole += 1.0 / (FINE * FINE);
        if (x >= 0 && y >= 0 && x < COLUMNS * FINE && y < ROWS * FINE) on += 1.0 / (FINE * FINE);
      }
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(0.3, whole, polygon_area(&p), case_note);
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(0.3, on, polygon_area_on(&p, &mission), case_note);
  }
}

static void test_polygons_that_cross_or_touch_themselves_are_told(void) {
  static const double bow[][2] = {{0, 0}, {2, 2}, {2, 0}, {0, 2}}, spike[][2] = {{0, 0}, {4, 0}, {2, 0}, {2, 2}},
                      touch[][2] = {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}},
                      fine[][2] = {{0, 0}, {4, 0}, {4, 4}, {2, 1}};
  char wrong[POLYGON_WRONG];
  make(4, bow);
  TEST_ASSERT_NOT_NULL(polygon_check(&p, wrong));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(wrong, "corners 0 and 2 meet"), wrong);
  make(4, spike);
  TEST_ASSERT_NOT_NULL(polygon_check(&p, wrong));
  make(5, touch);
  TEST_ASSERT_NOT_NULL(polygon_check(&p, wrong));
  make(4, fine);
  TEST_ASSERT_NULL(polygon_check(&p, wrong));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_cells_are_those_that_points_fall_into);
  RUN_TEST(test_areas_are_those_of_many_points);
  RUN_TEST(test_polygons_that_cross_or_touch_themselves_are_told);
  return UNITY_END();
}
