#include "draw_file.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "draw_svg.h"
#include "host/base/option.h"
#include "host/base/outfile.h"

void draw_of_input(drawing *d, const input *in, drawing_seeker seekers[QTR_MAX_SEEKERS]) {
  const qtr_mission *mission = &in->mission;
  d->columns = mission->columns;
  d->rows = mission->rows;
  d->cost = mission->cost;
  d->cell_size = in->frame.metric ? in->frame.cell_size : 0.0;
  d->turned = in->frame.yaw != 0.0;
  d->x = in->frame.origin_x;
  d->y = in->frame.origin_y;
  d->places = mission->places;
  d->place = mission->place;
  d->likelihood = mission->weight;
  d->number = in->place_number;
  d->names = &in->names;
  d->seekers = mission->seekers;
  d->seeker = seekers;
  for (int i = 0; i < mission->seekers; i++) seekers[i] = (drawing_seeker){.start = mission->start[i]};
}

/* A name that promises another format would be believed. */
static int refuse_other(const char *option, const char *path, const char *dot, fault *why) {
  static const char *const others[] = {".jpg", ".jpeg", ".gif", ".bmp", ".webp", ".eps", ".ps", ".tif"};
  for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
    if (strcasecmp(dot, others[i]) == 0)
      return fault_set(why, "%s %s: the picture is SVG, PNG or PDF; name it %.*s.png, and convert that", option, path,
                       (int)(dot - path), path);
  return 0;
}

int draw_file_form(enum draw_form *form, const char *option, const char *path, const char *format, fault *why) {
  int index;
  *form = DRAW_SVG;
  if (format != NULL) {
    if (option_word(&index, "format", format, strlen(format), draw_forms, why) != 0) return -1;
    *form = (enum draw_form)index;
    return 0;
  }
  const char *dot = strrchr(path, '.');
  if (dot == NULL) return 0;
  for (int i = 0; draw_forms[i] != NULL; i++)
    if (strcasecmp(dot + 1, draw_forms[i]) == 0) *form = (enum draw_form)i;
  return refuse_other(option, path, dot, why);
}

/* What draw_svg() writes, in memory; newly allocated. NULL with *why set. */
static char *draw_text(const drawing *d, const char *what, size_t *length, fault *why) {
  char *text = NULL;
  FILE *memory = open_memstream(&text, length);
  const bool drawn = memory != NULL && draw_svg(memory, d) == 0;
  if (memory != NULL && fclose(memory) == 0 && drawn) return text;
  free(text);
  fault_set(why, "%s: cannot be drawn: no memory, or a route that leaves its map", what);
  return NULL;
}

int draw_file_write(const drawing *d, const char *what, const char *path, enum draw_form form, fault *why) {
  outfile out;
  size_t length;
  char *text = draw_text(d, what, &length, why);
  if (text == NULL) return -1;
  int status = outfile_open(&out, path, why);
  if (status == 0) {
    if (form == DRAW_SVG)
      fwrite(text, 1, length, out.file);
    else
      status = draw_render(out.file, text, length, form, why);
    if (status == 0)
      status = outfile_commit(&out, why);
    else
      outfile_abort(&out);
  }
  free(text);
  return status;
}
