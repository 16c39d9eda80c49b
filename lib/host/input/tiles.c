#include "host/input/tiles.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "host/base/count.h"
#include "host/base/file.h"
#include "host/base/memory.h"
#include "host/input/frame.h"
#include "host/input/reach.h"
#include "host/input/sites.h"

#define ROUNDING 1e-12 /* of a sum of shares */

typedef struct {
  double mass;
  double column, row; /* the mass's middle, as cells are counted; its moments until all is summed */
  qtr_cell cell;      /* the nearest to it that a place may stand in; QTR_NO_CELL: there is none */
  double apart;       /* squared, in cells */
  size_t at;          /* among all, before they are sorted: from the lower left one on */
  double most;        /* of a cell's mass */
  uint32_t area;      /* of that cell, from 1; 0: none */
} tile;

typedef struct {
  input *in;
  const tiles_settings *settings;
  fault *why;
  reach *ground; /* who can get to each cell */
  bool *taken;   /* another place stands in it */
  tile *tiles;
  size_t across, rows, count; /* tiles side by side, above one another, and all */
  size_t lost;                /* tiles that nobody gets to */
  tile likeliest;             /* of these */
  double all, reached;        /* mass on the grid, and of tiles within reach */
  int taken_tiles;            /* the first so many */
} work;

static size_t tile_of(const work *w, size_t cell) {
  const size_t columns = w->in->mission.columns, up = w->in->mission.rows - 1u - cell / columns;
  const double side = w->settings->side;
  return (size_t)floor(((double)up + 0.5) / side) * w->across + (size_t)floor(((double)(cell % columns) + 0.5) / side);
}

/* ---- the tiles ---- */

static void sum_up(work *w) {
  const size_t columns = w->in->mission.columns, cells = qtr_mission_cells(&w->in->mission);
  for (size_t cell = 0; cell < cells; cell++) {
    const double mass = w->settings->mass[cell];
    tile *it = &w->tiles[tile_of(w, cell)];
    if (mass > it->most && w->settings->area_of != NULL) it->area = w->settings->area_of[cell];
    it->most = fmax(it->most, mass);
    it->mass += mass;
    it->column += mass * (double)(cell % columns);
    it->row += mass * (double)(cell / columns);
    w->all += mass;
  }
  for (size_t i = 0; i < w->count; i++) {
    tile *it = &w->tiles[i];
    if (it->area > 0) w->settings->area[it->area - 1].tiles++;
    it->at = i;
    it->cell = QTR_NO_CELL;
    it->column /= it->mass > 0.0 ? it->mass : 1.0;
    it->row /= it->mass > 0.0 ? it->mass : 1.0;
  }
}

static bool is_nearer(const work *w, const tile *it, size_t cell, double apart) {
  if (it->cell == QTR_NO_CELL) return true;
  const bool now = w->taken[it->cell], then = w->taken[cell];
  return now != then ? now : apart < it->apart - ROUNDING;
}

static void find_cells(work *w) {
  const size_t columns = w->in->mission.columns, cells = qtr_mission_cells(&w->in->mission);
  for (size_t cell = 0; cell < cells; cell++) {
    if (w->ground[cell] == 0) continue;
    tile *it = &w->tiles[tile_of(w, cell)];
    const double across = (double)(cell % columns) - it->column, down = (double)(cell / columns) - it->row;
    const double apart = across * across + down * down;
    if (!is_nearer(w, it, cell, apart)) continue;
    it->cell = (qtr_cell)cell;
    it->apart = apart;
  }
}

/* The likeliest first; among equals as one reads. */
static int compare(const void *a, const void *b) {
  const tile *one = a, *other = b;
  if (one->mass != other->mass) return one->mass > other->mass ? -1 : 1;
  return one->cell < other->cell ? -1 : one->cell > other->cell;
}

/* Those within reach alone, in order. */
static void sort_reached(work *w) {
  size_t kept = 0;
  for (size_t i = 0; i < w->count; i++) {
    const tile *it = &w->tiles[i];
    if (it->mass > 0.0 && it->cell != QTR_NO_CELL) w->tiles[kept++] = *it;
    if (it->mass <= 0.0 || it->cell != QTR_NO_CELL) continue;
    if (w->lost++ == 0 || it->mass > w->likeliest.mass) w->likeliest = *it;
  }
  w->count = kept;
  qsort(w->tiles, kept, sizeof *w->tiles, compare);
  for (size_t i = 0; i < kept; i++) w->reached += w->tiles[i].mass;
}

