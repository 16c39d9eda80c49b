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

void input_note_numbers(input *in) {
  char runs[NOTES_SIZE / 2] = "";
  size_t used = 0;
  const int places = in->mission.places;
  if (places == in->places_stated) return;
  for (int first = 0, next; first < places && used < sizeof runs; first = next) {
    for (next = first + 1; next < places && in->place_number[next] == in->place_number[next - 1] + 1;) next++;
    const int number = in->place_number[first], last = number + next - first - 1;
    const char *joint = first > 0 ? ", " : "";
    used += (size_t)(next - first == 1 ? snprintf(runs + used, sizeof runs - used, "%s%d is %d", joint, first, number)
                                       : snprintf(runs + used, sizeof runs - used, "%s%d to %d are %d to %d", joint,
                                                  first, next - 1, number, last));
  }
  notes_add(&in->note,
            "%s: this report has the input's numbers of places, but the table numbers those it holds anew, and so do "
            "simulate, inspect and draw of it: %s of the input",
            file_short_path(in->path), runs);
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
