#include "host/input/foreign.h"

#include <stdbool.h>
#include <string.h>
#include <strings.h>

#include "host/base/text.h"

#define HEAD 4096 /* bytes in which a format shows itself */

#define MAPS "maps that are: a drawing, a Moving AI .map, a ROS map_server YAML with a PGM, PNG or BMP"

#define WORDS 3

/* What a file starts with, blanks left out, and the words of which it holds one near its start (none named: any file).
 * In this order. */
static const struct {
  const char *start, *words[WORDS], *what;
} formats[] = {
    {"QTRP", {NULL}, "a policy table, which is made already; 'quarter inspect', 'simulate' and 'draw' take it"},
    {"{", {"\"fileType\""}, "a QGroundControl plan, which is not read; list its waypoints as places; " MAPS},
    {"{",
     {"\"FeatureCollection\"", "\"Feature\"", "\"coordinates\""},
     "a GeoJSON, which is no map; name it under places_geojson; " MAPS},
    {"{", {"\"tilewidth\""}, "a Tiled map, which is not read; " MAPS},
    {"QGC WPL", {NULL}, "a list of waypoints for a drone, which is not read; list them as places; " MAPS},
    {"<", {"<kml"}, "a KML, which is not read; list its points as places (places_csv); " MAPS},
    {"<", {"<gpx"}, "a GPX, which is not read; list its points as places (places_csv); " MAPS},
    {"<", {"<osm"}, "an OpenStreetMap extract, which is not read; " MAPS},
    {"<", {"<svg"}, "an SVG picture, which is not read; " MAPS},
    {"<", {"<sdf"}, "a Gazebo world, which is not read; save the robot's map of it; " MAPS},
    {"<", {"<html"}, "a web page, which is not read; " MAPS},
    {"<", {NULL}, "an XML file, which is not read; " MAPS},
    {"ncols", {NULL}, "an ESRI ASCII grid, which is no map; likelihoods go under places_raster; " MAPS},
    {"version 1",
     {NULL},
     "a Moving AI scenario, which is not read; name the .map that it is about, and its points as places"},
    {"#ROSBAG", {NULL}, "a ROS bag, which is not read; save the map from it with map_saver; " MAPS},
    {"# Octomap", {NULL}, "an OctoMap, which is not read; save its floor with map_saver; " MAPS},
    {"# .PCD", {NULL}, "a point cloud, which is not read; " MAPS},
    {"ply\n", {NULL}, "a point cloud, which is not read; " MAPS},
    {"%PDF", {NULL}, "a PDF, which is not read; " MAPS},
    {"PK\3\4", {NULL}, "a ZIP archive (or KMZ), which is not read; unpack it first; " MAPS},
    {"\x1f\x8b", {NULL}, "compressed by gzip; unpack it first"},
    {"SQLite format 3", {NULL}, "a database (a GeoPackage or a ROS 2 bag), which is not read; " MAPS},
    {"x,y,", {NULL}, "a CSV of places; name it by 'places_csv' in a mission, beside its map: " MAPS},
    {"column,row,", {NULL}, "a CSV of places; name it by 'places_csv' in a mission, beside its map: " MAPS}};

static const char building[] = "a building of Open-RMF, which is not read; name the map_server YAML of one level's "
                               "floor plan, and its points as places";

/* Whether `word` stands within the first bytes. The bytes end in a NUL, but may hold others. */
static bool holds(const char *text, size_t size, const char *word) {
  const size_t length = strlen(word);
  for (size_t i = 0; i + length <= size; i++)
    if (text[i] == word[0] && strncasecmp(text + i, word, length) == 0) return true;
  return false;
}

static bool holds_one(const char *text, size_t size, const char *const *words) {
  bool found = words[0] == NULL;
  for (int i = 0; i < WORDS && words[i] != NULL; i++) found = found || holds(text, size, words[i]);
  return found;
}

/* A YAML with "levels:" at the margin, which no map or mission of ours has. */
static bool is_building(const file_bytes *bytes) {
  text_lines lines;
  text_start(&lines, bytes);
  for (int i = 0; i < 10000 && text_next(&lines); i++)
    if (lines.length >= 7 && memcmp(lines.line, "levels:", 7) == 0) return true;
  return false;
}

/* Without a byte order mark and blanks at the start. */
static void skip_start(const char **text, size_t *size) {
  const size_t mark = *size >= 3 && memcmp(*text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
  const size_t skipped = mark + strspn(*text + mark, " \t\r\n");
  *text += skipped;
  *size -= skipped < *size ? skipped : *size;
}

const char *foreign_what(const file_bytes *bytes) {
  const char *text = (const char *)bytes->data;
  size_t size = bytes->size < HEAD ? bytes->size : HEAD;
  skip_start(&text, &size);
  for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
    const size_t length = strlen(formats[i].start);
    if (size < length || strncasecmp(text, formats[i].start, length) != 0) continue;
    if (holds_one(text, size, formats[i].words)) return formats[i].what;
  }
  return is_building(bytes) ? building : NULL;
}
