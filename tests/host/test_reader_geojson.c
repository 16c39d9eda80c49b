#include "support/reader_scratch.h"

#define FILE_OF(features)                                                                                              \
  "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"local\"}},\n\"features\":"    \
  "[" features "]}\n"
#define DEGREES_OF(features) "{\"type\": \"FeatureCollection\", \"features\": [" features "]}\n"
#define FEATURE(type, coordinates, properties)                                                                         \
  "{\"type\":\"Feature\",\"geometry\":{\"type\":\"" type "\",\"coordinates\":" coordinates                             \
  "},\"properties\":" properties "}"
#define SQUARE "[[[0,0],[2,0],[2,2],[0,2],[0,0]]]"

void setUp(void) {
  scratch_open();
  scratch_write("a.txt", "......\n......\n......\nS.....\n");
  scratch_write("m.yaml", "map: a.txt\nplaces_geojson: {file: p.json, footprint: 2}\n");
  scratch_write("m.pgm", "P2\n16 8\n1\n"
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 \n"
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 \n"
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 \n"
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 \n"
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 \n"
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 \n"
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 \n"
                         "1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 \n");
  scratch_write("m_ros.yaml", "image: m.pgm\nresolution: 100\norigin: [-450, -250, 0]\nnegate: 0\n"
                              "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

void tearDown(void) {
  scratch_close();
}

static void write_globe(const char *rest) {
  char text[400];
  snprintf(text, sizeof text, "map: m_ros.yaml\nrobots: [{column: 0, row: 0}]\n%s", rest);
  scratch_write("globe.yaml", text);
}

static void expect_place(int place, unsigned column, unsigned row, double weight) {
  const qtr_mission *mission = &scratch_input.mission;
  TEST_ASSERT_LESS_THAN_INT(mission->places, place);
  TEST_ASSERT_EQUAL_INT(row * mission->columns + column, mission->place[place]);
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, weight, mission->weight[place]);
}

static void test_points_are_places_with_weights_and_names(void) {
  scratch_write(
      "p.json",
      FILE_OF(FEATURE("Point", "[0.5,1.5]", "{\"POA\":0.25,\"name\":\"Well\",\"depth\":\"3 cm\"}") "," FEATURE(
          "Point", "[3.5,0.5,12]", "{\"likelihood\":7,\"name\":null}") "," FEATURE("Point", "[5.5,3.5]", "null")));
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(3, scratch_input.mission.places);
  expect_place(0, 0, 2, 0.25);
  expect_place(1, 3, 3, 7.0);
  expect_place(2, 5, 0, 1.0);
  TEST_ASSERT_EQUAL_STRING("Well", scratch_input.names.place[0]);
  TEST_ASSERT_EQUAL_STRING("", scratch_input.names.place[1]);
}

/* Nine cells of 2 each, of which four, two, two and one fall into tiles; a hole leaves the middle out. */
static void test_polygons_are_spread_over_tiles(void) {
  scratch_write("p.json", FILE_OF(FEATURE("Polygon", "[[[0,0],[3,0],[3,3],[0,3],[0,0]]]", "{\"weight\":18}")));
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(4, scratch_input.mission.places);
  TEST_ASSERT_EQUAL_DOUBLE(8.0, scratch_input.mission.weight[0]);
  TEST_ASSERT_EQUAL_DOUBLE(4.0, scratch_input.mission.weight[1]);
  expect_place(3, 2, 1, 2.0);
  scratch_write("p.json", FILE_OF(FEATURE("MultiPolygon",
                                          "[[[[0,0],[3,0],[3,3],[0,3],[0,0]],[[1,1],[2,1],[2,2],[1,2],[1,1]]],"
                                          "[[[4,0],[5,0],[5,1],[4,1],[4,0]]]]",
                                          "{\"weight\":18}")));
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(5, scratch_input.mission.places);
  TEST_ASSERT_EQUAL_DOUBLE(6.0, scratch_input.mission.weight[0]);
  expect_place(4, 4, 3, 2.0);
}

/* Of tiles of 2 cells one area takes a column, the second one a single tile, and the third has no name. */
static void test_tiles_of_polygons_are_named_by_them(void) {
  scratch_write(
      "p.json",
      FILE_OF(FEATURE("Polygon", "[[[0,0],[2,0],[2,4],[0,4],[0,0]]]", "{\"weight\":8,\"name\":\"Wood\"}") "," FEATURE(
          "Polygon", "[[[2,2],[4,2],[4,4],[2,4],[2,2]]]",
          "{\"weight\":2,\"name\":\"Barn\"}") "," FEATURE("Polygon", "[[[2,0],[4,0],[4,2],[2,2],[2,0]]]",
                                                          "{\"weight\":1}")));
  scratch_read("m.yaml");
  TEST_ASSERT_EQUAL_INT(4, scratch_input.mission.places);
  TEST_ASSERT_EQUAL_STRING("Wood A2", scratch_input.names.place[0]);
  TEST_ASSERT_EQUAL_STRING("Wood A1", scratch_input.names.place[1]);
  TEST_ASSERT_EQUAL_STRING("Barn", scratch_input.names.place[2]);
  TEST_ASSERT_EQUAL_STRING("B1", scratch_input.names.place[3]);
}

static double sum_of_weights(void) {
  double sum = 0.0;
  for (int place = 0; place < scratch_input.mission.places; place++) sum += scratch_input.mission.weight[place];
  return sum;
}

/* The map is 6 x 4; of the area of 4 x 2, with a hole of 1 x 1 in what lies off it, 4 of 7 are on it. */
static void test_of_an_area_that_leaves_the_map_a_part_counts(void) {
  scratch_write("p.json", FILE_OF(FEATURE("Polygon",
                                          "[[[4,0],[8,0],[8,2],[4,2],[4,0]],[[6.5,0.5],[7.5,0.5],[7.5,1.5],[6.5,1.5],"
                                          "[6.5,0.5]]]",
                                          "{\"POA\":7}")));
  scratch_read("m.yaml");
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 4.0, sum_of_weights());
  TEST_ASSERT_NOT_NULL(strstr(scratch_input.note.text[0], "42.9 % of all lies off the map"));
  scratch_write("p.json", FILE_OF(FEATURE("Polygon", "[[[4,0],[6,0],[6,4],[4,4],[4,0]]]", "{\"POA\":7}")));
  scratch_read("m.yaml");
  TEST_ASSERT_DOUBLE_WITHIN(1e-9, 7.0, sum_of_weights());
  TEST_ASSERT_NULL(strstr(scratch_input.note.text[0], "off the map"));
}

