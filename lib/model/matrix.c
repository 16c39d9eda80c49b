#include "model/matrix.h"

#include <stddef.h>

#include "core/bytes.h"

/* A search a place and none a start: it goes backwards from the place, so that one gives the times from everywhere. With terrain
 * there and back differ, and what is kept is d(node, place). Little-endian, as a robot's board reads them from the table. */
uint16_t qtr_matrix_fill(uint8_t *steps, const qtr_mission *mission, const qtr_cell *start, unsigned starts,
                         qtr_field *field) {
  const qtr_grid grid = qtr_mission_grid(mission);
  const size_t row = 4u * (size_t)mission->places;
  uint16_t to = 0;
  for (; to < mission->places; to++) {
    if (to > 0 && !qtr_watch_go_on(&mission->watch)) break;
    qtr_field_fill(field, &grid, mission->place[to]);
    uint8_t *at = steps + 4u * to;
    for (unsigned from = 0; from < mission->places; from++, at += row)
      store32_le(at, field->to_go[mission->place[from]]);
    for (unsigned from = 0; from < starts; from++, at += row) store32_le(at, field->to_go[start[from]]);
  }
  return to;
}
