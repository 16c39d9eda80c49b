/* ROS maps whose origin has a yaw: positions in metres are turned into the grid of the image. */
#include "host/input/frame.h"
#include "support/random.h"
#include "support/reader_scratch.h"

void setUp(void) {
  scratch_open();
}

void tearDown(void) {
  scratch_close();
}

#define TURNED(yaw)                                                                                                    \
  "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, " yaw "]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n"
#define WIDE "P2 4 2 255\n255 255 255 255\n255 255 255 255\n" /* row 0 on top: cells 0 to 3, then 4 to 7 */

/* Where a robot and a place, both in metres, come to stand. */
static void expect_turned(const char *yaw_map, const char *sites, int start, int place) {
  scratch_write_rosmap(yaw_map, WIDE, sites);
  scratch_read("mission.yaml");
  TEST_ASSERT_EQUAL_INT(start, scratch_input.mission.start[0]);
  TEST_ASSERT_EQUAL_INT(place, scratch_input.mission.place[0]);
}

static void test_a_map_turned_about_its_lower_left_corner(void) {
  /* A quarter turn to the left: along the image's bottom row y grows, up the image x falls. */
  const char *left = "map: m.yaml\nrobots: [{x: -1.25, y: 2.25}]\nplaces: [{x: -1.75, y: 3.75}]\n";
  expect_turned(TURNED("1.5707963267948966"), left, 4, 3);
  expect_turned(TURNED("1.5708"), left, 4, 3);
  expect_turned(TURNED("-4.71238898038469"), left, 4, 3);
  /* Half a turn, and a quarter to the right. */
  expect_turned(TURNED("3.141592653589793"),
                "map: m.yaml\nrobots: [{x: -1.25, y: 1.75}]\nplaces: [{x: -2.75, y: 1.25}]\n", 4, 3);
  expect_turned(TURNED("-1.5707963267948966"),
                "map: m.yaml\nrobots: [{x: -0.75, y: 1.75}]\nplaces: [{x: -0.25, y: 0.25}]\n", 4, 3);
  /* A turn by atan(3/4): the middle of the third cell of the top row is (1.25, 0.75) in the image, (0.55, 1.35) from
   * the corner. */
  expect_turned(TURNED("0.6435011087932844"),
                "map: m.yaml\nrobots: [{x: -0.95, y: 2.35}]\nplaces: [{x: -0.45, y: 3.35}]\n", 4, 2);
  const input_position centre = frame_centre(&scratch_input, 2, true);
  TEST_ASSERT_INT32_WITHIN(9, QTR_FRAME_ONE / 5 * 4, scratch_input.mission.frame.cosine);
  TEST_ASSERT_INT32_WITHIN(9, QTR_FRAME_ONE / 5 * 3, scratch_input.mission.frame.sine);
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, -0.45, centre.x);
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, 3.35, centre.y);
}

static void test_cells_do_not_turn_with_the_map(void) {
  expect_turned(TURNED("0.7"), "map: m.yaml\nrobots: [{column: 1, row: 0}]\nplaces: [{column: 2, row: 1}]\n", 1, 6);
}

static void test_a_whole_turn_is_none(void) {
  const char *sites = "map: m.yaml\nrobots: [{x: -0.75, y: 2.25}]\nplaces: [{x: 0.75, y: 2.75}]\n";
  const char *const turns[] = {TURNED("0"), TURNED("6.283185307179586"), TURNED("-12.566370614359172"),
                               TURNED("6.2832"), TURNED("1e-7")};
  for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
    expect_turned(turns[i], sites, 4, 3);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, scratch_input.frame.yaw);
  }
}

static void test_who_is_outside_a_turned_map_is_told_its_corners(void) {
  scratch_write_rosmap(TURNED("1.5707963267948966"), WIDE,
                       "map: m.yaml\nrobots: [{x: 5, y: 2}]\nplaces: [{column: 0, row: 0}]\n");
  scratch_refuse("mission.yaml", "mission.yaml:2", "corners are (-1, 2), (-1, 4), (-2, 4) and (-2, 2)", "nearest is");
}

/* Out to metres and back, for every cell and any turn. */
static void test_middles_of_cells_come_back_whatever_the_turn(void) {
  for (unsigned trial = 0; trial < 200; trial++) {
    test_random random = random_case("turn", trial);
    char yaml[300];
    const double yaw = random_below(&random, 20000) / 1000.0 - 10.0, x = random_below(&random, 1000) - 500.0;
    snprintf(yaml, sizeof yaml,
             "image: m.pgm\nresolution: 0.05\norigin: [%.3f, %.3f, %.5f]\nnegate: 0\noccupied_thresh: 0.6\n"
             "free_thresh: 0.2\n",
             x, -2.0 * x, yaw);
    scratch_write_rosmap(yaml, WIDE, "map: m.yaml\nrobots: [{column: 0, row: 0}]\nplaces: [{column: 1, row: 0}]\n");
    scratch_read("mission.yaml");
    for (qtr_cell cell = 0; cell < 8; cell++)
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(cell, frame_cell(&scratch_input, frame_centre(&scratch_input, cell, true)),
                                       case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_map_turned_about_its_lower_left_corner);
  RUN_TEST(test_cells_do_not_turn_with_the_map);
  RUN_TEST(test_a_whole_turn_is_none);
  RUN_TEST(test_who_is_outside_a_turned_map_is_told_its_corners);
  RUN_TEST(test_middles_of_cells_come_back_whatever_the_turn);
  return UNITY_END();
}
