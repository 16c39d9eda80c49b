#include "sites.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "count.h"
#include "file.h"

const char *sites_path(const input *in, input_origin origin) {
  switch (origin.source) {
  case INPUT_FROM_MAP: return in->map;
  case INPUT_FROM_CSV: return in->csv;
  default: return in->path;
  }
}

static int site_fault(const input *in, input_origin origin, fault *why, const char *what) {
  return file_fault(why, sites_path(in, origin), origin.line, origin.column, "%s", what);
}

int sites_add_start(input *in, qtr_cell cell, input_origin origin, fault *why) {
  qtr_mission *mission = &in->mission;
  if (mission->seekers >= QTR_MAX_SEEKERS) {
    char what[200];
    snprintf(what, sizeof what,
             "more than %d robots, the most that this build holds; list fewer, or build with a larger QTR_MAX_SEEKERS",
             QTR_MAX_SEEKERS);
    return site_fault(in, origin, why, what);
  }
  mission->start[mission->seekers] = cell;
  in->start_origin[mission->seekers] = origin;
  mission->seekers++;
  return 0;
}

int sites_add_place(input *in, qtr_cell cell, double weight, input_origin origin, fault *why) {
  qtr_mission *mission = &in->mission;
  char what[200];
  if (!(weight > 0.0) || !isfinite(weight)) {
    snprintf(what, sizeof what, "the weight %g of a place is not above 0; give its likelihood in any unit", weight);
    return site_fault(in, origin, why, what);
  }
  if (mission->places >= QTR_MAX_PLACES) {
    snprintf(what, sizeof what,
             "more than %d places, the most that this build holds; list fewer, or build with a larger QTR_MAX_PLACES",
             QTR_MAX_PLACES);
    return site_fault(in, origin, why, what);
  }
  mission->place[mission->places] = cell;
  mission->weight[mission->places] = weight;
  in->place_origin[mission->places] = origin;
  mission->places++;
  return 0;
}

int sites_check_size(const char *path, long line, double columns, double rows, fault *why) {
  if (!(columns >= 1.0) || !(rows >= 1.0)) {
    return file_fault(why, path, line, 0, "%.0f x %.0f cells: there is no map; give it a column and a row at least",
                      columns, rows);
  }
  if (columns > UINT16_MAX || rows > UINT16_MAX) {
    return file_fault(
        why, path, line, 0,
        "%.0f x %.0f cells: at most %d columns and rows are possible; cut the map, or choose larger cells", columns,
        rows, UINT16_MAX);
  }
  if (columns * rows > (double)QTR_MAX_CELLS) {
    return file_fault(why, path, line, 0,
                      "%.0f x %.0f cells are more than %ld, the most that this build holds; cut the map, choose larger "
                      "cells, or build with a larger QTR_MAX_CELLS",
                      columns, rows, (long)QTR_MAX_CELLS);
  }
  return 0;
}

/* Enough starts for `robots`: a single start serves them all. */
static int share_start(input *in, int robots, fault *why) {
  qtr_mission *mission = &in->mission;
  if (robots < 0) return fault_set(why, "%s: %d robots; ask for 1 or more", file_short_path(in->path), robots);
  if (robots == 0 || robots == mission->seekers) return 0;
  if (mission->seekers > 1) {
    return file_fault(why, in->path, 0, 0,
                      "%d robots asked for, but the input has %s; ask for %d, or keep one start for all", robots,
                      counted(mission->seekers, "start").text, mission->seekers);
  }
  if (robots > QTR_MAX_SEEKERS) {
    return file_fault(
        why, in->path, 0, 0,
        "%d robots asked for, but this build holds %d; ask for fewer, or build with a larger QTR_MAX_SEEKERS", robots,
        QTR_MAX_SEEKERS);
  }
  for (int i = 1; i < robots; i++) {
    mission->start[i] = mission->start[0];
    in->start_origin[i] = in->start_origin[0];
  }
  mission->seekers = (uint8_t)robots;
  return 0;
}

static int check_cell(const input *in, qtr_cell cell, input_origin origin, const char *what, int index, fault *why) {
  const qtr_mission *mission = &in->mission;
  if (mission->cost[cell] != 0) return 0;
  char inflated[80] = "";
  if (in->robot_radius > 0.0) {
    snprintf(inflated, sizeof inflated, " grown by the robot_radius of %g m", in->robot_radius);
  }
  char text[300];
  snprintf(text, sizeof text, "%s %d stands on an obstacle%s, at column %u, row %u; move it to a free cell", what,
           index, inflated, (unsigned)(cell % mission->columns), (unsigned)(cell / mission->columns));
  return site_fault(in, origin, why, text);
}

static int check_twins(const input *in, fault *why) {
  const qtr_mission *mission = &in->mission;
  for (int j = 1; j < mission->places; j++) {
    for (int i = 0; i < j; i++) {
      if (mission->place[i] != mission->place[j]) continue;
      char first[INPUT_PATH_SIZE + 64], text[sizeof why->text];
      input_place_name(in, i, first, sizeof first);
      snprintf(text, sizeof text,
               "place %d lies in the same cell as %.450s: column %u, row %u; drop one of them, or move it", j, first,
               (unsigned)(mission->place[j] % mission->columns), (unsigned)(mission->place[j] / mission->columns));
      return site_fault(in, in->place_origin[j], why, text);
    }
  }
  return 0;
}

/* The likelihoods are the weights' shares of their sum: both must be numbers that a double holds in full. */
static int check_weights(const input *in, fault *why) {
  const qtr_mission *mission = &in->mission;
  double sum = 0.0;
  for (int i = 0; i < mission->places; i++) sum += mission->weight[i];
  if (!isfinite(sum)) {
    return file_fault(why, in->path, 0, 0,
                      "the weights of the places add up to more than a number holds; scale them down");
  }
  for (int i = 0; i < mission->places; i++) {
    if (mission->weight[i] / sum >= DBL_MIN) continue;
    char what[200];
    snprintf(what, sizeof what,
             "the weight %g of place %d is nothing beside the sum of all, %g; raise it, or drop the place",
             mission->weight[i], i, sum);
    return site_fault(in, in->place_origin[i], why, what);
  }
  return 0;
}

int sites_finish(input *in, int robots, fault *why) {
  const qtr_mission *mission = &in->mission;
  for (int i = 0; i < mission->seekers; i++) {
    if (check_cell(in, mission->start[i], in->start_origin[i], "robot", i, why)) return -1;
  }
  for (int i = 0; i < mission->places; i++) {
    if (check_cell(in, mission->place[i], in->place_origin[i], "place", i, why)) return -1;
  }
  if (check_twins(in, why) || check_weights(in, why)) return -1;
  return share_start(in, robots, why);
}
