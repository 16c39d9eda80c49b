#include "support/reader_scratch.h"

#define MISSION "map: m.yaml\nrobots: [{x: 0.5, y: 0.5}]\nplaces: [{x: 2.5, y: 0.5}]\n"

void setUp(void) {
  scratch_open();
  scratch_write("m.pgm", "P2\n4 2\n255\n254 254 254 254\n254 254 254 254\n");
  scratch_write("m.yaml", "image: m.pgm\nresolution: 1.0\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                          "free_thresh: 0.196\n");
  scratch_write("a.txt", "S..1\n");
}

void tearDown(void) {
  scratch_close();
}

static void read_geo(const char *value) {
  char text[300];
  snprintf(text, sizeof text, MISSION "geo: %s\n", value);
  scratch_write("mission.yaml", text);
  scratch_read("mission.yaml");
}

static void refuse(const char *value, const char *what, const char *mend) {
  char text[300];
  snprintf(text, sizeof text, MISSION "geo: %s\n", value);
  scratch_write("mission.yaml", text);
  scratch_refuse("mission.yaml", "mission.yaml:4", what, mend);
}

static void expect(double latitude, double longitude, double yaw) {
  const qtr_geo *geo = &scratch_input.geo;
  TEST_ASSERT_TRUE(geo->given);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, latitude, (double)geo->latitude / 1e9);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, longitude, (double)geo->longitude / 1e9);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, yaw, (double)geo->yaw / 1e9);
}

static void test_the_origin_is_read(void) {
  read_geo("{latitude: 52.516275, longitude: -13.377704, yaw: 0.25}");
  expect(52.516275, -13.377704, 0.25);
  read_geo("{longitude: 180, latitude: -90}");
  expect(-90.0, 180.0, 0.0);
}

static void test_a_mission_without_it_has_none(void) {
  scratch_write("mission.yaml", MISSION);
  scratch_read("mission.yaml");
  TEST_ASSERT_FALSE(scratch_input.geo.given);
}

static void test_values_out_of_range_are_refused_by_name(void) {
  refuse("{latitude: 91, longitude: 95}", "'latitude' is 91", "from -90 to 90");
  refuse("{latitude: 5, longitude: 181}", "'longitude' is 181", "from -180 to 180");
  refuse("{latitude: 5, longitude: 6, yaw: 90}", "'yaw' is 90", "(90 degrees are 1.5708)");
  refuse("{latitude: x, longitude: 6}", "'latitude' is \"x\"", "give a number");
  refuse("{latitude: nan, longitude: 6}", "'latitude'", "number");
}

static void test_exchanged_coordinates_are_suspected(void) {
  refuse("{latitude: 151.2, longitude: -33.9}", "seem exchanged", "the other way round");
}

static void test_what_is_missing_or_unknown_is_named(void) {
  refuse("{latitude: 5}", "longitude", "longitude: 13.3777");
  refuse("{longitude: 5}", "latitude", "latitude: 52.5163");
  refuse("{latitude: 5, longitude: 6, altitude: 7}", "altitude", "latitude");
  refuse("[5, 6]", "'geo'", "latitude");
}

static void test_a_map_without_metres_has_no_place_on_the_globe(void) {
  scratch_write("mission.yaml", "map: a.txt\ngeo: {latitude: 5, longitude: 6}\n");
  scratch_refuse("mission.yaml", "mission.yaml:2", "metres", "delete it");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_the_origin_is_read);
  RUN_TEST(test_a_mission_without_it_has_none);
  RUN_TEST(test_values_out_of_range_are_refused_by_name);
  RUN_TEST(test_exchanged_coordinates_are_suspected);
  RUN_TEST(test_what_is_missing_or_unknown_is_named);
  RUN_TEST(test_a_map_without_metres_has_no_place_on_the_globe);
  return UNITY_END();
}
