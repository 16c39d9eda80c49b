#include "host/input/rosmap.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/count.h"
#include "host/input/decode.h"
#include "host/input/pixels.h"
#include "host/input/sites.h"

static tree_keys KEYS = {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode", NULL};
static const char *const WHAT = "the ROS map";

#define PI 3.14159265358979323846
#define SAVERS_GREY 205 /* of 255: what map savers write for unknown ground */

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
  tree_node *node = tree_need(yaml, root, WHAT, "origin", "[0, 0, 0]");
  if (node == NULL) return -1;
  if (tree_count(node) != 3)
    return tree_fault(yaml, node, "'origin' is not a list of x, y and yaw; write \"origin: [0, 0, 0]\"");
  for (int i = 0; i < 3; i++) {
    tree_node *item = tree_item(yaml, node, i);
    double *value = &header->origin[i];
    if (tree_number(yaml, item, names[i], value)) return -1;
    if (fabs(*value) > 1e9) return tree_fault(yaml, item, "the %s is %g, beyond 1e9; mend it", names[i], *value);
  }
  header->origin[2] = remainder(header->origin[2], 2.0 * PI);
  return 0;
}

/* What a threshold's key could say: the usual value, or the other threshold where the usual one would be refused. */
static double usual_threshold(tree *yaml, tree_node *root, const char *other, double usual, bool below) {
  double value = usual;
  tree_node *node = tree_find(yaml, root, other);
  fault unused, *why = yaml->why;
  yaml->why = &unused; /* a wrong value is told of where it is read */
  const bool read = node != NULL && tree_number(yaml, node, other, &value) == 0;
  yaml->why = why;
  if (!read || !(value >= 0.0 && value <= 1.0)) return usual;
  return below ? fmin(usual, value) : fmax(usual, value);
}

static int read_threshold(tree *yaml, tree_node *root, const char *key, double usual, double *out) {
  char example[32];
  snprintf(example, sizeof example, "%.6g", usual);
  tree_node *node = tree_need(yaml, root, WHAT, key, example);
  if (node == NULL || tree_number(yaml, node, key, out)) return -1;
  if (*out >= 0.0 && *out <= 1.0) return 0;
  return tree_fault(yaml, node, "'%s' is %g; give a probability from 0 to 1, such as %s", key, *out, example);
}