/* ---- those that are taken ---- */

static double mass_of(const work *w, size_t tiles) {
  double mass = 0.0;
  for (size_t i = 0; i < tiles && i < w->count; i++) mass += w->tiles[i].mass;
  return mass;
}

/* Rounded down, so that it fits when it is given back. */
static double fitting_share(const work *w, size_t tiles) {
  return floor(mass_of(w, tiles) / w->reached * 1000.0) / 1000.0;
}

static int too_many(const work *w, size_t tiles, size_t left) {
  const tiles_settings *s = w->settings;
  char fits[100] = "";
  if (left > 0 && fitting_share(w, left) > 0.0)
    snprintf(fits, sizeof fits, "\"share: %g\" fits; lower it, ", fitting_share(w, left));
  return file_fault(
      w->why, s->path, s->line, 0,
      "a share of %g takes %s, and %zu are left of the %d that this build holds: %schoose a larger footprint, or build "
      "with a larger QTR_MAX_PLACES",
      s->share, counted(tiles, "place").text, left, QTR_MAX_PLACES, fits);
}

static int take_share(work *w) {
  const tiles_settings *s = w->settings;
  const size_t left = (size_t)(QTR_MAX_PLACES - w->in->mission.places);
  double mass = 0.0;
  size_t tiles = 0;
  if (!(w->all > 0.0))
    return file_fault(w->why, s->path, s->line, 0, "no likelihood above 0 lies on the map; mend the values");
  if (w->count == 0)
    return file_fault(w->why, s->path, s->line, 0,
                      "all of the likelihood lies where no robot gets to; check that it lies on the map as it should");
  while (tiles < w->count && mass < w->reached * (s->share - ROUNDING)) mass += w->tiles[tiles++].mass;
  if (tiles > left) return too_many(w, tiles, left);
  w->taken_tiles = (int)tiles;
  return 0;
}

static tile_naming naming_of(const work *w, const tile *it) {
  const tiles_settings *s = w->settings;
  return (tile_naming){.column = it->at % w->across,
                       .row = it->at / w->across,
                       .rows = w->rows,
                       .area = it->area > 0 ? &s->area[it->area - 1] : NULL,
                       .file = s->file,
                       .plain = !w->in->tiled};
}

static int add_places(work *w) {
  const bool metres = w->in->frame.metric;
  bool plain = false;
  for (int i = 0; i < w->taken_tiles; i++) {
    const tile *it = &w->tiles[i];
    const tile_naming called = naming_of(w, it);
    input_site site = {.position = frame_centre(w->in, it->cell, metres), .weight = it->mass};
    tile_name(site.name, &called, w->in);
    plain = plain || called.area == NULL || called.area->name[0] == '\0';
    if (sites_add_place(w->in, &site, w->settings->origin, w->why) != 0) return -1;
  }
  w->in->tiled = w->in->tiled || plain;
  return 0;
}

/* ", in 3 tiles, the likeliest around x 3.5, y 2" */
static void name_lost(char *out, size_t size, const work *w) {
  char where[100];
  const qtr_mission *mission = &w->in->mission;
  const qtr_cell middle =
      (qtr_cell)((size_t)lround(w->likeliest.row) * mission->columns + (size_t)lround(w->likeliest.column));
  frame_name(where, sizeof where, frame_centre(w->in, middle, w->in->frame.metric));
  snprintf(out, size, ", %s%s around %s", counted(w->lost, "tile").text, w->lost > 1 ? ", the likeliest" : "", where);
}

