#include "host/input/mapfile.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "host/input/decode.h"
#include "host/input/drawing.h"
#include "host/input/foreign.h"
#include "host/input/frame.h"
#include "host/input/movingai.h"
#include "host/input/rosmap.h"
#include "host/input/sites.h"
#include "host/input/tree.h"

void mapfile_begin(input *in, double cell_size) {
  memset(in, 0, sizeof *in);
  qtr_mission_default(&in->mission);
  in->frame.cell_size = 1.0;
  in->ground.cell_size = cell_size;
  in->ground.size_given = cell_size > 0.0;
}

static int set_path(char out[INPUT_PATH_SIZE], const char *path, fault *why) {
  const int length = snprintf(out, INPUT_PATH_SIZE, "%s", path);
  if (length < INPUT_PATH_SIZE) return 0;
  return file_fault(why, path, 0, 0, "the name is too long for a file; shorten it");
}

void mapfile_write_name(FILE *out, const char *name) {
  bool plain = isalpha((unsigned char)name[0]) || name[0] == '/';
  for (const char *c = name; *c != '\0'; c++) plain = plain && (isalnum((unsigned char)*c) || strchr("._/-", *c));
  if (plain) {
    fputs(name, out);
    return;
  }
  fputc('"', out);
  for (const char *c = name; *c != '\0'; c++) {
    if (*c == '"' || *c == '\\') fputc('\\', out);
    fputc(*c, out);
  }
  fputc('"', out);
}

/* ---- ROS maps ---- */

/* The least whole multiple of the resolution that leaves no more cells than one would wait for. */
static double suitable_size(const rosmap_header *header, const image *picture) {
  for (double pixels = 1.0;; pixels++)
    if (ceil(picture->width / pixels) * ceil(picture->height / pixels) <= fmin(MAPFILE_ROOMY, QTR_MAX_CELLS))
      return pixels * header->resolution;
}

static int choose_size(input *in, const file_bytes *bytes, fault *why) {
  rosmap_header header;
  file_bytes of_image;
  image picture;
  if (in->ground.cell_size > 0.0) return 0;
  if (rosmap_read_header(&header, in->map, bytes, why) != 0) return -1;
  if (file_read(&of_image, header.image, FILE_MAP_LIMIT, in->map, why) != 0) return -1;
  const int status = decode_image(&picture, header.image, &of_image, IMAGE_ALPHA_AVERAGED, why);
  file_free(&of_image);
  if (status != 0) return -1;
  in->ground.cell_size = suitable_size(&header, &picture);
  image_free(&picture);
  return 0;
}

static int read_rosmap(input *in, const file_bytes *bytes, fault *why) {
  return choose_size(in, bytes, why) == 0 ? rosmap_read(in, bytes, why) : -1;
}

static int read_yaml(input *in, const file_bytes *bytes, fault *why) {
  tree yaml;
  if (tree_read(&yaml, in->map, bytes, why) != 0) return -1;
  const bool is_mission = tree_find(&yaml, tree_root(&yaml), "map") != NULL;
  tree_free(&yaml);
  if (!is_mission) return read_rosmap(in, bytes, why);
  return file_fault(why, in->map, 0, 0, "is a mission already; 'quarter check' lists what is wrong with it");
}

/* ---- images ---- */

/* The YAML's name for an image: the same but for the ending. */
static int name_yaml(input *in, const char *path, fault *why) {
  const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
  const size_t stem = dot != NULL && (slash == NULL || dot > slash) ? (size_t)(dot - path) : strlen(path);
  if (stem + sizeof ".yaml" > sizeof in->map) return set_path(in->map, path, why);
  memcpy(in->map, path, stem);
  strcpy(in->map + stem, ".yaml");
  return 0;
}

static int refuse_image(const input *in, const char *path, const file_bytes *bytes, fault *why) {
  if (access(in->map, F_OK) == 0)
    return file_fault(why, path, 0, 0, "is %s; its map is %s, it seems: name that", decode_format_name(bytes),
                      file_short_path(in->map));
  return file_fault(why, path, 0, 0,
                    "is %s, which has no scale; say how many metres a pixel is, as --resolution 0.05, and %s is "
                    "written, which tells it",
                    decode_format_name(bytes), file_short_path(in->map));
}

