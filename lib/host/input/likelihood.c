#include "host/input/likelihood.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "host/base/memory.h"
#include "host/input/mission_keys.h"
#include "host/input/overlay.h"
#include "host/input/raster_read.h"
#include "host/input/tiles.h"

/* What has no likelihood at all is all the same to a sum. */
static int check_values(const raster *it, const char *path, double *sum, fault *why) {
  const size_t count = (size_t)it->columns * (size_t)it->rows;
  *sum = 0.0;
  for (size_t i = 0; i < count; i++) {
    const double value = it->value[i];
    if (value < 0.0)
      return file_fault(why, path, 0, 0,
                        "the value in column %zu, row %zu (from 0) is %g; a likelihood is 0 or more, and NODATA_value "
                        "says what stands for none",
                        i % (size_t)it->columns, i / (size_t)it->columns, value);
    if (!isnan(value)) *sum += value;
  }
  if (isfinite(*sum)) return 0;
  return file_fault(why, path, 0, 0, "its values add up to more than a number holds; scale them down");
}

static void add_mass(void *context, qtr_cell cell, double value, double part) {
  double *mass = context;
  mass[cell] += value * part;
}

static double sum_of(const double *mass, size_t cells) {
  double sum = 0.0;
  for (size_t cell = 0; cell < cells; cell++) sum += mass[cell];
  return sum;
}

static double overlap(double from, double length, double most) {
  return fmax(0.0, fmin(from + length, most) - fmax(from, 0.0)) / most;
}

/* A grid that leaves a part of the map out says nothing of it, which may be meant. */
static void note_uncovered(input *in, const raster *it, const overlay *over, const char *path) {
  const qtr_mission *m = &in->mission;
  const double covered = overlap(over->left, over->across * it->columns, m->columns) *
                         overlap(over->bottom, over->upward * it->rows, m->rows);
  if (covered < 0.995)
    notes_add(&in->note, "%s: covers %.3g %% of the map: elsewhere there is no likelihood", file_short_path(path),
              100.0 * covered);
}

static int add_tiles(input *in, const raster *it, const mission_raster *key, tree *yaml, tree_node *node) {
  const size_t cells = qtr_mission_cells(&in->mission);
  const int line = tree_line(node);
  overlay over;
  double sum;
  if (check_values(it, key->file, &sum, yaml->why) || overlay_find(&over, it, in, key->file, yaml->why)) return -1;
  note_uncovered(in, it, &over, key->file);
  double *mass = memory_take(cells * sizeof *mass, yaml->why);
  if (mass == NULL) return -1;
  overlay_each(&over, it, in, add_mass, mass);
  const tiles_settings settings = {.mass = mass,
                                   .off = fmax(0.0, sum - sum_of(mass, cells)),
                                   .side = key->footprint / in->frame.cell_size,
                                   .share = key->share,
                                   .path = yaml->path,
                                   .line = line,
                                   .origin = {INPUT_FROM_MISSION, line, 0},
                                   .file = key->file};
  const int result = tiles_add(in, &settings, yaml->why);
  free(mass);
  return result;
}

int likelihood_read(input *in, tree *yaml, tree_node *root) {
  static mission_raster key;
  raster it;
  char named_by[INPUT_PATH_SIZE + 32];
  tree_node *node = tree_find(yaml, root, "places_raster");
  if (node == NULL || in->mission.columns == 0) return 0;
  key = (mission_raster){.share = 1.0};
  if (keys_read(&key, &mission_raster_keys, yaml, node, "'places_raster'", NULL)) return -1;
  const value_site site = tree_site(yaml, node);
  if (tiles_check(in, key.footprint, &site)) return -1;
  snprintf(named_by, sizeof named_by, "%s:%d", yaml->path, tree_line(tree_find(yaml, node, "file")));
  if (raster_read(&it, key.file, named_by, yaml->why)) return -1;
  const int result = add_tiles(in, &it, &key, yaml, node);
  raster_free(&it);
  return result;
}
