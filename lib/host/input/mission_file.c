#include "host/input/mission_file.h"

#include <stdio.h>
#include <string.h>

#include "host/input/barred.h"
#include "host/input/choose.h"
#include "host/input/classes.h"
#include "host/input/csv.h"
#include "host/input/decode.h"
#include "host/input/drawing.h"
#include "host/input/foreign.h"
#include "host/input/frame.h"
#include "host/input/geo.h"
#include "host/input/geoplaces.h"
#include "host/input/kind.h"
#include "host/input/likelihood.h"
#include "host/input/mission_keys.h"
#include "host/input/movingai.h"
#include "host/input/rosmap.h"
#include "host/input/sites.h"

/* ---- the map ---- */

/* Obstacles of whole cells grow by whole cells; ignoring it would plan for another robot than the user's. */
static int check_no_radius(const input *in, tree *yaml, tree_node *root) {
  if (in->ground.robot_radius == 0.0) return 0;
  return tree_fault(yaml, tree_find(yaml, root, "robot_radius"),
                    "'robot_radius' is for ROS maps only, and this map's obstacles are whole cells; delete it");
}

static int read_yaml_map(input *in, tree *mission, tree_node *node, const file_bytes *bytes) {
  tree yaml;
  if (tree_read(&yaml, in->map, bytes, mission->why)) return -1;
  bool is_mission = tree_find(&yaml, tree_root(&yaml), "map") != NULL;
  tree_free(&yaml);
  if (is_mission) return tree_fault(mission, node, "'map' names another mission; name its map instead");
  return rosmap_read(in, bytes, mission->why);
}

static int read_map_bytes(input *in, tree *yaml, tree_node *root, const file_bytes *bytes) {
  tree_node *node = tree_find(yaml, root, "map");
  drawing_marks marks = {tree_find(yaml, root, "robots") == NULL, tree_find(yaml, root, "places") == NULL &&
                                                                      tree_find(yaml, root, "places_csv") == NULL &&
                                                                      tree_find(yaml, root, "places_raster") == NULL &&
                                                                      tree_find(yaml, root, "places_geojson") == NULL};
  enum kind kind = kind_of(in->map, bytes);
  if (kind == KIND_IMAGE) {
    return tree_fault(yaml, node, "'map' names %s, which has no scale; name the map_server YAML that goes with it",
                      decode_format_name(bytes));
  }
  if (kind == KIND_FOREIGN) return tree_fault(yaml, node, "'map' names %s", foreign_what(bytes));
  if (kind == KIND_YAML) return read_yaml_map(in, yaml, node, bytes);
  if (check_no_radius(in, yaml, root)) return -1;
  frame_of_cells(in);
  return kind == KIND_MOVINGAI ? movingai_read(in, bytes, yaml->why) : drawing_read(in, bytes, marks, yaml->why);
}

/* Read a file that a key names. */
static int read_named(file_bytes *bytes, const char *path, size_t limit, tree *yaml, tree_node *node) {
  char named_by[INPUT_PATH_SIZE + 32];
  snprintf(named_by, sizeof named_by, "%s:%d", yaml->path, tree_line(node));
  return file_read(bytes, path, limit, named_by, yaml->why);
}

static int check_greys(const input *in, tree *yaml, tree_node *root) {
  if (in->ground.grey_cost == 0 || in->ground.has_greys) return 0;
  return tree_fault(yaml, tree_find(yaml, root, "grey_cost"),
                    "'grey_cost' is for the greys of ROS maps of \"mode: scale\", and %s is none; delete it, or name a "
                    "'terrain'",
                    file_short_path(in->map));
}

static int read_map(input *in, tree *yaml, tree_node *root, const input_options *options) {
  file_bytes bytes;
  if (options->cell_size > 0.0) in->ground.cell_size = options->cell_size;
  if (read_named(&bytes, in->map, FILE_MAP_LIMIT, yaml, tree_find(yaml, root, "map"))) return -1;
  int result = read_map_bytes(in, yaml, root, &bytes);
  file_free(&bytes);
  return result != 0 ? -1 : check_greys(in, yaml, root);
}

/* ---- robots and places ---- */

/* Slips that the list of keys would not mend: [1, 10] for a position, and 0,5 for 0.5. */
static int check_item(tree *yaml, tree_node *item, const char *what) {
  const char *first, *second;
  if (tree_count(item) == 2 && tree_plain(yaml, tree_item(yaml, item, 0), &first) &&
      tree_plain(yaml, tree_item(yaml, item, 1), &second)) {
    return tree_fault(yaml, item, "%s is a list; write {column: %.20s, row: %.20s}, or in metres {x: %.20s, y: %.20s}",
                      what, first, second, first, second);
  }
  if (tree_count(item) >= 0)
    return tree_fault(yaml, item, "%s is a list; write {column: 1, row: 10}, or in metres {x: 0.5, y: 5.5}", what);
  if (tree_has_number_key(yaml, item))
    return tree_fault(yaml, item, "%s has a number without a key; decimals take a point, 0.5 and not 0,5", what);
  return 0;
}

