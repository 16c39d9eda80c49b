#include "rosmap.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "pgm.h"
#include "pixels.h"
#include "sites.h"

static tree_keys KEYS = {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode", NULL};
static const char *const WHAT = "the ROS map";

bool rosmap_looks_like_one(tree *yaml) {
  tree_node *root = tree_root(yaml);
  if (tree_find(yaml, root, "map") != NULL) return false;
  for (int i = 0; KEYS[i] != NULL; i++) {
    if (tree_find(yaml, root, KEYS[i]) != NULL) return true;
  }
  return false;
}

static int read_image(rosmap_header *header, tree *yaml, tree_node *root) {
  const char *name;
  tree_node *node = tree_need(yaml, root, WHAT, "image", "map.pgm");
  if (node == NULL || tree_text(yaml, node, "image", &name)) return -1;
  header->image_line = tree_line(node);
  return file_path_beside(header->image, sizeof header->image, yaml->path, name, yaml->why);
}

static int read_resolution(rosmap_header *header, tree *yaml, tree_node *root) {
  tree_node *node = tree_need(yaml, root, WHAT, "resolution", "0.05");
  if (node == NULL || tree_number(yaml, node, "resolution", &header->resolution)) return -1;
  if (header->resolution >= 1e-6 && header->resolution <= 1e6) return 0;
  return tree_fault(yaml, node, "'resolution' is %g metres a pixel; give a number from 1e-6 to 1e6",
                    header->resolution);
}

static int read_origin(rosmap_header *header, tree *yaml, tree_node *root) {
  static const char *const names[] = {"origin's x", "origin's y", "origin's yaw"};
  double values[3];
  tree_node *node = tree_need(yaml, root, WHAT, "origin", "[0, 0, 0]");
  if (node == NULL) return -1;
  if (tree_count(node) != 3)
    return tree_fault(yaml, node, "'origin' is not a list of x, y and yaw; write \"origin: [0, 0, 0]\"");
  for (int i = 0; i < 3; i++) {
    tree_node *item = tree_item(yaml, node, i);
    if (tree_number(yaml, item, names[i], &values[i])) return -1;
    if (fabs(values[i]) > 1e9) return tree_fault(yaml, item, "the %s is %g, beyond 1e9; mend it", names[i], values[i]);
  }
  if (fabs(values[2]) > 1e-6) {
    return tree_fault(yaml, node, "the map is turned by a yaw of %g; only 0 is read: turn the image and set yaw to 0",
                      values[2]);
  }
  header->origin[0] = values[0];
  header->origin[1] = values[1];
  return 0;
}

static int read_threshold(tree *yaml, tree_node *root, const char *key, const char *example, double *out) {
  tree_node *node = tree_need(yaml, root, WHAT, key, example);
  if (node == NULL || tree_number(yaml, node, key, out)) return -1;
  if (*out >= 0.0 && *out <= 1.0) return 0;
  return tree_fault(yaml, node, "'%s' is %g; give a probability from 0 to 1, such as %s", key, *out, example);
}

static int read_thresholds(rosmap_header *header, tree *yaml, tree_node *root) {
  if (read_threshold(yaml, root, "occupied_thresh", "0.65", &header->occupied)) return -1;
  if (read_threshold(yaml, root, "free_thresh", "0.196", &header->free)) return -1;
  if (header->free <= header->occupied) return 0;
  return tree_fault(yaml, tree_find(yaml, root, "free_thresh"),
                    "'free_thresh' %g is above 'occupied_thresh' %g; swap or mend them", header->free,
                    header->occupied);
}

static int read_negate(rosmap_header *header, tree *yaml, tree_node *root) {
  static tree_keys words = {"0", "1", "false", "true", NULL};
  int word = 0;
  tree_node *node = tree_need(yaml, root, WHAT, "negate", "0");
  if (node == NULL || tree_word(yaml, node, "negate", words, &word)) return -1;
  header->negate = word % 2 == 1;
  return 0;
}

static int read_mode(rosmap_header *header, tree *yaml, tree_node *root) {
  static tree_keys words = {"trinary", "scale", "raw", NULL};
  tree_node *node = tree_find(yaml, root, "mode");
  header->mode = ROSMAP_TRINARY;
  return node == NULL ? 0 : tree_word(yaml, node, "mode", words, &header->mode);
}

int rosmap_read_header(rosmap_header *header, const char *path, const file_bytes *bytes, fault *why) {
  tree yaml;
  memset(header, 0, sizeof *header);
  if (tree_read(&yaml, path, bytes, why)) return -1;
  tree_node *root = tree_root(&yaml);
  /* Other tools add keys of their own: as in nav2, those are none of our business. */
  bool ok = tree_check_keys(&yaml, root, WHAT, KEYS, true) == 0 && read_image(header, &yaml, root) == 0 &&
            read_resolution(header, &yaml, root) == 0 && read_origin(header, &yaml, root) == 0 &&
            read_negate(header, &yaml, root) == 0 && read_thresholds(header, &yaml, root) == 0 &&
            read_mode(header, &yaml, root) == 0;
  tree_free(&yaml);
  return ok ? 0 : -1;
}

enum rosmap_class rosmap_classify(const rosmap_header *header, int sample, int maximum) {
  if (header->mode == ROSMAP_RAW) {
    double value = round(sample * 255.0 / maximum);
    return value == 0.0 ? ROSMAP_FREE : value <= 100.0 ? ROSMAP_OCCUPIED : ROSMAP_UNKNOWN;
  }
  /* One correctly rounded division: a threshold written as the same fraction compares equal, which 1 - v/max would not. */
  double occupancy = (double)(header->negate ? sample : maximum - sample) / maximum;
  if (occupancy > header->occupied) return ROSMAP_OCCUPIED;
  if (occupancy < header->free) return ROSMAP_FREE;
  if (header->mode == ROSMAP_TRINARY) return ROSMAP_UNKNOWN;
  double scaled = (occupancy - header->free) / (header->occupied - header->free) * 100.0;
  return scaled < 0.5 ? ROSMAP_FREE : ROSMAP_OCCUPIED;
}

/* Blocked pixels of the image. */
static int make_pixels(pixels *map, const pgm *image, const rosmap_header *header, bool unknown_free) {
  size_t count = (size_t)image->width * (size_t)image->height, grades = (size_t)image->maximum + 1;
  uint8_t *blocks = malloc(grades);
  map->width = image->width;
  map->height = image->height;
  map->blocked = malloc(count);
  if (blocks == NULL || map->blocked == NULL) {
    free(blocks);
    free(map->blocked);
    return -1;
  }
  for (size_t v = 0; v < grades; v++) {
    enum rosmap_class kind = rosmap_classify(header, (int)v, image->maximum);
    blocks[v] = kind == ROSMAP_OCCUPIED || (kind == ROSMAP_UNKNOWN && !unknown_free);
  }
  for (size_t i = 0; i < count; i++) map->blocked[i] = blocks[image->samples[i]];
  free(blocks);
  return 0;
}

static int plan_cells(input *in, const pgm *image, const rosmap_header *header, const rosmap_wish *wish, fault *why) {
  qtr_mission *mission = &in->mission;
  double size = wish->cell_size > 0.0 ? wish->cell_size : header->resolution, ratio = size / header->resolution;
  double columns = pixels_cells(image->width, ratio), rows = pixels_cells(image->height, ratio);
  if (sites_check_size(in->map, 0, columns, rows, why)) return -1;
  mission->columns = (uint16_t)columns;
  mission->rows = (uint16_t)rows;
  in->frame = (input_frame){true, size, header->origin[0], header->origin[1]};
  pixels map;
  int result = make_pixels(&map, image, header, wish->unknown_free);
  if (result == 0) {
    result = pixels_grow(&map, wish->robot_radius / header->resolution);
    if (result == 0) result = pixels_coarsen(mission->cost, mission->columns, mission->rows, &map, ratio);
    free(map.blocked);
  }
  if (result != 0) return file_fault(why, header->image, 0, 0, "no memory for its pixels; scale the map down");
  in->robot_radius = wish->robot_radius;
  return 0;
}

int rosmap_read(input *in, const file_bytes *bytes, const rosmap_wish *wish, fault *why) {
  rosmap_header header;
  file_bytes image_bytes;
  pgm image;
  char named_by[INPUT_PATH_SIZE + 32];
  if (rosmap_read_header(&header, in->map, bytes, why)) return -1;
  snprintf(named_by, sizeof named_by, "%s:%d", in->map, header.image_line);
  if (file_read(&image_bytes, header.image, FILE_MAP_LIMIT, named_by, why)) return -1;
  int result = pgm_read(&image, header.image, &image_bytes, why);
  file_free(&image_bytes);
  if (result != 0) return -1;
  result = plan_cells(in, &image, &header, wish, why);
  pgm_free(&image);
  return result;
}
