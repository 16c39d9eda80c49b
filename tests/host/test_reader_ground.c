#include "support/reader_scratch.h"

#define REST "robots: [{column: 0, row: 0}]\nplaces: [{column: 4, row: 3}]\n"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", ".....\n.....\n..#..\n.....\n");
}

void tearDown(void) {
  scratch_close();
}

static void write_mission(const char *key, const char *value) {
  char text[400];
  snprintf(text, sizeof text, "map: a.txt\n" REST "%s: %s\n", key, value);
  scratch_write("m.yaml", text);
}

static void expect_cells(const char *key, const char *value, const char *cells) {
  write_mission(key, value);
  scratch_read("m.yaml");
  scratch_expect_cells(cells);
}

static void refuse(const char *key, const char *value, const char *where, const char *what, const char *mend) {
  write_mission(key, value);
  scratch_refuse("m.yaml", where, what, mend);
}

/* ---- keepout ---- */

static void test_dark_pixels_keep_robots_out_of_every_cell_that_they_cut(void) {
  scratch_write("k.pgm", "P2\n5 4\n255\n255 0 127 128 255\n255 255 255 255 255\n255 255 255 255 255\n"
                         "255 255 255 255 255\n");
  expect_cells("keepout", "k.pgm", "1##11|11111|11#11|11111|");
  scratch_write("k.pgm", "P2\n3 2\n1\n1 0 1\n1 1 1\n"); /* of the same proportions, as near as pixels come */
  expect_cells("keepout", "k.pgm", "1###1|1###1|11#11|11111|");
}

static void test_numbers_but_0_of_a_grid_keep_robots_out_where_it_lies(void) {
  scratch_write("k.asc", "ncols 2\nnrows 2\nxllcorner 3\nyllcorner 1\ncellsize 1\n1 0\n-9999 -2\n");
  expect_cells("keepout", "k.asc", "11111|111#1|11#1#|11111|");
}

static void test_a_keepout_that_leaves_nothing_is_refused(void) {
  scratch_write("k.pgm", "P2\n5 4\n1\n0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n");
  refuse("keepout", "k.pgm", "m.yaml:4", "'keepout' leaves no cell", "check");
  scratch_write("k.pgm", "P2\n5 5\n1\n0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n");
  refuse("keepout", "k.pgm", "k.pgm", "5 x 5 pixels, and the map 5 x 4 cells", "cut it");
  scratch_write("k.asc", "ncols 1\nnrows 1\nxllcorner 9\nyllcorner 1\ncellsize 1\n1\n");
  refuse("keepout", "k.asc", "k.asc", "lies beside the map", "mend");
  refuse("keepout", "none.pgm", "none.pgm", "no such file", "m.yaml:4)");
}

/* ---- terrain ---- */

static void test_greys_are_the_costs_of_cells(void) {
  scratch_write("t.pgm", "P2\n5 4\n255\n1 2 3 4 5\n0 1 1 1 1\n9 9 9 9 9\n1 1 1 1 7\n");
  expect_cells("terrain", "t.pgm", "12345|#1111|99#99|11117|");
}

static void test_the_worst_of_what_lies_over_a_cell_counts(void) {
  scratch_write("t.asc", "ncols 4\nnrows 2\nxllcorner 1\nyllcorner 3\ncellsize 0.5\n1 2 0 4\n3 1 5 -9999\n");
  expect_cells("terrain", "t.asc", "13#11|11111|11#11|11111|");
}

static void test_costs_that_are_none(void) {
  scratch_write("t.asc", "ncols 1\nnrows 1\nxllcorner 1\nyllcorner 3\ncellsize 1\n256\n");
  refuse("terrain", "t.asc", "t.asc", "column 0, row 0 (from 0) is 256", "1 to 255");
  scratch_write("t.asc", "ncols 1\nnrows 1\nxllcorner 1\nyllcorner 3\ncellsize 1\n1.5\n");
  refuse("terrain", "t.asc", "t.asc", "is 1.5", "1 to 255");
  scratch_write("t.asc", "ncols 1\nnrows 1\nxllcorner 1\nyllcorner 3\ncellsize 1\nnan\n");
  refuse("terrain", "t.asc", "t.asc:6:1", "not a finite number", "number");
}

/* ---- no_go ---- */

