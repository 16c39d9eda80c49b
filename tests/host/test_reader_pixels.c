#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/input/pixels.h"
#include "support/random.h"
#include "support/reader_scratch.h"

#define SIDE 24

static uint8_t blocked[SIDE * SIDE];
static uint8_t cost[SIDE * SIDE * 16];

void setUp(void) {
}

void tearDown(void) {
}

/* From rows of '#' and '.', each ended by '|'. */
static pixels draw(const char *rows) {
  pixels map = {(int)strcspn(rows, "|"), 0, blocked, NULL};
  for (size_t i = 0, n = 0; rows[i] != '\0'; i++) {
    if (rows[i] == '|') {
      map.height++;
    } else {
      blocked[n++] = rows[i] == '#';
    }
  }
  return map;
}

static void expect_grown(const char *rows, double radius, const char *wanted) {
  pixels map = draw(rows);
  char grown[SIDE * SIDE];
  size_t used = 0;
  TEST_ASSERT_EQUAL_INT(0, pixels_grow(&map, radius));
  for (int y = 0; y < map.height; y++) {
    for (int x = 0; x < map.width; x++) grown[used++] = blocked[y * map.width + x] ? '#' : '.';
    grown[used++] = '|';
  }
  grown[used] = '\0';
  TEST_ASSERT_EQUAL_STRING(wanted, grown);
}

static void expect_cells(const char *rows, double ratio, int columns, int wanted_rows, const char *wanted) {
  pixels map = draw(rows);
  char coarse[SIDE * SIDE];
  size_t used = 0;
  TEST_ASSERT_EQUAL_DOUBLE(columns, pixels_cells(map.width, ratio));
  TEST_ASSERT_EQUAL_DOUBLE(wanted_rows, pixels_cells(map.height, ratio));
  TEST_ASSERT_EQUAL_INT(0, pixels_coarsen(cost, columns, wanted_rows, &map, ratio));
  for (int y = 0; y < wanted_rows; y++) {
    for (int x = 0; x < columns; x++) coarse[used++] = cost[y * columns + x] ? '.' : '#';
    coarse[used++] = '|';
  }
  coarse[used] = '\0';
  TEST_ASSERT_EQUAL_STRING(wanted, coarse);
}

static void test_radius_of_nothing_changes_nothing(void) {
  expect_grown(".....|..#..|.....|", 0.0, ".....|..#..|.....|");
}

static void test_growth_counts_from_a_pixels_middle_to_an_obstacles_edge(void) {
  expect_grown(".....|.....|..#..|.....|.....|", 0.49, ".....|.....|..#..|.....|.....|");
  /* Touching counts: the middle of the next pixel is half a pixel from the edge. */
  expect_grown(".....|.....|..#..|.....|.....|", 0.5, ".....|..#..|.###.|..#..|.....|");
  /* The corner is sqrt(0.5) = 0.7071 away. */
  expect_grown(".....|.....|..#..|.....|.....|", 0.707, ".....|..#..|.###.|..#..|.....|");
  expect_grown(".....|.....|..#..|.....|.....|", 0.708, ".....|.###.|.###.|.###.|.....|");
  expect_grown(".....|.....|..#..|.....|.....|", 1.5, "..#..|.###.|#####|.###.|..#..|");
  /* Two aside and one up: sqrt(1.5 * 1.5 + 0.5 * 0.5) = 1.5811. */
  expect_grown(".....|.....|..#..|.....|.....|", 1.59, ".###.|#####|#####|#####|.###.|");
}

static void test_the_maps_edge_does_not_grow(void) {
  expect_grown("...|...|", 2.0, "...|...|");
  expect_grown("#..|...|...|", 1.0, "##.|##.|...|");
}

static void test_a_huge_radius_blocks_all(void) {
  expect_grown("....|...#|....|", 1e18, "####|####|####|");
}

/* The definition itself, pixel by pixel. */
static bool near_obstacle(const uint8_t *before, int width, int height, int x, int y, double radius) {
  for (int v = 0; v < height; v++) {
    for (int u = 0; u < width; u++) {
      if (!before[v * width + u]) continue;
      double across = fmax(0.0, abs(u - x) - 0.5), down = fmax(0.0, abs(v - y) - 0.5);
      if (across * across + down * down <= radius * radius) return true;
    }
  }
  return false;
}

static void test_growth_agrees_with_brute_force(void) {
  for (unsigned seed = 1; seed <= 300; seed++) {
    test_random random = random_case("growth", seed);
    uint8_t before[SIDE * SIDE];
    pixels map = {1 + (int)random_below(&random, SIDE), 1 + (int)random_below(&random, SIDE), blocked, NULL};
    double radius = random_below(&random, 1000) / 137.0;
    unsigned density = 2 + random_below(&random, 60);
    for (int i = 0; i < map.width * map.height; i++) before[i] = random_below(&random, density) == 0;
    memcpy(blocked, before, sizeof before);
    TEST_ASSERT_EQUAL_INT(0, pixels_grow(&map, radius));
    for (int i = 0; i < map.width * map.height; i++) {
      bool wanted = near_obstacle(before, map.width, map.height, i % map.width, i / map.width, radius);
      TEST_ASSERT_EQUAL_INT_MESSAGE(wanted, blocked[i], case_note);
    }
  }
}

