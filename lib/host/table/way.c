#include "host/table/way.h"

#include <stdlib.h>

#include "quarter/claim.h"
#include "quarter/field.h"
#include "quarter/status.h"

/* From the way's last cell to a place, `field` filled for it, in so many steps a cell; `room` for so many cells in
 * all. */
static int walk_to(way *w, const table *t, const qtr_field *field, const qtr_grid *grid, uint32_t cell_steps,
                   unsigned place, size_t room) {
  const qtr_cell goal = qtr_policy_cell(&t->policy, place);
  waypoint here = w->at[w->count - 1];
  /* Another look at where it is. */
  if (here.cell == goal && here.place != WAY_NO_PLACE) {
    if (w->count == room) return -1;
    w->at[w->count++] = here;
  }
  while (here.cell != goal) {
    here.cell = qtr_field_next(field, grid, here.cell);
    if (here.cell == QTR_NO_CELL || w->count == room) return -1;
    here.step += cell_steps * qtr_grid_cost(grid, here.cell);
    here.place = WAY_NO_PLACE;
    w->at[w->count++] = here;
  }
  w->at[w->count - 1].place = (int)place;
  return 0;
}

/* Entering a cell takes a step at least, so a way has no more cells than its last visit has steps, and the start.
 * Places may share a cell, though. */
static int walk(way *w, const table *t, qtr_field *field, int seeker, const table_route *route, fault *why) {
  const qtr_board *board = &t->policy.board;
  const qtr_grid grid = qtr_policy_ground(&t->policy, (unsigned)seeker);
  const uint32_t cell_steps = qtr_claim_cell_steps(&t->policy, board->class_of[seeker]);
  const size_t room = 1u + (unsigned)route->places + (route->places > 0 ? route->step[route->places - 1] : 0u);
  w->at = malloc(room * sizeof *w->at);
  if (w->at == NULL) return fault_set(why, "no memory for the way of seeker %d", seeker);
  const unsigned start = (unsigned)board->places + board->start_of[seeker];
  w->at[w->count++] =
      (waypoint){qtr_policy_cell(&t->policy, start), qtr_board_ready(board, (unsigned)seeker), WAY_NO_PLACE};
  for (int i = 0; i < route->places; i++) {
    if (qtr_field_fill(field, &grid, qtr_policy_cell(&t->policy, route->place[i])) != QTR_OK ||
        walk_to(w, t, field, &grid, cell_steps, route->place[i], room) != 0)
      return fault_set(why, "the table's travel times do not fit its map; learn it again");
    w->at[w->count - 1].step = route->step[i]; /* the scan is over, and the robot goes on */
  }
  return 0;
}

int way_walk(way *w, const table *t, int seeker, const table_route *route, fault *why) {
  *w = (way){NULL, 0};
  qtr_field *field = malloc(sizeof *field);
  const int status = field != NULL ? walk(w, t, field, seeker, route, why)
                                   : fault_set(why, "no memory for the way of seeker %d", seeker);
  free(field);
  if (status != 0) way_free(w);
  return status;
}

static bool is_corner(const way *w, size_t i) {
  const qtr_cell before = w->at[i - 1].cell, here = w->at[i].cell, after = w->at[i + 1].cell;
  return (int64_t)here - before != (int64_t)after - here;
}

static void keep(way *w, bool corners) {
  size_t kept = 1;
  for (size_t i = 1; i < w->count; i++) {
    const bool stays = w->at[i].place != WAY_NO_PLACE || (corners && is_corner(w, i));
    if (stays) w->at[kept++] = w->at[i];
  }
  w->count = kept;
}

void way_keep_corners(way *w) {
  keep(w, true);
}

void way_keep_places(way *w) {
  keep(w, false);
}

void way_free(way *w) {
  free(w->at);
  *w = (way){NULL, 0};
}
