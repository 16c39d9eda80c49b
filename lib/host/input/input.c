#include "host/input/input.h"

#include <stdio.h>

#include "host/base/file.h"

const char *input_source_path(const input *in, input_origin origin) {
  switch (origin.source) {
  case INPUT_FROM_MAP: return in->map;
  case INPUT_FROM_CSV: return in->csv;
  default: return in->path;
  }
}

void input_keep_place(input *in, int to, int from) {
  qtr_mission *mission = &in->mission;
  mission->place[to] = mission->place[from];
  mission->weight[to] = mission->weight[from];
  in->place_origin[to] = in->place_origin[from];
  in->place_position[to] = in->place_position[from];
  in->place_number[to] = in->place_number[from];
}

static void name_site(const input *in, const char *what, int index, input_origin origin, char *out, size_t size) {
  const char *path = file_short_path(input_source_path(in, origin));
  if (origin.column > 0) {
    snprintf(out, size, "%s %d (%s:%d:%d)", what, index, path, origin.line, origin.column);
  } else {
    snprintf(out, size, "%s %d (%s:%d)", what, index, path, origin.line);
  }
}

void input_place_name(const input *in, int place, char *out, size_t size) {
  name_site(in, "place", in->place_number[place], in->place_origin[place], out, size);
}

void input_seeker_name(const input *in, int seeker, char *out, size_t size) {
  name_site(in, "seeker", seeker, in->start_origin[seeker], out, size);
}
