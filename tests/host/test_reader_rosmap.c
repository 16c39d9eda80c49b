#include "host/input/frame.h"
#include "host/input/rosmap.h"
#include "support/reader_scratch.h"

#define YAML(more) "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n" more
#define MISSION(more) "map: m.yaml\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 0}]\n" more

static rosmap_header header;

void setUp(void) {
  scratch_open();
  header = (rosmap_header){.occupied = 0.6, .free = 0.2, .mode = ROSMAP_TRINARY};
}

void tearDown(void) {
  scratch_close();
}

static void expect_classes(int maximum, const int *samples, const char *wanted) {
  for (int i = 0; wanted[i] != '\0'; i++) {
    char kind = "fo?"[rosmap_classify(&header, samples[i], maximum)], message[40];
    snprintf(message, sizeof message, "sample %d", samples[i]);
    TEST_ASSERT_EQUAL_CHAR_MESSAGE(wanted[i], kind, message);
  }
}

static void test_trinary_thresholds_are_strict(void) {
  /* p = (255 - v) / 255: 102 is 0.6 and 204 is 0.2 exactly, so both are unknown. */
  expect_classes(255, (const int[]){0, 101, 102, 103, 203, 204, 205, 255}, "oo????ff");
}

static void test_negate_turns_the_greys_round(void) {
  header.negate = true;
  expect_classes(255, (const int[]){255, 154, 153, 152, 52, 51, 50, 0}, "oo????ff");
}

static void test_other_maxima_scale(void) {
  expect_classes(10, (const int[]){0, 3, 4, 5, 7, 8, 9, 10}, "oo????ff");
  expect_classes(65535, (const int[]){0, 26213, 26214, 26215, 52427, 52428, 52429, 65535}, "oo????ff");
  expect_classes(1, (const int[]){0, 1}, "of");
}

static void test_map_savers_own_greys(void) {
  header.occupied = 0.65;
  header.free = 0.196;
  expect_classes(255, (const int[]){0, 205, 254, 255}, "o?ff");
  header.free = 0.25; /* nav2's saver: 205 would be free; hence its saver writes what it writes */
  expect_classes(255, (const int[]){0, 205, 254}, "off");
}

static void test_scale_counts_all_but_nothing_as_occupied(void) {
  header.mode = ROSMAP_SCALE;
  /* On 1000 greys, 0.2 to 0.6 is 0 to 100: 2 greys are half a percent. */
  expect_classes(1000, (const int[]){0, 400, 500, 798, 799, 800, 801, 1000},
                 "oooofff"
                 "f");
  expect_classes(255, (const int[]){0, 102, 150, 203, 204, 205, 255}, "oooofff");
}

/* Occupancy 0.2 is free ground and 0.6 an obstacle: of the ten greys of this image 8 is 0, 7 a quarter, 6 a half, 5
 * three quarters, and 4 the obstacle. */
static void test_greys_of_scale_maps_are_ground_that_takes_longer(void) {
  scratch_write_rosmap(YAML("negate: 0\nmode: scale\n"), "P2 6 1 10\n9 8 7 6 5 4\n",
                       "map: m.yaml\ngrey_cost: 9\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 0}]\n");
  scratch_read("mission.yaml");
  static const uint8_t expected[6] = {1, 1, 3, 5, 7, 0};
  TEST_ASSERT_EQUAL_UINT8_ARRAY(expected, scratch_input.mission.cost, 6);
  /* Without it they are obstacles, and a note says what would open them. */
  scratch_write_rosmap(YAML("negate: 0\nmode: scale\n"), "P2 6 1 10\n9 8 7 6 5 4\n",
                       "map: m.yaml\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 0}]\n");
  scratch_read("mission.yaml");
  static const uint8_t closed[6] = {1, 1, 0, 0, 0, 0};
  TEST_ASSERT_EQUAL_UINT8_ARRAY(closed, scratch_input.mission.cost, 6);
  TEST_ASSERT_NOT_NULL(strstr(scratch_input.note.text[0], "3 pixels of the image are grey"));
  TEST_ASSERT_NOT_NULL(strstr(scratch_input.note.text[0], "grey_cost: 5"));
}

