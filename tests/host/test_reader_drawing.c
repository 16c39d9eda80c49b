#include "host/input/frame.h"
#include "support/reader_scratch.h"

void setUp(void) {
  scratch_open();
}

void tearDown(void) {
  scratch_close();
}

static void test_every_character_becomes_its_cell(void) {
  scratch_write("a.txt", "; a comment\nS.#\n~19\n");
  scratch_read("a.txt");
  const qtr_mission *mission = &scratch_input.mission;
  TEST_ASSERT_EQUAL_INT(3, mission->columns);
  TEST_ASSERT_EQUAL_INT(2, mission->rows);
  scratch_expect_cells("11#|311|");
  TEST_ASSERT_EQUAL_INT(1, mission->seekers);
  TEST_ASSERT_EQUAL_INT(0, mission->start[0]);
  TEST_ASSERT_EQUAL_INT(2, mission->places);
  TEST_ASSERT_EQUAL_INT(4, mission->place[0]);
  TEST_ASSERT_EQUAL_DOUBLE(1.0, mission->weight[0]);
  TEST_ASSERT_EQUAL_INT(5, mission->place[1]);
  TEST_ASSERT_EQUAL_DOUBLE(9.0, mission->weight[1]);
}

static void test_defaults_are_the_missions(void) {
  scratch_write("a.txt", "S1\n");
  scratch_read("a.txt");
  TEST_ASSERT_EQUAL_INT(QTR_DISCOUNTED, scratch_input.mission.aim.kind);
  TEST_ASSERT_EQUAL_INT(QTR_RULE_FREE, scratch_input.mission.rule);
  TEST_ASSERT_EQUAL_DOUBLE(0.99, scratch_input.mission.aim.gamma);
  TEST_ASSERT_FALSE(scratch_input.gamma_given || scratch_input.objective_given || scratch_input.rule_given);
  TEST_ASSERT_FALSE(scratch_input.frame.metric);
  TEST_ASSERT_EQUAL_STRING(scratch_input.path, scratch_input.map);
}

static void test_one_start_serves_all_robots(void) {
  scratch_write("a.txt", "1.S\n");
  scratch_options.robots = 3;
  scratch_read("a.txt");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.seekers);
  for (int i = 0; i < 3; i++) TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.start[i]);
}

static void test_several_starts_are_seekers_in_reading_order(void) {
  scratch_write("a.txt", "1.S\nS.S\n");
  scratch_read("a.txt");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.seekers);
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.start[1]);
  TEST_ASSERT_EQUAL_INT(5, scratch_input.mission.start[2]);
  scratch_options.robots = 3;
  scratch_read("a.txt");
  scratch_options.robots = 2;
  scratch_refuse("a.txt", "a.txt", "2 robots asked for, but the input has 3 starts", "ask for 3");
}

static void test_line_ends_marks_and_comments_of_other_systems(void) {
  scratch_write("a.txt", "\xef\xbb\xbfS.1\r\n; between\r\n###\r\n\r\n  \r\n");
  scratch_read("a.txt");
  scratch_expect_cells("111|###|");
  scratch_write("b.txt", "\n\nS.1\n###");
  scratch_read("b.txt");
  scratch_expect_cells("111|###|");
}

static void test_contents_decide_not_the_extension(void) {
  scratch_write("a.yaml", "####\n#S1#\n####\n");
  scratch_read("a.yaml");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.places);
  scratch_write("b.map", "S.1\n");
  scratch_read("b.map");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.columns);
}

static void test_places_and_starts_have_names_and_positions(void) {
  char name[160], wanted[160];
  scratch_write("a.txt", "; here\nS.1\n..2\n");
  scratch_read("a.txt");
  input_place_name(&scratch_input, 1, name, sizeof name);
  snprintf(wanted, sizeof wanted, "place 1 (%s:3:3)", scratch_path("a.txt"));
  TEST_ASSERT_EQUAL_STRING(wanted, name);
  input_seeker_name(&scratch_input, 0, name, sizeof name);
  snprintf(wanted, sizeof wanted, "seeker 0 (%s:2:1)", scratch_path("a.txt"));
  TEST_ASSERT_EQUAL_STRING(wanted, name);
  const input_position centre = frame_centre(&scratch_input, 2, true);
  TEST_ASSERT_EQUAL_DOUBLE(2.5, centre.x);
  TEST_ASSERT_EQUAL_DOUBLE(1.5, centre.y);
}

