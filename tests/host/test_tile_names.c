/* What tiles are called: by column and row, as squares of a map are, and by what they are of. */
#include <stdio.h>
#include <string.h>

#include "host/base/naming.h"
#include "host/input/tile_names.h"
#include "unity.h"

static input in;
static char name[QTR_SITE_NAME_BYTES];

void setUp(void) {
  memset(&in, 0, sizeof in);
}

void tearDown(void) {
}

static void expect(const char *wanted, tile_naming tile) {
  if (tile.file == NULL) tile.file = "folder.d/likely ground.pgm";
  tile_name(name, &tile, &in);
  TEST_ASSERT_EQUAL_STRING(wanted, name);
}

static void add(const char *place) {
  snprintf(in.names.place[in.mission.places++], QTR_SITE_NAME_BYTES, "%s", place);
}

static void test_columns_are_letters_and_rows_numbers_of_as_many_digits_as_the_last(void) {
  expect("A1", (tile_naming){.column = 0, .row = 0, .rows = 9, .plain = true});
  expect("B07", (tile_naming){.column = 1, .row = 6, .rows = 10, .plain = true});
  expect("Z100", (tile_naming){.column = 25, .row = 99, .rows = 100, .plain = true});
  expect("AA1", (tile_naming){.column = 26, .row = 0, .rows = 1, .plain = true});
  expect("AZ1", (tile_naming){.column = 51, .row = 0, .rows = 1, .plain = true});
  expect("BA1", (tile_naming){.column = 52, .row = 0, .rows = 1, .plain = true});
  expect("ZZ1", (tile_naming){.column = 701, .row = 0, .rows = 1, .plain = true});
  expect("AAA1", (tile_naming){.column = 702, .row = 0, .rows = 1, .plain = true});
}

static void test_no_two_tiles_share_a_name(void) {
  enum { COLUMNS = 60, ROWS = 11 };
  static char seen[COLUMNS * ROWS][QTR_SITE_NAME_BYTES];
  for (size_t at = 0; at < COLUMNS * ROWS; at++) {
    tile_name(seen[at],
              &(tile_naming){.column = at % COLUMNS, .row = at / COLUMNS, .rows = ROWS, .file = "x", .plain = true},
              &in);
    for (size_t before = 0; before < at; before++) TEST_ASSERT_FALSE(strcmp(seen[before], seen[at]) == 0);
  }
}

static void test_a_name_that_a_place_has_goes_by_the_file(void) {
  const tile_naming tile = {.rows = 1, .plain = true};
  add("A1");
  expect("likely ground A1", tile);
  add("likely ground A1");
  expect("", tile);
}

static void test_tiles_of_a_second_file_go_by_it(void) {
  expect("likely ground A1", (tile_naming){.rows = 1});
  expect("areas A1", (tile_naming){.rows = 1, .file = "areas"});
  expect(".hidden A1", (tile_naming){.rows = 1, .file = "a/.hidden"});
}

static void test_an_area_names_its_tiles(void) {
  const tile_area one = {"Orchard", 1}, two = {"Orchard", 2}, nameless = {"", 1};
  expect("Orchard", (tile_naming){.rows = 1, .area = &one, .plain = true});
  expect("Orchard A1", (tile_naming){.rows = 1, .area = &two});
  expect("A1", (tile_naming){.rows = 1, .area = &nameless, .plain = true});
  add("Orchard");
  expect("Orchard A1", (tile_naming){.rows = 1, .area = &one});
}

static void test_what_would_be_no_name_is_passed_over(void) {
  char path[200];
  tile_area area = {"", 2};
  memset(area.name, 'o', QTR_SITE_NAME_BYTES - 1);
  expect("A1", (tile_naming){.rows = 1, .area = &area, .plain = true});
  memset(path, 'p', sizeof path);
  path[sizeof path - 1] = '\0';
  expect("", (tile_naming){.rows = 1, .file = path});
  expect("", (tile_naming){.rows = 1, .file = "\xff.asc"});
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_columns_are_letters_and_rows_numbers_of_as_many_digits_as_the_last);
  RUN_TEST(test_no_two_tiles_share_a_name);
  RUN_TEST(test_a_name_that_a_place_has_goes_by_the_file);
  RUN_TEST(test_tiles_of_a_second_file_go_by_it);
  RUN_TEST(test_an_area_names_its_tiles);
  RUN_TEST(test_what_would_be_no_name_is_passed_over);
  return UNITY_END();
}
