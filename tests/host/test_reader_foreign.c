/* Files of other trades are named as what they are, as an input, as a mission's map and as its places. */
#include "support/reader_scratch.h"

void setUp(void) {
  scratch_open();
}

void tearDown(void) {
  scratch_close();
}

static const struct {
  const char *name, *text, *what;
} files[] = {
    {"a.geojson", "{\"type\":\"FeatureCollection\",\"features\":[]}\n", "a GeoJSON"},
    {"b.json", "\n { \"type\": \"Point\", \"coordinates\": [1, 2] }", "a GeoJSON"},
    {"a.kml", "<?xml version=\"1.0\"?>\n<kml/>\n", "a KML"},
    {"b.kml", "\xef\xbb\xbf<kml xmlns=\"http://www.opengis.net/kml/2.2\">", "a KML"},
    {"a.gpx", "<?xml version=\"1.0\"?><gpx version=\"1.1\">", "a GPX"},
    {"a.svg", "<svg width=\"3\">", "an SVG picture"},
    {"a.world", "<?xml version=\"1.0\"?><sdf version=\"1.6\">", "a Gazebo world"},
    {"a.xml", "<thing/>", "an XML file"},
    {"a.plan", "{\"fileType\":\"Plan\",\"mission\":{\"items\":[]},\"version\":1}\n", "a QGroundControl plan"},
    {"a.waypoints", "QGC WPL 110\n0\t1\t0\n", "a list of waypoints"},
    {"a.asc", "ncols 2\nnrows 2\ncellsize 1\n1 1\n1 1\n", "an ESRI ASCII grid"},
    {"b.asc", "NCOLS        2\nNROWS 2\n", "an ESRI ASCII grid"},
    {"a.scen", "version 1\n0\tm.map\t4\t4\t0\t0\t3\t3\t6\n", "a Moving AI scenario"},
    {"a.building.yaml", "levels:\n  L1: {}\nname: x\n", "a building of Open-RMF"},
    {"nav.yaml", "building_name: b\nlevels:\n  L1: {}\n", "a building of Open-RMF"},
    {"a.bt", "# Octomap OcTree binary file\n", "an OctoMap"},
    {"a.pcd", "# .PCD v0.7 - Point Cloud Data\n", "a point cloud"},
    {"a.bag", "#ROSBAG V2.0\n", "a ROS bag"},
    {"a.qtr", "QTRP\1\2\3", "a policy table"},
    {"a.zip", "PK\3\4abc", "a ZIP archive"},
};

static void test_as_an_input(void) {
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    scratch_write(files[i].name, files[i].text);
    char what[100];
    snprintf(what, sizeof what, "%s: is %s", files[i].name, files[i].what);
    scratch_refuse(files[i].name, files[i].name, what, files[i].what[2] == 'p' ? "" : ";");
  }
}

static void test_as_a_missions_map_and_as_its_places(void) {
  scratch_write("map.txt", "S..1\n");
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    char mission[200], what[100];
    scratch_write("f", files[i].text);
    snprintf(mission, sizeof mission, "map: f\nrobots: [{column: 1, row: 1}]\nplaces: [{column: 3, row: 3}]\n");
    scratch_write("m.yaml", mission);
    snprintf(what, sizeof what, "'map' names %s", files[i].what);
    scratch_refuse("m.yaml", "m.yaml:1", what, ";");
    scratch_write("m.yaml", "map: map.txt\nplaces_csv: f\n");
    snprintf(what, sizeof what, "is %s", files[i].what);
    scratch_refuse("m.yaml", "f", what, ";");
  }
}

static void test_a_csv_of_places_is_one_only_where_places_are_wanted(void) {
  scratch_write("map.txt", "S..1\n");
  scratch_write("p.csv", "x,y,weight\n2.5,0.5,3\n");
  scratch_refuse("p.csv", "p.csv", "is a CSV of places", "'places_csv' in a mission");
  scratch_write("m.yaml", "map: map.txt\nplaces_csv: p.csv\n");
  scratch_read("m.yaml");
}

static void test_what_only_resembles_them_is_read(void) {
  scratch_write("map.txt", "S..1\n");
  scratch_write("m.json", "{\"map\": \"map.txt\", \"name\": \"Plan\"}");
  scratch_read("m.json");
  scratch_write("m.yaml", "# levels: none\nmap: map.txt\n");
  scratch_read("m.yaml");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_as_an_input);
  RUN_TEST(test_as_a_missions_map_and_as_its_places);
  RUN_TEST(test_a_csv_of_places_is_one_only_where_places_are_wanted);
  RUN_TEST(test_what_only_resembles_them_is_read);
  return UNITY_END();
}
