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
} tile;

typedef struct {
  input *in;
  const tiles_settings *settings;
  fault *why;
  uint8_t *ground; /* REACHED, TAKEN, or 0 */
  tile *tiles;
  size_t across, count; /* tiles side by side, and all */
  double all, reached;  /* mass on the grid, and of tiles within reach */
  int taken;            /* tiles, the first so many */
} work;

enum { REACHED = 1, TAKEN = 2 };

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
    it->mass += mass;
    it->column += mass * (double)(cell % columns);
    it->row += mass * (double)(cell / columns);
    w->all += mass;
  }
  for (size_t i = 0; i < w->count; i++) {
    tile *it = &w->tiles[i];
    it->cell = QTR_NO_CELL;
    it->column /= it->mass > 0.0 ? it->mass : 1.0;
    it->row /= it->mass > 0.0 ? it->mass : 1.0;
  }
}

static bool is_nearer(const work *w, const tile *it, size_t cell, double apart) {
  if (it->cell == QTR_NO_CELL) return true;
  const uint8_t now = w->ground[it->cell], then = w->ground[cell];
  return now != then ? then == REACHED : apart < it->apart - ROUNDING;
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
  for (size_t i = 0; i < w->count; i++)
    if (w->tiles[i].mass > 0.0 && w->tiles[i].cell != QTR_NO_CELL) w->tiles[kept++] = w->tiles[i];
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
  w->taken = (int)tiles;
  return 0;
}

static int add_places(work *w) {
  const bool metres = w->in->frame.metric;
  for (int i = 0; i < w->taken; i++) {
    const input_site site = {.position = frame_centre(w->in, w->tiles[i].cell, metres), .weight = w->tiles[i].mass};
    if (sites_add_place(w->in, &site, w->settings->origin, w->why) != 0) return -1;
  }
  return 0;
}

static void note_cover(const work *w) {
  const tiles_settings *s = w->settings;
  const double all = w->all + s->off, out = w->all - w->reached;
  char lost[200] = "";
  size_t used = 0;
  if (out > all * ROUNDING)
    used = (size_t)snprintf(lost, sizeof lost, "; %.3g %% of all lies where no robot gets to", 100.0 * out / all);
  if (s->off > all * 1e-9)
    snprintf(lost + used, sizeof lost - used, "; %.3g %% of all lies off the map", 100.0 * s->off / all);
  notes_add(&w->in->note, "%s:%d: %s of %zu tiles hold %.4g %% of the likelihood within reach%s",
            file_short_path(s->path), s->line, counted((uint64_t)w->taken, "place").text, w->count,
            100.0 * mass_of(w, (size_t)w->taken) / w->reached, lost);
}

static int add(work *w) {
  const qtr_mission *mission = &w->in->mission;
  for (int i = 0; i < mission->places; i++)
    if (mission->place[i] != QTR_NO_CELL && w->ground[mission->place[i]] != 0) w->ground[mission->place[i]] = TAKEN;
  sum_up(w);
  find_cells(w);
  sort_reached(w);
  if (take_share(w) != 0 || add_places(w) != 0) return -1;
  note_cover(w);
  return 0;
}

int tiles_add(input *in, const tiles_settings *settings, fault *why) {
  work w = {.in = in, .settings = settings, .why = why};
  w.across = (size_t)ceil(in->mission.columns / settings->side);
  w.count = w.across * (size_t)ceil(in->mission.rows / settings->side);
  w.ground = reach_mark(in);
  w.tiles = memory_take(w.count * sizeof *w.tiles, why);
  const int result = w.ground == NULL  ? file_fault(why, settings->path, settings->line, 0, "no memory for the tiles")
                     : w.tiles == NULL ? -1
                                       : add(&w);
  free(w.ground);
  free(w.tiles);
  return result;
}

int tiles_check(const input *in, double footprint, const value_site *site) {
  if (footprint >= in->frame.cell_size * (1.0 - 1e-9)) return 0;
  return value_fault(site, "the footprint of %g is less than a cell, %g%s; choose smaller cells, or give a cell's side",
                     footprint, in->frame.cell_size, in->frame.metric ? " m" : "");
}
