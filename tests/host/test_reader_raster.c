#include <math.h>

#include "support/reader_scratch.h"

#define GRID "ncols 6\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n"

/* Two rooms; the right one is out of reach. */
#define ROOMS "....#.\n....#.\n....#.\nS...#.\n"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", ROOMS);
  scratch_write("m.yaml", "map: a.txt\nplaces_raster: {file: p.asc, footprint: 2, share: 1}\n");
}

void tearDown(void) {
  scratch_close();
}

static void write_mission(const char *map, const char *key) {
  char text[300];
  snprintf(text, sizeof text, "map: %s\nplaces_raster: %s\n", map, key);
  scratch_write("m.yaml", text);
}

static void expect_place(int place, unsigned column, unsigned row, double weight) {
  const qtr_mission *mission = &scratch_input.mission;
  TEST_ASSERT_LESS_THAN_INT(mission->places, place);
  TEST_ASSERT_EQUAL_INT(row * mission->columns + column, mission->place[place]);
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, weight, mission->weight[place]);
}

static void expect_note(const char *wanted) {
  for (int i = 0; i < scratch_input.note.count; i++)
    if (strstr(scratch_input.note.text[i], wanted) != NULL) return;
  TEST_FAIL_MESSAGE(scratch_input.note.count > 0 ? scratch_input.note.text[0] : "no note");
}

/* Tiles of 2 x 2 cells, counted from the lower left corner: the likeliest is place 0. */
static void test_a_grid_becomes_a_place_a_tile_at_the_middle_of_its_mass(void) {
  scratch_write("p.asc", GRID "0 0 0 3 0 0\n0 0 0 1 0 0\n1 1 0 0 0 0\n1 2 0 0 0 0\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  expect_place(0, 1, 3, 5.0); /* the middle is at 0.6, 2.6 */
  expect_place(1, 3, 0, 4.0);
  expect_note("m.yaml:2: 2 places of 2 tiles hold 100 % of the likelihood within reach");
}

static void test_the_likeliest_tiles_are_taken_until_they_cover_the_share(void) {
  scratch_write("p.asc", GRID "4 0 3 0 0 0\n0 0 0 0 0 0\n2 0 1 0 0 0\n0 0 0 0 0 0\n");
  write_mission("a.txt", "{file: p.asc, footprint: 2, share: 0.7}");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  expect_place(0, 0, 0, 4.0);
  expect_place(1, 2, 0, 3.0);
  write_mission("a.txt", "{file: p.asc, footprint: 2, share: 0.71}");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.places);
  write_mission("a.txt", "{file: p.asc, footprint: 2}");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(4, scratch_input.mission.places);
}

