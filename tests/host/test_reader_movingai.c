#include "support/reader_scratch.h"

#define MISSION "map: a.map\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 3, row: 1}]\n"

void setUp(void) {
  scratch_open();
  scratch_write("m.yaml", MISSION);
}

void tearDown(void) {
  scratch_close();
}

static void test_ground_and_swamp_are_free_the_rest_blocked(void) {
  scratch_write("a.map", "type octile\nheight 2\nwidth 4\nmap\n.G@O\nTWSS\n");
  scratch_read("m.yaml");
  scratch_expect_cells("11##|##11|");
  TEST_ASSERT_EQUAL_INT(7, scratch_input.mission.place[0]);
  TEST_ASSERT_FALSE(scratch_input.frame.metric);
}

static void test_header_in_any_order_and_line_ends_of_other_systems(void) {
  scratch_write("a.map", "type octile\r\nwidth\t4\r\nheight  2 \r\nmap\r\n....\r\n....\r\n\r\n");
  scratch_read("m.yaml");
  scratch_expect_cells("1111|1111|");
}

static void test_metres_work_with_cells_of_one_metre(void) {
  scratch_write("a.map", "type octile\nheight 2\nwidth 4\nmap\n....\n....\n");
  scratch_write("x.yaml", "map: a.map\nrobots: [{x: 0.5, y: 0.5}]\nplaces: [{x: 3.9, y: 1}]\n");
  scratch_read("x.yaml");
  TEST_ASSERT_EQUAL_INT(4, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.place[0]);
}

static void test_a_map_alone_is_refused_with_how_to_write_a_mission(void) {
  scratch_write("a.map", "type octile\nheight 1\nwidth 2\nmap\n..\n");
  scratch_refuse("a.map", "a.map", "without robots and places", "map: a.map");
  scratch_expect_text("robots: [{column");
  scratch_expect_text("places: [{column");
}

static void test_faults_name_the_line(void) {
  scratch_write("a.map", "type tile\nheight 1\nwidth 2\nmap\n..\n");
  scratch_refuse("m.yaml", "a.map:1", "the type is not octile", "check");
  scratch_write("a.map", "height 1\nwidth 2\nmap\n..\n");
  scratch_refuse("a.map", "a.map:1", "not a Moving AI map", "check");
  scratch_write("a.map", "type octile\nheight 0\nwidth 2\nmap\n..\n");
  scratch_refuse("m.yaml", "a.map:2", "height is not a whole number of 1 or more", "height 32");
  scratch_write("a.map", "type octile\nheight 1\nheight 1\nwidth 2\nmap\n..\n");
  scratch_refuse("m.yaml", "a.map:3", "stated twice (first in line 2)", "keep one");
  scratch_write("a.map", "type octile\nheight 1\nmap\n..\n");
  scratch_refuse("m.yaml", "a.map:3", "before the width is stated", "width 32");
  scratch_write("a.map", "type octile\nheight 1\nwidth 2\nfoo\nmap\n..\n");
  scratch_refuse("m.yaml", "a.map:4", "not \"height\", \"width\" or \"map\"", "check");
  scratch_write("a.map", "type octile\nheight 1\nwidth 2\n");
  scratch_refuse("m.yaml", "a.map:3", "ends before the line \"map\"", "copy");
  scratch_write("a.map", "type octile\nheight 2\nwidth 2\nmap\n..\n");
  scratch_refuse("m.yaml", "a.map:5", "ends after 1 of 2 rows", "height (line 2)");
  scratch_write("a.map", "type octile\nheight 1\nwidth 2\nmap\n...\n");
  scratch_refuse("m.yaml", "a.map:5", "3 cells, but the width is 2", "agree");
  scratch_write("a.map", "type octile\nheight 1\nwidth 2\nmap\n..\n..\n");
  scratch_refuse("m.yaml", "a.map:6", "goes on after the 1 row of", "height (line 2)");
  scratch_write("a.map", "type octile\nheight 1\nwidth 2\nmap\n.x\n");
  scratch_refuse("m.yaml", "a.map:5:2", "unknown character 'x'", "use .");
}

static void test_absurd_sizes_are_refused_by_the_header(void) {
  scratch_write("a.map", "type octile\nheight 2049\nwidth 2048\nmap\n");
  scratch_refuse("m.yaml", "a.map:2", "2048 x 2049 cells are more than 4194304", "QTR_MAX_CELLS");
  scratch_write("a.map", "type octile\nheight 999999999\nwidth 999999999\nmap\n");
  scratch_refuse("m.yaml", "a.map:2", "999999999 x 999999999 cells", "at most 65535");
  scratch_write("a.map", "type octile\nheight 99999999999999999999\nwidth 1\nmap\n");
  scratch_refuse("m.yaml", "a.map:2", "height is not a whole number", "height 32");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_ground_and_swamp_are_free_the_rest_blocked);
  RUN_TEST(test_header_in_any_order_and_line_ends_of_other_systems);
  RUN_TEST(test_metres_work_with_cells_of_one_metre);
  RUN_TEST(test_a_map_alone_is_refused_with_how_to_write_a_mission);
  RUN_TEST(test_faults_name_the_line);
  RUN_TEST(test_absurd_sizes_are_refused_by_the_header);
  return UNITY_END();
}