static void test_one_pixel_a_cell_is_the_map(void) {
  expect_cells("#..|...|..#|", 1.0, 3, 3, "#..|...|..#|");
}

static void test_two_pixels_a_cell(void) {
  expect_cells("#...|....|....|...#|", 2.0, 2, 2, "#.|.#|");
}

static void test_cells_start_at_the_lower_left_and_the_edge_blocks(void) {
  /* Three pixels: the cells of the right column and the top row stick out of the map. */
  expect_cells("...|...|...|", 2.0, 2, 2, "##|.#|");
}

static void test_three_pixels_for_two_cells(void) {
  /* Cells of 1.5 pixels: the middle pixel is cut by both. */
  expect_cells("...|...|...|", 1.5, 2, 2, "..|..|");
  expect_cells("...|...|#..|", 1.5, 2, 2, "..|#.|");
  expect_cells("...|.#.|...|", 1.5, 2, 2, "##|##|");
  expect_cells("..#|...|...|", 1.5, 2, 2, ".#|..|");
}

static void test_cells_smaller_than_pixels(void) {
  expect_cells("#.|..|", 0.5, 4, 4, "##..|##..|....|....|");
  /* Cells of 2/3 pixel: the middle one is cut by both pixels, the top row by the edge. */
  expect_cells("#.|", 2.0 / 3.0, 3, 2, "###|##.|");
}

static void test_rounding_makes_no_extra_cells(void) {
  expect_cells("......|......|......|", 0.15 / 0.05, 2, 1, "..|");
  expect_cells("......|......|......|", 0.3 / 0.1, 2, 1, "..|");
  expect_cells("......|......|......|", 0.15 / 0.05000000074505806, 2, 1, "..|");
  TEST_ASSERT_EQUAL_DOUBLE(1000.0, pixels_cells(4000, 0.2 / 0.05000000074505806));
}

static void test_a_cell_larger_than_the_map_is_blocked(void) {
  expect_cells("...|...|", 7.0, 1, 1, "#|");
}

/* The definition itself: a cell is free if it lies in the map and overlaps no blocked pixel. */
static bool cell_free(const pixels *map, int column, int above, double ratio) {
  double left = column * ratio, bottom = above * ratio, slack = 1e-4;
  if (left + ratio > map->width + slack || bottom + ratio > map->height + slack) return false;
  for (int y = 0; y < map->height; y++) {
    for (int x = 0; x < map->width; x++) {
      double across = fmin(left + ratio, x + 1.0) - fmax(left, x);
      double up = map->height - 1.0 - y, down = fmin(bottom + ratio, up + 1.0) - fmax(bottom, up);
      if (map->blocked[y * map->width + x] && across > slack && down > slack) return false;
    }
  }
  return true;
}

static void test_coarsening_agrees_with_brute_force(void) {
  for (unsigned seed = 1; seed <= 300; seed++) {
    test_random random = random_case("coarsening", seed);
    pixels map = {1 + (int)random_below(&random, SIDE), 1 + (int)random_below(&random, SIDE), blocked, NULL};
    double ratio = 0.3 + random_below(&random, 1000) / 213.0;
    unsigned density = 2 + random_below(&random, 60);
    for (int i = 0; i < map.width * map.height; i++) blocked[i] = random_below(&random, density) == 0;
    int columns = (int)pixels_cells(map.width, ratio), rows = (int)pixels_cells(map.height, ratio);
    TEST_ASSERT_LESS_OR_EQUAL_INT((int)sizeof cost, columns * rows);
    TEST_ASSERT_EQUAL_INT(0, pixels_coarsen(cost, columns, rows, &map, ratio));
    for (int i = 0; i < columns * rows; i++) {
      bool wanted = cell_free(&map, i % columns, rows - 1 - i / columns, ratio);
      TEST_ASSERT_EQUAL_INT_MESSAGE(wanted, cost[i], case_note);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_radius_of_nothing_changes_nothing);
  RUN_TEST(test_growth_counts_from_a_pixels_middle_to_an_obstacles_edge);
  RUN_TEST(test_the_maps_edge_does_not_grow);
  RUN_TEST(test_a_huge_radius_blocks_all);
  RUN_TEST(test_one_pixel_a_cell_is_the_map);
  RUN_TEST(test_two_pixels_a_cell);
  RUN_TEST(test_cells_start_at_the_lower_left_and_the_edge_blocks);
  RUN_TEST(test_three_pixels_for_two_cells);
  RUN_TEST(test_cells_smaller_than_pixels);
  RUN_TEST(test_rounding_makes_no_extra_cells);
  RUN_TEST(test_a_cell_larger_than_the_map_is_blocked);
  RUN_TEST(test_growth_agrees_with_brute_force);
  RUN_TEST(test_coarsening_agrees_with_brute_force);
  return UNITY_END();
}