/* By column and row from the lower left, whichever of them are taken, and in which order. */
static void test_tiles_are_named_by_where_they_lie(void) {
  scratch_write("p.asc", GRID "4 0 3 0 0 0\n0 0 0 0 0 0\n2 0 1 0 0 0\n0 0 0 0 0 0\n");
  write_mission("a.txt", "{file: p.asc, footprint: 2, share: 0.7}");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_STRING("A2", scratch_input.names.place[0]);
  TEST_ASSERT_EQUAL_STRING("B2", scratch_input.names.place[1]);
  scratch_write("p.asc", GRID "4 0 9 0 0 0\n0 0 0 0 0 0\n7 0 1 0 0 0\n0 0 0 0 0 0\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_STRING("B2", scratch_input.names.place[0]);
  TEST_ASSERT_EQUAL_STRING("A1", scratch_input.names.place[1]);
}

static void test_what_no_robot_gets_to_is_told_and_not_counted(void) {
  scratch_write("p.asc", GRID "4 0 0 0 0 12\n0 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.places);
  expect_place(0, 0, 0, 4.0);
  expect_note("75 % of all lies where no robot gets to");
}

/* Behind the rough ground in the middle only drones get, and behind the wall nobody. */
static void test_what_some_classes_alone_get_to_is_left_to_them_and_told(void) {
  scratch_write("rough.txt", "..~.#.\n..~.#.\n");
  scratch_write("p.asc", "ncols 6\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 0 0 3 0 4\n0 0 0 2 0 0\n");
  scratch_write("m.yaml", "map: rough.txt\nplaces_raster: {file: p.asc, footprint: 1}\nclasses: {drone: {}, rover: "
                          "{rough: false}}\nrobots: [{column: 0, row: 0, class: rover}, {column: 1, row: 0, class: "
                          "drone}]\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.places);
  expect_place(0, 3, 0, 3.0);
  expect_note("40 % of all lies where no robot gets to, 1 tile around column 5, row 0");
  expect_note("m.yaml:2: 2 places with 83.3 % of the likelihood within reach are left to drone: no other class");
  scratch_write("m.yaml", "map: rough.txt\nplaces_raster: {file: p.asc, footprint: 1}\nclasses: {rover: "
                          "{rough: false}}\nrobots: [{column: 0, row: 0, class: rover}]\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.places);
  expect_note("90 % of all lies where no robot gets to, 3 tiles, the likeliest around column 5, row 0");
}

/* Values of 2 cells a side over the left third of the map's lower half. */
static void test_a_grid_that_leaves_ground_out_is_told(void) {
  scratch_write("p.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 2\n7\n");
  scratch_read("m.yaml");
  expect_note("p.asc: covers 16.7 % of the map: elsewhere there is no likelihood");
}

static void test_a_grid_says_where_it_lies(void) {
  /* Values of 2 cells a side, half of them left of the map; each covers a tile. */
  scratch_write("p.asc", "NCOLS 2\nNROWS 2\nXLLCENTER -1\nYLLCENTER 1\nCELLSIZE 2\n7 3\n5 1\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  expect_place(0, 0, 0, 3.0); /* the middle is at 0.5, 0.5: the first of four as near */
  expect_place(1, 0, 2, 1.0);
  expect_note("75 % of all lies off the map");
}

static void test_values_are_shared_among_the_cells_under_them(void) {
  scratch_write("p.asc", "ncols 1\nnrows 1\nxllcorner 1.5\nyllcorner 0\ncellsize 2\n8\n");
  write_mission("a.txt", "{file: p.asc, footprint: 1}");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(6, scratch_input.mission.places);
  expect_place(0, 2, 2, 4.0 * 0.5);
  expect_place(1, 2, 3, 4.0 * 0.5);
  expect_place(2, 1, 2, 4.0 * 0.25);
  expect_place(5, 3, 3, 4.0 * 0.25);
}

static void test_no_data_is_no_likelihood(void) {
  scratch_write("p.asc", GRID "-9999 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n0 1 0 0 0 -9999\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.places);
  expect_place(0, 1, 3, 1.0);
}

static void test_an_image_covers_the_map_and_bright_is_likely(void) {
  scratch_write("p.pgm", "P2\n12 8\n255\n255 0 0 0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0 0 0 0 0\n"
                         "0 0 0 0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0 0 0 0 0\n"
                         "0 0 0 0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 51 0 0 0 0 0\n");
  write_mission("a.txt", "{file: p.pgm, footprint: 1}");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  expect_place(0, 0, 0, 255.0);
  expect_place(1, 3, 3, 51.0);
}

/* 5 x 3 pixels of 1 m, cells of 2 m: the image covers 5 x 3 m, and the last column and the top row of cells are cut. */
static void test_an_image_covers_the_maps_own_pixels_and_footprints_are_metres(void) {
  scratch_write_rosmap("image: m.pgm\nresolution: 1.0\norigin: [10, 20, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                       "free_thresh: 0.196\n",
                       "P2\n5 3\n255\n254 254 254 254 254\n254 254 254 254 254\n254 254 254 254 254\n",
                       "map: m.yaml\ncell_size: 2\nrobots: [{x: 10.5, y: 20.5}]\n"
                       "places_raster: {file: p.pgm, footprint: 2}\n");
  scratch_write("p.pgm", "P2\n5 3\n255\n0 0 0 0 0\n0 0 8 0 0\n4 0 0 0 0\n");
  scratch_read("mission.yaml");
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  expect_place(0, 1, 1, 8.0);
  expect_place(1, 0, 1, 4.0);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 13.0, scratch_input.place_position[0].x);
  scratch_write("p.asc", "ncols 1\nnrows 1\nxllcorner 12\nyllcorner 20\ncellsize 2\n6\n");
  scratch_write("mission.yaml", "map: m.yaml\ncell_size: 2\nrobots: [{x: 10.5, y: 20.5}]\n"
                                "places_raster: {file: p.asc, footprint: 2}\n");
  scratch_read("mission.yaml");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.places);
  expect_place(0, 1, 1, 6.0);
}

static void test_they_come_after_listed_places_and_keep_out_of_their_cells(void) {
  scratch_write("p.asc", GRID "4 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n");
  scratch_write("m.yaml", "map: a.txt\nplaces_raster: {file: p.asc, footprint: 2}\n"
                          "places: [{column: 0, row: 0, weight: 9}]\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  expect_place(0, 0, 0, 9.0);
  expect_place(1, 1, 0, 4.0);
}

/* ---- bad input ---- */

static void refuse(const char *asc, const char *where, const char *what, const char *mend) {
  scratch_write("p.asc", asc);
  scratch_refuse("m.yaml", where, what, mend);
}

static void test_values_that_are_no_likelihoods(void) {
  refuse(GRID "0 0 0 0 0 0\n0 nan 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n", "p.asc:8:3", "\"nan\" is not a finite number",
         "number");
  refuse(GRID "nan 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n", "p.asc:7:1", "\"nan\" is not a finite",
         "number");
  refuse(GRID "0 0 0 0 0 0\n0 0,5 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n", "p.asc:8:3", "\"0,5\"", "a point should be");
  refuse(GRID "0 0 0 0 0 0\n0 0 -1 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n", "p.asc", "column 2, row 1 (from 0) is -1",
         "0 or more");
  refuse(GRID "0 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n", "m.yaml:2", "no likelihood above 0", "mend");
  refuse(GRID "0 0 0 0 0 1\n0 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n", "m.yaml:2", "where no robot gets to", "check");
}

static void test_grids_that_are_cut_or_too_long(void) {
  refuse("ncols 600\nnrows 400\nxllcorner 0\nyllcorner 0\ncellsize 1\n0 0 0\n", "p.asc",
         "ends before its 600 x 400 values", "copy");
  refuse(GRID "0 0 0 0 0 0\n", "p.asc:7", "ends after 6 of 24 values", "copy");
  refuse(GRID "0 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 0\n0 0 0 0 0 1\n5\n", "p.asc:11:1", "stands behind the last value",
         "mend");
  refuse("ncols 6\nnrows\n", "p.asc", "ends within the header", "copy");
  refuse("ncols 6\nnrows 4\n", "p.asc", "holds no values", "copy");
}

static void test_headers_that_do_not_hold(void) {
  refuse("ncols 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n", "p.asc", "lacks 'nrows'", "add");
  refuse("ncols 1\nnrows 1\nxllcorner 0\ncellsize 1\n5\n", "p.asc", "lacks 'yllcorner'", "add");
  refuse("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ndx 1\n5\n", "p.asc:5:1", "\"dx\" is no word", "cellsize");
  refuse("ncols 1\nncols 1\n5\n", "p.asc:2:1", "is there twice", "keep one");
  refuse("ncols 1\nnrows 1\nxllcorner 0\nxllcenter 0\nyllcorner 0\ncellsize 1\n5\n", "p.asc", "both", "keep one");
  refuse("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 0\n5\n", "p.asc", "'cellsize' is 0", "above 0");
  refuse("ncols 1.5\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n", "p.asc", "1.5 columns", "mend");
  refuse("ncols 1e5\nnrows 1e9\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n", "p.asc", "the most that are read", "cut");
  refuse("ncols x\n", "p.asc:1:7", "\"x\" is not a number", "number");
}

static void test_rasters_of_another_extent(void) {
  refuse("ncols 1\nnrows 1\nxllcorner 6\nyllcorner 0\ncellsize 1\n5\n", "p.asc",
         "spans x 6 to 7 and y 0 to 1 and lies beside the map, which spans x 0 to 6 and y 0 to 4", "in cells");
  write_mission("a.txt", "{file: p.pgm, footprint: 2}");
  scratch_write("p.pgm", "P2\n4 4\n1\n1 1 1 1\n1 1 1 1\n1 1 1 1\n1 1 1 1\n");
  scratch_refuse("m.yaml", "p.pgm", "4 x 4 pixels, and the map 6 x 4 cells", "cut it to the map");
}

static void test_files_that_are_no_rasters(void) {
  refuse("hello\n", "p.asc", "is no raster that is read", "ESRI ASCII grid");
  write_mission("a.txt", "{file: none.asc, footprint: 2}");
  scratch_refuse("m.yaml", "none.asc", "no such file", "m.yaml:2)");
}

static void test_settings(void) {
  scratch_write("p.asc", GRID "0 0 0 3 0 0\n0 0 0 1 0 0\n1 1 0 0 0 0\n1 2 0 0 0 0\n");
  write_mission("a.txt", "p.asc");
  scratch_refuse("m.yaml", "m.yaml:2", "'places_raster'", "file");
  write_mission("a.txt", "{file: p.asc}");
  scratch_refuse("m.yaml", "m.yaml:2", "footprint", "footprint: 5");
  write_mission("a.txt", "{file: p.asc, footprint: 0.5}");
  scratch_refuse("m.yaml", "m.yaml:2", "footprint of 0.5 is less than a cell, 1",
                 "smaller cells, or write \"footprint: 1\"");
  write_mission("a.txt", "{file: p.asc, footprint: 2, share: 1.5}");
  scratch_refuse("m.yaml", "m.yaml:2", "'share' is 1.5", "up to 1");
  write_mission("a.txt", "{file: p.asc, footprint: 2, share: nan}");
  scratch_refuse("m.yaml", "m.yaml:2", "'share'", "number");
}

/* As likely everywhere, with more cells than the build holds places. */
static void test_more_places_than_the_build_holds(void) {
  static char map[4096], grid[16384];
  const int columns = 64, rows = QTR_MAX_PLACES / 64 + 2;
  size_t at = 0, used = (size_t)snprintf(grid, sizeof grid,
                                         "ncols %d\nnrows %d\nxllcorner 0\nyllcorner 0\ncellsize 1\n", columns, rows);
  TEST_ASSERT_LESS_THAN_size_t(sizeof map, (size_t)(columns + 1) * (size_t)rows);
  for (int cell = 0; cell < columns * rows; cell++) {
    const bool last = cell % columns == columns - 1;
    at += (size_t)snprintf(map + at, sizeof map - at, "%c%s", cell == 0 ? 'S' : '.', last ? "\n" : "");
    used += (size_t)snprintf(grid + used, sizeof grid - used, "1%s", last ? "\n" : " ");
  }
  char fits[32];
  snprintf(fits, sizeof fits, "\"share: %g\" fits", floor(1000.0 * QTR_MAX_PLACES / (columns * rows)) / 1000.0);
  scratch_write("big.txt", map);
  write_mission("big.txt", "{file: p.asc, footprint: 1}");
  refuse(grid, "m.yaml:2", fits, "larger footprint");
  char key[100];
  snprintf(key, sizeof key, "{file: p.asc, footprint: 1, share: %g}",
           floor(1000.0 * QTR_MAX_PLACES / (columns * rows)) / 1000.0);
  write_mission("big.txt", key);
  scratch_read("m.yaml");
  TEST_ASSERT_LESS_OR_EQUAL_INT(QTR_MAX_PLACES, scratch_input.mission.places);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_grid_becomes_a_place_a_tile_at_the_middle_of_its_mass);
  RUN_TEST(test_the_likeliest_tiles_are_taken_until_they_cover_the_share);
  RUN_TEST(test_tiles_are_named_by_where_they_lie);
  RUN_TEST(test_what_no_robot_gets_to_is_told_and_not_counted);
  RUN_TEST(test_what_some_classes_alone_get_to_is_left_to_them_and_told);
  RUN_TEST(test_a_grid_that_leaves_ground_out_is_told);
  RUN_TEST(test_a_grid_says_where_it_lies);
  RUN_TEST(test_values_are_shared_among_the_cells_under_them);
  RUN_TEST(test_no_data_is_no_likelihood);
  RUN_TEST(test_an_image_covers_the_map_and_bright_is_likely);
  RUN_TEST(test_an_image_covers_the_maps_own_pixels_and_footprints_are_metres);
  RUN_TEST(test_they_come_after_listed_places_and_keep_out_of_their_cells);
  RUN_TEST(test_values_that_are_no_likelihoods);
  RUN_TEST(test_grids_that_are_cut_or_too_long);
  RUN_TEST(test_headers_that_do_not_hold);
  RUN_TEST(test_rasters_of_another_extent);
  RUN_TEST(test_files_that_are_no_rasters);
  RUN_TEST(test_settings);
  RUN_TEST(test_more_places_than_the_build_holds);
  return UNITY_END();
}
