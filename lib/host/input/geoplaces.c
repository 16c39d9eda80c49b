#include "host/input/geoplaces.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/memory.h"
#include "host/input/geojson.h"
#include "host/input/mission_keys.h"
#include "host/input/sites.h"
#include "host/input/tiles.h"

typedef struct {
  input *in;
  double footprint; /* 0: none is given */
  double *mass;     /* of the cells of polygons */
  uint8_t *mask;
  double off;      /* mass of polygons that lies off the map */
  tile_area *area; /* they, as they come */
  uint32_t areas;
  uint32_t *area_of; /* of each cell, from 1: the first that lies over it; 0: none */
} reading;

/* ---- properties ---- */

/* "POA", as search and rescue writes it. */
static tree_node *property(tree *file, tree_node *properties, const key_record *r) {
  tree_node *node = keys_node(file, properties, r);
  return node == NULL && strcmp(r->name, "weight") == 0 ? tree_find(file, properties, "POA") : node;
}

static bool is_null(tree *file, tree_node *node) {
  const char *text;
  return tree_plain(file, node, &text) && (strcmp(text, "null") == 0 || text[0] == '\0');
}

/* What a place's keys say, but its position; other properties are the user's own. */
static int read_properties(mission_site *stated, geojson *g, const geojson_feature *f) {
  tree *file = &g->file;
  *stated = (mission_site){.it.weight = 1.0};
  for (const key_record *r = mission_place_keys.records; f->properties != NULL && r->name != NULL; r++) {
    tree_node *node = property(file, f->properties, r);
    const bool position = r->at < offsetof(mission_site, it);
    if (node == NULL || position || r->kind >= KEY_LIST || is_null(file, node)) continue;
    const value_site site = tree_site(file, node);
    const char *text = tree_scalar(file, node, r->name, "a single value");
    if (text == NULL || keys_take(stated, r, &site, text)) return -1;
  }
  return 0;
}

/* ---- features ---- */

static int add_point(reading *r, geojson *g, const geojson_feature *f) {
  mission_site stated;
  const input_origin origin = {INPUT_FROM_GEOJSON, tree_line(f->node), 0};
  if (read_properties(&stated, g, f) || geojson_position(g, f->shape, &stated.it.position)) return -1;
  return sites_add_place(r->in, &stated.it, origin, g->file.why);
}

/* Of an area. One that cells cover but for rounding lies on the map as a whole. */
static double share_on_map(const geojson *g) {
  const double share = g->area > 0.0 ? g->area_on / g->area : 1.0;
  return share > 0.0 && share < 1.0 - 1e-9 ? share : 1.0;
}

/* One more, by its name. */
static int note_area(reading *r, const char *name, fault *why) {
  tile_area *more = realloc(r->area, (r->areas + 1) * sizeof *more);
  if (more == NULL) return fault_set(why, "no memory for the areas");
  r->area = more;
  r->area[r->areas] = (tile_area){.tiles = 0};
  memcpy(r->area[r->areas++].name, name, sizeof r->area->name);
  return 0;
}

static int add_area(reading *r, geojson *g, const geojson_feature *f) {
  const size_t cells = qtr_mission_cells(&r->in->mission);
  mission_site stated;
  if (r->footprint == 0.0)
    return tree_fault(&g->file, f->node,
                      "feature %d is an area, and 'places_geojson' has no footprint that cuts it into places; add "
                      "\"footprint: 5\"",
                      f->index);
  if (read_properties(&stated, g, f) || note_area(r, stated.it.name, g->file.why)) return -1;
  const long count = geojson_mark(g, f, r->mask, true);
  if (count < 0) return -1;
  const double on = share_on_map(g), weight = stated.it.weight;
  for (size_t cell = 0; cell < cells; cell++) {
    if (r->mask[cell] == 0) continue;
    r->mass[cell] += weight * on / (double)count;
    if (r->area_of[cell] == 0) r->area_of[cell] = r->areas;
  }
  r->off += weight * (1.0 - on);
  return 0;
}

static int add_feature(void *context, geojson *g, const geojson_feature *f) {
  reading *r = context;
  if (strcmp(f->type, "Point") == 0) return add_point(r, g, f);
  if (geojson_is_area(f)) return add_area(r, g, f);
  return tree_fault(&g->file, f->node, "feature %d is a %.40s; give Points and Polygons", f->index, f->type);
}

static int add_tiles(reading *r, const mission_raster *key, tree *yaml, tree_node *node) {
  const input_origin origin = {INPUT_FROM_MISSION, tree_line(node), 0};
  const tiles_settings settings = {.mass = r->mass,
                                   .off = r->off,
                                   .side = key->footprint / r->in->frame.cell_size,
                                   .share = key->share,
                                   .path = yaml->path,
                                   .line = tree_line(node),
                                   .origin = origin,
                                   .file = r->in->geojson,
                                   .area_of = r->area_of,
                                   .area = r->area};
  return r->areas > 0 ? tiles_add(r->in, &settings, yaml->why) : 0;
}

static int add_places(reading *r, const mission_raster *key, tree *yaml, tree_node *node) {
  char named_by[INPUT_PATH_SIZE + 32];
  geojson g;
  snprintf(named_by, sizeof named_by, "%s:%d", yaml->path, tree_line(tree_find(yaml, node, "file")));
  if (geojson_open(&g, r->in, r->in->geojson, named_by, yaml->why)) return -1;
  const int result = geojson_each(&g, add_feature, r);
  geojson_close(&g);
  return result != 0 ? -1 : add_tiles(r, key, yaml, node);
}

int geoplaces_read(input *in, tree *yaml, tree_node *root) {
  static mission_raster key;
  tree_node *node = tree_find(yaml, root, "places_geojson");
  if (node == NULL || in->mission.columns == 0) return 0;
  const size_t cells = qtr_mission_cells(&in->mission);
  key = (mission_raster){.share = 1.0};
  if (keys_read(&key, &mission_geojson_keys, yaml, node, "'places_geojson'", NULL)) return -1;
  const value_site site = tree_site(yaml, node);
  if (key.footprint > 0.0 && tiles_check(in, key.footprint, &site)) return -1;
  memcpy(in->geojson, key.file, sizeof in->geojson);
  reading r = {.in = in, .footprint = key.footprint};
  r.mass = memory_take(cells * sizeof *r.mass, yaml->why);
  r.mask = memory_take(cells, yaml->why);
  r.area_of = memory_take(cells * sizeof *r.area_of, yaml->why);
  const bool has_memory = r.mass != NULL && r.mask != NULL && r.area_of != NULL;
  const int result = has_memory ? add_places(&r, &key, yaml, node) : -1;
  free(r.mass);
  free(r.mask);
  free(r.area_of);
  free(r.area);
  return result;
}