static void test_faults_name_line_and_column(void) {
  scratch_write("a.txt", "S.1\n..\n");
  scratch_refuse("a.txt", "a.txt:2", "2 cells, but the first one (line 1) has 3", "equally long");
  scratch_write("a.txt", "; c\nS.x\n");
  scratch_refuse("a.txt", "a.txt:2:3", "unknown character 'x'", "use #");
  scratch_write("a.txt", "S.0\n");
  scratch_refuse("a.txt", "a.txt:1:3", "unknown character '0'", "1 to 9");
  scratch_write_bytes("a.txt",
                      "S.\0"
                      "1\n",
                      5);
  scratch_refuse("a.txt", "a.txt:1:3", "unknown character 0x00", "use #");
  scratch_write("a.txt", "S.1 \n");
  scratch_refuse("a.txt", "a.txt:1:4", "unknown character 0x20", "use #");
  scratch_write("a.txt", "S.1\n\n...\n");
  scratch_refuse("a.txt", "a.txt:2", "an empty line between the rows", "delete it");
  scratch_write("a.txt", "..1\n");
  scratch_refuse("a.txt", "a.txt", "no start", "S");
  scratch_write("a.txt", "S..\n");
  scratch_refuse("a.txt", "a.txt", "no place", "1 to 9");
  scratch_write("a.txt", "; nothing\n\n");
  scratch_refuse("a.txt", "a.txt", "holds no rows", "draw");
}

static void test_limits_of_the_build_are_named(void) {
  static char text[QTR_MAX_CELLS + 8192];
  memset(text, '1', QTR_MAX_PLACES + 2);
  memcpy(text, "S", 1);
  strcpy(text + QTR_MAX_PLACES + 2, "\n");
  scratch_write("places.txt", text);
  scratch_refuse("places.txt", "places.txt:1:1026", "more than 1024 places", "QTR_MAX_PLACES");
  memset(text, 'S', QTR_MAX_SEEKERS + 1);
  strcpy(text + QTR_MAX_SEEKERS + 1, "1\n");
  scratch_write("robots.txt", text);
  scratch_refuse("robots.txt", "robots.txt:1:33", "more than 32 robots", "QTR_MAX_SEEKERS");
  size_t used = 0;
  for (int row = 0; row < 2049; row++) {
    memset(text + used, '.', 2048);
    text[used + 2048] = '\n';
    used += 2049;
  }
  scratch_write_bytes("cells.txt", text, used);
  scratch_refuse("cells.txt", "cells.txt:2049", "2048 x 2049 cells are more than 4194304", "QTR_MAX_CELLS");
  scratch_write("a.txt", "S1\n");
  scratch_options.robots = QTR_MAX_SEEKERS + 1;
  scratch_refuse("a.txt", "a.txt", "33 robots asked for, but this build holds 32", "QTR_MAX_SEEKERS");
}

static void test_a_cell_size_gives_it_metres(void) {
  scratch_write("a.txt", "S1\n");
  scratch_options.cell_size = 0.2;
  scratch_read("a.txt");
  TEST_ASSERT_EQUAL_UINT32(200000, scratch_input.mission.frame.cell_size_um);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_character_becomes_its_cell);
  RUN_TEST(test_defaults_are_the_missions);
  RUN_TEST(test_one_start_serves_all_robots);
  RUN_TEST(test_several_starts_are_seekers_in_reading_order);
  RUN_TEST(test_line_ends_marks_and_comments_of_other_systems);
  RUN_TEST(test_contents_decide_not_the_extension);
  RUN_TEST(test_places_and_starts_have_names_and_positions);
  RUN_TEST(test_faults_name_line_and_column);
  RUN_TEST(test_limits_of_the_build_are_named);
  RUN_TEST(test_a_cell_size_gives_it_metres);
  return UNITY_END();
}
