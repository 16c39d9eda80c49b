#include "host/input/mission_file.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host/input/csv.h"
#include "host/input/decode.h"
#include "host/input/drawing.h"
#include "host/input/foreign.h"
#include "host/input/geo.h"
#include "host/input/kind.h"
#include "host/input/movingai.h"
#include "host/input/rosmap.h"
#include "host/input/sites.h"
#include "host/input/words.h"

static tree_keys KEYS = {"map",       "cell_size", "robot_radius", "unknown", "robots", "places", "places_csv",
                         "objective", "gamma",     "rule",         "name",    "geo",    NULL};
static const char *const WHAT = "the mission";

/* ---- what to learn ---- */

static int read_gamma(input *in, tree *yaml, tree_node *root) {
  tree_node *node = tree_find(yaml, root, "gamma");
  if (node == NULL) return 0;
  if (tree_number(yaml, node, "gamma", &in->mission.aim.gamma)) return -1;
  if (!(in->mission.aim.gamma > 0.0 && in->mission.aim.gamma < 1.0)) {
    return tree_fault(yaml, node, "'gamma' is %g; give a discount between 0 and 1, both excluded, such as 0.99",
                      in->mission.aim.gamma);
  }
  in->gamma_given = true;
  return 0;
}

static int read_game(input *in, tree *yaml, tree_node *root) {
  int word;
  tree_node *node = tree_find(yaml, root, "objective");
  if (node != NULL) {
    if (tree_word(yaml, node, "objective", qtr_objective_names, &word)) return -1;
    in->mission.aim.kind = (uint8_t)word;
    in->objective_given = true;
  }
  node = tree_find(yaml, root, "rule");
  if (node != NULL) {
    if (tree_word(yaml, node, "rule", words_rule, &word)) return -1;
    in->mission.rule = (uint8_t)word;
    in->rule_given = true;
  }
  return read_gamma(in, yaml, root);
}

static int read_name(input *in, tree *yaml, tree_node *root) {
  const char *name;
  tree_node *node = tree_find(yaml, root, "name");
  if (node == NULL) return 0;
  if (tree_text(yaml, node, "name", &name)) return -1;
  if (strlen(name) >= sizeof in->name) {
    return tree_fault(yaml, node, "'name' has %zu bytes; shorten it to %zu", strlen(name), sizeof in->name - 1);
  }
  strcpy(in->name, name);
  return 0;
}

/* ---- the map ---- */

/* A length in metres; *out is left alone where the key is not there. */
static int read_metres_of(double *out, tree *yaml, tree_node *root, const char *key, bool zero) {
  tree_node *node = tree_find(yaml, root, key);
  if (node == NULL) return 0;
  if (tree_number(yaml, node, key, out)) return -1;
  if (*out > 0.0 || (zero && *out == 0.0)) return 0;
  return tree_fault(yaml, node, "'%s' is %g m; give a length %s", key, *out, zero ? "of 0 or more" : "above 0");
}

static int read_wish(rosmap_wish *wish, tree *yaml, tree_node *root, const input_options *options) {
  static tree_keys words = {"blocked", "free", NULL};
  int word = 0;
  memset(wish, 0, sizeof *wish);
  if (read_metres_of(&wish->cell_size, yaml, root, "cell_size", false)) return -1;
  if (read_metres_of(&wish->robot_radius, yaml, root, "robot_radius", true)) return -1;
  wish->radius_given = tree_find(yaml, root, "robot_radius") != NULL;
  if (options->cell_size > 0.0) wish->cell_size = options->cell_size;
  tree_node *node = tree_find(yaml, root, "unknown");
  if (node == NULL) return 0;
  if (tree_word(yaml, node, "unknown", words, &word)) return -1;
  wish->unknown = word == 0 ? ROSMAP_BLOCKED : ROSMAP_UNKNOWN_FREE;
  return 0;
}

/* Lengths make sense on a map with metres only; ignoring them would plan for another robot than the user's. */
static int check_no_metres(const rosmap_wish *wish, tree *yaml, tree_node *root, const input_options *options) {
  tree_node *node = tree_find(yaml, root, "cell_size");
  if (node != NULL)
    return tree_fault(yaml, node, "'cell_size' is for ROS maps only, and this map has no metres; delete it");
  if (options->cell_size > 0.0) {
    return file_fault(yaml->why, yaml->path, 0, 0,
                      "a cell size is for ROS maps only, and this map has no metres; leave --cell-size out");
  }
  if (wish->robot_radius == 0.0) return 0;
  return tree_fault(yaml, tree_find(yaml, root, "robot_radius"),
                    "'robot_radius' is for ROS maps only, and this map has no metres; delete it");
}

