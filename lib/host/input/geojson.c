#include "host/input/geojson.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "host/base/memory.h"
#include "host/input/frame.h"
#include "host/input/polygon.h"

/* ---- what coordinates are ---- */

static const char *text_of(tree *file, tree_node *mapping, const char *key) {
  const char *text;
  tree_node *node = mapping != NULL ? tree_find(file, mapping, key) : NULL;
  return node != NULL && tree_plain(file, node, &text) ? text : NULL;
}

/* The file's "crs", which RFC 7946 did away with and programs write all the same; NULL: none. */
static const char *system_of(tree *file) {
  tree_node *crs = tree_find(file, tree_root(file), "crs");
  return crs != NULL ? text_of(file, tree_find(file, crs, "properties"), "name") : NULL;
}

static bool ends(const char *text, const char *tail) {
  const size_t length = strlen(text), size = strlen(tail);
  return length >= size && strcasecmp(text + length - size, tail) == 0;
}

static int choose_system(geojson *g) {
  const char *name = system_of(&g->file);
  g->globe = NULL;
  if (name != NULL && strcasecmp(name, "local") == 0) return 0;
  if (name != NULL && !ends(name, "4326") && !ends(name, "CRS84"))
    return tree_fault(
        &g->file, tree_find(&g->file, tree_root(&g->file), "crs"),
        "coordinates of %.60s are not read; write the file in WGS84 (EPSG:4326), or name \"local\" for metres "
        "in the map frame",
        name);
  if (!g->in->geo.given)
    return tree_fault(
        &g->file, tree_root(&g->file),
        "its coordinates are degrees, and the mission does not say where its map lies; add \"geo: {latitude: "
        "52.5163, longitude: 13.3777}\" to the mission, or \"crs\": {\"properties\": {\"name\": \"local\"}} "
        "here for metres in the map frame");
  g->globe = projection_open(&g->in->geo, g->file.why);
  return g->globe != NULL ? 0 : -1;
}

int geojson_open(geojson *g, const input *in, const char *path, const char *named_by, fault *why) {
  file_bytes bytes;
  if (file_read(&bytes, path, FILE_TEXT_LIMIT, named_by, why) != 0) return -1;
  g->in = in;
  int result = tree_read(&g->file, path, &bytes, why); /* YAML takes in JSON */
  file_free(&bytes);
  if (result != 0) return -1;
  if (choose_system(g) == 0) return 0;
  tree_free(&g->file);
  return -1;
}

void geojson_close(geojson *g) {
  projection_close(g->globe);
  tree_free(&g->file);
}

/* ---- features ---- */

static int visit_feature(geojson *g, tree_node *node, int index, geojson_visit *visit, void *context) {
  tree *file = &g->file;
  const bool bare = tree_find(file, node, "coordinates") != NULL; /* a geometry by itself */
  tree_node *geometry = bare ? node : tree_find(file, node, "geometry");
  if (geometry == NULL) return tree_fault(file, node, "feature %d has no geometry; give it one", index);
  const char *unused;
  if (tree_plain(file, geometry, &unused)) return 0; /* null */
  geojson_feature f = {index, text_of(file, geometry, "type"), tree_find(file, geometry, "coordinates"), node, NULL};
  f.properties = tree_find(file, node, "properties");
  if (f.type == NULL || f.shape == NULL)
    return tree_fault(file, geometry, "the geometry of feature %d has no %s; give it one", index,
                      f.type == NULL ? "type" : "coordinates of its own");
  return visit(context, g, &f);
}

int geojson_each(geojson *g, geojson_visit *visit, void *context) {
  tree *file = &g->file;
  tree_node *root = tree_root(file), *list = tree_find(file, root, "features");
  if (list == NULL && text_of(file, root, "type") != NULL) return visit_feature(g, root, 0, visit, context);
  const int count = list != NULL ? tree_count(list) : -1;
  if (count < 0) return tree_fault(file, root, "is no GeoJSON: it has no list of features; export it as GeoJSON");
  for (int i = 0; i < count; i++) {
    const int result = visit_feature(g, tree_item(file, list, i), i, visit, context);
    if (result != 0) return result;
  }
  return 0;
}

/* ---- positions ---- */

/* False: there is no such point on the globe. */
static bool locate(const geojson *g, double latitude, double longitude, input_position *out) {
  double east, north;
  const double yaw = (double)g->in->geo.yaw / (double)QTR_GEO_ONE;
  if (projection_to_metres(g->globe, latitude, longitude, &east, &north) != 0) return false;
  *out = (input_position){true, cos(yaw) * east + sin(yaw) * north, cos(yaw) * north - sin(yaw) * east};
  return true;
}

static bool is_on_map(const geojson *g, double latitude, double longitude) {
  input_position position;
  return locate(g, latitude, longitude, &position) && frame_cell(g->in, position) != QTR_NO_CELL;
}

