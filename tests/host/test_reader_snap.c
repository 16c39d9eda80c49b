/* Robots and places that are on no free cell of their own: all told at once, moved, or left out. */
#include <math.h>

#include "host/input/frame.h"
#include "support/random.h"
#include "support/reader_scratch.h"

/* Column 0 to 6, rows 0 to 4; a wall with a gap, and a pocket of a cell that nobody gets to. */
#define AREA                                                                                                           \
  "#######\n"                                                                                                          \
  "#..#..#\n"                                                                                                          \
  "#.....#\n"                                                                                                          \
  "#######\n"                                                                                                          \
  "####.##\n"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", AREA);
}

void tearDown(void) {
  scratch_close();
}

static void expect_line(int number, const char *what, const char *where) {
  const char *line = scratch_fault.text;
  for (int i = 0; i < number && line != NULL; i++) line = strchr(line, '\n') != NULL ? strchr(line, '\n') + 1 : NULL;
  TEST_ASSERT_NOT_NULL_MESSAGE(line, scratch_fault.text);
  char one[FAULT_LINE + 1];
  snprintf(one, sizeof one, "%.*s", (int)strcspn(line, "\n"), line);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(one, what), one);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(one, where), one);
}

static int lines_of_fault(void) {
  int lines = 1;
  for (const char *c = scratch_fault.text; *c != '\0'; c++) lines += *c == '\n';
  return lines;
}

static void refuse_all(const char *mission, int lines) {
  scratch_write("m.yaml", mission);
  TEST_ASSERT_EQUAL_INT(-1, input_read(&scratch_input, scratch_path("m.yaml"), &scratch_options, &scratch_fault));
  TEST_ASSERT_EQUAL_INT_MESSAGE(lines, lines_of_fault(), scratch_fault.text);
}

static void expect_note(const char *what) {
  for (int i = 0; i < scratch_input.note.count; i++)
    if (strstr(scratch_input.note.text[i], what) != NULL) return;
  TEST_FAIL_MESSAGE(what);
}

#define BAD                                                                                                            \
  "map: a.txt\nrobots:\n  - {column: 1, row: 1}\n  - {column: 0, row: 2}\nplaces:\n  - {column: 3, row: 1}\n"          \
  "  - {column: 4, row: 1}\n  - {column: 9, row: 2, weight: 2}\nplaces_csv: p.csv\n"

static void test_all_are_told_at_once_each_with_its_line_and_its_nearest_free_cell(void) {
  scratch_write("p.csv", "column,row,weight\n2,1,1\n3,3,1\n");
  refuse_all(BAD, 5);
  expect_line(0, "m.yaml: 3 places and 1 robot are not on a free cell of their own",
              "--snap 4, or left out by --skip-unreachable (places)");
  expect_line(1, "m.yaml:4: robot 1 stands on an obstacle, at column 0, row 2", "column 1, row 2, 1 cell away");
  expect_line(2, "m.yaml:6: place 0 stands on an obstacle, at column 3, row 1", "column 3, row 2, 1 cell away");
  expect_line(3, "m.yaml:8: place 2: column 9, row 2 lies outside the map, whose columns are 0 to 6 and rows 0 to 4",
              "column 5, row 2, 4 cells away");
  expect_line(4, "p.csv:3: place 4 stands on an obstacle, at column 3, row 3", "column 3, row 2, 1 cell away");
}

static void test_a_single_one_is_one_line_with_its_mend(void) {
  refuse_all("map: a.txt\nrobots: [{column: 1, row: 1}]\nplaces: [{column: 3, row: 1}]\n", 1);
  expect_line(0, "m.yaml:3: place 0 stands on an obstacle", "--snap 1, or left out by --skip-unreachable");
  refuse_all("map: a.txt\nrobots: [{column: 3, row: 1}]\nplaces: [{column: 1, row: 1}]\n", 1);
  expect_line(0, "m.yaml:2: robot 0 stands on an obstacle", "--snap 1");
  TEST_ASSERT_NULL(strstr(scratch_fault.text, "--skip-unreachable")); /* a robot is not left out */
}

static void test_two_places_of_one_cell_are_told_among_the_others(void) {
  refuse_all("map: a.txt\nrobots: [{column: 1, row: 1}]\nplaces:\n  - {column: 2, row: 2}\n  - {column: 0, row: 0}\n"
             "  - {column: 2, row: 2}\n",
             3);
  expect_line(1, "place 1 stands on an obstacle", "nearest");
  expect_line(2, "m.yaml:6: place 2 lies in the same cell as place 0", "drop one of them");
}