/* "drone, rover": the names of classes. False: all that have robots are among them. */
static bool name_classes(char *out, size_t size, const input *in, reach who) {
  bool all = true;
  size_t used = 0;
  out[0] = '\0';
  for (int of = 0; of < in->mission.classes; of++) {
    const char *name = in->terms.of_class[of].name;
    bool has_robot = false;
    for (int i = 0; i < in->mission.seekers; i++) has_robot = has_robot || in->mission.class_of[i] == of;
    const bool among = (who >> of & 1u) != 0;
    all = all && (among || !has_robot);
    if (among && used < size)
      used += (size_t)snprintf(out + used, size - used, "%s%s", used > 0 ? ", " : "",
                               name[0] != '\0' ? name : "robots without a class");
  }
  return !all;
}

/* Places that some classes alone get to, once for each lot of classes. */
static void note_classes(const work *w) {
  for (int i = 0; i < w->taken_tiles; i++) {
    const reach who = w->ground[w->tiles[i].cell];
    char names[QTR_MAX_CLASSES * QTR_SITE_NAME_BYTES];
    double mass = 0.0;
    uint64_t count = 0;
    bool told = !name_classes(names, sizeof names, w->in, who);
    for (int other = 0; other < w->taken_tiles && !told; other++) {
      if (w->ground[w->tiles[other].cell] != who) continue;
      told = other < i;
      mass += w->tiles[other].mass;
      count++;
    }
    if (!told)
      notes_add(&w->in->note,
                "%s:%d: %s with %.3g %% of the likelihood within reach %s left to %.300s: no other class "
                "gets there",
                file_short_path(w->settings->path), w->settings->line, counted(count, "place").text,
                100.0 * mass / w->reached, count == 1 ? "is" : "are", names);
  }
}

static void note_cover(const work *w) {
  const tiles_settings *s = w->settings;
  const double all = w->all + s->off, out = w->all - w->reached;
  char lost[400] = "", where[240] = "";
  size_t used = 0;
  if (w->lost > 0) name_lost(where, sizeof where, w);
  if (out > all * ROUNDING)
    used =
        (size_t)snprintf(lost, sizeof lost, "; %.3g %% of all lies where no robot gets to%s", 100.0 * out / all, where);
  if (s->off > all * 1e-9)
    snprintf(lost + used, sizeof lost - used, "; %.3g %% of all lies off the map", 100.0 * s->off / all);
  notes_add(&w->in->note, "%s:%d: %s of %s %s %.4g %% of the likelihood within reach%s", file_short_path(s->path),
            s->line, counted((uint64_t)w->taken_tiles, "place").text, counted(w->count, "tile").text,
            w->taken_tiles == 1 ? "holds" : "hold", 100.0 * mass_of(w, (size_t)w->taken_tiles) / w->reached, lost);
}

static int add(work *w) {
  const qtr_mission *mission = &w->in->mission;
  for (int i = 0; i < mission->places; i++)
    if (mission->place[i] != QTR_NO_CELL) w->taken[mission->place[i]] = true;
  sum_up(w);
  find_cells(w);
  sort_reached(w);
  if (take_share(w) != 0 || add_places(w) != 0) return -1;
  note_cover(w);
  note_classes(w);
  return 0;
}

int tiles_add(input *in, const tiles_settings *settings, fault *why) {
  work w = {.in = in, .settings = settings, .why = why};
  w.across = (size_t)ceil(in->mission.columns / settings->side);
  w.rows = (size_t)ceil(in->mission.rows / settings->side);
  w.count = w.across * w.rows;
  w.ground = reach_mark(in);
  w.tiles = memory_take(w.count * sizeof *w.tiles, why);
  w.taken = memory_take(qtr_mission_cells(&in->mission) * sizeof *w.taken, why);
  const bool has_memory = w.tiles != NULL && w.taken != NULL;
  const int result = w.ground == NULL ? file_fault(why, settings->path, settings->line, 0, "no memory for the tiles")
                     : has_memory     ? add(&w)
                                      : -1;
  free(w.ground);
  free(w.taken);
  free(w.tiles);
  return result;
}

int tiles_check(const input *in, double footprint, const value_site *site) {
  if (footprint >= in->frame.cell_size * (1.0 - 1e-9)) return 0;
  return value_fault(site,
                     "the footprint of %g is less than a cell, %g%s; choose smaller cells, or write \"footprint: %g\"",
                     footprint, in->frame.cell_size, in->frame.metric ? " m" : "", in->frame.cell_size);
}
