/* Missions whose ground says where the target may be. */
#include "support/tool_run.h"

static tool_result r;

void setUp(void) {
  write_file("field.txt", "S......\n.......\n.......\n.......\n");
  write_file("likely.asc", "ncols 7\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
                           "0 0 0 0 0 9 0\n0 0 0 0 0 0 0\n0 0 0 1 0 0 0\n5 0 0 0 0 0 0\n");
  write_file("raster.yaml", "map: field.txt\nplaces_raster: {file: likely.asc, footprint: 1, share: 0.9}\n"
                            "robots: [{column: 0, row: 0}, {column: 0, row: 0}]\n");
  write_file("listed.yaml", "map: field.txt\nplaces: [{column: 5, row: 0, weight: 9}, {column: 0, row: 3, weight: 5}]\n"
                            "robots: [{column: 0, row: 0}, {column: 0, row: 0}]\n");
}

void tearDown(void) {
}

/* Of the mass of 15 the two tiles of 9 and 5 cover 93 %. */
static void test_a_raster_is_learnt_as_its_tiles_are_when_they_are_listed(void) {
  run_tool(&r, "learn listed.yaml --objective time --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  const double listed = json_value(r.out, "expected_time");
  run_tool(&r, "learn raster.yaml --objective time --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, listed, json_value(r.out, "expected_time"));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "2 places of 3 tiles hold 93.33 % of the likelihood within reach"), r.out);
}

/* Seven columns and four rows of tiles: a replan without one of them calls the others what they were called. */
static void test_places_of_a_raster_keep_their_names(void) {
  run_tool(&r, "learn raster.yaml -o all.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "F4 (step"), r.out);
  run_tool(&r, "learn raster.yaml --clear F4 --against all.qtr -o rest.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, ": A1 (step 3)"), r.out);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "gone: F4\n"), r.out);
  run_tool(&r, "export rest.qtr --places -o ways.csv");
  char ways[500];
  read_text("ways.csv", ways, sizeof ways);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(ways, ",A1,0,3,"), ways);
}

static void test_a_raster_that_does_not_lie_on_the_map_is_refused(void) {
  write_file("likely.asc", "ncols 1\nnrows 1\nxllcorner 70\nyllcorner 0\ncellsize 1\n1\n");
  run_tool(&r, "learn raster.yaml -o none.qtr");
  TEST_ASSERT_EQUAL_INT(2, r.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, "likely.asc: it spans x 70 to 71 and y 0 to 1"), r.err);
}

static void test_points_of_a_geojson_are_learnt_as_they_are_when_they_are_listed(void) {
  write_file("points.json", "{\"type\": \"FeatureCollection\", \"crs\": {\"properties\": {\"name\": \"local\"}}, "
                            "\"features\": [{\"type\": \"Feature\", \"properties\": {\"POA\": 9, \"name\": \"Barn\"}, "
                            "\"geometry\": {\"type\": \"Point\", \"coordinates\": [5.5, 3.5]}}, {\"type\": "
                            "\"Feature\", \"properties\": {\"POA\": 5}, \"geometry\": {\"type\": \"Polygon\", "
                            "\"coordinates\": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}}]}");
  write_file("points.yaml", "map: field.txt\nplaces_geojson: {file: points.json, footprint: 1}\n"
                            "robots: [{column: 0, row: 0}, {column: 0, row: 0}]\n");
  run_tool(&r, "learn listed.yaml --objective time --json");
  const double listed = json_value(r.out, "expected_time");
  run_tool(&r, "learn points.yaml --objective time --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, listed, json_value(r.out, "expected_time"));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "Barn"), r.out);
}

/* The wall leaves a way round below; mud beside the start costs more than its detour. */
static void test_barred_and_rough_ground_is_gone_round(void) {
  write_file("barred.yaml", "map: field.txt\nplaces: [{column: 6, row: 0}]\nrobots: [{column: 0, row: 0}]\n"
                            "no_go: [[{x: 3, y: 1}, {x: 4, y: 1}, {x: 4, y: 4}, {x: 3, y: 4}]]\n");
  run_tool(&r, "learn barred.yaml --objective time --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 12.0, json_value(r.out, "expected_time"));
  write_file("mud.asc", "ncols 1\nnrows 1\nxllcorner 1\nyllcorner 3\ncellsize 1\n9\n");
  write_file("barred.yaml", "map: field.txt\nplaces: [{column: 6, row: 0}]\nrobots: [{column: 0, row: 0}]\n"
                            "terrain: mud.asc\n");
  run_tool(&r, "learn barred.yaml --objective time --json");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 8.0, json_value(r.out, "expected_time"));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_raster_is_learnt_as_its_tiles_are_when_they_are_listed);
  RUN_TEST(test_places_of_a_raster_keep_their_names);
  RUN_TEST(test_a_raster_that_does_not_lie_on_the_map_is_refused);
  RUN_TEST(test_points_of_a_geojson_are_learnt_as_they_are_when_they_are_listed);
  RUN_TEST(test_barred_and_rough_ground_is_gone_round);
  return UNITY_END();
}