/* An item of a list: its keys, and the position that they state in either way. */
static int read_site(input_site *site, const key_set *set, tree *yaml, tree_node *item, const char *what) {
  int group;
  mission_site stated = {.it.weight = 1.0};
  if (check_item(yaml, item, what) || keys_read(&stated, set, yaml, item, what, &group)) return -1;
  *site = mission_site_of(&stated, group);
  return 0;
}

/* The items of a list, each by `read_item`. */
static int read_list(input *in, tree *yaml, tree_node *list,
                     int (*read_item)(input *in, tree *yaml, tree_node *item, int index)) {
  const int count = list == NULL ? 0 : tree_count(list);
  for (int i = 0; i < count; i++)
    if (!input_goes_on(in, read_item(in, yaml, tree_item(yaml, list, i), i), yaml->why)) return -1;
  return 0;
}

static int read_robot(input *in, tree *yaml, tree_node *item, int index) {
  char what[32];
  input_site site;
  const input_origin origin = {INPUT_FROM_MISSION, tree_line(item), 0};
  snprintf(what, sizeof what, "robot %d", index);
  if (read_site(&site, &mission_robot_keys, yaml, item, what)) return -1;
  return sites_add_start(in, &site, origin, yaml->why);
}

static int read_place(input *in, tree *yaml, tree_node *item, int index) {
  char what[32];
  input_site site;
  const input_origin origin = {INPUT_FROM_MISSION, tree_line(item), 0};
  snprintf(what, sizeof what, "place %d", index);
  if (read_site(&site, &mission_place_keys, yaml, item, what)) return -1;
  return sites_add_place(in, &site, origin, yaml->why);
}

static int read_robots(input *in, tree *yaml, tree_node *root) {
  tree_node *list = tree_find(yaml, root, "robots");
  if (read_list(in, yaml, list, read_robot)) return -1;
  if (in->mission.seekers > 0 || in->failed) return 0;
  if (list != NULL)
    return tree_fault(yaml, list, "'robots' is empty; list one at least: \"robots: [{x: 0.5, y: 1.5}]\"");
  return file_fault(yaml->why, yaml->path, 0, 0, "no robot starts anywhere; add \"robots: [{x: 0.5, y: 1.5}]\"");
}

static int read_places(input *in, tree *yaml, tree_node *root) {
  return read_list(in, yaml, tree_find(yaml, root, "places"), read_place);
}

static int read_csv(input *in, tree *yaml, tree_node *root) {
  file_bytes bytes;
  tree_node *node = tree_find(yaml, root, "places_csv");
  if (node == NULL) return 0;
  if (read_named(&bytes, in->csv, FILE_TEXT_LIMIT, yaml, node)) return -1;
  int result = csv_read(in, &bytes, yaml->why);
  file_free(&bytes);
  return result;
}

/* Files that were to bring some are named. */
static int no_place(const input *in, tree *yaml) {
  const bool csv = in->csv[0] != '\0', geojson = in->geojson[0] != '\0';
  if (csv || geojson)
    return file_fault(yaml->why, csv ? in->csv : in->geojson, 0, 0,
                      "holds no place to visit, and the mission lists none; write one at least into it");
  return file_fault(yaml->why, yaml->path, 0, 0,
                    "no place to visit; list one at least under 'places', or name a 'places_csv'");
}

/* What names places means little where not all could be read. */
static int read_rest(input *in, tree *yaml, tree_node *root, const input_options *options) {
  if (in->failed) return 0;
  if (classes_finish(in, yaml, root)) return -1;
  if (in->mission.places > 0 || options->adds > 0) return choose_cleared(in, yaml, root);
  return no_place(in, yaml);
}

/* The map, and where it lies: without a map named there is none. */
static int read_ground(input *in, tree *yaml, tree_node *root, const input_options *options) {
  if (tree_find(yaml, root, "map") == NULL) return 0;
  return read_map(in, yaml, root, options) || geo_read(in, yaml, root) || barred_read(in, yaml, root) ? -1 : 0;
}

int mission_file_read(input *in, tree *yaml, const input_options *options) {
  tree_node *root = tree_root(yaml);
  yaml->all = in->all;
  if (!input_goes_on(in, keys_read(in, &mission_keys, yaml, root, "the mission", NULL), yaml->why)) return -1;
  if (!input_goes_on(in, classes_read(in, yaml, root), yaml->why)) return -1;
  if (!input_goes_on(in, read_ground(in, yaml, root, options), yaml->why)) return -1;
  if (!input_goes_on(in, read_robots(in, yaml, root), yaml->why)) return -1;
  if (!input_goes_on(in, read_places(in, yaml, root), yaml->why)) return -1;
  if (!input_goes_on(in, read_csv(in, yaml, root), yaml->why)) return -1;
  if (!input_goes_on(in, geoplaces_read(in, yaml, root), yaml->why)) return -1;
  if (!input_goes_on(in, likelihood_read(in, yaml, root), yaml->why)) return -1;
  return input_goes_on(in, read_rest(in, yaml, root, options), yaml->why) ? 0 : -1;
}
