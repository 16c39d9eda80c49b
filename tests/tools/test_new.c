/* quarter new: a mission to begin with, which learns as it stands. */
#include <sys/stat.h>
#include <unistd.h>

#include "host/input/mission_keys.h"
#include "support/tool_run.h"

static tool_result r;
static char text[1 << 16], edited[1 << 16];

static const char *const made[] = {"mission.yaml", "mission.svg", "mission.txt", "map.yaml", "map.pgm",
                                   "rooms.txt",    "arena.map",   "p.qtr",       "p.csv",    "other.svg"};

void setUp(void) {
  for (size_t i = 0; i < sizeof made / sizeof made[0]; i++) remove(made[i]);
  write_file("rooms.txt", "....#..\n....#..\n....#..\n");
}

void tearDown(void) {
}

static int is_there(const char *path) {
  return access(path, F_OK) == 0;
}

/* A PGM of light ground with a wall across, and a door in it. */
static void write_image(const char *path, int width, int height) {
  FILE *file = fopen(path, "wb");
  TEST_ASSERT_NOT_NULL(file);
  fprintf(file, "P5\n%d %d\n255\n", width, height);
  for (int row = 0; row < height; row++)
    for (int column = 0; column < width; column++) fputc(row == height / 2 && column > 3 ? 0 : 254, file);
  fclose(file);
}

static void write_ros_map(void) {
  write_image("map.pgm", 40, 30);
  write_file("map.yaml", "image: map.pgm\nresolution: 0.1\norigin: [-2, 1, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                         "free_thresh: 0.196\n");
}

static void run_well(const char *words) {
  run_tool(&r, "%s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
}

/* What is written is sound, learns and leaves for other tools. */
static void expect_whole(void) {
  run_well("check mission.yaml");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "no faults"), r.out);
  run_well("learn mission.yaml -q -o p.qtr");
  run_well("export p.qtr -q -o p.csv");
  read_text("mission.yaml", text, sizeof text);
}

/* `text` with the # before a key taken away. */
static void take_up(const char *name) {
  char line[80];
  snprintf(line, sizeof line, "\n#%s: ", name);
  const char *at = strstr(text, line);
  TEST_ASSERT_NOT_NULL_MESSAGE(at, name);
  snprintf(edited, sizeof edited, "%.*s\n%s", (int)(at - text), text, at + 2);
  remove("edited.yaml");
  write_file("edited.yaml", edited);
}

/* ---- whatever the map is ---- */

static void test_a_ros_map_becomes_a_mission_in_metres(void) {
  write_ros_map();
  run_well("new map.yaml");
  TEST_ASSERT_EQUAL_STRING("map.yaml: 40 x 30 cells of 0.1 m; 2 robots proposed, 5 places proposed\n"
                           "wrote mission.yaml\nwrote mission.svg\n",
                           r.out);
  expect_whole();
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "\nmap: map.yaml\n"), text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "\ncell_size: 0.1\n"), text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "\n  - {x: "), text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "which spans x -2 to 2 and y 1 to 4"), text);
}

static void test_an_image_gets_a_map_that_tells_its_scale(void) {
  write_image("map.pgm", 40, 30);
  run_well("new map.pgm --resolution 0.5");
  expect_whole();
  read_text("map.yaml", text, sizeof text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "image: map.pgm\nresolution: 0.5\n"), text);
}

static void test_a_drawing_without_marks_is_planned_in_cells(void) {
  run_well("new rooms.txt --robots 3");
  expect_whole();
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "\n  - {column: "), text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "name: Charlie"), text);
  TEST_ASSERT_NULL_MESSAGE(strstr(text, "robot_radius"), text); /* for ROS maps only */
}

static void test_marks_of_a_drawing_are_taken_up(void) {
  write_file("rooms.txt", "S...#..\n.3..#..\n....9..\n");
  run_well("new rooms.txt");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "1 robot marked, 2 places marked"), r.out);
  expect_whole();
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "{column: 1, row: 1, weight: 3}"), text);
  run_well("new rooms.txt --robots 2 --force");
  expect_whole();
}

static void test_a_drawing_with_a_cell_size_is_planned_in_metres(void) {
  run_well("new rooms.txt --cell-size 2");
  expect_whole();
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "\ncell_size: 2\n"), text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "\n  - {x: "), text);
}

static void test_a_moving_ai_map_becomes_a_mission(void) {
  write_file("arena.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n");
  run_well("new arena.map");
  expect_whole();
}

