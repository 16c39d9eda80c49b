#include "host/input/input.h"

#include <stdio.h>
#include <string.h>

#include "host/base/file.h"

const char *input_source_path(const input *in, input_origin origin) {
  switch (origin.source) {
  case INPUT_FROM_MAP: return in->map;
  case INPUT_FROM_CSV: return in->csv;
  case INPUT_FROM_GEOJSON: return in->geojson;
  case INPUT_FROM_OPTION: return "--add";
  default: return in->path;
  }
}

static void keep_in_class(qtr_robot_class *of, int to, int from) {
  const bool is_avoided = qtr_places_has(&of->avoided, (unsigned)from);
  qtr_places_remove(&of->avoided, (unsigned)to);
  if (is_avoided) qtr_places_add(&of->avoided, (unsigned)to);
  of->scan[to] = of->scan[from];
}

void input_keep_place(input *in, int to, int from) {
  qtr_mission *mission = &in->mission;
  mission->place[to] = mission->place[from];
  mission->weight[to] = mission->weight[from];
  mission->detection[to] = mission->detection[from];
  mission->looks[to] = mission->looks[from];
  for (int i = 0; i < mission->classes; i++) keep_in_class(&mission->robot_class[i], to, from);
  in->terms.place_scan[to] = in->terms.place_scan[from];
  in->place_origin[to] = in->place_origin[from];
  in->place_position[to] = in->place_position[from];
  in->place_number[to] = in->place_number[from];
  if (to != from) memcpy(in->names.place[to], in->names.place[from], sizeof in->names.place[to]);
}

void input_keep_robot(input *in, int to, int from) {
  in->mission.start[to] = in->mission.start[from];
  in->mission.class_of[to] = in->mission.class_of[from];
  in->terms.ready[to] = in->terms.ready[from];
  in->start_origin[to] = in->start_origin[from];
  in->start_position[to] = in->start_position[from];
  if (to != from) memcpy(in->names.seeker[to], in->names.seeker[from], sizeof in->names.seeker[to]);
}

bool input_goes_on(input *in, int status, fault *why) {
  if (status == 0) return true;
  in->failed = true;
  return fault_keep(in->all, why);
}

naming input_naming(const input *in) {
  return (naming){&in->names, in->place_number, in->mission.places, in->mission.seekers, NULL};
}

static void name_site(const input *in, const char *what, const char *label, input_origin origin, char *out,
                      size_t size) {
  const char *path = file_short_path(input_source_path(in, origin));
  if (origin.column > 0) {
    snprintf(out, size, "%s %s (%s:%d:%d)", what, label, path, origin.line, origin.column);
  } else {
    snprintf(out, size, "%s %s (%s:%d)", what, label, path, origin.line);
  }
}

void input_place_name(const input *in, int place, char *out, size_t size) {
  const naming n = input_naming(in);
  name_site(in, "place", naming_place(&n, (unsigned)place).text, in->place_origin[place], out, size);
}

void input_seeker_name(const input *in, int seeker, char *out, size_t size) {
  const naming n = input_naming(in);
  name_site(in, "seeker", naming_seeker(&n, (unsigned)seeker).text, in->start_origin[seeker], out, size);
}
