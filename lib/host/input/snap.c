#include "host/input/snap.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/count.h"
#include "host/base/file.h"
#include "host/input/frame.h"
#include "host/input/reach.h"

#define TEXT 400

/* A start or a place, and where it could go. */
typedef struct {
  bool place;
  int index; /* in the mission */
  naming_label label;
  qtr_cell cell; /* where it is; QTR_NO_CELL outside the map */
  input_position position;
  input_origin origin;
  qtr_cell nearest; /* free cell; QTR_NO_CELL: there is none */
  double apart;     /* cells from the position to the middle of that cell */
} site;

/* What is going on. */
typedef struct {
  input *in;
  const input_options *options;
  fault *why;
  reach *ground;             /* who can get to each cell */
  bool *left_out;            /* places, by index */
  int places, robots, twins; /* that stay faulty */
  double farthest;           /* of them, in metres or cells as --snap takes them */
  bool far;                  /* one of them is nowhere near the map */
} work;

static site start_site(const input *in, int i) {
  const naming n = input_naming(in);
  return (site){
      false,       i,  naming_seeker(&n, (unsigned)i), in->mission.start[i], in->start_position[i], in->start_origin[i],
      QTR_NO_CELL, 0.0};
}

static site place_site(const input *in, int i) {
  const naming n = input_naming(in);
  return (site){
      true,        i,  naming_place(&n, (unsigned)i), in->mission.place[i], in->place_position[i], in->place_origin[i],
      QTR_NO_CELL, 0.0};
}

static bool is_free(const input *in, qtr_cell cell) {
  return cell != QTR_NO_CELL && in->mission.cost[cell] != 0;
}

/* ---- the nearest free cell ---- */

static bool holds_place(const input *in, qtr_cell cell) {
  for (int i = 0; i < in->mission.places; i++)
    if (in->mission.place[i] == cell) return true;
  return false;
}

/* Robots may share a cell, places may not. */
static void find_nearest(const work *w, site *it) {
  const qtr_mission *mission = &w->in->mission;
  const frame_point from = frame_locate(w->in, it->position);
  const size_t cells = qtr_mission_cells(mission);
  double least = 0.0;
  for (size_t cell = 0; cell < cells; cell++) {
    if (it->place ? w->ground[cell] == 0 : mission->cost[cell] == 0) continue;
    const double across = (double)(cell % mission->columns) + 0.5 - from.across;
    const double up = mission->rows - (double)(cell / mission->columns) - 0.5 - from.up;
    const double square = across * across + up * up;
    if (it->nearest != QTR_NO_CELL && square >= least) continue;
    if (it->place && holds_place(w->in, (qtr_cell)cell)) continue;
    it->nearest = (qtr_cell)cell;
    least = square;
  }
  it->apart = sqrt(least);
}

/* A length as --snap takes it, three digits rounded up: given back to --snap it is enough. */
static double snap_length(const input *in, double cells) {
  const double length = cells * in->frame.cell_size;
  const double unit = length > 0.0 ? pow(10.0, floor(log10(length)) - 2.0) : 1.0;
  return ceil(length / unit - 1e-9) * unit;
}

/* ---- what is said ---- */

/* Farther off than one end of the map from the other: moving it there is no mend. */
static bool is_far(const input *in, double cells) {
  return cells > hypot(in->mission.columns, in->mission.rows);
}

/* Whether a position off the map lies on it when its two numbers change places. */
static bool is_exchanged(const input *in, input_position position) {
  return frame_cell(in, (input_position){position.metres, position.y, position.x}) != QTR_NO_CELL;
}