static void test_open_ground_needs_no_map(void) {
  run_well("new --open 120x80");
  TEST_ASSERT_EQUAL_STRING("mission.txt: 120 x 80 cells of 1 m; 2 robots proposed, 5 places proposed\n"
                           "wrote mission.txt\nwrote mission.yaml\nwrote mission.svg\n",
                           r.out);
  expect_whole();
  remove("mission.txt");
  run_well("new --open 3x2.5 --cell-size 0.5 -o - -q");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "which spans x 0 to 3 and y 0 to 2.5"), r.out);
}

/* In the smaller room nothing would be reached. */
static void test_proposals_stand_in_the_largest_room_apart(void) {
  run_well("new rooms.txt --json");
  TEST_ASSERT_EQUAL_INT(5, (int)json_value(r.out, "places"));
  run_well("check mission.yaml");
  write_file("rooms.txt", "#.#\n");
  run_well("new rooms.txt --json --force --robots 1");
  TEST_ASSERT_EQUAL_INT(1, (int)json_value(r.out, "places"));
  run_well("check mission.yaml");
}

static void test_large_maps_get_cells_that_are_soon_planned(void) {
  write_ros_map();
  write_image("map.pgm", 600, 500);
  run_well("new map.yaml --json");
  TEST_ASSERT_EQUAL_INT(200, (int)json_value(r.out, "columns"));
  TEST_ASSERT_EQUAL_INT(167, (int)json_value(r.out, "rows"));
}

/* The wall across has a door of 0.4 m. */
static void test_what_may_shut_a_door_is_named(void) {
  static const char sites[] = "robots: [{x: 1.5, y: 1.25}]\nplaces: [{x: 1.5, y: 3.75}]\n";
  write_ros_map();
  snprintf(edited, sizeof edited, "map: map.yaml\n%s", sites);
  write_file("mission.yaml", edited);
  run_well("check mission.yaml");
  run_tool(&r, "check mission.yaml --cell-size 0.5");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "cells of 0.5 m may shut doors"), r.err);
  snprintf(edited, sizeof edited, "map: map.yaml\nrobot_radius: 0.5\n%s", sites);
  write_file("mission.yaml", edited);
  run_tool(&r, "check mission.yaml");
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "robot_radius of 0.5 m may shut doors"), r.err);
}

static void test_the_mission_may_lie_elsewhere(void) {
  mkdir("elsewhere", 0777);
  remove("elsewhere/m.yaml");
  run_well("new ./rooms.txt -o elsewhere/m.yaml --picture other.svg");
  run_well("learn elsewhere/m.yaml -q");
  TEST_ASSERT_TRUE(is_there("other.svg"));
}

/* ---- keys ---- */

static void test_every_key_is_there_and_its_example_is_one_that_is_read(void) {
  write_ros_map();
  run_well("new map.yaml");
  read_text("mission.yaml", text, sizeof text);
  for (const key_record *key = mission_keys.records; key->name != NULL; key++) {
    char line[80], fault[80];
    snprintf(line, sizeof line, "\n%s: ", key->name);
    if (strstr(text, line) != NULL) continue;
    snprintf(line, sizeof line, "\n%s:\n", key->name);
    if (strstr(text, line) != NULL) continue;
    take_up(key->name);
    run_tool(&r, "check edited.yaml");
    snprintf(fault, sizeof fault, "'%s' is", key->name);
    TEST_ASSERT_NULL_MESSAGE(strstr(r.err, "unknown key"), r.err);
    const char *refused = strstr(r.err, fault); /* "'deadline_seconds' is for ..." goes with another key */
    TEST_ASSERT_TRUE_MESSAGE(refused == NULL || strncmp(refused + strlen(fault), " for ", 5) == 0, r.err);
  }
}

static void test_default_and_unit_stand_beside_a_key(void) {
  run_well("new rooms.txt -o -");
  TEST_ASSERT_NOT_NULL_MESSAGE(
      strstr(r.out, "(a number above 0 and up to 10000, in m/s; maps with metres only; default"), r.out);
}

/* ---- the picture ---- */

static void test_the_picture_has_coordinates_along_its_edges_and_over_the_map(void) {
  write_ros_map();
  run_well("new map.yaml -q");
  TEST_ASSERT_EQUAL_STRING("", r.out);
  read_text("mission.svg", text, sizeof text);
  TEST_ASSERT_NOT_NULL(strstr(text, "x, metres"));
  TEST_ASSERT_NOT_NULL(strstr(text, "stroke-opacity=\".55\""));
  TEST_ASSERT_NOT_NULL(strstr(text, "Alpha: starts here"));
  run_well("draw mission.yaml -o other.svg");
  read_text("other.svg", text, sizeof text);
  TEST_ASSERT_NULL(strstr(text, "stroke-opacity=\".55\""));
  run_well("draw mission.yaml --grid -o other.svg");
  read_text("other.svg", text, sizeof text);
  TEST_ASSERT_NOT_NULL(strstr(text, "stroke-opacity=\".55\""));
}

