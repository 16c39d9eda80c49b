#include <sys/stat.h>

#include "support/reader_scratch.h"

#define HEAD "map: a.txt\nrobots: [{column: 0, row: 0}]\n"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", "S..#\n.2.3\n");
}

void tearDown(void) {
  scratch_close();
}

static void refuse(const char *mission, const char *where, const char *what, const char *mend) {
  scratch_write("m.yaml", mission);
  scratch_refuse("m.yaml", where, what, mend);
}

static void test_every_key(void) {
  scratch_write("m.yaml",
                "# all of them\nname: Trial\nmap: a.txt\nrobots:\n  - {column: 0, row: 1}\n  - column: 2\n    row: 0\n"
                "places:\n  - {column: 1, row: 0, weight: 2.5}\n  - {x: 2.5, y: 0.5}\n"
                "objective: time\ngamma: 0.9\nrule: paper\nunknown: free\nrobot_radius: 0\n");
  scratch_read("m.yaml");
  const qtr_mission *mission = &scratch_input.mission;
  TEST_ASSERT_EQUAL_STRING("Trial", scratch_input.names.mission);
  TEST_ASSERT_EQUAL_INT(2, mission->seekers);
  TEST_ASSERT_EQUAL_INT(4, mission->start[0]);
  TEST_ASSERT_EQUAL_INT(2, mission->start[1]);
  TEST_ASSERT_EQUAL_INT(2, mission->places);
  TEST_ASSERT_EQUAL_INT(1, mission->place[0]);
  TEST_ASSERT_EQUAL_DOUBLE(2.5, mission->weight[0]);
  TEST_ASSERT_EQUAL_INT(6, mission->place[1]);
  TEST_ASSERT_EQUAL_DOUBLE(1.0, mission->weight[1]);
  TEST_ASSERT_EQUAL_INT(QTR_TIME, mission->aim.kind);
  TEST_ASSERT_EQUAL_DOUBLE(0.9, mission->aim.gamma);
  TEST_ASSERT_EQUAL_INT(QTR_RULE_PAPER, mission->rule);
  TEST_ASSERT_TRUE(scratch_input.objective_given && scratch_input.gamma_given && scratch_input.rule_given);
}