static int read_yaml_map(input *in, tree *mission, tree_node *node, const file_bytes *bytes, const rosmap_wish *wish) {
  tree yaml;
  if (tree_read(&yaml, in->map, bytes, mission->why)) return -1;
  bool is_mission = tree_find(&yaml, tree_root(&yaml), "map") != NULL;
  tree_free(&yaml);
  if (is_mission) return tree_fault(mission, node, "'map' names another mission; name its map instead");
  return rosmap_read(in, bytes, wish, mission->why);
}

static int read_map_bytes(input *in, tree *yaml, tree_node *root, const file_bytes *bytes,
                          const input_options *options) {
  rosmap_wish wish;
  tree_node *node = tree_find(yaml, root, "map");
  drawing_marks marks = {tree_find(yaml, root, "robots") == NULL,
                         tree_find(yaml, root, "places") == NULL && tree_find(yaml, root, "places_csv") == NULL};
  if (read_wish(&wish, yaml, root, options)) return -1;
  enum kind kind = kind_of(in->map, bytes);
  if (kind == KIND_IMAGE) {
    return tree_fault(yaml, node, "'map' names %s, which has no scale; name the map_server YAML that goes with it",
                      decode_format_name(bytes));
  }
  if (kind == KIND_FOREIGN) return tree_fault(yaml, node, "'map' names %s", foreign_what(bytes));
  if (kind == KIND_YAML) return read_yaml_map(in, yaml, node, bytes, &wish);
  if (check_no_metres(&wish, yaml, root, options)) return -1;
  return kind == KIND_MOVINGAI ? movingai_read(in, bytes, yaml->why) : drawing_read(in, bytes, marks, yaml->why);
}

/* Read the file that a key names, relative to the mission, and leave its path in out. */
static int read_named(char *out, size_t size, file_bytes *bytes, size_t limit, tree *yaml, tree_node *node,
                      const char *key) {
  const char *name;
  char named_by[INPUT_PATH_SIZE + 32];
  if (tree_text(yaml, node, key, &name) || file_path_beside(out, size, yaml->path, name, yaml->why)) return -1;
  snprintf(named_by, sizeof named_by, "%s:%d", yaml->path, tree_line(node));
  return file_read(bytes, out, limit, named_by, yaml->why);
}

static int read_map(input *in, tree *yaml, tree_node *root, const input_options *options) {
  file_bytes bytes;
  tree_node *node = tree_need(yaml, root, WHAT, "map", "map.yaml");
  if (node == NULL || read_named(in->map, sizeof in->map, &bytes, FILE_MAP_LIMIT, yaml, node, "map")) return -1;
  int result = read_map_bytes(in, yaml, root, &bytes, options);
  file_free(&bytes);
  return result;
}

/* ---- robots and places ---- */

static tree_keys ROBOT_KEYS = {"x", "y", "column", "row", NULL};
static tree_keys PLACE_KEYS = {"x", "y", "column", "row", "weight", NULL};

static int read_metres(tree *yaml, tree_node *item, const char *what, input_position *position) {
  tree_node *x_node = tree_need(yaml, item, what, "x", "1.5"), *y_node;
  if (x_node == NULL || (y_node = tree_need(yaml, item, what, "y", "1.5")) == NULL) return -1;
  position->metres = true;
  return tree_number(yaml, x_node, "x", &position->x) || tree_number(yaml, y_node, "y", &position->y) ? -1 : 0;
}

static int read_indices(tree *yaml, tree_node *item, const char *what, input_position *position) {
  long column, row;
  tree_node *column_node = tree_need(yaml, item, what, "column", "4"), *row_node;
  if (column_node == NULL || (row_node = tree_need(yaml, item, what, "row", "4")) == NULL) return -1;
  if (tree_integer(yaml, column_node, "column", &column) || tree_integer(yaml, row_node, "row", &row)) return -1;
  *position = (input_position){false, (double)column, (double)row};
  return 0;
}

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