static void test_a_feature_or_geometry_alone_is_read(void) {
  scratch_write("p.json",
                "{\"type\":\"Point\",\"coordinates\":[1.5,0.5],\"crs\":{\"properties\":{\"name\":\"local\"}}}");
  scratch_read("m.yaml");
  expect_place(0, 1, 3, 1.0);
}

static void test_no_go_areas_of_a_file(void) {
  scratch_write("m.yaml", "map: a.txt\nplaces: [{column: 5, row: 0}]\nno_go: n.json\n");
  scratch_write("n.json", FILE_OF(FEATURE("Polygon", "[[[1.5,1],[3,1],[3,3],[1.5,3]]]", "{}")));
  scratch_read("m.yaml");
  scratch_expect_cells("111111|1##111|1##111|111111|");
  scratch_write("n.json",
                FILE_OF(FEATURE("Polygon", "[[[1,0],[5,0],[5,4],[1,4]],[[2,0.5],[4,0.5],[4,3],[2,3]]]", "{}")));
  scratch_read("m.yaml");
  scratch_expect_cells("1####1|1#11#1|1#11#1|1####1|");
}

/* ---- degrees ---- */

#define GEO "geo: {latitude: 52.5163, longitude: 13.3777}\n"

static void test_degrees_need_an_origin(void) {
  write_globe("places_geojson: {file: p.json}\n");
  scratch_write("p.json", DEGREES_OF(FEATURE("Point", "[13.39243077,52.51629908]", "{}")));
  scratch_refuse("globe.yaml", "p.json:1", "coordinates are degrees", "geo: {latitude");
}

#ifdef QUARTER_PROJ
/* As geographiclib has it: 1000 m east of the origin, and 300 m west and 400 m north. */
static void test_degrees_are_put_on_the_map(void) {
  write_globe("places_geojson: {file: p.json}\n" GEO);
  scratch_write("p.json", DEGREES_OF(FEATURE("Point", "[13.392430769467,52.516299083298]", "{}") "," FEATURE(
                              "Point", "[13.373280408431,52.519894545039]", "{\"weight\": 3}")));
  scratch_read("globe.yaml");
  expect_place(0, 14, 5, 1.0);
  expect_place(1, 1, 1, 3.0);
  TEST_ASSERT_DOUBLE_WITHIN(1e-3, -300.0, scratch_input.place_position[1].x);
  TEST_ASSERT_DOUBLE_WITHIN(1e-3, 400.0, scratch_input.place_position[1].y);
  write_globe(
      "places_geojson: {file: p.json}\ngeo: {latitude: 52.5163, longitude: 13.3777, yaw: 1.5707963267948966}\n");
  scratch_write("p.json", DEGREES_OF(FEATURE("Point", "[13.373280408431,52.519894545039]", "{}")));
  scratch_read("globe.yaml");
  TEST_ASSERT_DOUBLE_WITHIN(1e-3, 400.0, scratch_input.place_position[0].x);
  TEST_ASSERT_DOUBLE_WITHIN(1e-3, 300.0, scratch_input.place_position[0].y);
}

