#include "host/input/sites.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host/base/count.h"
#include "host/base/file.h"
#include "host/input/classes.h"
#include "host/input/frame.h"
#include "host/input/snap.h"

static int site_fault(const input *in, input_origin origin, fault *why, const char *what) {
  return file_fault(why, input_source_path(in, origin), origin.line, origin.column, "%s", what);
}

/* Names tell places apart, and robots. */
static int check_name(input *in, const char *what, const char *name, char names[][QTR_SITE_NAME_BYTES],
                      const input_origin *origins, int count, input_origin origin, fault *why) {
  for (int i = 0; name[0] != '\0' && i < count; i++) {
    if (strcmp(names[i], name) != 0) continue;
    return file_fault(why, input_source_path(in, origin), origin.line, origin.column,
                      "a second %s is called '%s', after that of %s:%d; give it another name", what, name,
                      file_short_path(input_source_path(in, origins[i])), origins[i].line);
  }
  return 0;
}

int sites_add_start(input *in, const input_site *site, input_origin origin, fault *why) {
  qtr_mission *mission = &in->mission;
  if (mission->seekers >= QTR_MAX_SEEKERS) {
    char what[200];
    snprintf(what, sizeof what,
             "more than %d robots, the most that this build holds; list fewer, or build with a larger QTR_MAX_SEEKERS",
             QTR_MAX_SEEKERS);
    return site_fault(in, origin, why, what);
  }
  if (check_name(in, "robot", site->name, in->names.seeker, in->start_origin, mission->seekers, origin, why)) return -1;
  if (classes_join(in, mission->seekers, site->class_name, origin, why)) return -1;
  in->terms.ready[mission->seekers] = site->ready_seconds;
  in->terms.stated = in->terms.stated || site->ready_given;
  mission->start[mission->seekers] = frame_cell(in, site->position);
  in->start_origin[mission->seekers] = origin;
  in->start_position[mission->seekers] = site->position;
  memcpy(in->names.seeker[mission->seekers], site->name, sizeof site->name);
  mission->seekers++;
  return 0;
}

/* The place over the mission. */
static void state_looks(input *in, unsigned place, const input_site *site) {
  qtr_mission *mission = &in->mission;
  input_terms *terms = &in->terms;
  const double detection = site->detection > 0.0 ? site->detection : terms->detection;
  const uint8_t looks = site->looks > 0 ? site->looks : terms->looks;
  mission->detection[place] = detection > 0.0 ? detection : 1.0;
  mission->looks[place] = looks > 0 ? looks : 1;
  terms->place_scan[place] = site->scan_given ? site->scan_seconds : INPUT_UNSAID;
  terms->stated = terms->stated || site->scan_given;
}

int sites_add_place(input *in, const input_site *site, input_origin origin, fault *why) {
  qtr_mission *mission = &in->mission;
  char what[200];
  if (mission->places >= QTR_MAX_PLACES) {
    snprintf(what, sizeof what,
             "more than %d places, the most that this build holds; list fewer, or build with a larger QTR_MAX_PLACES",
             QTR_MAX_PLACES);
    return site_fault(in, origin, why, what);
  }
  if (check_name(in, "place", site->name, in->names.place, in->place_origin, mission->places, origin, why)) return -1;
  mission->place[mission->places] = frame_cell(in, site->position);
  mission->weight[mission->places] = site->weight;
  state_looks(in, mission->places, site);
  in->place_origin[mission->places] = origin;
  in->place_position[mission->places] = site->position;
  memcpy(in->names.place[mission->places], site->name, sizeof site->name);
  in->place_number[mission->places] = mission->places;
  in->places_stated = ++mission->places;
  return 0;
}

int sites_check_size(const char *path, long line, double columns, double rows, const char *mend, fault *why) {
  if (!(columns >= 1.0) || !(rows >= 1.0)) {
    return file_fault(why, path, line, 0, "%.0f x %.0f cells: there is no map; give it a column and a row at least",
                      columns, rows);
  }
  if (columns > UINT16_MAX || rows > UINT16_MAX) {
    return file_fault(why, path, line, 0, "%.0f x %.0f cells: at most %d columns and rows are possible; %s", columns,
                      rows, UINT16_MAX, mend);
  }
  if (columns * rows > (double)QTR_MAX_CELLS) {
    return file_fault(why, path, line, 0,
                      "%.0f x %.0f cells are more than %ld, the most that this build holds; %s, or build with a larger "
                      "QTR_MAX_CELLS",
                      columns, rows, (long)QTR_MAX_CELLS, mend);
  }
  return 0;
}

/* "Alpha" for four robots: "Alpha 1" to "Alpha 4". A name that would become too long is dropped. */
static void number_shared(input *in, int robots) {
  char name[QTR_SITE_NAME_BYTES];
  memcpy(name, in->names.seeker[0], sizeof name);
  const bool fits = name[0] != '\0' && strlen(name) + 5 < sizeof name;
  for (int i = 0; i < robots; i++) {
    char *to = in->names.seeker[i];
    to[0] = '\0';
    if (fits) snprintf(to, QTR_SITE_NAME_BYTES, "%.*s %d", QTR_SITE_NAME_BYTES - 6, name, i + 1);
  }
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
  number_shared(in, robots);
  for (int i = 1; i < robots; i++) {
    mission->start[i] = mission->start[0];
    mission->class_of[i] = mission->class_of[0];
    in->terms.ready[i] = in->terms.ready[0];
    in->start_origin[i] = in->start_origin[0];
  }
  mission->seekers = (uint8_t)robots;
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
    char what[300];
    const naming n = input_naming(in);
    snprintf(what, sizeof what,
             "the weight %g of place %s is nothing beside the sum of all, %g; raise it, or drop the place",
             mission->weight[i], naming_place(&n, (unsigned)i).text, sum);
    return site_fault(in, in->place_origin[i], why, what);
  }
  return 0;
}

/* A map without a single free cell needs another mend than its places. */
static int check_free(const input *in, fault *why) {
  const size_t cells = qtr_mission_cells(&in->mission);
  if (memchr(in->mission.cost, 1, cells) != NULL) return 0;
  for (size_t cell = 0; cell < cells; cell++)
    if (in->mission.cost[cell] != 0) return 0;
  return file_fault(why, in->map, 0, 0, "no cell of the map is free; check that it is the right one");
}

int sites_finish(input *in, const input_options *options, fault *why) {
  if (check_free(in, why) || snap_all(in, options, why) || check_weights(in, why)) return -1;
  return share_start(in, options->robots, why);
}