/* "place 3 stands on an obstacle, at column 0, row 4" */
static void name_trouble(char *out, size_t size, const input *in, const site *it) {
  const char *what = it->place ? "place" : "robot";
  char position[100], rest[160] = "";
  frame_name(position, sizeof position, it->position);
  if (it->cell == QTR_NO_CELL) {
    frame_span(rest, sizeof rest, in, it->position.metres);
    snprintf(out, size, "%s %s: %s lies outside the map, %s%s", what, it->label.text, position, rest,
             !is_exchanged(in, it->position) ? ""
             : it->position.metres           ? ", and inside with x and y exchanged"
                                             : ", and inside with column and row exchanged");
    return;
  }
  if (in->ground.robot_radius > 0.0)
    snprintf(rest, sizeof rest, " grown by the robot_radius of %g m", in->ground.robot_radius);
  snprintf(out, size, "%s %s stands on an obstacle%s, at column %u, row %u", what, it->label.text, rest,
           (unsigned)(it->cell % in->mission.columns), (unsigned)(it->cell / in->mission.columns));
}

/* "x 1, y 2, 0.7 m away", in the unit of the position. */
static void name_nearest(char *out, size_t size, const input *in, const site *it) {
  char where[100];
  frame_name(where, sizeof where, frame_centre(in, it->nearest, it->position.metres));
  const double length = snap_length(in, it->apart);
  if (it->position.metres)
    snprintf(out, size, length < 1000.0 ? "%s, %.3g m away" : "%s, %.0f m away", where, length);
  else
    snprintf(out, size, "%s, %s away", where, measured(snap_length(in, it->apart / in->frame.cell_size), "cell").text);
}

static int complain(work *w, const site *it, const char *text) {
  const char *path = input_source_path(w->in, it->origin);
  fault line;
  file_fault(&line, path, it->origin.line, it->origin.column, "%s", text);
  return fault_add(w->why, "%s", line.text);
}

static void complain_of(work *w, const site *it) {
  char trouble[TEXT], nearest[TEXT], text[3 * TEXT];
  name_trouble(trouble, sizeof trouble, w->in, it);
  *(it->place ? &w->places : &w->robots) += 1;
  if (it->nearest == QTR_NO_CELL) {
    snprintf(text, sizeof text, "%s; no free cell is left for it: drop it", trouble);
  } else {
    name_nearest(nearest, sizeof nearest, w->in, it);
    const bool degrees = is_far(w->in, it->apart) && it->origin.source == INPUT_FROM_GEOJSON && w->in->geo.given;
    snprintf(text, sizeof text, "%s; %smove it to a free cell, the nearest is %s", trouble,
             degrees ? "check the mission's geo, or " : "", nearest);
    w->far = w->far || is_far(w->in, it->apart);
    w->farthest = fmax(w->farthest, snap_length(w->in, it->apart));
  }
  complain(w, it, text);
}

static void note_site(work *w, const site *it, const char *what) {
  char trouble[TEXT];
  name_trouble(trouble, sizeof trouble, w->in, it);
  notes_add(&w->in->note, "%s:%d: %s; %s", file_short_path(input_source_path(w->in, it->origin)), it->origin.line,
            trouble, what);
}

/* ---- what is done ---- */

static void treat(work *w, site *it) {
  qtr_mission *mission = &w->in->mission;
  char nearest[TEXT], what[2 * TEXT];
  if (is_free(w->in, it->cell)) return;
  find_nearest(w, it);
  if (it->nearest != QTR_NO_CELL && it->apart * w->in->frame.cell_size <= w->options->snap * (1.0 + 1e-9)) {
    name_nearest(nearest, sizeof nearest, w->in, it);
    snprintf(what, sizeof what, "moved to %s", nearest);
    note_site(w, it, what);
    *(it->place ? &mission->place[it->index] : &mission->start[it->index]) = it->nearest;
  } else if (it->place && w->options->skip) {
    note_site(w, it, "left out");
    w->left_out[it->index] = true;
    mission->place[it->index] = QTR_NO_CELL;
  } else {
    complain_of(w, it);
  }
}

/* Places that were stated in one cell: moving never brings two together. */
static void check_twins(work *w) {
  const qtr_mission *mission = &w->in->mission;
  for (int j = 1; j < mission->places; j++) {
    for (int i = 0; i < j; i++) {
      if (mission->place[i] != mission->place[j] || !is_free(w->in, mission->place[i])) continue;
      char first[INPUT_PATH_SIZE + 64], text[FAULT_LINE];
      const site it = place_site(w->in, j);
      input_place_name(w->in, i, first, sizeof first);
      snprintf(text, sizeof text,
               "place %s lies in the same cell as %.450s: column %u, row %u; drop one of them, or move it",
               it.label.text, first, (unsigned)(it.cell % mission->columns), (unsigned)(it.cell / mission->columns));
      w->twins++;
      complain(w, &it, text);
      break;
    }
  }
}