/* Thresholds as map savers write them: what is darker than four fifths of white is no free ground. */
static int make_yaml(mapfile *map, const char *path, double resolution, fault *why) {
  const char *slash = strrchr(path, '/');
  FILE *out = open_memstream(&map->made, &map->length);
  if (out == NULL) return file_fault(why, path, 0, 0, "no memory for its map");
  fputs("image: ", out);
  mapfile_write_name(out, slash != NULL ? slash + 1 : path);
  fprintf(out, "\nresolution: %.9g\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
          resolution);
  return fclose(out) == 0 ? 0 : file_fault(why, path, 0, 0, "no memory for its map");
}

static int read_image(input *in, mapfile *map, const char *path, const file_bytes *bytes, double resolution,
                      fault *why) {
  if (name_yaml(in, path, why) != 0) return -1;
  if (resolution == 0.0) return refuse_image(in, path, bytes, why);
  map->kind = KIND_YAML;
  if (make_yaml(map, path, resolution, why) != 0) return -1;
  const file_bytes made = {(unsigned char *)map->made, map->length};
  return read_rosmap(in, &made, why);
}

/* ---- whatever it is ---- */

static int read_bytes(input *in, mapfile *map, const char *path, const file_bytes *bytes, double resolution,
                      fault *why) {
  static const drawing_marks all = {true, true};
  map->kind = kind_of(path, bytes);
  if (map->kind == KIND_IMAGE) return read_image(in, map, path, bytes, resolution, why);
  if (resolution > 0.0)
    return fault_set(why, "--resolution is for images, and %s is none; --cell-size says how large its cells are to be",
                     file_short_path(path));
  if (map->kind == KIND_FOREIGN) return file_fault(why, path, 0, 0, "is %s", foreign_what(bytes));
  if (map->kind == KIND_YAML) return read_yaml(in, bytes, why);
  frame_of_cells(in);
  return map->kind == KIND_MOVINGAI ? movingai_read(in, bytes, why) : drawing_read(in, bytes, all, why);
}

/* A failed step leaves nothing to free. */
static int end(mapfile *map, int status) {
  if (status == 0) return 0;
  free(map->made);
  map->made = NULL;
  return -1;
}

int mapfile_read(input *in, mapfile *map, const char *path, double resolution, fault *why) {
  file_bytes bytes;
  *map = (mapfile){0};
  if (set_path(in->path, path, why) != 0 || set_path(in->map, path, why) != 0) return -1;
  if (file_read(&bytes, path, FILE_MAP_LIMIT, NULL, why) != 0) return -1;
  const int status = read_bytes(in, map, path, &bytes, resolution, why);
  file_free(&bytes);
  return end(map, status);
}

/* ---- open ground ---- */

static double plain_size(double width, double height) {
  static const double steps[] = {1, 2, 5};
  for (double power = 1e-3;; power *= 10)
    for (int i = 0; i < 3; i++)
      if (ceil(width / (steps[i] * power)) * ceil(height / (steps[i] * power)) <= MAPFILE_PLAIN)
        return steps[i] * power;
}

static int make_drawing(mapfile *map, double columns, double rows, fault *why) {
  const size_t width = (size_t)columns + 1;
  map->length = width * (size_t)rows;
  map->made = malloc(map->length + 1);
  if (map->made == NULL) return fault_set(why, "--open: no memory for a drawing of %.0f x %.0f cells", columns, rows);
  memset(map->made, '.', map->length);
  for (size_t end_of_row = width; end_of_row <= map->length; end_of_row += width) map->made[end_of_row - 1] = '\n';
  map->made[map->length] = '\0';
  return 0;
}

int mapfile_open(input *in, mapfile *map, const char *path, double width, double height, fault *why) {
  static const drawing_marks none = {false, false};
  *map = (mapfile){.kind = KIND_DRAWING};
  if (set_path(in->path, path, why) != 0 || set_path(in->map, path, why) != 0) return -1;
  if (in->ground.cell_size == 0.0) in->ground.cell_size = plain_size(width, height);
  const double columns = ceil(frame_settle(width / in->ground.cell_size));
  const double rows = ceil(frame_settle(height / in->ground.cell_size));
  if (sites_check_size(path, 0, columns, rows, "choose larger cells, by --cell-size", why) != 0 ||
      make_drawing(map, columns, rows, why) != 0)
    return -1;
  frame_of_cells(in);
  const file_bytes bytes = {(unsigned char *)map->made, map->length};
  return end(map, drawing_read(in, &bytes, none, why));
}
