#include "propose.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/file.h"
#include "host/input/frame.h"
#include "host/input/sites.h"

static const double APART_M = 1.0; /* between robots that start beside one another */
static const double CLEAR_M = 0.4; /* of what is proposed from walls */

enum { FAR = UINT16_MAX };

/* Steps from the nearest of the cells in the queue, FAR where there is no way; the queue is left in the order of
 * them. */
typedef struct {
  const qtr_mission *mission;
  uint16_t *steps;
  qtr_cell *queue;
  size_t count; /* of cells in the queue */
  int clear;    /* cells to every side that are free around a cell that is proposed, where there is such a one */
} ground;

static void reach(ground *g, qtr_cell cell, unsigned steps) {
  if (g->mission->cost[cell] == 0 || g->steps[cell] <= steps) return;
  if (g->steps[cell] == FAR) g->queue[g->count++] = cell;
  g->steps[cell] = (uint16_t)steps;
}

/* From the sources that the queue holds, each at 0 steps; beyond FAR - 1 steps all are equally far. */
static void spread(ground *g) {
  const unsigned columns = g->mission->columns, rows = g->mission->rows;
  for (size_t at = 0; at < g->count; at++) {
    const qtr_cell cell = g->queue[at];
    const unsigned column = (unsigned)(cell % columns), row = (unsigned)(cell / columns);
    const unsigned next = g->steps[cell] < FAR - 1 ? g->steps[cell] + 1u : FAR - 1;
    if (row > 0) reach(g, (qtr_cell)(cell - columns), next);
    if (column > 0) reach(g, (qtr_cell)(cell - 1), next);
    if (column + 1 < columns) reach(g, (qtr_cell)(cell + 1), next);
    if (row + 1 < rows) reach(g, (qtr_cell)(cell + columns), next);
  }
}

static void measure(ground *g, const qtr_cell *sources, int count) {
  const size_t cells = qtr_mission_cells(g->mission);
  for (size_t cell = 0; cell < cells; cell++) g->steps[cell] = FAR;
  g->count = 0;
  for (int i = 0; i < count; i++) reach(g, sources[i], 0);
  spread(g);
}

static bool is_free(const qtr_mission *mission, int column, int row) {
  return column >= 0 && column < mission->columns && row >= 0 && row < mission->rows &&
         mission->cost[(size_t)row * mission->columns + (size_t)column] != 0;
}

static bool is_clear(const ground *g, qtr_cell cell) {
  const int column = (int)(cell % g->mission->columns), row = (int)(cell / g->mission->columns);
  for (int up = -g->clear; up <= g->clear; up++)
    for (int across = -g->clear; across <= g->clear; across++)
      if (!is_free(g->mission, column + across, row + up)) return false;
  return true;
}

/* Of the cells that are clear and not among the sources, or else of all. */
static qtr_cell farthest(const ground *g) {
  for (size_t at = g->count; at > 0 && g->steps[g->queue[at - 1]] > 0; at--)
    if (is_clear(g, g->queue[at - 1])) return g->queue[at - 1];
  return g->queue[g->count - 1];
}

/* A cell of the largest piece; false: no cell is free. */
static bool find_largest(ground *g, qtr_cell *found) {
  const size_t cells = qtr_mission_cells(g->mission);
  size_t largest = 0;
  for (size_t cell = 0; cell < cells; cell++) g->steps[cell] = FAR;
  for (size_t cell = 0; cell < cells; cell++) {
    if (g->mission->cost[cell] == 0 || g->steps[cell] != FAR) continue;
    g->count = 0;
    reach(g, (qtr_cell)cell, 0);
    spread(g);
    if (g->count <= largest) continue;
    largest = g->count;
    *found = (qtr_cell)cell;
  }
  return largest > 0;
}

/* ---- robots ---- */

static int add_start(input *in, qtr_cell cell, const char *name, fault *why) {
  input_site site = {.position = frame_centre(in, cell, false)};
  snprintf(site.name, sizeof site.name, "%s", name);
  return sites_add_start(in, &site, (input_origin){INPUT_FROM_MAP, 0, 0}, why);
}

/* Names of robots beyond the alphabet's first are their numbers. */
static const char *const robot_names[] = {"Alpha", "Bravo", "Charlie", "Delta", "Echo", "Foxtrot", "Golf", "Hotel"};

static const char *robot_name(int index) {
  return index < (int)(sizeof robot_names / sizeof robot_names[0]) ? robot_names[index] : "";
}

/* From one end of the ground on, so far apart as robots are that stand beside one another. */
static int add_robots(input *in, ground *g, int robots, fault *why) {
  qtr_cell end;
  if (!find_largest(g, &end)) return file_fault(why, in->map, 0, 0, "has no free cell");
  measure(g, &end, 1);
  end = farthest(g);
  measure(g, &end, 1);
  const double apart = in->frame.metric ? fmax(1.0, round(APART_M / in->frame.cell_size)) : 1.0;
  size_t at = 0;
  for (int i = 0; i < robots; i++) {
    while (at + 1 < g->count && (g->steps[g->queue[at]] < i * apart || !is_clear(g, g->queue[at]))) at++;
    if (add_start(in, g->queue[at], robot_name(i), why) != 0) return -1;
  }
  return 0;
}

static int repeat_start(input *in, int robots, fault *why) {
  for (int i = 1; i < robots; i++)
    if (add_start(in, in->mission.start[0], "", why) != 0) return -1;
  return 0;
}

/* ---- places ---- */

static int add_place(input *in, qtr_cell cell, int index, fault *why) {
  input_site site = {.position = frame_centre(in, cell, false), .weight = 1.0};
  snprintf(site.name, sizeof site.name, "%c", 'A' + index);
  return sites_add_place(in, &site, (input_origin){INPUT_FROM_MAP, 0, 0}, why);
}

/* Each as far as can be from the robots and the places before it. */
static int add_places(input *in, ground *g, int places, fault *why) {
  qtr_cell taken[QTR_MAX_SEEKERS + 26];
  int count = in->mission.seekers;
  memcpy(taken, in->mission.start, (size_t)count * sizeof *taken);
  for (int i = 0; i < places; i++) {
    measure(g, taken, count);
    taken[count] = farthest(g);
    if (i > 0 && g->steps[taken[count]] == 0) return 0;
    if (add_place(in, taken[count++], i, why) != 0) return -1;
  }
  return 0;
}

static int propose(input *in, ground *g, int robots, int places, fault *why) {
  if (in->mission.seekers == 0 && add_robots(in, g, robots, why) != 0) return -1;
  if (in->mission.seekers == 1 && repeat_start(in, robots, why) != 0) return -1;
  return in->mission.places == 0 ? add_places(in, g, places, why) : 0;
}

int propose_sites(input *in, int robots, int places, fault *why) {
  const size_t cells = qtr_mission_cells(&in->mission);
  const double clear = in->frame.metric ? round(CLEAR_M / in->frame.cell_size) : 1.0;
  ground g = {.mission = &in->mission, .clear = (int)fmax(1.0, fmin(3.0, clear))};
  g.steps = malloc(cells * sizeof *g.steps);
  g.queue = malloc(cells * sizeof *g.queue);
  int status = -1;
  if (g.steps == NULL || g.queue == NULL)
    fault_set(why, "%s: no memory to look for free ground", in->map);
  else
    status = propose(in, &g, robots, places < 26 ? places : 26, why);
  free(g.steps);
  free(g.queue);
  return status;
}
