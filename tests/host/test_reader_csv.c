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

static void test_a_columns_name_is_any_word_for_a_key_in_any_case(void) {
  scratch_write("p.csv", "Row,Column,POA\n1,1,2.5\n0.0,3,40\n");
  expect_two();
  scratch_write("p.csv", "x,y,Likelihood\n1.5,0.5,2.5\n3,1,40\n");
  expect_two();
}

static void test_places_without_a_weight_count_alike(void) {
  scratch_write("p.csv", "x,y\n1.5,0.5\n3,1\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_DOUBLE(1.0, scratch_input.mission.weight[1]);
}

static void test_names_and_columns_of_the_users_own(void) {
  scratch_write("p.csv",
                "id,name,x,y,depth of soil,weight,\n7,\"Bay 3, \"\"left\"\"\",1.5,0.5,3 cm,2.5,\n8,,3,1,,40,\n");
  expect_two();
  TEST_ASSERT_EQUAL_STRING("Bay 3, \"left\"", scratch_input.names.place[0]);
  TEST_ASSERT_EQUAL_STRING("", scratch_input.names.place[1]);
  TEST_ASSERT_EQUAL_INT(1, scratch_input.note.count);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(scratch_input.note.text[0], "p.csv: columns are not used: 'id', 'depth of soil'"),
                               scratch_input.note.text[0]);
}

static void test_semicolons_leave_commas_to_numbers(void) {
  scratch_write("p.csv", "x;y;weight;name\r\n1,5;0,5;2,5;\"a;b\"\r\n3.0;1;4e1;c,d\r\n");
  expect_two();
  TEST_ASSERT_EQUAL_STRING("a;b", scratch_input.names.place[0]);
  TEST_ASSERT_EQUAL_STRING("c,d", scratch_input.names.place[1]);
  refuse("x;y;weight\n1.234,5;1;1\n", "p.csv:2:1", "'x' is \"1.234,5\"", "number");
}

static void test_quoted_fields_hold_line_breaks(void) {
  scratch_write("p.csv", "x,y,weight,remark\n1.5,0.5,2.5,\"two\nlines\"\n3,1,40,\n");
  expect_two();
  refuse("x,y,weight,remark\n1.5,0.5,2.5,\"two\nlines\"\n3,1,none,\n", "p.csv:4:5", "'weight' is \"none\"", "number");
}

static void test_headers(void) {
  refuse("1,2,3\n", "p.csv:1", "not the header \"x,y,weight\"", "write it above");
  refuse("x,y,wieght\n", "p.csv:1:5", "unknown column 'wieght'", "did you mean 'weight'?");
  refuse("clumn,row,weight\n", "p.csv:1", "the header has 'row' and lacks 'column'", "add that column");
  refuse("clumn,raw,weight\n", "p.csv:1:1", "unknown column 'clumn'", "did you mean 'column'?");
  refuse("x,x,weight\n", "p.csv:1:3", "the column 'x' is there twice", "keep one");
  refuse("x,y,weight,poa\n", "p.csv:1:12", "the column 'poa' is there twice, as 'weight' in column 3", "keep one");
  refuse("x,row,weight\n", "p.csv:1", "the header has 'x' and lacks 'y'", "add that column");
  refuse("x,y,column,row\n", "p.csv:1", "both metres and cells", "keep x and y, or column and row");
  refuse("name,weight\n", "p.csv:1", "the header has no position", "x and y, or column and row");
  refuse("lat,lon,weight\n", "p.csv:1", "latitudes and longitudes are not read here", "places_geojson");
  refuse("# only a comment\n", "p.csv", "holds no header", "x,y,weight");
  refuse("x,y,weight\n", "p.csv", "no place", "write one");
  refuse("", "p.csv", "is empty", "m.yaml:2)");
}

static void test_fields(void) {
  refuse("x,y,weight\n1,1,1\n2,1\n", "p.csv:3", "has 2 fields, not 3 as the header", "write as many");
  refuse("x,y,weight\n1,1,1,1\n", "p.csv:2", "has 4 fields, not 3", "write 0.5 and not 0,5");
  refuse("x,y,weight\n1,5,0,5,2\n", "p.csv:2", "has 5 fields, not 3", "put ; between all fields");
  refuse("x,y,weight\n1,1,\n", "p.csv:2:5", "'weight' has no value", "number");
  refuse("x,y,weight\n1,one,1\n", "p.csv:2:3", "'y' is \"one\", which is not a number", "number");
  refuse("x,y,weight\n1,1,nan\n", "p.csv:2:5", "not a finite number", "number");
  refuse("x,y,weight\n1,\"0,5\",1\n", "p.csv:2:3", "has a comma where a point should be", "number");
  refuse("x,y,weight\n1,1,1e999\n", "p.csv:2:5", "too large", "number");
  refuse("x,y,poa\n1,1,-1\n", "p.csv:2:5", "'poa' is -1", "a likelihood in any unit above 0");
  refuse("x,y,weight\n9,1,1\n", "p.csv:2", "x 9, y 1 lies outside the map", "move");
  refuse("column,row,weight\n1.5,1,1\n", "p.csv:2:1", "'column' is \"1.5\"", "whole number");
  refuse("x,y,weight\n1,0,1\n1.5,0.5,1\n", "p.csv:3", "place 1 lies in the same cell as place 0", "drop one");
  refuse("x,y,weight\n1,0,1\nX,Y,weight\n", "p.csv:3", "the header is there twice", "delete this line");
  refuse("x,y,name\n1,0,a\n2,0,a\n", "p.csv:3", "a second place is called 'a', after that of ", "p.csv:2");
  refuse("x,y,name\n1,0,a\xff\n", "p.csv:2:5", "'name' is \"a", "which is not UTF-8");
}

static void test_quotes(void) {
  refuse("x,y,name\n1,0,\"a\n2,0,b\n", "p.csv:2:5", "a quote begins here and has no end", "close it");
  refuse("x,y,name\n1,0,\"a\"b\n", "p.csv:2:8", "text stands behind a closing quote", "twice");
}

static void test_more_columns_than_are_read(void) {
  char text[400] = "x,y";
  for (int i = 0; i < 70; i++) strcat(text, ",a");
  refuse(text, "p.csv:1", "more than 64 fields", "leave some columns out");
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
  RUN_TEST(test_a_columns_name_is_any_word_for_a_key_in_any_case);
  RUN_TEST(test_places_without_a_weight_count_alike);
  RUN_TEST(test_names_and_columns_of_the_users_own);
  RUN_TEST(test_semicolons_leave_commas_to_numbers);
  RUN_TEST(test_quoted_fields_hold_line_breaks);
  RUN_TEST(test_headers);
  RUN_TEST(test_fields);
  RUN_TEST(test_quotes);
  RUN_TEST(test_more_columns_than_are_read);
  RUN_TEST(test_no_such_file);
  return UNITY_END();
}