static void test_cells_that_a_polygon_cuts_are_blocked_and_no_others(void) {
  expect_cells("no_go", "[[{x: 1, y: 2}, {x: 3, y: 2}, {x: 3, y: 4}, {x: 1, y: 4}]]", "1##11|1##11|11#11|11111|");
  expect_cells("no_go", "[[{x: 0.5, y: 2.5}, {x: 3.1, y: 2.5}, {x: 3.1, y: 2.6}]]", "11111|####1|11#11|11111|");
  expect_cells("no_go", "[[{x: 3, y: 0}, {x: 5, y: 2}, {x: 3, y: 2}]]", "11111|11111|11###|111#1|");
  expect_cells("no_go", "[[{column: 1, row: 0}, {column: 3, row: 0}, {column: 3, row: 1}]]",
               "1###1|11##1|11#11|11111|");
}

static void test_polygons_may_reach_over_the_edge_and_overlap(void) {
  scratch_write("a.txt", ".....\n..S..\n..#..\n1....\n");
  scratch_write("m.yaml", "map: a.txt\nno_go: [[{x: -9, y: 3}, {x: 1, y: 3}, {x: 1, y: 9}, {x: -9, y: 9}], [{x: 4, y: "
                          "-1}, {x: 9, y: -1}, {x: 4, y: 9}], "
                          "[{x: 0, y: 3}, {x: 2, y: 3}, {x: 2, y: 4}, {x: 0, y: 4}, {x: 0, y: 3}]]\n");
  scratch_read("m.yaml");
  scratch_expect_cells("##11#|1111#|11#1#|1111#|");
}

static void test_polygons_that_are_none(void) {
  refuse("no_go", "[[{x: 1, y: 1}, {x: 2, y: 1}]]", "m.yaml:4", "polygon 0 of 'no_go' has 2 corners", "3 at least");
  refuse("no_go", "[[{x: 1, y: 1}, {x: 2, y: 1}, {x: 1, y: 1}]]", "m.yaml:4", "has 2 corners", "3 at least");
  refuse("no_go", "[[{x: 1, y: 1}, {x: 3, y: 3}, {x: 3, y: 1}, {x: 1, y: 3}]]", "m.yaml:4",
         "crosses itself: its edges behind corners 0 and 2 meet", "in their order");
  refuse("no_go", "[[{x: 1, y: 1}, {x: 3, y: 1}, {x: 2, y: 1}]]", "m.yaml:4", "crosses itself", "in their order");
  refuse("no_go", "[[{x: 1, y: 1}, {x: 2, y: 1}, {x: 1, y: 2}], [{x: 9, y: 9}, {x: 12, y: 9}, {x: 9, y: 12}]]",
         "m.yaml:4", "polygon 1 of 'no_go' lies outside the map, which spans x 0 to 5 and y 0 to 4", "move");
  refuse("no_go", "[[{x: -9, y: -9}, {x: 99, y: -9}, {x: 99, y: 99}, {x: -9, y: 99}]]", "m.yaml:4",
         "'no_go' leaves no cell", "check");
  refuse("no_go", "[{x: 1, y: 1}]", "m.yaml:4", "polygon 0 of 'no_go' is not a list", "write its corners");
  refuse("no_go", "[[{x: 1, y: nan}, {x: 2, y: 1}, {x: 1, y: 2}]]", "m.yaml:4", "'y'", "number");
  refuse("no_go", "[[{x: 1}, {x: 2, y: 1}, {x: 1, y: 2}]]", "m.yaml:4", "corner 0 of polygon 0", "y");
  refuse("no_go", "{}", "m.yaml:4", "'no_go'", "list");
}

/* A place on barred ground is told of like one on an obstacle. */
static void test_places_on_barred_ground_are_refused(void) {
  refuse("no_go", "[[{x: 4, y: 0}, {x: 5, y: 0}, {x: 5, y: 1}]]", "m.yaml:3", "place 0 stands on an obstacle",
         "move it");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_dark_pixels_keep_robots_out_of_every_cell_that_they_cut);
  RUN_TEST(test_numbers_but_0_of_a_grid_keep_robots_out_where_it_lies);
  RUN_TEST(test_a_keepout_that_leaves_nothing_is_refused);
  RUN_TEST(test_greys_are_the_costs_of_cells);
  RUN_TEST(test_the_worst_of_what_lies_over_a_cell_counts);
  RUN_TEST(test_costs_that_are_none);
  RUN_TEST(test_cells_that_a_polygon_cuts_are_blocked_and_no_others);
  RUN_TEST(test_polygons_may_reach_over_the_edge_and_overlap);
  RUN_TEST(test_polygons_that_are_none);
  RUN_TEST(test_places_on_barred_ground_are_refused);
  return UNITY_END();
}