/* The position that an item of a list states, in either way. */
static int read_position(tree *yaml, tree_node *item, const char *what, tree_keys keys, input_position *position) {
  if (check_item(yaml, item, what) || tree_check_keys(yaml, item, what, keys, false)) return -1;
  bool metres = tree_find(yaml, item, "x") != NULL || tree_find(yaml, item, "y") != NULL;
  bool indices = tree_find(yaml, item, "column") != NULL || tree_find(yaml, item, "row") != NULL;
  if (metres && indices)
    return tree_fault(yaml, item, "%s has both metres and cells; keep x and y, or column and row", what);
  if (!metres && !indices)
    return tree_fault(yaml, item, "%s has no position; give it x and y, or column and row", what);
  return metres ? read_metres(yaml, item, what, position) : read_indices(yaml, item, what, position);
}

/* A key's list; NULL with *count = 0 where the key is not there, -1 where it is something else. */
static tree_node *find_list(tree *yaml, tree_node *root, const char *key, const char *example, int *count) {
  tree_node *list = tree_find(yaml, root, key);
  *count = list == NULL ? 0 : tree_count(list);
  if (*count >= 0) return list;
  const bool robots = strcmp(key, "robots") == 0;
  tree_fault(yaml, list, "'%s' is not a list; write one, such as \"%s: [%s]\"%s", key, key, example,
             robots ? ", an item each (or one, and --robots K for K of them)" : "");
  return list;
}

static int read_robots(input *in, tree *yaml, tree_node *root) {
  int count;
  tree_node *list = find_list(yaml, root, "robots", "{x: 0.5, y: 1.5}", &count);
  for (int i = 0; i < count; i++) {
    tree_node *item = tree_item(yaml, list, i);
    char what[32];
    input_position position;
    snprintf(what, sizeof what, "robot %d", i);
    if (read_position(yaml, item, what, ROBOT_KEYS, &position)) return -1;
    input_origin origin = {INPUT_FROM_MISSION, tree_line(item), 0};
    if (sites_add_start(in, position, origin, yaml->why)) return -1;
  }
  if (count < 0) return -1;
  if (in->mission.seekers > 0) return 0;
  if (list != NULL)
    return tree_fault(yaml, list, "'robots' is empty; list one at least: \"robots: [{x: 0.5, y: 1.5}]\"");
  return file_fault(yaml->why, yaml->path, 0, 0, "no robot starts anywhere; add \"robots: [{x: 0.5, y: 1.5}]\"");
}

static int read_places(input *in, tree *yaml, tree_node *root) {
  int count;
  tree_node *list = find_list(yaml, root, "places", "{x: 0.5, y: 1.5, weight: 2}", &count);
  for (int i = 0; i < count; i++) {
    tree_node *item = tree_item(yaml, list, i), *node;
    char what[32];
    double weight = 1.0;
    input_position position;
    snprintf(what, sizeof what, "place %d", i);
    if (read_position(yaml, item, what, PLACE_KEYS, &position)) return -1;
    if ((node = tree_find(yaml, item, "weight")) != NULL && tree_number(yaml, node, "weight", &weight)) return -1;
    input_origin origin = {INPUT_FROM_MISSION, tree_line(item), 0};
    if (sites_add_place(in, position, weight, origin, yaml->why)) return -1;
  }
  return count < 0 ? -1 : 0;
}

static int read_csv(input *in, tree *yaml, tree_node *root) {
  file_bytes bytes;
  tree_node *node = tree_find(yaml, root, "places_csv");
  if (node == NULL) return 0;
  if (read_named(in->csv, sizeof in->csv, &bytes, FILE_TEXT_LIMIT, yaml, node, "places_csv")) return -1;
  int result = csv_read(in, &bytes, yaml->why);
  file_free(&bytes);
  return result;
}

int mission_file_read(input *in, tree *yaml, const input_options *options) {
  tree_node *root = tree_root(yaml);
  if (tree_check_keys(yaml, root, WHAT, KEYS, false)) return -1;
  if (read_game(in, yaml, root) || read_name(in, yaml, root)) return -1;
  if (read_map(in, yaml, root, options) || geo_read(in, yaml, root) || read_robots(in, yaml, root)) return -1;
  if (read_places(in, yaml, root) || read_csv(in, yaml, root)) return -1;
  if (in->mission.places > 0) return 0;
  return file_fault(yaml->why, yaml->path, 0, 0,
                    "no place to visit; list one at least under 'places', or name a 'places_csv'");
}
