#include "host/input/read.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host/base/file.h"
#include "host/input/choose.h"
#include "host/input/decode.h"
#include "host/input/drawing.h"
#include "host/input/foreign.h"
#include "host/input/frame.h"
#include "host/input/kind.h"
#include "host/input/mission_file.h"
#include "host/input/movingai.h"
#include "host/input/rosmap.h"
#include "host/input/sites.h"

/* The longest row of free cells side by side: its first cell and its length. */
static unsigned longest_run(const input *in, qtr_cell *first) {
  const qtr_mission *mission = &in->mission;
  const unsigned cells = qtr_mission_cells(mission);
  unsigned longest = 0, length = 0;
  for (unsigned cell = 0; cell < cells; cell++) {
    length = mission->cost[cell] == 0 ? 0 : cell % mission->columns == 0 ? 1 : length + 1;
    if (length <= longest) continue;
    longest = length;
    *first = (qtr_cell)(cell + 1 - length);
  }
  return longest;
}

/* A map by itself says nothing of robots and places. What is proposed stands on free cells of it, within reach. */
static int needs_mission(const input *in, const char *what, fault *why) {
  const char *slash = strrchr(in->path, '/'), *name = slash == NULL ? in->path : slash + 1;
  qtr_cell first = 0;
  const unsigned run = longest_run(in, &first);
  const unsigned column = (unsigned)(first % in->mission.columns), row = (unsigned)(first / in->mission.columns);
  return file_fault(why, in->path, 0, 0,
                    "is %s without robots and places; write a mission.yaml beside it and name that: \"map: %.100s\", "
                    "\"robots: [{column: %u, row: %u}]\", \"places: [{column: %u, row: %u, weight: 2}]\", a line each",
                    what, name, column, row, column + (run > 0 ? run - 1 : 0), row);
}

static int read_drawing(input *in, const file_bytes *bytes, const input_options *options, fault *why) {
  drawing_marks marks = {true, true};
  in->ground.cell_size = options->cell_size;
  frame_of_cells(in);
  if (drawing_read(in, bytes, marks, why)) return -1;
  if (in->mission.seekers == 0) return file_fault(why, in->path, 0, 0, "no start; mark the robots' cell with S");
  if (in->mission.places == 0) {
    return file_fault(why, in->path, 0, 0, "no place to visit; mark one at least with its weight, 1 to 9");
  }
  return 0;
}

static int read_yaml(input *in, const file_bytes *bytes, const input_options *options, fault *why) {
  tree yaml;
  if (tree_read(&yaml, in->path, bytes, why)) return -1;
  bool is_map = rosmap_looks_like_one(&yaml);
  int result = is_map ? 0 : mission_file_read(in, &yaml, options);
  tree_free(&yaml);
  if (!is_map) return result;
  /* Faults of the map come first: a mission would not mend them. */
  in->ground.cell_size = options->cell_size;
  if (rosmap_read(in, bytes, why)) return -1;
  return needs_mission(in, "a ROS map", why);
}

static int read_bytes(input *in, const file_bytes *bytes, const input_options *options, fault *why) {
  switch (kind_of(in->path, bytes)) {
  case KIND_IMAGE:
    return file_fault(why, in->path, 0, 0,
                      "is %s, which has no scale, robots or places; name a mission YAML whose 'map' is the map_server "
                      "YAML of the image",
                      decode_format_name(bytes));
  case KIND_MOVINGAI:
    if (movingai_read(in, bytes, why)) return -1;
    return needs_mission(in, "a Moving AI map", why);
  case KIND_FOREIGN: return file_fault(why, in->path, 0, 0, "is %s", foreign_what(bytes));
  case KIND_YAML: return read_yaml(in, bytes, options, why);
  default: return read_drawing(in, bytes, options, why);
  }
}

/* Words for places mean little where not all could be read. */
static int choose(input *in, const input_options *options, fault *why) {
  if (in->failed) return 0;
  return choose_added(in, options, why) != 0 ? -1 : choose_rest(in, options, why);
}

/* Places cannot be judged where there is no map. */
static int finish(input *in, const input_options *options, fault *why) {
  const qtr_mission *mission = &in->mission;
  if (!input_goes_on(in, choose(in, options, why), why)) return -1;
  const bool is_whole = mission->columns > 0 && mission->seekers > 0 && mission->places > 0;
  if (is_whole && !input_goes_on(in, sites_finish(in, options, why), why)) return -1;
  return in->failed ? -1 : 0;
}

int input_read(input *in, const char *path, const input_options *options, fault *why) {
  file_bytes bytes;
  memset((char *)in + offsetof(input, frame), 0, sizeof *in - offsetof(input, frame)); /* of the mission see below */
  in->all = options->all;
  qtr_mission_default(&in->mission);
  in->frame.cell_size = 1.0;
  if (strlen(path) >= sizeof in->path)
    return file_fault(why, path, 0, 0, "the name is too long for a file; shorten it");
  strcpy(in->path, path);
  strcpy(in->map, path);
  if (!(options->cell_size >= 0.0) || !isfinite(options->cell_size)) {
    return fault_set(why, "the cell size %g is not a length above 0; mend --cell-size", options->cell_size);
  }
  if (file_read(&bytes, path, FILE_MAP_LIMIT, NULL, why)) return -1;
  int result = read_bytes(in, &bytes, options, why);
  file_free(&bytes);
  if (!input_goes_on(in, result, why)) return -1;
  frame_in_um(&in->frame, &in->mission.frame);
  return finish(in, options, why);
}