static void test_what_is_named_is_enough_for_snap(void) {
  scratch_write("p.csv", "column,row,weight\n2,1,1\n3,3,1\n");
  scratch_options.snap = 4.0;
  scratch_write("m.yaml", BAD);
  scratch_read("m.yaml");
  const qtr_mission *mission = &scratch_input.mission;
  TEST_ASSERT_EQUAL_INT(5, mission->places);
  TEST_ASSERT_EQUAL_INT(15, mission->start[1]);
  TEST_ASSERT_EQUAL_INT(17, mission->place[0]); /* column 3, row 2 */
  TEST_ASSERT_EQUAL_INT(19, mission->place[2]);
  expect_note("m.yaml:4: robot 1 stands on an obstacle, at column 0, row 2; moved to column 1, row 2, 1 cell away");
  expect_note("p.csv:3: place 4");
  scratch_options.snap = 3.9;
  TEST_ASSERT_EQUAL_INT(-1, input_read(&scratch_input, scratch_path("m.yaml"), &scratch_options, &scratch_fault));
  TEST_ASSERT_EQUAL_INT_MESSAGE(1, lines_of_fault(), scratch_fault.text);
  expect_line(0, "place 2: column 9, row 2 lies outside", "--snap 4");
}

/* Places 0 and 4 both have column 3, row 2 as the nearest: the second takes the next free one. */
static void test_moving_never_brings_two_places_together(void) {
  scratch_write("p.csv", "column,row,weight\n2,1,1\n3,3,1\n");
  scratch_options.snap = 4.0;
  scratch_write("m.yaml", BAD);
  scratch_read("m.yaml");
  const qtr_mission *mission = &scratch_input.mission;
  for (int i = 0; i < mission->places; i++)
    for (int j = 0; j < i; j++) TEST_ASSERT_NOT_EQUAL(mission->place[i], mission->place[j]);
  TEST_ASSERT_EQUAL_INT(16, mission->place[4]); /* column 2, row 2: in reading order before column 4 */
}

