#include "model/matrix.h"

#include <stddef.h>

#include "core/bytes.h"

static void add_reach(qtr_box *used, const qtr_grid *grid, const qtr_travel *travel) {
  for (uint32_t cell = 0; cell < qtr_grid_cells(grid); cell++)
    if (travel->to_go[cell] != QTR_NEVER) qtr_box_add(used, grid, (qtr_cell)cell);
}

/* Whether place `to` lies in one part of the map with a place before it. */
static bool is_in_known_part(const uint8_t *steps, const qtr_mission *mission, unsigned to) {
  for (unsigned before = 0; before < to; before++)
    if (qtr_load32(steps + 4u * ((size_t)to * mission->places + before)) != QTR_NEVER) return true;
  return false;
}

/* A search a place and none a start: it goes backwards from the place, so that one gives the times from everywhere.
 * With terrain there and back differ, and what is kept is d(node, place). Little-endian, as a robot's board reads them
 * from the table. */
uint16_t qtr_matrix_fill(uint8_t *steps, const qtr_mission *mission, const qtr_cell *start, unsigned starts,
                         qtr_travel *travel, qtr_box *used) {
  const qtr_grid grid = qtr_mission_grid(mission);
  const size_t row = 4u * (size_t)mission->places;
  uint16_t to = 0;
  for (unsigned from = 0; used != NULL && from < starts; from++) qtr_box_add(used, &grid, start[from]);
  for (; to < mission->places; to++) {
    if (to > 0 && !qtr_watch_go_on(&mission->watch)) break;
    qtr_travel_fill(travel, &grid, mission->place[to]);
    if (used != NULL && !is_in_known_part(steps, mission, to)) add_reach(used, &grid, travel);
    uint8_t *at = steps + 4u * to;
    for (unsigned from = 0; from < mission->places; from++, at += row)
      qtr_store32(at, travel->to_go[mission->place[from]]);
    for (unsigned from = 0; from < starts; from++, at += row) qtr_store32(at, travel->to_go[start[from]]);
  }
  return to;
}