static void test_a_drawings_marks_serve_unless_the_mission_lists_its_own(void) {
  scratch_write("m.yaml", "map: a.txt\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(0, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  scratch_write("m.yaml", "map: a.txt\nrobots: [{column: 2, row: 1}]\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.seekers);
  TEST_ASSERT_EQUAL_INT(6, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.places);
  scratch_write("m.yaml", "map: a.txt\nplaces: [{column: 2, row: 0}]\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(0, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(1, scratch_input.mission.places);
  TEST_ASSERT_EQUAL_INT(2, scratch_input.mission.place[0]);
  scratch_expect_cells("111#|1111|");
}

static void test_names_say_where_a_place_is_stated(void) {
  char name[160], wanted[200];
  scratch_write("p.csv", "x,y,weight\n3.5,0.5,1\n");
  scratch_write("m.yaml", HEAD "places_csv: p.csv\nplaces:\n  - {column: 1, row: 1}\n  - {column: 2, row: 1}\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.places);
  input_place_name(&scratch_input, 1, name, sizeof name);
  snprintf(wanted, sizeof wanted, "place 1 (%s:6)", scratch_path("m.yaml"));
  TEST_ASSERT_EQUAL_STRING(wanted, name);
  input_place_name(&scratch_input, 2, name, sizeof name);
  snprintf(wanted, sizeof wanted, "place 2 (%s:2)", scratch_path("p.csv"));
  TEST_ASSERT_EQUAL_STRING(wanted, name);
  input_seeker_name(&scratch_input, 0, name, sizeof name);
  snprintf(wanted, sizeof wanted, "seeker 0 (%s:2)", scratch_path("m.yaml"));
  TEST_ASSERT_EQUAL_STRING(wanted, name);
}

static void test_one_robot_is_shared_several_are_counted(void) {
  scratch_write("m.yaml", HEAD);
  scratch_options.robots = 4;
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(4, scratch_input.mission.seekers);
  TEST_ASSERT_EQUAL_INT(0, scratch_input.mission.start[3]);
  refuse("map: a.txt\nrobots: [{column: 0, row: 0}, {column: 0, row: 0}]\n", "m.yaml",
         "4 robots asked for, but the input has 2", "ask for 2");
  scratch_options.robots = -1;
  refuse(HEAD, "m.yaml", "-1 robots", "1 or more");
}

static void test_points_on_lines_between_cells(void) {
  scratch_write("g.pgm", "P2 5 5 1 "
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n");
  scratch_write(
      "g.yaml",
      "image: g.pgm\nresolution: 0.2\norigin: [0.1, 0.1, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n");
  /* (0.7 - 0.1) / 0.2 is below 3 in binary. */
  scratch_write("m.yaml", "map: g.yaml\nrobots: [{x: 0.7, y: 0.1}]\nplaces: [{x: 0.699, y: 0.3}]\n");
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(23, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(17, scratch_input.mission.place[0]);
  scratch_write("m.yaml", "map: g.yaml\nrobots: [{x: 1.1, y: 0.1}]\nplaces: [{x: 0.7, y: 0.3}]\n");
  scratch_refuse("m.yaml", "m.yaml:2", "x 1.1, y 0.1 lies outside the map, which spans x 0.1 to 1.1 and y 0.1 to 1.1",
                 "move it");
}

static void test_map_faults(void) {
  refuse("robots: [{column: 0, row: 0}]\n", "m.yaml:1", "lacks the key 'map'", "map: map.yaml");
  refuse("map: b.txt\n", "b.txt", "no such file; check its name", "m.yaml:1)");
  refuse("map:\n", "m.yaml:1", "'map' has no value", "give a text");
  refuse("map: [a.txt]\n", "m.yaml:1", "'map' is a list", "give a text");
  refuse("map: m.yaml\n", "m.yaml:1", "names another mission", "its map");
  scratch_write("p.pgm", "P2 1 1 1 1");
  refuse("map: p.pgm\n", "m.yaml:1", "names a PGM image", "map_server YAML");
}

static void test_lengths_are_of_their_range(void) {
  refuse(HEAD "robot_radius: 0.1\n", "m.yaml:3", "'robot_radius' is for ROS maps only", "delete");
  refuse(HEAD "cell_size: -1\n", "m.yaml:3", "'cell_size' is -1 m", "above 0");
  refuse(HEAD "robot_radius: -0.1\n", "m.yaml:3", "'robot_radius' is -0.1 m", "0 or more");
}

static void test_mistyped_and_doubled_keys(void) {
  refuse("mpa: a.txt\n", "m.yaml:1", "unknown key 'mpa' of the mission", "did you mean 'map'?");
  refuse("map: a.txt\nrobot: []\n", "m.yaml:2", "unknown key 'robot'", "did you mean 'robots'?");
  refuse("map: a.txt\nColor: red\n", "m.yaml:2", "unknown key 'Color'", "known are map, cell_size, robot_radius");
  refuse("map: a.txt\nmap: a.txt\n", "m.yaml:2", "key 'map' of the mission is there twice (first in line 1)",
         "keep one");
  refuse("map: a.txt\nrobots:\n - {column: 0, rwo: 0}\n", "m.yaml:3", "unknown key 'rwo' of robot 0",
         "did you mean 'row'?");
  refuse("map: a.txt\nrobots:\n - {column: 0, row: 0, weight: 1}\n", "m.yaml:3", "unknown key 'weight' of robot 0",
         "known are");
  refuse(HEAD "places:\n - {x: 1, y: 0,\n    y: 1}\n", "m.yaml:5",
         "key 'y' of place 0 is there twice (first in line 4)", "keep one");
  refuse("map: a.txt\n[a]: 1\n", "m.yaml:2", "a key of the mission is not a plain word", "check");
}

static void test_wrong_types_and_values(void) {
  refuse(HEAD "gamma: high\n", "m.yaml:3", "'gamma' is \"high\", which is not a number", "give a number");
  refuse(HEAD "scan_seconds: 1 min\n", "m.yaml:3", "'scan_seconds' is \"1 min\", which is not a number",
         "give a number alone, in s, such as 30");
  refuse(HEAD "gamma: 1\n", "m.yaml:3", "'gamma' is 1", "a discount above 0 and below 1, such as 0.99");
  refuse(HEAD "gamma: 0\n", "m.yaml:3", "'gamma' is 0", "a discount above 0 and below 1, such as 0.99");
  refuse(HEAD "gamma: .nan\n", "m.yaml:3", "not a finite number", "give a number");
  refuse(HEAD "objective: speed\n", "m.yaml:3", "'objective' is \"speed\"", "one of discounted, time and deadline");
  refuse(HEAD "rule: [free]\n", "m.yaml:3", "'rule' is a list", "one of free and paper");
  refuse(HEAD "unknown: maybe\n", "m.yaml:3", "'unknown' is \"maybe\"", "one of blocked and free");
  refuse("map: a.txt\nrobots: 3\n", "m.yaml:2", "'robots' is not a list", "robots: [");
  refuse("map: a.txt\nrobots: []\n", "m.yaml:2", "'robots' is empty", "robots: [");
  refuse("map: a.txt\nrobots: [3]\n", "m.yaml:2", "robot 0 is not a mapping", "x, y, column, row, name");
  refuse(HEAD "places: {x: 1, y: 1}\n", "m.yaml:3", "'places' is not a list", "places: [");
  refuse(HEAD "places: []\n", "m.yaml", "no place", "'places'");
  refuse(HEAD "places: [{x: 1}]\n", "m.yaml:3", "place 0 lacks the key 'y'", "add");
  refuse(HEAD "places: [{row: 1}]\n", "m.yaml:3", "place 0 lacks the key 'column'", "add");
  refuse(HEAD "places: [{weight: 1}]\n", "m.yaml:3", "place 0 has no position", "x and y");
  refuse(HEAD "places: [{x: 1, row: 1}]\n", "m.yaml:3", "place 0 has both metres and cells", "keep");
  refuse(HEAD "places: [{column: 1.5, row: 1}]\n", "m.yaml:3", "'column' is \"1.5\"", "whole number");
  refuse(HEAD "places: [{x: one, y: 1}]\n", "m.yaml:3", "'x' is \"one\"", "number");
  scratch_write("b.txt", "..1\n");
  refuse("map: b.txt\n", "m.yaml", "no robot starts", "robots: [");
}

static void test_weights(void) {
  refuse(HEAD "places: [{x: 1, y: 1, weight: 0}]\n", "m.yaml:3", "'weight' is 0", "likelihood");
  refuse(HEAD "places: [{x: 1, y: 1, weight: -2}]\n", "m.yaml:3", "'weight' is -2", "likelihood");
  refuse(HEAD "places: [{x: 1, y: 1, weight: .nan}]\n", "m.yaml:3", "not a finite number", "number");
  refuse(HEAD "places: [{x: 1, y: 1, weight: -.INF}]\n", "m.yaml:3", "not a finite number", "number");
  refuse(HEAD "places: [{x: 1, y: 1, weight: 1e999}]\n", "m.yaml:3", "too large a number", "number");
  refuse(HEAD "places: [{x: 1, y: 1, weight: 1e-999}]\n", "m.yaml:3", "'weight' is 0", "likelihood");
  refuse(HEAD "places: [{x: 1, y: 1, weight: 0x10}]\n", "m.yaml:3", "not a number", "number");
  refuse(HEAD "places: [{x: 1, y: 1, weight: heavy}]\n", "m.yaml:3", "'weight' is \"heavy\"", "number");
  refuse(HEAD "places: [{x: 0, y: 0, weight: 1e308}, {x: 1, y: 0, weight: 1e308}]\n", "m.yaml", "add up to more",
         "scale them down");
  refuse(HEAD "places: [{x: 0, y: 0, weight: 1e300}, {x: 1, y: 0, weight: 1e-300}]\n", "m.yaml:3",
         "nothing beside the sum", "raise");
}

static void test_places_and_starts_against_the_map(void) {
  refuse("map: a.txt\nrobots: [{column: 3, row: 0}]\n", "m.yaml:2", "robot 0 stands on an obstacle, at column 3, row 0",
         "move");
  refuse(HEAD "places:\n - {column: 1, row: 1}\n - {column: 3, row: 0}\n", "m.yaml:5", "place 1 stands on an obstacle",
         "move");
  refuse(HEAD "places:\n - {column: 4, row: 0}\n", "m.yaml:4",
         "column 4, row 0 lies outside the map, whose columns are 0 to 3", "move");
  refuse(HEAD "places:\n - {column: 0, row: -1}\n", "m.yaml:4", "column 0, row -1 lies outside", "move");
  refuse(HEAD "places:\n - {x: 1e300, y: 0}\n", "m.yaml:4", "x 1e+300, y 0 lies outside the map, which spans x 0 to 4",
         "move");
  char twin[200];
  scratch_write("m.yaml", HEAD "places:\n - {column: 1, row: 1}\n - {column: 2, row: 1}\n - {x: 1.9, y: 0.1}\n");
  scratch_refuse("m.yaml", "m.yaml:6", "place 2 lies in the same cell as place 0", "drop one");
  snprintf(twin, sizeof twin, "(%s:4)", scratch_path("m.yaml"));
  scratch_expect_text(twin);
}

static void test_more_than_the_build_holds(void) {
  static char text[QTR_MAX_PLACES * 40];
  size_t used = (size_t)sprintf(text, HEAD "places:\n");
  for (int i = 0; i <= QTR_MAX_PLACES; i++) used += (size_t)sprintf(text + used, " - {column: 0, row: 0}\n");
  refuse(text, "m.yaml:1028", "more than 1024 places", "QTR_MAX_PLACES");
  used = (size_t)sprintf(text, "map: a.txt\nrobots:\n");
  for (int i = 0; i <= QTR_MAX_SEEKERS; i++) used += (size_t)sprintf(text + used, " - {column: 0, row: 0}\n");
  refuse(text, "m.yaml:35", "more than 32 robots", "QTR_MAX_SEEKERS");
}

static void test_yaml_that_is_none(void) {
  refuse("map: [a\nrobots: }\n", "m.yaml:2:7", "not valid YAML", "mend the line");
  refuse("map: a.txt\n\trobots: 1\n", "m.yaml:2", "indented by a tab", "use blanks");
  refuse("map: a.txt\n---\nmap: b.txt\n", "m.yaml:3", "second YAML document", "keep one");
  refuse("- map\n- robots\n", "m.yaml:1", "holds no keys, but a list", "key: value");
  refuse("# nothing\n\n", "m.yaml", "holds no keys", "key: value");
  refuse("just words\n", "m.yaml:1", "holds no keys, but a single value", "key: value");
  refuse("map: \"a\\0b\"\n", "m.yaml:1", "'map' is a single value", "give a text");
  refuse("map: &a [*a]\n", "m.yaml:1", "'map' is a list", "give a text");
  refuse("map: *a\n", "m.yaml:1:6", "not valid YAML", "mend the line");
  scratch_write_bytes("m.yaml", "map: a\0b\n", 9);
  scratch_refuse("m.yaml", "m.yaml", "is not YAML text", "right file");
  scratch_write_bytes("m.yaml", "map: \x80\x81", 7);
  scratch_refuse("m.yaml", "m.yaml", "is not YAML text: invalid leading UTF-8 octet at byte 5", "right file");
}

static void test_yaml_that_would_take_minutes(void) {
  static char text[200001];
  memset(text, '[', 200000);
  memcpy(text, "map: ", 5);
  refuse(text, "m.yaml:1", "nested more than 32 deep", "brackets");
  memset(text, '\0', sizeof text);
  size_t used = (size_t)sprintf(text, "map: [");
  for (int i = 0; i < 10000; i++) used += (size_t)sprintf(text + used, "&a%d 1, ", i);
  refuse(text, "m.yaml:1", "more than 256 anchors and aliases", "write the values out");
  used = 0;
  for (int i = 0; i < 9000; i++) used += (size_t)sprintf(text + used, "%%TAG !a%d! tag:a\n", i);
  sprintf(text + used, "---\nmap: a.txt\n");
  refuse(text, "m.yaml:9", "more than 8 directives", "delete");
}

static void test_files_that_are_none(void) {
  char path[128];
  TEST_ASSERT_EQUAL_INT(-1, input_read(&scratch_input, scratch_folder, &scratch_options, &scratch_fault));
  scratch_expect_text("is a folder");
  TEST_ASSERT_EQUAL_INT(-1, input_read(&scratch_input, "", &scratch_options, &scratch_fault));
  scratch_expect_text("name a file");
  TEST_ASSERT_EQUAL_INT(-1, input_read(&scratch_input, "/dev/zero", &scratch_options, &scratch_fault));
  scratch_expect_text("/dev/zero: is a device or pipe");
  snprintf(path, sizeof path, "%s", scratch_path("pipe"));
  TEST_ASSERT_EQUAL_INT(0, mkfifo(path, 0600));
  int result = input_read(&scratch_input, path, &scratch_options, &scratch_fault);
  unlink(path);
  TEST_ASSERT_EQUAL_INT(-1, result);
  scratch_expect_text("pipe: is a device or pipe");
  scratch_refuse("none.txt", "none.txt", "no such file", "check its name");
  scratch_write("empty.yaml", "");
  scratch_refuse("empty.yaml", "empty.yaml", "is empty", "copied");
}

static void test_a_file_that_is_far_too_large(void) {
  scratch_write("large.txt", "S");
  TEST_ASSERT_EQUAL_INT(0, truncate(scratch_path("large.txt"), 300L << 20));
  scratch_refuse("large.txt", "large.txt", "more than the 256 MiB", "right one");
  scratch_write("large.yaml", "map: a.txt\n");
  TEST_ASSERT_EQUAL_INT(0, truncate(scratch_path("large.yaml"), 5L << 20));
  scratch_refuse("large.yaml", "large.yaml", "more than the 4 MiB", "right one");
}

static void test_long_paths_leave_room_for_what_is_wrong(void) {
  static char path[6000];
  memset(path, 'x', 1000);
  TEST_ASSERT_EQUAL_INT(-1, input_read(&scratch_input, path, &scratch_options, &scratch_fault));
  scratch_expect_text("too long");
  memset(path, 'x', 5000);
  TEST_ASSERT_EQUAL_INT(-1, input_read(&scratch_input, path, &scratch_options, &scratch_fault));
  scratch_expect_text("too long");
  char yaml[6010];
  snprintf(yaml, sizeof yaml, "map: %s\n", path);
  refuse(yaml, "m.yaml", "longer than 4095 bytes", "shorten");
  refuse("map: \"a\\nb\\x1b[2J\"\n", "a?b?[2J", "no such file", "check");
}

static void test_the_demo_mission(void) {
#ifdef QUARTER_SOURCE_DIR
  const char *path = QUARTER_SOURCE_DIR "/demo/missions/turtlebot3_world/mission.yaml";
  int result = input_read(&scratch_input, path, &scratch_options, &scratch_fault);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result, scratch_fault.text);
  TEST_ASSERT_EQUAL_INT(96, scratch_input.mission.columns);
  TEST_ASSERT_EQUAL_INT(96, scratch_input.mission.rows);
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.seekers);
  TEST_ASSERT_EQUAL_INT(14, scratch_input.mission.places);
#else
  TEST_IGNORE_MESSAGE("QUARTER_SOURCE_DIR is not known");
#endif
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_key);
  RUN_TEST(test_a_drawings_marks_serve_unless_the_mission_lists_its_own);
  RUN_TEST(test_names_say_where_a_place_is_stated);
  RUN_TEST(test_one_robot_is_shared_several_are_counted);
  RUN_TEST(test_points_on_lines_between_cells);
  RUN_TEST(test_map_faults);
  RUN_TEST(test_lengths_are_of_their_range);
  RUN_TEST(test_mistyped_and_doubled_keys);
  RUN_TEST(test_wrong_types_and_values);
  RUN_TEST(test_weights);
  RUN_TEST(test_places_and_starts_against_the_map);
  RUN_TEST(test_more_than_the_build_holds);
  RUN_TEST(test_yaml_that_is_none);
  RUN_TEST(test_yaml_that_would_take_minutes);
  RUN_TEST(test_files_that_are_none);
  RUN_TEST(test_a_file_that_is_far_too_large);
  RUN_TEST(test_long_paths_leave_room_for_what_is_wrong);
  RUN_TEST(test_the_demo_mission);
  return UNITY_END();
}