static int read_thresholds(rosmap_header *header, tree *yaml, tree_node *root) {
  const double occupied = usual_threshold(yaml, root, "free_thresh", 0.65, false);
  const double free = usual_threshold(yaml, root, "occupied_thresh", 0.196, true);
  if (read_threshold(yaml, root, "occupied_thresh", occupied, &header->occupied)) return -1;
  if (read_threshold(yaml, root, "free_thresh", free, &header->free)) return -1;
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

/* One correctly rounded division: a threshold written as the same fraction compares equal, which 1 - v/max would
 * not. */
static double occupancy_of(const rosmap_header *header, int sample, int maximum) {
  return (double)(header->negate ? sample : maximum - sample) / maximum;
}

double rosmap_greyness(const rosmap_header *header, int sample, int maximum) {
  const double occupancy = occupancy_of(header, sample, maximum);
  if (header->mode != ROSMAP_SCALE || occupancy < header->free) return 0.0;
  return occupancy > header->occupied ? 1.0 : (occupancy - header->free) / (header->occupied - header->free);
}

enum rosmap_class rosmap_classify(const rosmap_header *header, int sample, int maximum) {
  if (header->mode == ROSMAP_RAW) {
    double value = round(sample * 255.0 / maximum);
    return value == 0.0 ? ROSMAP_FREE : value <= 100.0 ? ROSMAP_OCCUPIED : ROSMAP_UNKNOWN;
  }
  const double occupancy = occupancy_of(header, sample, maximum);
  if (occupancy > header->occupied) return ROSMAP_OCCUPIED;
  if (occupancy < header->free) return ROSMAP_FREE;
  if (header->mode == ROSMAP_TRINARY) return ROSMAP_UNKNOWN;
  return rosmap_greyness(header, sample, maximum) * 100.0 < 0.5 ? ROSMAP_FREE : ROSMAP_OCCUPIED;
}

/* Steps beyond the first that a grey takes, where greys are slow ground: of 100 shades, as map_server makes them, the
 * last is an obstacle. -1: it is one, or greys are. */
static int slowness(const rosmap_header *header, int sample, int maximum, const input_ground *ground) {
  const double shade = round(rosmap_greyness(header, sample, maximum) * 100.0);
  if (ground->grey_cost == 0 || header->mode != ROSMAP_SCALE || shade >= 100.0) return -1;
  return (int)round(shade / 99.0 * (ground->grey_cost - 1));
}

/* The sample of the savers' grey, as the occupancy has it; -1: no sample is that grey. */
static int savers_sample(const rosmap_header *header, const image *picture) {
  return image_grey(picture, header->negate && header->mode != ROSMAP_RAW ? 255 - SAVERS_GREY : SAVERS_GREY);
}

static bool is_free_unknown(const input_ground *ground) {
  return ground->unknown_given && ground->unknown == INPUT_UNKNOWN_FREE;
}

static bool is_blocked(const rosmap_header *header, int sample, const image *picture, const input_ground *ground) {
  const enum rosmap_class kind = rosmap_classify(header, sample, picture->maximum);
  if (kind == ROSMAP_UNKNOWN) return !is_free_unknown(ground);
  const bool obstacle = kind == ROSMAP_OCCUPIED && slowness(header, sample, picture->maximum, ground) < 0;
  return obstacle || (ground->unknown_given && ground->unknown == INPUT_UNKNOWN_BLOCKED &&
                      sample == savers_sample(header, picture));
}

/* Slow pixels, where greys are. False: no memory. */
static bool make_slow(pixels *map, const image *picture, const rosmap_header *header, const input_ground *ground) {
  const size_t count = (size_t)picture->width * (size_t)picture->height;
  if (ground->grey_cost == 0 || header->mode != ROSMAP_SCALE) return true;
  map->slow = calloc(count, 1);
  for (size_t i = 0; map->slow != NULL && i < count; i++) {
    const int steps = slowness(header, picture->samples[i], picture->maximum, ground);
    if (steps > 0 && !(picture->transparent != NULL && picture->transparent[i])) map->slow[i] = (uint8_t)steps;
  }
  return map->slow != NULL;
}

static void free_pixels(pixels *map) {
  free(map->blocked);
  free(map->slow);
}

/* Blocked pixels of the image, and slow ones. */
static int make_pixels(pixels *map, const image *picture, const rosmap_header *header, const input_ground *ground) {
  size_t count = (size_t)picture->width * (size_t)picture->height, grades = (size_t)picture->maximum + 1;
  uint8_t *blocks = malloc(grades);
  map->width = picture->width;
  map->height = picture->height;
  map->blocked = malloc(count);
  map->slow = NULL;
  if (blocks == NULL || map->blocked == NULL || !make_slow(map, picture, header, ground)) {
    free(blocks);
    free_pixels(map);
    return -1;
  }
  for (size_t v = 0; v < grades; v++) blocks[v] = is_blocked(header, (int)v, picture, ground);
  for (size_t i = 0; i < count; i++) map->blocked[i] = blocks[picture->samples[i]];
  for (size_t i = 0; picture->transparent != NULL && i < count; i++)
    if (picture->transparent[i]) map->blocked[i] = !is_free_unknown(ground);
  free(blocks);
  return 0;
}

/* ---- notes ---- */

/* Whether nothing is said of what is unknown, nor of what greys are. */
static bool is_unsaid(const input *in, const rosmap_header *header) {
  const bool greys = header->mode == ROSMAP_SCALE && in->ground.grey_cost > 0;
  return !in->ground.unknown_given && !greys;
}

static void note_unknown(input *in, const image *picture, const rosmap_header *header) {
  const size_t count = (size_t)picture->width * (size_t)picture->height;
  const int sample = savers_sample(header, picture);
  uint64_t greys = 0;
  if (!is_unsaid(in, header) || sample < 0) return;
  if (rosmap_classify(header, sample, picture->maximum) != ROSMAP_FREE) return;
  for (size_t i = 0; i < count; i++)
    greys += picture->samples[i] == sample && (picture->transparent == NULL || !picture->transparent[i]);
  if (greys == 0) return;
  notes_add(&in->note,
            "%s: %s of the image %s unknown-grey (%d) and free by its free_thresh of %g: the plan may cross unknown "
            "ground; \"unknown: blocked\" in the mission closes %s",
            file_short_path(in->map), counted(greys, "cell").text, greys == 1 ? "is" : "are", SAVERS_GREY, header->free,
            greys == 1 ? "it" : "them");
}

static void note_greys(input *in, const image *picture, const rosmap_header *header) {
  const size_t count = (size_t)picture->width * (size_t)picture->height;
  uint64_t greys = 0;
  if (header->mode != ROSMAP_SCALE || in->ground.grey_cost > 0) return;
  for (size_t i = 0; i < count; i++) {
    const double shade = round(100.0 * rosmap_greyness(header, picture->samples[i], picture->maximum));
    greys += shade > 0.0 && shade < 100.0 && (picture->transparent == NULL || !picture->transparent[i]);
  }
  if (greys == 0) return;
  notes_add(
      &in->note,
      "%s: %s of the image %s grey, between free ground and obstacle, and counted as obstacle; \"grey_cost: 5\" in "
      "the mission makes them ground that takes up to 5 times as long",
      file_short_path(in->map), counted(greys, "pixel").text, greys == 1 ? "is" : "are");
}

static void note_points(input *in, const rosmap_header *header) {
  if (in->ground.radius_given || in->ground.cell_size > 0.0) return;
  notes_add(&in->note,
            "%s: no robot_radius and no cell_size are given: robots are points, and cells the map's pixels of %g m; "
            "\"robot_radius: 0.2\" in the mission keeps robots of 0.2 m clear of the walls",
            file_short_path(in->path), header->resolution);
}

/* ---- cells ---- */

/* The smallest cell size, at three digits, whose cells the build holds. */
static double smallest_cell_size(const image *picture, double resolution) {
  const double most = fmax(sqrt((double)picture->width * picture->height / QTR_MAX_CELLS),
                           fmax(picture->width, picture->height) / (double)UINT16_MAX);
  const double unit = pow(10.0, floor(log10(most * resolution)) - 2.0);
  for (double steps = floor(most * resolution / unit);; steps++) {
    const double ratio = steps * unit / resolution;
    const double columns = pixels_cells(picture->width, ratio), rows = pixels_cells(picture->height, ratio);
    if (columns <= UINT16_MAX && rows <= UINT16_MAX && columns * rows <= QTR_MAX_CELLS) return steps * unit;
  }
}

static int check_size(const input *in, const image *picture, double resolution, double columns, double rows,
                      fault *why) {
  char mend[100];
  snprintf(mend, sizeof mend, "cut the map, or choose larger cells: \"cell_size: %.3g\" is the smallest that fits",
           smallest_cell_size(picture, resolution));
  return sites_check_size(in->map, 0, columns, rows, mend, why);
}

static bool any_free(const uint8_t *blocked, size_t count) {
  return memchr(blocked, 0, count) != NULL;
}

/* Grow and coarsen. -1 with *fault set, also where nothing is left free: then who took the last of it is named. */
static int fill_cells(input *in, pixels *map, const rosmap_header *header, fault *why) {
  const input_ground *ground = &in->ground;
  qtr_mission *mission = &in->mission;
  const size_t count = (size_t)map->width * (size_t)map->height, cells = qtr_mission_cells(mission);
  if (!any_free(map->blocked, count))
    return file_fault(why, header->image, 0, 0,
                      "no pixel is free by the thresholds of %s; check them, 'negate', and that it is the right image",
                      file_short_path(in->map));
  if (pixels_grow(map, ground->robot_radius / header->resolution) != 0)
    return file_fault(why, header->image, 0, 0, "no memory for its pixels; scale the map down");
  if (!any_free(map->blocked, count))
    return file_fault(
        why, in->path, 0, 0,
        "no cell is left free: the robot_radius of %g m is larger than the free space; choose a smaller one",
        ground->robot_radius);
  if (pixels_coarsen(mission->cost, mission->columns, mission->rows, map, in->frame.cell_size / header->resolution))
    return file_fault(why, header->image, 0, 0, "no memory for its pixels; scale the map down");
  for (size_t cell = 0; cell < cells; cell++)
    if (mission->cost[cell] != 0) return 0;
  return file_fault(why, in->path, 0, 0,
                    "no cell is left free: cells of %g m are larger than the free space%s; choose a smaller cell_size "
                    "(the map's pixels are %g m)",
                    in->frame.cell_size, ground->robot_radius > 0.0 ? " that the robot_radius leaves" : "",
                    header->resolution);
}

/* A turn that moves no point of the map by a hundredth of a pixel is none. */
static double settle_yaw(double yaw, const image *picture) {
  return fabs(yaw) * hypot(picture->width, picture->height) < 0.01 ? 0.0 : yaw;
}

static int plan_cells(input *in, const image *picture, const rosmap_header *header, fault *why) {
  const input_ground *ground = &in->ground;
  qtr_mission *mission = &in->mission;
  double size = ground->cell_size > 0.0 ? ground->cell_size : header->resolution, ratio = size / header->resolution;
  double columns = pixels_cells(picture->width, ratio), rows = pixels_cells(picture->height, ratio);
  if (check_size(in, picture, header->resolution, columns, rows, why)) return -1;
  mission->columns = (uint16_t)columns;
  mission->rows = (uint16_t)rows;
  in->resolution = header->resolution;
  in->across = picture->width / ratio;
  in->upward = picture->height / ratio;
  in->frame = (input_frame){true, size, header->origin[0], header->origin[1], settle_yaw(header->origin[2], picture)};
  note_unknown(in, picture, header);
  note_greys(in, picture, header);
  note_points(in, header);
  in->map_notes = in->note.count;
  pixels map;
  if (make_pixels(&map, picture, header, ground) != 0)
    return file_fault(why, header->image, 0, 0, "no memory for its pixels; scale the map down");
  int result = fill_cells(in, &map, header, why);
  free_pixels(&map);
  return result;
}

int rosmap_read(input *in, const file_bytes *bytes, fault *why) {
  rosmap_header header;
  file_bytes image_bytes;
  image picture;
  char named_by[INPUT_PATH_SIZE + 32];
  if (rosmap_read_header(&header, in->map, bytes, why)) return -1;
  in->ground.has_greys = header.mode == ROSMAP_SCALE;
  snprintf(named_by, sizeof named_by, "%s:%d", in->map, header.image_line);
  if (file_read(&image_bytes, header.image, FILE_MAP_LIMIT, named_by, why)) return -1;
  static const enum image_alpha alpha_of[] = {IMAGE_ALPHA_AVERAGED, IMAGE_ALPHA_MARKED, IMAGE_ALPHA_IGNORED};
  int result = decode_image(&picture, header.image, &image_bytes, alpha_of[header.mode], why);
  file_free(&image_bytes);
  if (result != 0) return -1;
  result = plan_cells(in, &picture, &header, why);
  image_free(&picture);
  return result;
}
