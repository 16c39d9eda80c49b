#include "model/matrix.h"

#include <stddef.h>

#include "core/bytes.h"

qtr_grid qtr_matrix_grid(const qtr_mission *mission, unsigned of_class) {
  qtr_grid grid = qtr_mission_grid(mission);
  if (mission->robot_class[of_class].smooth_only) grid.encoding = QTR_GRID_SMOOTH;
  return grid;
}

unsigned qtr_matrix_place(const qtr_matrix_nodes *nodes, unsigned place) {
  return nodes->look_of == NULL ? place : qtr_load16(nodes->look_of + 2 * (size_t)place);
}

/* A class's time for a way of base cost `cost`. More than a time can be is still a way: one that the board refuses as
 * too long to add up. */
static qtr_steps steps_of(const qtr_robot_class *of, qtr_steps cost, qtr_steps scan) {
  if (cost == QTR_NEVER) return QTR_NEVER;
  const uint64_t steps = (uint64_t)cost * of->cell_steps + scan;
  return steps < QTR_NEVER ? (qtr_steps)steps : QTR_NEVER - 1;
}

static void add_reach(qtr_box *used, const qtr_grid *grid, const qtr_travel *travel) {
  for (uint32_t cell = 0; cell < qtr_grid_cells(grid); cell++)
    if (travel->to_go[cell] != QTR_NEVER) qtr_box_add(used, grid, (qtr_cell)cell);
}

/* Whether the mission's place `to` lies in one part of the map with a place before it, for the class of the matrix. */
static bool is_in_known_part(const uint8_t *matrix, const qtr_matrix_nodes *nodes, unsigned to) {
  for (unsigned before = 0; before < to; before++)
    if (qtr_load32(matrix + 4 * ((size_t)to * nodes->places + before)) != QTR_NEVER) return true;
  return false;
}

/* The column of a place, and of each later look at it, for one class. */
static void fill_columns(uint8_t *matrix, const qtr_matrix_nodes *nodes, unsigned of_class, unsigned to,
                         const qtr_travel *travel) {
  const qtr_mission *mission = nodes->mission;
  const qtr_robot_class *of = &mission->robot_class[of_class];
  const size_t row = 4 * (size_t)nodes->places;
  const bool avoided = qtr_places_has(&of->avoided, to);
  for (unsigned look = to; look < nodes->places; look++) {
    if (qtr_matrix_place(nodes, look) != to) continue;
    uint8_t *at = matrix + 4 * (size_t)look;
    for (unsigned from = 0; from < nodes->places + nodes->starts; from++, at += row) {
      const qtr_cell cell =
          from < nodes->places ? mission->place[qtr_matrix_place(nodes, from)] : nodes->start[from - nodes->places];
      qtr_store32(at, avoided ? QTR_NEVER : steps_of(of, travel->to_go[cell], of->scan[to]));
    }
  }
}

/* The mission's place `to` for all classes. Those that may enter the same ground, one after another, share a search. */
static void fill_place(uint8_t *steps, const qtr_matrix_nodes *nodes, unsigned to, qtr_travel *travel, qtr_box *used) {
  const qtr_mission *mission = nodes->mission;
  const size_t matrix_bytes = 4 * (size_t)(nodes->places + nodes->starts) * nodes->places;
  int searched = -1; /* the encoding of the grid that `travel` is of */
  for (unsigned i = 0; i < mission->classes; i++) {
    uint8_t *matrix = steps + i * matrix_bytes;
    const qtr_grid grid = qtr_matrix_grid(mission, i);
    if (grid.encoding != searched) {
      qtr_travel_fill(travel, &grid, mission->place[to]);
      if (used != NULL && !is_in_known_part(matrix, nodes, to)) add_reach(used, &grid, travel);
      searched = grid.encoding;
    }
    fill_columns(matrix, nodes, i, to, travel);
  }
}

/* A search a place and none a start: it goes backwards from the place, so that one gives the times from everywhere.
 * With terrain there and back differ, and what is kept is d(node, place). Little-endian, as a robot's board reads them
 * from the table. */
uint16_t qtr_matrix_fill(uint8_t *steps, const qtr_matrix_nodes *nodes, qtr_travel *travel, qtr_box *used) {
  const qtr_mission *mission = nodes->mission;
  const qtr_grid ground = qtr_mission_grid(mission);
  uint16_t to = 0;
  for (unsigned from = 0; used != NULL && from < nodes->starts; from++) qtr_box_add(used, &ground, nodes->start[from]);
  for (; to < mission->places; to++) {
    if (to > 0 && !qtr_watch_go_on(&mission->watch)) break;
    fill_place(steps, nodes, to, travel, used);
  }
  return to;
}

void qtr_matrix_fill_home(uint8_t *home, const qtr_matrix_nodes *nodes, unsigned of_class, qtr_cell start,
                          qtr_travel *travel) {
  const qtr_mission *mission = nodes->mission;
  const qtr_grid grid = qtr_matrix_grid(mission, of_class);
  qtr_travel_fill(travel, &grid, start);
  for (unsigned place = 0; place < nodes->places; place++) {
    const qtr_steps cost = travel->to_go[mission->place[qtr_matrix_place(nodes, place)]];
    qtr_store32(home + 4 * (size_t)place, steps_of(&mission->robot_class[of_class], cost, 0));
  }
}