static void test_exchanged_coordinates_are_suspected(void) {
  write_globe("places_geojson: {file: p.json}\n" GEO);
  scratch_write("p.json", DEGREES_OF(FEATURE("Point", "[52.516299083298,13.392430769467]", "{}")));
  scratch_refuse("globe.yaml", "p.json:1", "on it with latitude and longitude exchanged",
                 "write [13.3924308, 52.5162991]");
  scratch_write("p.json", DEGREES_OF(FEATURE("Point", "[13.6,52.6]", "{}")));
  scratch_refuse("globe.yaml", "p.json:1", "lies outside the map", "move");
  scratch_write("p.json", DEGREES_OF(FEATURE("Point", "[13.6,95]", "{}")));
  scratch_refuse("globe.yaml", "p.json:1", "no point of the globe", "they seem exchanged");
  scratch_write("p.json", DEGREES_OF(FEATURE("Point", "[193.6,52]", "{}")));
  scratch_refuse("globe.yaml", "p.json:1", "no point of the globe", "\"local\"");
  scratch_write("p.json", DEGREES_OF(FEATURE("Point", "[13.6,48]", "{}"))); /* hundreds of kilometres off */
  scratch_refuse("globe.yaml", "p.json:1", "lies outside the map", "check the mission's geo");
  TEST_ASSERT_NULL_MESSAGE(strstr(scratch_fault.text, "--snap"), scratch_fault.text);
}
#endif

/* ---- bad input ---- */

static void refuse(const char *text, const char *where, const char *what, const char *mend) {
  scratch_write("p.json", text);
  scratch_refuse("m.yaml", where, what, mend);
}

static void test_features_that_are_no_places(void) {
  refuse(FILE_OF(FEATURE("LineString", "[[0,0],[1,1]]", "{}")), "p.json:2", "feature 0 is a LineString", "Points");
  refuse(FILE_OF(FEATURE("Point", "[1]", "{}")), "p.json:2", "no list of two numbers", "[longitude, latitude]");
  refuse(FILE_OF(FEATURE("Point", "[1,NaN]", "{}")), "p.json:2", "'y' is \"NaN\"", "number");
  refuse(FILE_OF(FEATURE("Point", "[9,1]", "{}")), "p.json:2", "lies outside the map", "move");
  refuse(FILE_OF(FEATURE("Point", "[1,1]", "{\"weight\":-1}")), "p.json:2", "'weight' is -1", "likelihood");
  refuse(FILE_OF("{\"type\":\"Feature\"}"), "p.json:2", "feature 0 has no geometry", "give it one");
  refuse(FILE_OF("{\"geometry\":{\"type\":\"Point\"}}"), "p.json:2", "has no coordinates", "give it one");
  refuse(FILE_OF(""), "p.json", "no place to visit", "write one");
  refuse("{\"a\": 1}", "p.json:1", "geo", "local");
  refuse("{\"crs\":{\"properties\":{\"name\":\"local\"}}}", "p.json:1", "has no list of features", "GeoJSON");
  refuse("{\"crs\":{\"properties\":{\"name\":\"EPSG:32633\"}}}", "p.json:1", "coordinates of EPSG:32633", "EPSG:4326");
  refuse("{\"type\": \n", "p.json:2:1", "not valid", "mend");
}

static void test_polygons_that_are_none(void) {
  refuse(FILE_OF(FEATURE("Polygon", "[[[0,0],[2,2],[2,0],[0,2],[0,0]]]", "{}")), "p.json:2",
         "the polygon of feature 0 crosses itself", "in their order");
  refuse(FILE_OF(FEATURE("Polygon", "[[[0,0],[2,2],[0,0]]]", "{}")), "p.json:2", "has 2 corners", "3 at least");
  refuse(FILE_OF(FEATURE("Polygon", "[[[7,0],[9,0],[9,2]]]", "{}")), "p.json:2", "lies outside the map", "move");
  refuse(FILE_OF(FEATURE("Polygon", "[]", "{}")), "p.json:2", "has no ring", "corners");
  scratch_write("m.yaml", "map: a.txt\nplaces_geojson: {file: p.json}\n");
  refuse(FILE_OF(FEATURE("Polygon", SQUARE, "{}")), "p.json:2", "has no footprint", "footprint: 5");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_points_are_places_with_weights_and_names);
  RUN_TEST(test_polygons_are_spread_over_tiles);
  RUN_TEST(test_tiles_of_polygons_are_named_by_them);
  RUN_TEST(test_of_an_area_that_leaves_the_map_a_part_counts);
  RUN_TEST(test_a_feature_or_geometry_alone_is_read);
  RUN_TEST(test_no_go_areas_of_a_file);
  RUN_TEST(test_degrees_need_an_origin);
#ifdef QUARTER_PROJ
  RUN_TEST(test_degrees_are_put_on_the_map);
  RUN_TEST(test_exchanged_coordinates_are_suspected);
#endif
  RUN_TEST(test_features_that_are_no_places);
  RUN_TEST(test_polygons_that_are_none);
  return UNITY_END();
}