static int take_degrees(geojson *g, tree_node *node, const double given[2], input_position *out) {
  if (!is_on_map(g, given[1], given[0]) && is_on_map(g, given[0], given[1]))
    return tree_fault(
        &g->file, node,
        "[%.9g, %.9g] lies off the map, and on it with latitude and longitude exchanged; GeoJSON has the "
        "longitude first: write [%.9g, %.9g], or mend the mission's geo, if that is where they are exchanged",
        given[0], given[1], given[1], given[0]);
  if (fabs(given[1]) <= 90.0 && fabs(given[0]) <= 180.0 && locate(g, given[1], given[0], out)) return 0;
  return tree_fault(&g->file, node, "longitude %.10g, latitude %.10g is no point of the globe; %s", given[0], given[1],
                    fabs(given[0]) <= 90.0 && fabs(given[1]) > 90.0
                        ? "they seem exchanged: GeoJSON has the longitude first"
                        : "mend it, or, where these are metres in the map frame, add \"crs\": "
                          "{\"properties\": {\"name\": \"local\"}}");
}

int geojson_position(geojson *g, tree_node *coordinates, input_position *out) {
  static const char *const names[2][2] = {{"x", "y"}, {"longitude", "latitude"}};
  double given[2];
  if (tree_count(coordinates) < 2)
    return tree_fault(&g->file, coordinates, "a position is no list of two numbers; write [longitude, latitude]");
  for (int i = 0; i < 2; i++)
    if (tree_number(&g->file, tree_item(&g->file, coordinates, i), names[g->globe != NULL][i], &given[i])) return -1;
  if (g->globe != NULL) return take_degrees(g, coordinates, given, out);
  *out = (input_position){true, given[0], given[1]};
  return 0;
}

/* ---- areas ---- */

static int read_ring(polygon *p, geojson *g, const geojson_feature *f, tree_node *ring) {
  char wrong[POLYGON_WRONG];
  input_position position;
  const int count = tree_count(ring);
  p->corners = 0;
  if (count < 0) return tree_fault(&g->file, ring, "a ring of feature %d is no list of positions; mend it", f->index);
  for (int i = 0; i < count; i++) {
    if (geojson_position(g, tree_item(&g->file, ring, i), &position)) return -1;
    if (!polygon_add(p, frame_locate(g->in, position)))
      return tree_fault(&g->file, ring, "a ring of feature %d has more than %d corners; leave some out", f->index,
                        POLYGON_CORNERS);
  }
  if (polygon_check(p, wrong) == NULL) return 0;
  return tree_fault(&g->file, ring, "the polygon of feature %d %s", f->index, wrong);
}

/* A ring's cells in *found; a hole leaves its edge to the area around it. */
static int mark_ring(geojson *g, const geojson_feature *f, tree_node *ring, uint8_t *found, bool hole, bool middles) {
  static polygon p;
  char span[200];
  const qtr_mission *mission = &g->in->mission;
  memset(found, 0, qtr_mission_cells(mission));
  if (read_ring(&p, g, f, ring)) return -1;
  g->area += (hole ? -1.0 : 1.0) * polygon_area(&p);
  g->area_on += (hole ? -1.0 : 1.0) * polygon_area_on(&p, mission);
  if ((hole || middles) && polygon_mark(found, &p, mission, middles ? POLYGON_MIDDLES : POLYGON_HOLDS) > 0) return 0;
  if (hole || polygon_mark(found, &p, mission, POLYGON_CUTS) > 0) return 0;
  frame_span(span, sizeof span, g->in, true);
  return tree_fault(&g->file, ring, "the polygon of feature %d lies outside the map, %s; move or drop it", f->index,
                    span);
}

/* The ring around it, and those of its holes. */
static int mark_polygon(geojson *g, const geojson_feature *f, tree_node *rings, uint8_t *masks[2], bool middles) {
  const size_t cells = qtr_mission_cells(&g->in->mission);
  const int count = tree_count(rings);
  if (count < 1) return tree_fault(&g->file, rings, "feature %d has no ring; give it its corners", f->index);
  for (int i = 0; i < count; i++) {
    if (mark_ring(g, f, tree_item(&g->file, rings, i), masks[1], i > 0, middles)) return -1;
    for (size_t cell = 0; cell < cells; cell++)
      if (masks[1][cell] != 0) masks[0][cell] = i == 0;
  }
  return 0;
}

bool geojson_is_area(const geojson_feature *f) {
  return strcmp(f->type, "Polygon") == 0 || strcmp(f->type, "MultiPolygon") == 0;
}

static int mark_all(geojson *g, const geojson_feature *f, uint8_t *masks[2], bool middles) {
  if (strcmp(f->type, "Polygon") == 0) return mark_polygon(g, f, f->shape, masks, middles);
  for (int i = 0; i < tree_count(f->shape); i++)
    if (mark_polygon(g, f, tree_item(&g->file, f->shape, i), masks, middles)) return -1;
  return 0;
}

long geojson_mark(geojson *g, const geojson_feature *f, uint8_t *mask, bool middles) {
  const size_t cells = qtr_mission_cells(&g->in->mission);
  uint8_t *masks[2] = {mask, memory_take(cells, g->file.why)};
  long count = 0;
  if (masks[1] == NULL) return -1;
  memset(mask, 0, cells);
  g->area = g->area_on = 0.0;
  const int result = mark_all(g, f, masks, middles);
  free(masks[1]);
  for (size_t cell = 0; cell < cells; cell++) count += mask[cell];
  return result != 0 ? -1 : count;
}