/* ---- what it leaves alone ---- */

static void refuse(const char *words, const char *part) {
  run_tool(&r, "%s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(2, r.status, words);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, part), r.err);
  TEST_ASSERT_EQUAL_PTR_MESSAGE(r.err + strlen(r.err) - 1, strchr(r.err, '\n'), r.err);
  TEST_ASSERT_EQUAL_STRING("", r.out);
}

static void test_what_is_there_is_written_over_by_force_alone(void) {
  write_file("mission.yaml", "mine\n");
  refuse("new rooms.txt", "mission.yaml: is there already; --force writes over it, -o FILE elsewhere");
  TEST_ASSERT_FALSE(is_there("mission.svg"));
  read_text("mission.yaml", text, sizeof text);
  TEST_ASSERT_EQUAL_STRING("mine\n", text);
  run_well("new rooms.txt --force");
  expect_whole();
  remove("mission.yaml");
  refuse("new rooms.txt", "mission.svg: is there already; --force writes over it, --picture FILE elsewhere");
  TEST_ASSERT_FALSE(is_there("mission.yaml"));
}

static void test_a_map_is_never_written_over(void) {
  write_ros_map();
  refuse("new map.pgm", "is a PGM image; its map is map.yaml, it seems: name that");
  refuse("new map.pgm --resolution 0.5 --force", "map.yaml: is there already, and says otherwise");
  refuse("new map.yaml -o map.yaml --force", "map.yaml");
  write_file("mission.txt", "mine\n");
  refuse("new --open 3x3 --force", "mission.txt: is there already, and says otherwise");
}

static void test_bad_words_are_a_line(void) {
  write_image("map.pgm", 4, 4);
  write_file("rooms.txt", "###\n");
  refuse("new", "name a map");
  refuse("new none.txt", "none.txt: no such file");
  refuse("new rooms.txt", "has no free cell");
  refuse("new map.pgm", "which has no scale; say how many metres a pixel is, as --resolution 0.05, and map.yaml");
  refuse("new map.pgm --resolution 0", "--resolution 0: not a number of metres");
  refuse("new map.pgm --resolution 1 -o map.yaml", "is where the map goes");
  refuse("new --open 3", "say metres as WIDTHxHEIGHT");
  refuse("new --open 3x-1", "say metres as WIDTHxHEIGHT");
  refuse("new --open 3x1 map.pgm", "--open takes no map");
  refuse("new --open 3x1 --resolution 2", "--resolution is for images");
  refuse("new --open 90000x90000 --cell-size 1", "--cell-size");
  write_file("rooms.txt", "S.S\n");
  refuse("new rooms.txt --robots 3", "marks 2 starts");
  refuse("new rooms.txt --resolution 3", "--resolution is for images");
  refuse("new rooms.txt --picture a.jpg", "--picture a.jpg: the picture is SVG, PNG or PDF");
  write_file("mission.yaml", "map: rooms.txt\n");
  refuse("new mission.yaml -o m2.yaml", "is a mission already");
  refuse("new rooms.txt -o none/m.yaml", "make its folder first");
}

static void test_help_begins_with_examples(void) {
  run_well("new --help");
  TEST_ASSERT_EQUAL_PTR_MESSAGE(r.out, strstr(r.out, "quarter new map.yaml "), r.out);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_ros_map_becomes_a_mission_in_metres);
  RUN_TEST(test_an_image_gets_a_map_that_tells_its_scale);
  RUN_TEST(test_a_drawing_without_marks_is_planned_in_cells);
  RUN_TEST(test_marks_of_a_drawing_are_taken_up);
  RUN_TEST(test_a_drawing_with_a_cell_size_is_planned_in_metres);
  RUN_TEST(test_a_moving_ai_map_becomes_a_mission);
  RUN_TEST(test_open_ground_needs_no_map);
  RUN_TEST(test_proposals_stand_in_the_largest_room_apart);
  RUN_TEST(test_large_maps_get_cells_that_are_soon_planned);
  RUN_TEST(test_what_may_shut_a_door_is_named);
  RUN_TEST(test_the_mission_may_lie_elsewhere);
  RUN_TEST(test_every_key_is_there_and_its_example_is_one_that_is_read);
  RUN_TEST(test_default_and_unit_stand_beside_a_key);
  RUN_TEST(test_the_picture_has_coordinates_along_its_edges_and_over_the_map);
  RUN_TEST(test_what_is_there_is_written_over_by_force_alone);
  RUN_TEST(test_a_map_is_never_written_over);
  RUN_TEST(test_bad_words_are_a_line);
  RUN_TEST(test_help_begins_with_examples);
  return UNITY_END();
}
