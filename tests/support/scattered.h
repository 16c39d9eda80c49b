/* The maps that learning is measured on: a square, a fifth of its cells blocked, all seekers in a corner, one place in
 * three of three times the weight. */
#ifndef QUARTER_TESTS_SCATTERED_H
#define QUARTER_TESTS_SCATTERED_H

#include <stdbool.h>

#include "quarter/game.h"
#include "quarter/mission.h"
#include "quarter/random.h"

static inline bool scattered_is_taken(const qtr_mission *mission, qtr_cell cell) {
  for (int p = 0; p < mission->places; p++)
    if (mission->place[p] == cell) return true;
  return mission->cost[cell] == 0 || cell == 0;
}

static inline void scattered_draw(qtr_mission *mission, uint64_t *state, unsigned side, unsigned places,
                                  unsigned seekers, int objective) {
  qtr_mission_default(mission);
  mission->columns = mission->rows = (uint16_t)side;
  mission->aim.kind = (uint8_t)objective;
  mission->seekers = (uint8_t)seekers;
  for (unsigned cell = 0; cell < side * side; cell++) mission->cost[cell] = qtr_lcg_below(state, 100) >= 20;
  mission->cost[0] = 1;
  while (mission->places < places) {
    const qtr_cell cell = (qtr_cell)qtr_lcg_below(state, side * side);
    if (scattered_is_taken(mission, cell)) continue;
    mission->place[mission->places] = cell;
    mission->weight[mission->places++] = qtr_lcg_below(state, 3) == 0 ? 3.0 : 1.0;
  }
}

/* Map number `seed`, and its game. One with a place that cannot be reached is drawn again. */
static inline void scattered_make(qtr_mission *mission, qtr_game *game, qtr_travel *travel, unsigned seed,
                                  unsigned side, unsigned places, unsigned seekers, int objective) {
  uint64_t state = seed * 0x9E3779B97F4A7C15u;
  do scattered_draw(mission, &state, side, places, seekers, objective);
  while (qtr_game_init(game, mission, travel, NULL) != QTR_OK);
}

#endif
