#include "host/input/barred.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/memory.h"
#include "host/input/geojson.h"
#include "host/input/mission_keys.h"
#include "host/input/overlay.h"
#include "host/input/polygon.h"
#include "host/input/raster_read.h"

#define TOUCHED 1e-9 /* of a value: less of it lies in a cell by rounding alone */

/* A key that makes ground worse must leave some. */
static int check_left(const input *in, tree *yaml, tree_node *node, const char *key) {
  const size_t cells = qtr_mission_cells(&in->mission);
  for (size_t cell = 0; cell < cells; cell++)
    if (in->mission.cost[cell] != 0) return 0;
  return tree_fault(yaml, node, "'%s' leaves no cell of the map free; check that it lies on the map as it should", key);
}

/* ---- rasters ---- */

typedef struct {
  const raster *it;
  uint8_t *cost;  /* of the mission */
  int16_t *worst; /* a cell's cost by what lies over it; -1: nothing does */
} laying;

/* Dark pixels of an image, numbers but 0 of a grid. */
static void lay_keepout(void *context, qtr_cell cell, double value, double part) {
  const laying *l = context;
  if (part > TOUCHED && (l->it->placed ? value != 0.0 : value < 127.5)) l->cost[cell] = 0;
}

static void lay_terrain(void *context, qtr_cell cell, double value, double part) {
  const laying *l = context;
  int16_t *worst = &l->worst[cell];
  const int16_t cost = (int16_t)lround(value);
  if (part > TOUCHED && *worst != 0 && (cost == 0 || cost > *worst)) *worst = cost;
}

static int check_costs(const raster *it, const char *path, fault *why) {
  const size_t count = (size_t)it->columns * (size_t)it->rows;
  for (size_t i = 0; i < count; i++) {
    const double value = it->value[i];
    if (isnan(value) || !it->placed || (value >= 0.0 && value <= 255.0 && value == floor(value))) continue;
    return file_fault(
        why, path, 0, 0,
        "the value in column %zu, row %zu (from 0) is %g; give the steps that entering takes, 1 to 255, or "
        "0 for ground that may not be entered",
        i % (size_t)it->columns, i / (size_t)it->columns, value);
  }
  return 0;
}

static int apply_terrain(input *in, const raster *it, const overlay *over, fault *why) {
  const size_t cells = qtr_mission_cells(&in->mission);
  laying l = {it, in->mission.cost, memory_take(cells * sizeof *l.worst, why)};
  if (l.worst == NULL) return -1;
  memset(l.worst, 0xff, cells * sizeof *l.worst);
  overlay_each(over, it, in, lay_terrain, &l);
  for (size_t cell = 0; cell < cells; cell++)
    if (l.worst[cell] >= 0 && l.cost[cell] != 0) l.cost[cell] = (uint8_t)l.worst[cell];
  free(l.worst);
  return 0;
}

static int apply_keepout(input *in, const raster *it, const overlay *over) {
  laying l = {it, in->mission.cost, NULL};
  overlay_each(over, it, in, lay_keepout, &l);
  return 0;
}

static int read_raster(input *in, tree *yaml, tree_node *root, const char *key, const char *path) {
  const bool terrain = strcmp(key, "terrain") == 0;
  char named_by[INPUT_PATH_SIZE + 32];
  raster it;
  overlay over;
  tree_node *node = tree_find(yaml, root, key);
  if (node == NULL) return 0;
  snprintf(named_by, sizeof named_by, "%s:%d", yaml->path, tree_line(node));
  if (raster_read(&it, path, named_by, yaml->why)) return -1;
  int result = terrain ? check_costs(&it, path, yaml->why) : 0;
  if (result == 0) result = overlay_find(&over, &it, in, path, yaml->why);
  if (result == 0) result = terrain ? apply_terrain(in, &it, &over, yaml->why) : apply_keepout(in, &it, &over);
  raster_free(&it);
  return result != 0 ? -1 : check_left(in, yaml, node, key);
}

/* ---- polygons ---- */