static void drop_left_out(work *w) {
  uint16_t kept = 0;
  qtr_mission *mission = &w->in->mission;
  for (uint16_t i = 0; i < mission->places; i++)
    if (!w->left_out[i]) input_keep_place(w->in, kept++, i);
  mission->places = kept;
}

/* "3 places and 1 robot are" */
static void name_who(char *out, size_t size, const work *w) {
  const int places = w->places + w->twins;
  const count_text robots = counted((uint64_t)w->robots, "robot");
  if (places == 0)
    snprintf(out, size, "%s are", robots.text);
  else if (w->robots == 0)
    snprintf(out, size, "%s are", counted((uint64_t)places, "place").text);
  else
    snprintf(out, size, "%s and %s are", counted((uint64_t)places, "place").text, robots.text);
}

static void name_mends(char *out, size_t size, const work *w, const char *them) {
  const char *places = w->robots > 0 ? " (places)" : "";
  const int used = w->far ? 0 : snprintf(out, size, ", or have %s moved by --snap %.3g", them, w->farthest);
  if (w->places > 0 && w->far)
    snprintf(out, size, ", or have %s left out by --skip-unreachable%s", them, places);
  else if (w->places > 0)
    snprintf(out + used, size - (size_t)used, ", or left out by --skip-unreachable%s", places);
}

/* The headline above several lines; a single line gets its mends at its end. */
static int sum_up(work *w) {
  const int off = w->places + w->robots, all = off + w->twins;
  const char *them = all == 1 ? "it" : "them";
  char mends[200] = "", who[160], *lines = NULL;
  if (all == 0) return 0;
  if (off > 0) name_mends(mends, sizeof mends, w, them);
  if (all == 1) { /* the text so far is an empty line and that one */
    memmove(w->why->text, w->why->text + 1, strlen(w->why->text));
    strncat(w->why->text, mends, FAULT_SIZE - 1 - strlen(w->why->text));
    return -1;
  }
  lines = strdup(w->why->text);
  name_who(who, sizeof who, w);
  fault_set(w->why, "%s: %s not on a free cell of their own, see below; move them%s", file_short_path(w->in->path), who,
            mends);
  if (lines != NULL) strncat(w->why->text, lines, FAULT_SIZE - 1 - strlen(w->why->text));
  free(lines);
  return -1;
}

static int treat_all(work *w) {
  const qtr_mission *mission = &w->in->mission;
  w->why->text[0] = '\0';
  for (int i = 0; i < mission->seekers; i++) {
    site it = start_site(w->in, i);
    treat(w, &it);
  }
  for (int i = 0; i < mission->places; i++) {
    site it = place_site(w->in, i);
    treat(w, &it);
  }
  check_twins(w);
  drop_left_out(w);
  if (sum_up(w) != 0) return -1;
  if (mission->places > 0) return 0;
  return file_fault(w->why, w->in->path, 0, 0, "no place is left: each is on an obstacle or outside the map; move one");
}

/* Most missions have nothing to treat. */
static bool is_sound(const input *in) {
  for (int i = 0; i < in->mission.seekers; i++)
    if (!is_free(in, in->mission.start[i])) return false;
  for (int i = 0; i < in->mission.places; i++)
    if (!is_free(in, in->mission.place[i])) return false;
  return true;
}

int snap_all(input *in, const input_options *options, fault *why) {
  static bool left_out[QTR_MAX_PLACES];
  work w = {.in = in, .options = options, .why = why, .left_out = left_out};
  memset(left_out, 0, sizeof left_out);
  if (!is_sound(in) && (w.ground = reach_mark(in)) == NULL) {
    return file_fault(why, in->path, 0, 0, "no memory for the map's free cells");
  }
  const int result = treat_all(&w);
  free(w.ground);
  return result;
}
