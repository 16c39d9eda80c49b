#include "field/ground.h"

#include <stdlib.h>
#include <string.h>

#include "field/families.h"
#include "host/base/memory.h"
#include "host/input/read.h"
#include "quarter/random.h"

enum { ROOM = 8, STOREY = 7 }; /* cells from one wall to the next, and from one corridor to the next */

/* A fifth of the cells blocked, but for the corner. */
static void scatter(qtr_mission *mission, uint32_t side, uint64_t *state) {
  for (uint32_t cell = 0; cell < side * side; cell++) mission->cost[cell] = qtr_lcg_below(state, 100) >= 20;
  mission->cost[0] = 1;
}

static void open_door(qtr_mission *mission, uint32_t side, uint32_t row, uint32_t column) {
  if (row < side && column < side) mission->cost[row * side + column] = 1;
}

/* Square rooms, a door in nine of ten walls between two. */
static void rooms(qtr_mission *mission, uint32_t side, uint64_t *state) {
  for (uint32_t cell = 0; cell < side * side; cell++)
    mission->cost[cell] = cell % side % ROOM != ROOM - 1 && cell / side % ROOM != ROOM - 1;
  for (uint32_t row = 0; row < side; row += ROOM) {
    for (uint32_t column = 0; column < side; column += ROOM) {
      if (qtr_lcg_below(state, 10) > 0)
        open_door(mission, side, row + qtr_lcg_below(state, ROOM - 1), column + ROOM - 1);
      if (qtr_lcg_below(state, 10) > 0)
        open_door(mission, side, row + ROOM - 1, column + qtr_lcg_below(state, ROOM - 1));
    }
  }
}

/* Corridors from left to right, rooms on both sides of each with a door to it, and a passage along the left edge. In a
 * storey of seven rows the first is the wall behind the rooms, the fourth the corridor. */
static void corridors(qtr_mission *mission, uint32_t side, uint64_t *state) {
  static const char storey[STOREY + 1] = "#.#.#..";
  for (uint32_t cell = 0; cell < side * side; cell++) {
    const uint32_t row = cell / side % STOREY;
    const bool partition = row != 3 && cell % side % ROOM == 0;
    mission->cost[cell] = cell % side == 0 || (storey[row] == '.' && !partition);
  }
  for (uint32_t row = 0; row < side; row += STOREY) {
    for (uint32_t column = 0; column < side; column += ROOM) {
      open_door(mission, side, row + 2, column + 1 + qtr_lcg_below(state, ROOM - 1));
      open_door(mission, side, row + 4, column + 1 + qtr_lcg_below(state, ROOM - 1));
    }
  }
}

/* The collapsed building of the demo's missions. */
static int floor_of_a_map(qtr_mission *mission, fault *why) {
  static const char path[] = QUARTER_SOURCE_DIR "/demo/missions/site/mission.yaml";
  const input_options options = {0};
  input *in = memory_take(sizeof *in, why);
  const int status = in != NULL ? input_read(in, path, &options, why) : -1;
  if (status == 0) {
    mission->columns = in->mission.columns;
    mission->rows = in->mission.rows;
    memcpy(mission->cost, in->mission.cost, qtr_mission_cells(&in->mission));
  }
  free(in);
  return status;
}

int ground_draw(qtr_mission *mission, int family, uint32_t side, uint64_t *state, fault *why) {
  if (family == FAMILY_FLOOR) return floor_of_a_map(mission, why);
  if ((uint64_t)side * side > QTR_MAX_CELLS) return fault_set(why, "ground of %u x %u cells is too large", side, side);
  mission->columns = mission->rows = (uint16_t)side;
  if (family == FAMILY_SCATTER) scatter(mission, side, state);
  if (family == FAMILY_ROOMS) rooms(mission, side, state);
  if (family == FAMILY_CORRIDORS) corridors(mission, side, state);
  return 0;
}
