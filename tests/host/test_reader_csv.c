#include "support/reader_scratch.h"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", "S...\n....\n");
  scratch_write("m.yaml", "map: a.txt\nplaces_csv: p.csv\n");
}

void tearDown(void) {
  scratch_close();
}

static void expect_two(void) {
  const qtr_mission *mission = &scratch_input.mission;
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(2, mission->places);
  TEST_ASSERT_EQUAL_INT(5, mission->place[0]);
  TEST_ASSERT_EQUAL_DOUBLE(2.5, mission->weight[0]);
  TEST_ASSERT_EQUAL_INT(3, mission->place[1]);
  TEST_ASSERT_EQUAL_DOUBLE(40.0, mission->weight[1]);
}

static void refuse(const char *csv, const char *where, const char *what, const char *mend) {
  scratch_write("p.csv", csv);
  scratch_refuse("m.yaml", where, what, mend);
}

static void test_metres(void) {
  scratch_write("p.csv", "x,y,weight\n1.5,0.5,2.5\n3,1,4e1\n");
  expect_two();
}

static void test_cells_and_columns_in_any_order(void) {
  scratch_write("p.csv", "weight,row,column\n2.5,1,1\n40,0,3\n");
  expect_two();
}

static void test_blanks_quotes_comments_and_line_ends_of_other_systems(void) {
  scratch_write("p.csv", "\xef\xbb\xbf"
                         "# surveyed\r\n\"x\", y , weight\r\n 1.5,\"0.5\",2.5\r\n\r\n\t3,1,40");
  expect_two();
}

static void test_places_come_after_the_missions_own(void) {
  scratch_write("m.yaml", "map: a.txt\nplaces_csv: p.csv\nplaces: [{column: 2, row: 0}]\n");
  scratch_write("p.csv", "x,y,weight\n1.5,0.5,2.5\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.place[0]);
  TEST_ASSERT_EQUAL_INT(5, scratch_input.mission.place[1]);
}

static void test_headers(void) {
  refuse("1,2,3\n", "p.csv:1", "not the header \"x,y,weight\"", "write it above");
  refuse("x,y\n1,1\n", "p.csv:1", "has 2 fields, not 3", "x,y,weight");
  refuse("x,y,wieght\n", "p.csv:1", "not the header", "write it");
  refuse("x,x,weight\n", "p.csv:1", "not the header", "write it");
  refuse("x,row,weight\n", "p.csv:1", "not the header", "write it");
  refuse("x;y;weight\n", "p.csv:1", "has 1 field, not 3", "commas");
  refuse("# only a comment\n", "p.csv", "holds no header", "x,y,weight");
  refuse("x,y,weight\n", "m.yaml", "no place", "places");
  refuse("", "p.csv", "is empty", "m.yaml:2)");
}

static void test_fields(void) {
  refuse("x,y,weight\n1,1,1\n2,1\n", "p.csv:3", "has 2 fields, not 3", "commas");
  refuse("x,y,weight\n1,1,1,1\n", "p.csv:2", "has 4 fields, not 3", "commas");
  refuse("x,y,weight\n1,1,\n", "p.csv:2", "the weight \"\" is missing", "number");
  refuse("x,y,weight\n1,one,1\n", "p.csv:2", "the y \"one\" is not a number", "number");
  refuse("x,y,weight\n1,1,nan\n", "p.csv:2", "not a finite number", "number");
  refuse("x,y,weight\n1,1,1e999\n", "p.csv:2", "too large", "number");
  refuse("x,y,weight\n1,1,-1\n", "p.csv:2", "the weight -1", "likelihood");
  refuse("x,y,weight\n9,1,1\n", "p.csv:2", "x 9, y 1 lies outside the map", "move");
  refuse("column,row,weight\n1.5,1,1\n", "p.csv:2", "column 1.5, row 1 is not a cell", "whole numbers");
  refuse("x,y,weight\n1,0,1\n1.5,0.5,1\n", "p.csv:3", "place 1 lies in the same cell as place 0", "drop one");
}

static void test_no_such_file(void) {
  scratch_refuse("m.yaml", "p.csv", "no such file", "m.yaml:2)");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_metres);
  RUN_TEST(test_cells_and_columns_in_any_order);
  RUN_TEST(test_blanks_quotes_comments_and_line_ends_of_other_systems);
  RUN_TEST(test_places_come_after_the_missions_own);
  RUN_TEST(test_headers);
  RUN_TEST(test_fields);
  RUN_TEST(test_no_such_file);
  return UNITY_END();
}