/* A cell is as slow as its slowest pixel, and blocked where any is; an obstacle still grows by the radius. */
static void test_the_slowest_pixel_of_a_cell_counts(void) {
  scratch_write_rosmap(YAML("negate: 0\nmode: scale\n"), "P2 6 2 10\n9 7 9 9 9 4\n6 9 9 9 9 9\n",
                       "map: m.yaml\ncell_size: 1\ngrey_cost: 9\nrobots: [{column: 0, row: 0}]\n"
                       "places: [{column: 1, row: 0}]\n");
  scratch_read("mission.yaml");
  static const uint8_t expected[3] = {5, 1, 0};
  TEST_ASSERT_EQUAL_UINT8_ARRAY(expected, scratch_input.mission.cost, 3);
}

static void test_grey_cost_is_for_maps_that_have_greys(void) {
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 2 1 10\n9 9\n",
                       "map: m.yaml\ngrey_cost: 9\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 0}]\n");
  scratch_refuse("mission.yaml", "mission.yaml:2", "\"mode: scale\"", "delete it");
  scratch_write("map.txt", "S.1\n");
  scratch_write("mission.yaml", "map: map.txt\ngrey_cost: 9\n");
  scratch_refuse("mission.yaml", "mission.yaml:2", "\"mode: scale\"", "'terrain'");
}

static void test_raw_takes_the_greys_as_percent(void) {
  header.mode = ROSMAP_RAW;
  header.negate = true;
  expect_classes(255, (const int[]){0, 1, 50, 100, 101, 205, 255}, "fooo???");
  expect_classes(65535, (const int[]){0, 128, 129, 25700, 25828, 25829, 65535}, "ffooo??");
}

static void test_rows_columns_and_the_frame(void) {
  /* Free, occupied | unknown, free. */
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 2 2 255\n255 0\n204 255\n",
                       "map: m.yaml\nrobots: [{x: -0.6, y: 2.9}]\nplaces: [{x: -0.1, y: 2.1}]\n");
  scratch_read("mission.yaml");
  scratch_expect_cells("1#|#1|");
  TEST_ASSERT_EQUAL_INT(0, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.place[0]);
  TEST_ASSERT_TRUE(scratch_input.frame.metric);
  TEST_ASSERT_EQUAL_DOUBLE(0.5, scratch_input.frame.cell_size);
  TEST_ASSERT_EQUAL_DOUBLE(-1.0, scratch_input.frame.origin_x);
  TEST_ASSERT_EQUAL_DOUBLE(2.0, scratch_input.frame.origin_y);
  TEST_ASSERT_EQUAL_UINT32(500000, scratch_input.mission.frame.cell_size_um);
  TEST_ASSERT_EQUAL_INT64(-1000000, scratch_input.mission.frame.origin_x_um);
  TEST_ASSERT_EQUAL_INT64(2000000, scratch_input.mission.frame.origin_y_um);
  const input_position centre = frame_centre(&scratch_input, 3, true);
  TEST_ASSERT_EQUAL_DOUBLE(-0.25, centre.x);
  TEST_ASSERT_EQUAL_DOUBLE(2.25, centre.y);
}