static void test_a_place_is_not_moved_to_where_no_robot_gets(void) {
  scratch_options.snap = 9.0;
  scratch_write("m.yaml", "map: a.txt\nrobots: [{column: 1, row: 1}]\nplaces: [{column: 4, row: 3}]\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(18, scratch_input.mission.place[0]); /* not the pocket below, column 4, row 4 */
}

static void test_left_out_places_leave_the_others_their_numbers(void) {
  scratch_write("p.csv", "column,row,weight\n2,1,7\n3,3,1\n");
  scratch_options.skip = true;
  scratch_write("m.yaml", "map: a.txt\nrobots: [{column: 1, row: 1}]\nplaces:\n  - {column: 3, row: 1}\n"
                          "  - {column: 4, row: 1}\n  - {column: 9, row: 2, weight: 2}\nplaces_csv: p.csv\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  TEST_ASSERT_EQUAL_INT(5, scratch_input.places_stated);
  TEST_ASSERT_EQUAL_INT(1, scratch_input.place_number[0]);
  TEST_ASSERT_EQUAL_INT(3, scratch_input.place_number[1]);
  TEST_ASSERT_EQUAL_DOUBLE(7.0, scratch_input.mission.weight[1]);
  expect_note("m.yaml:6: place 2: column 9, row 2 lies outside the map");
  char name[160];
  input_place_name(&scratch_input, 1, name, sizeof name);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(name, "place 3 ("), name);
}

static void test_both_move_what_is_near_and_leave_out_the_rest(void) {
  scratch_options = (input_options){.snap = 1.0, .skip = true};
  scratch_write("m.yaml", "map: a.txt\nrobots: [{column: 1, row: 1}]\nplaces:\n  - {column: 3, row: 1}\n"
                          "  - {column: 9, row: 2}\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.places);
  TEST_ASSERT_EQUAL_INT(9, scratch_input.mission.place[0]); /* column 2, row 1: the first of three as near */
  expect_note("moved to");
  expect_note("left out");
}

static void test_a_mission_whose_last_place_goes_is_refused(void) {
  scratch_options.skip = true;
  refuse_all("map: a.txt\nrobots: [{column: 1, row: 1}]\nplaces: [{column: 3, row: 1}]\n", 1);
  expect_line(0, "no place is left", "move one");
}

static void test_metres_are_answered_in_metres(void) {
  scratch_write("m.pgm", "P2 4 1 1 1 1 0 0\n");
  scratch_write("r.yaml", "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\noccupied_thresh: 0.6\n"
                          "free_thresh: 0.2\n");
  refuse_all("map: r.yaml\nrobots: [{x: -0.75, y: 2.25}]\nplaces: [{x: 0.25, y: 2.25}, {column: 3, row: 0}]\n", 3);
  expect_line(1, "place 0 stands on an obstacle", "x -0.25, y 2.25, 0.5 m away");
  expect_line(2, "place 1 stands on an obstacle", "column 1, row 0, 2 cells away");
  expect_line(0, "2 places are not", "--snap 1,");
  scratch_options.snap = 0.5;
  scratch_write("n.yaml", "map: r.yaml\nrobots: [{x: -0.75, y: 2.25}]\nplaces: [{x: 0.25, y: 2.25}]\n");
  scratch_read("n.yaml");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.place[0]);
}

#define SIDE 12

/* A random area and four places in it, stated in cells. Returns how many are on obstacles. */
static int write_crowd(test_random *random) {
  char area[SIDE * (SIDE + 1) + 1], mission[1024] = "map: b.txt\nrobots: [{column: 0, row: 0}]\nplaces:\n";
  int bad = 0;
  for (int i = 0; i < SIDE * (SIDE + 1); i++)
    area[i] = i % (SIDE + 1) == SIDE ? '\n' : random_below(random, 3) == 0 ? '.' : '#';
  area[0] = area[1] = area[2] = area[3] = area[SIDE + 1] = '.';
  area[SIDE * (SIDE + 1)] = '\0';
  for (unsigned i = 0; i < 4; i++) {
    const unsigned column = i * 3 + random_below(random, 3), row = random_below(random, SIDE);
    bad += area[row * (SIDE + 1) + column] == '#';
    snprintf(mission + strlen(mission), sizeof mission - strlen(mission), "  - {column: %u, row: %u}\n", column, row);
  }
  scratch_write("b.txt", area);
  scratch_write("m.yaml", mission);
  return bad;
}

/* Every place of a random crowd is told, and each is moved to a free cell of its own. */
static void test_random_crowds(void) {
  for (unsigned trial = 0; trial < 100; trial++) {
    test_random random = random_case("crowd", trial);
    const int bad = write_crowd(&random);
    scratch_options.snap = 0.0;
    const int result = input_read(&scratch_input, scratch_path("m.yaml"), &scratch_options, &scratch_fault);
    TEST_ASSERT_EQUAL_INT_MESSAGE(bad > 0 ? -1 : 0, result, case_note);
    if (bad > 0) TEST_ASSERT_EQUAL_INT_MESSAGE(bad == 1 ? 1 : bad + 1, lines_of_fault(), scratch_fault.text);
    scratch_options.snap = 20.0;
    scratch_read("m.yaml");
    for (int i = 0; i < 4; i++) {
      TEST_ASSERT_NOT_EQUAL(0, scratch_input.mission.cost[scratch_input.mission.place[i]]);
      for (int j = 0; j < i; j++) TEST_ASSERT_NOT_EQUAL(scratch_input.mission.place[i], scratch_input.mission.place[j]);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_all_are_told_at_once_each_with_its_line_and_its_nearest_free_cell);
  RUN_TEST(test_a_single_one_is_one_line_with_its_mend);
  RUN_TEST(test_two_places_of_one_cell_are_told_among_the_others);
  RUN_TEST(test_what_is_named_is_enough_for_snap);
  RUN_TEST(test_moving_never_brings_two_places_together);
  RUN_TEST(test_a_place_is_not_moved_to_where_no_robot_gets);
  RUN_TEST(test_left_out_places_leave_the_others_their_numbers);
  RUN_TEST(test_both_move_what_is_near_and_leave_out_the_rest);
  RUN_TEST(test_a_mission_whose_last_place_goes_is_refused);
  RUN_TEST(test_metres_are_answered_in_metres);
  RUN_TEST(test_random_crowds);
  return UNITY_END();
}