static int read_corner(polygon *p, const input *in, tree *yaml, tree_node *item, const char *what) {
  mission_site stated = {.it.weight = 1.0};
  int group;
  if (keys_read(&stated, &mission_corner_keys, yaml, item, what, &group)) return -1;
  if (polygon_add(p, frame_locate(in, mission_site_of(&stated, group).position))) return 0;
  return tree_fault(yaml, item, "%s is one more than the %d that are read; leave some out", what, POLYGON_CORNERS);
}

static int read_polygon(polygon *p, const input *in, tree *yaml, tree_node *list, int index) {
  char what[64], wrong[POLYGON_WRONG];
  const int count = tree_count(list);
  p->corners = 0;
  if (count < 0)
    return tree_fault(yaml, list,
                      "polygon %d of 'no_go' is not a list; write its corners, such as \"- [{x: 1, y: 1}, "
                      "{x: 3, y: 1}, {x: 3, y: 2}]\"",
                      index);
  for (int i = 0; i < count; i++) {
    snprintf(what, sizeof what, "corner %d of polygon %d", i, index);
    if (read_corner(p, in, yaml, tree_item(yaml, list, i), what)) return -1;
  }
  if (polygon_check(p, wrong) == NULL) return 0;
  return tree_fault(yaml, list, "polygon %d of 'no_go' %s", index, wrong);
}

static void bar(input *in, const uint8_t *mask) {
  const size_t cells = qtr_mission_cells(&in->mission);
  for (size_t cell = 0; cell < cells; cell++)
    if (mask[cell] != 0) in->mission.cost[cell] = 0;
}

static int bar_polygon(input *in, uint8_t *mask, tree *yaml, tree_node *list, int index) {
  static polygon p;
  char span[200];
  if (read_polygon(&p, in, yaml, list, index)) return -1;
  memset(mask, 0, qtr_mission_cells(&in->mission));
  if (polygon_mark(mask, &p, &in->mission, POLYGON_CUTS) == 0) {
    frame_span(span, sizeof span, in, true);
    return tree_fault(yaml, list, "polygon %d of 'no_go' lies outside the map, %s; move or drop it", index, span);
  }
  bar(in, mask);
  return 0;
}

static int bar_list(input *in, uint8_t *mask, tree *yaml, tree_node *list) {
  for (int i = 0; i < tree_count(list); i++)
    if (bar_polygon(in, mask, yaml, tree_item(yaml, list, i), i)) return -1;
  return 0;
}

typedef struct {
  input *in;
  uint8_t *mask;
} barring;

static int bar_feature(void *context, geojson *g, const geojson_feature *f) {
  const barring *b = context;
  if (!geojson_is_area(f))
    return tree_fault(&g->file, f->node, "feature %d is a %.40s; 'no_go' takes Polygons alone", f->index, f->type);
  if (geojson_mark(g, f, b->mask, false) < 0) return -1;
  bar(b->in, b->mask);
  return 0;
}

static int bar_file(input *in, uint8_t *mask, tree *yaml, tree_node *node, const char *name) {
  static char path[INPUT_PATH_SIZE];
  char named_by[INPUT_PATH_SIZE + 32];
  barring b = {in, mask};
  geojson g;
  snprintf(named_by, sizeof named_by, "%s:%d", yaml->path, tree_line(node));
  if (file_path_beside(path, sizeof path, yaml->path, name, yaml->why)) return -1;
  if (geojson_open(&g, in, path, named_by, yaml->why)) return -1;
  const int result = geojson_each(&g, bar_feature, &b);
  geojson_close(&g);
  return result;
}

static int read_no_go(input *in, tree *yaml, tree_node *root) {
  const char *name;
  tree_node *node = tree_find(yaml, root, "no_go");
  if (node == NULL) return 0;
  uint8_t *mask = memory_take(qtr_mission_cells(&in->mission), yaml->why);
  if (mask == NULL) return -1;
  const int result =
      tree_plain(yaml, node, &name) ? bar_file(in, mask, yaml, node, name) : bar_list(in, mask, yaml, node);
  free(mask);
  return result != 0 ? -1 : check_left(in, yaml, node, "no_go");
}

int barred_read(input *in, tree *yaml, tree_node *root) {
  if (in->mission.columns == 0) return 0;
  if (read_raster(in, yaml, root, "terrain", in->terrain)) return -1;
  if (read_raster(in, yaml, root, "keepout", in->keepout)) return -1;
  return read_no_go(in, yaml, root);
}