static void test_unknown_is_blocked_unless_free_is_asked_for(void) {
  const char *pgm = "P2 3 2 255\n255 255 204\n255 0 255\n";
  scratch_write_rosmap(YAML("negate: 0\n"), pgm, MISSION(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("11#|1#1|");
  scratch_write_rosmap(YAML("negate: 0\n"), pgm, MISSION("unknown: blocked\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("11#|1#1|");
  scratch_write_rosmap(YAML("negate: false\n"), pgm, MISSION("unknown: free\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("111|1#1|");
}

static void test_negate_and_mode_are_read(void) {
  scratch_write_rosmap(YAML("negate: 1\nmode: Trinary\n"), "P2 3 1 255\n0 0 255\n", MISSION(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("11#|");
  scratch_write_rosmap(YAML("negate: true\nmode: raw\n"), "P2 3 1 255\n0 0 1\n", MISSION(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("11#|");
  scratch_write_rosmap(YAML("negate: 0\nmode: scale\n"), "P2 4 1 255\n255 255 150 255\n", MISSION("unknown: free\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("11#1|");
}

static void test_obstacles_grow_by_the_radius(void) {
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 6 1 255\n255 255 255 255 255 0\n", MISSION("robot_radius: 0.75\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("111###|");
  TEST_ASSERT_EQUAL_DOUBLE(0.75, scratch_input.ground.robot_radius);
  /* The unknown grows too, unless it is free. */
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 6 1 255\n255 255 255 255 255 204\n", MISSION("robot_radius: 0.75\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("111###|");
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 6 1 255\n255 255 255 255 255 204\n",
                       MISSION("robot_radius: 0.75\nunknown: free\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("111111|");
}

static void test_growth_comes_before_coarsening(void) {
  scratch_write_rosmap(YAML("negate: 0\n"),
                       "P2 8 2 255\n255 255 255 255 255 255 0 255\n255 255 255 255 255 255 255 255\n",
                       MISSION("robot_radius: 0.25\ncell_size: 1\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("11##|");
  TEST_ASSERT_EQUAL_DOUBLE(1.0, scratch_input.frame.cell_size);
}

static void test_cell_size_of_the_command_line_wins(void) {
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 6 2 255\n255 255 255 255 0 255\n255 255 255 255 255 255\n",
                       MISSION("cell_size: 1\n"));
  scratch_options.cell_size = 0.5;
  scratch_read("mission.yaml");
  scratch_expect_cells("1111#1|111111|");
}

static void test_other_tools_keys_are_ignored(void) {
  scratch_write_rosmap(YAML("negate: 0\nfloor: ground\ncost: [1, 2]\n"), "P2 2 1 255\n255 255\n", MISSION(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("11|");
}

static void test_a_map_alone_is_refused_with_how_to_write_a_mission(void) {
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 2 1 255\n255 255\n", "");
  scratch_refuse("m.yaml", "m.yaml", "without robots and places", "map: m.yaml");
  scratch_write("m.pgm", "P2 2 1 255\n255");
  scratch_refuse("m.yaml", "m.pgm", "is cut off", "copy the file anew");
  scratch_refuse("m.pgm", "m.pgm", "a PGM image, which has no scale", "mission YAML");
}

/* What is proposed is a mission that is read. */
static void test_the_mission_that_is_proposed_for_a_map_is_sound(void) {
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 4 3 255\n0 0 0 0 0 255 255 0 255 0 0 255\n", "");
  scratch_refuse("m.yaml", "m.yaml", "map: m.yaml", "a line each");
  char mission[600] = "", *to = mission;
  for (const char *from = strchr(scratch_fault.text, '"'); from != NULL; from = strchr(from, '"')) {
    const size_t length = strcspn(from + 1, "\"");
    to += sprintf(to, "%.*s\n", (int)length, from + 1);
    from += length + 2;
  }
  scratch_write("mission.yaml", mission);
  scratch_read("mission.yaml");
  TEST_ASSERT_EQUAL_INT(5, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(6, scratch_input.mission.place[0]);
}

/* A map YAML that lacks or spoils one line. */
static void refuse_yaml(const char *yaml, const char *where, const char *what, const char *mend) {
  scratch_write_rosmap(yaml, "P2 2 1 255\n255 255\n", MISSION(""));
  scratch_refuse("mission.yaml", where, what, mend);
}

static void test_missing_keys(void) {
  refuse_yaml("resolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "m.yaml:1",
              "lacks the key 'image'", "image: map.pgm");
  refuse_yaml("image: m.pgm\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "m.yaml:1",
              "lacks the key 'resolution'", "resolution: 0.05");
  refuse_yaml("image: m.pgm\nresolution: 1\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "m.yaml:1",
              "lacks the key 'origin'", "origin: [0, 0, 0]");
  refuse_yaml("image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\nfree_thresh: 0.2\n", "m.yaml:1",
              "lacks the key 'occupied_thresh'", "0.65");
  refuse_yaml("image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\n", "m.yaml:1",
              "lacks the key 'free_thresh'", "0.196");
  refuse_yaml(YAML(""), "m.yaml:1", "lacks the key 'negate'", "negate: 0");
}

static void test_mistyped_keys(void) {
  refuse_yaml(YAML("negate: 0\nmoed: raw\n"), "m.yaml:7", "unknown key 'moed'", "did you mean 'mode'?");
  refuse_yaml(YAML("negate: 0\nnegate: 1\n"), "m.yaml:7",
              "key 'negate' of the ROS map is there twice (first in line 6)", "keep one");
  refuse_yaml(YAML("Negate: 0\n"), "m.yaml:6", "unknown key 'Negate'", "did you mean 'negate'?");
}

static void test_wrong_values(void) {
  refuse_yaml(YAML("negate: maybe\n"), "m.yaml:6", "'negate' is \"maybe\"", "one of 0, 1, false and true");
  refuse_yaml(YAML("negate: 0\nmode: rough\n"), "m.yaml:7", "'mode' is \"rough\"", "trinary, scale and raw");
  const char *rest = "negate: 0\nimage: m.pgm\n";
  const char *const wrong[][3] = {
      {"resolution: fine\norigin: [0, 0, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "'resolution' is \"fine\"",
       "number"},
      {"resolution: 0\norigin: [0, 0, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "'resolution' is 0 metres",
       "1e-6"},
      {"resolution: .inf\norigin: [0, 0, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "not a finite number",
       "number"},
      {"resolution: 1\norigin: [0, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n",
       "'origin' is not a list of x, y and yaw", "origin:"},
      {"resolution: 1\norigin: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "'origin' is not a list", "origin:"},
      {"resolution: 1\norigin: [0, 0, .inf]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "origin's yaw", "number"},
      {"resolution: 1\norigin: [0, .nan, 0]\noccupied_thresh: 0.6\nfree_thresh: 0.2\n", "origin's y", "number"},
      {"resolution: 1\norigin: [0, 0, 0]\noccupied_thresh: 65\nfree_thresh: 0.2\n", "'occupied_thresh' is 65",
       "0 to 1"},
      {"resolution: 1\norigin: [0, 0, 0]\noccupied_thresh: 0.2\nfree_thresh: 0.6\n", "above 'occupied_thresh'", "swap"},
      {"resolution: 1\norigin: [0, 0, 0]\noccupied_thresh:\nfree_thresh: 0.6\n", "'occupied_thresh' has no value",
       "number"}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    char yaml[300];
    snprintf(yaml, sizeof yaml, "%s%s", wrong[i][0], rest);
    scratch_write_rosmap(yaml, "P2 2 1 255\n255 255\n", MISSION(""));
    TEST_ASSERT_EQUAL_INT(-1,
                          input_read(&scratch_input, scratch_path("mission.yaml"), &scratch_options, &scratch_fault));
    scratch_expect_text("/m.yaml:");
    scratch_expect_text(wrong[i][1]);
    scratch_expect_text(wrong[i][2]);
  }
}

static void test_faults_of_the_image(void) {
  refuse_yaml("image: other.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n",
              "other.pgm", "no such file", "m.yaml:1)");
  scratch_write_rosmap(YAML("negate: 0\n"), "GIF89a", MISSION(""));
  scratch_refuse("mission.yaml", "m.pgm", "not a PGM, PNG or BMP", "convert");
}

/* ---- the savers' grey ---- */

#define SAVED(more) "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.25\n" more
#define GREYS "P2 5 1 255\n254 205 205 254 0\n"

static void expect_note(const char *what) {
  for (int i = 0; i < scratch_input.note.count; i++)
    if (strstr(scratch_input.note.text[i], what) != NULL) return;
  TEST_FAIL_MESSAGE(what);
}

static void expect_no_note(const char *what) {
  for (int i = 0; i < scratch_input.note.count; i++)
    if (strstr(scratch_input.note.text[i], what) != NULL) TEST_FAIL_MESSAGE(scratch_input.note.text[i]);
}

#define FAR_ENDS(more) "map: m.yaml\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 3, row: 0}]\n" more

static void test_unknown_grey_that_the_thresholds_make_free_is_told(void) {
  scratch_write_rosmap(SAVED("negate: 0\n"), GREYS, FAR_ENDS(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("1111#|");
  expect_note("2 cells of the image are unknown-grey (205) and free by its free_thresh of 0.25");
  expect_note("\"unknown: blocked\"");
}

static void test_unknown_blocked_written_out_closes_the_grey(void) {
  scratch_write_rosmap(SAVED("negate: 0\n"), GREYS, FAR_ENDS("unknown: blocked\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("1##1#|");
  expect_no_note("unknown-grey");
  scratch_write_rosmap(SAVED("negate: 0\nmode: scale\n"), GREYS, FAR_ENDS("unknown: blocked\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("1##1#|");
}

static void test_unknown_free_written_out_is_not_told(void) {
  scratch_write_rosmap(SAVED("negate: 0\n"), GREYS, FAR_ENDS("unknown: free\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("1111#|");
  expect_no_note("unknown-grey");
}

static void test_the_grey_in_other_modes_and_maxima(void) {
  /* scale: the same rule; negate: the grey is seen as its negative, 50; raw: 205 is unknown whatever the thresholds. */
  scratch_write_rosmap(SAVED("negate: 0\nmode: scale\n"), GREYS, FAR_ENDS(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("1111#|");
  expect_note("2 cells of the image are unknown-grey");
  scratch_write_rosmap(SAVED("negate: 1\n"), "P2 5 1 255\n1 50 50 1 255\n", FAR_ENDS(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("1111#|");
  expect_note("2 cells of the image are unknown-grey");
  scratch_write_rosmap(SAVED("negate: 1\n"), "P2 5 1 255\n1 50 205 1 255\n", FAR_ENDS("unknown: blocked\n"));
  scratch_read("mission.yaml");
  scratch_expect_cells("1##1#|");
  scratch_write_rosmap(SAVED("negate: 0\nmode: raw\n"), "P2 5 1 255\n0 205 205 0 100\n", FAR_ENDS(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("1##1#|");
  expect_no_note("unknown-grey");
  scratch_write_rosmap(SAVED("negate: 0\n"), "P2 5 1 65535\n65278 52685 52684 65278 0\n", FAR_ENDS(""));
  scratch_read("mission.yaml");
  expect_note("1 cell of the image is unknown-grey");
  scratch_write_rosmap(SAVED("negate: 0\n"), "P2 5 1 100\n100 80 81 100 0\n", FAR_ENDS(""));
  scratch_read("mission.yaml");
  expect_no_note("unknown-grey"); /* no sample of 100 is 205 of 255 */
}

static void test_thresholds_that_see_the_grey_need_no_note(void) {
  scratch_write_rosmap(
      "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.196\nnegate: 0\n",
      GREYS, FAR_ENDS(""));
  scratch_read("mission.yaml");
  scratch_expect_cells("1##1#|");
  expect_no_note("unknown-grey");
}

/* ---- other notes and mends ---- */

static void test_robots_without_a_size_are_told_to_be_points(void) {
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 2 1 255\n255 255\n", MISSION(""));
  scratch_read("mission.yaml");
  expect_note("robots are points, and cells the map's pixels of 0.5 m");
  static const char *const given[] = {MISSION("robot_radius: 0\n"), MISSION("cell_size: 0.5\n"),
                                      MISSION("robot_radius: 0.1\n")};
  for (size_t i = 0; i < sizeof given / sizeof *given; i++) {
    scratch_write_rosmap(YAML("negate: 0\n"), "P2 2 1 255\n255 255\n", given[i]);
    scratch_read("mission.yaml");
    expect_no_note("points");
  }
}

static void test_where_nothing_is_left_free_its_reason_is_named(void) {
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 3 1 255\n255 0 255\n", MISSION("cell_size: 1\n"));
  scratch_refuse("mission.yaml", "mission.yaml", "no cell is left free: cells of 1 m are larger than the free space",
                 "pixels are 0.5 m");
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 3 1 255\n255 0 255\n", MISSION("robot_radius: 2\n"));
  scratch_refuse("mission.yaml", "mission.yaml", "the robot_radius of 2 m is larger than the free space", "smaller");
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 3 1 255\n0 0 0\n", MISSION(""));
  scratch_refuse("mission.yaml", "m.pgm", "no pixel is free by the thresholds of", "negate");
}

/* What is proposed for a threshold that is missing is not refused next. */
static void test_a_proposed_threshold_fits_the_other(void) {
  static const char *const other[] = {"occupied_thresh: 0.05", "occupied_thresh: 0", "occupied_thresh: 0.65",
                                      "free_thresh: 0.9",      "free_thresh: 0.3",   "free_thresh: 1"};
  for (size_t i = 0; i < sizeof other / sizeof *other; i++) {
    char yaml[400], line[64];
    snprintf(yaml, sizeof yaml, "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n%s\n", other[i]);
    scratch_write_rosmap(yaml, "P2 2 1 255\n255 255\n", MISSION(""));
    scratch_refuse("mission.yaml", "m.yaml:1", "lacks the key", "_thresh: ");
    const char *from = strstr(scratch_fault.text, "add \"");
    TEST_ASSERT_NOT_NULL(from);
    snprintf(line, sizeof line, "%.*s\n", (int)strcspn(from + 5, "\""), from + 5);
    strcat(yaml, line);
    scratch_write_rosmap(yaml, "P2 2 1 255\n255 255\n", MISSION(""));
    if (input_read(&scratch_input, scratch_path("mission.yaml"), &scratch_options, &scratch_fault) != 0)
      TEST_ASSERT_NULL_MESSAGE(strstr(scratch_fault.text, "above 'occupied_thresh'"), scratch_fault.text);
  }
}

/* The cell size that is named is taken, and a hair less is not. */
#define INSIDE(more) "map: m.yaml\nrobots: [{column: 1, row: 9}]\nplaces: [{column: 2, row: 9}]\n" more
static void test_the_smallest_cell_size_that_fits_does(void) {
  static const int sizes[][2] = {{1100, 1000}, {1025, 1024}, {2000, 1500}, {4097, 257}};
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    const size_t pixels = (size_t)sizes[i][0] * (size_t)sizes[i][1];
    char *image = malloc(pixels + 64), mission[200];
    const int head = sprintf(image, "P5 %d %d 255\n", sizes[i][0], sizes[i][1]);
    memset(image + head, 255, pixels);
    scratch_write("m.yaml", YAML("negate: 0\n"));
    scratch_write_bytes("m.pgm", image, (size_t)head + pixels);
    free(image);
    scratch_write("mission.yaml", INSIDE("cell_size: 0.05\n"));
    scratch_refuse("mission.yaml", "m.yaml", "most that this build holds", "is the smallest that fits");
    const char *from = strstr(scratch_fault.text, "\"cell_size: ");
    TEST_ASSERT_NOT_NULL(from);
    const double least = strtod(from + strlen("\"cell_size: "), NULL);
    snprintf(mission, sizeof mission, INSIDE("cell_size: %.10g\n"), least);
    scratch_write("mission.yaml", mission);
    scratch_read("mission.yaml");
    snprintf(mission, sizeof mission, INSIDE("cell_size: %.10g\n"), least * 0.985);
    scratch_write("mission.yaml", mission);
    scratch_refuse("mission.yaml", "m.yaml", "most that this build holds", "is the smallest that fits");
  }
}

static void test_more_cells_than_the_build_holds(void) {
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 2 1 255\n255 255\n", MISSION("cell_size: 0.0003125\n"));
  scratch_refuse("mission.yaml", "m.yaml", "3200 x 1600 cells are more than 4194304", "QTR_MAX_CELLS");
  scratch_write_rosmap(YAML("negate: 0\n"), "P2 2 1 255\n255 255\n", MISSION("cell_size: 1e-300\n"));
  scratch_refuse("mission.yaml", "m.yaml", "cells: at most 65535", "larger cells");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_trinary_thresholds_are_strict);
  RUN_TEST(test_negate_turns_the_greys_round);
  RUN_TEST(test_other_maxima_scale);
  RUN_TEST(test_map_savers_own_greys);
  RUN_TEST(test_scale_counts_all_but_nothing_as_occupied);
  RUN_TEST(test_greys_of_scale_maps_are_ground_that_takes_longer);
  RUN_TEST(test_the_slowest_pixel_of_a_cell_counts);
  RUN_TEST(test_grey_cost_is_for_maps_that_have_greys);
  RUN_TEST(test_raw_takes_the_greys_as_percent);
  RUN_TEST(test_rows_columns_and_the_frame);
  RUN_TEST(test_unknown_is_blocked_unless_free_is_asked_for);
  RUN_TEST(test_negate_and_mode_are_read);
  RUN_TEST(test_obstacles_grow_by_the_radius);
  RUN_TEST(test_growth_comes_before_coarsening);
  RUN_TEST(test_cell_size_of_the_command_line_wins);
  RUN_TEST(test_other_tools_keys_are_ignored);
  RUN_TEST(test_a_map_alone_is_refused_with_how_to_write_a_mission);
  RUN_TEST(test_the_mission_that_is_proposed_for_a_map_is_sound);
  RUN_TEST(test_missing_keys);
  RUN_TEST(test_mistyped_keys);
  RUN_TEST(test_wrong_values);
  RUN_TEST(test_faults_of_the_image);
  RUN_TEST(test_unknown_grey_that_the_thresholds_make_free_is_told);
  RUN_TEST(test_unknown_blocked_written_out_closes_the_grey);
  RUN_TEST(test_unknown_free_written_out_is_not_told);
  RUN_TEST(test_the_grey_in_other_modes_and_maxima);
  RUN_TEST(test_thresholds_that_see_the_grey_need_no_note);
  RUN_TEST(test_robots_without_a_size_are_told_to_be_points);
  RUN_TEST(test_where_nothing_is_left_free_its_reason_is_named);
  RUN_TEST(test_a_proposed_threshold_fits_the_other);
  RUN_TEST(test_the_smallest_cell_size_that_fits_does);
  RUN_TEST(test_more_cells_than_the_build_holds);
  return UNITY_END();
}
