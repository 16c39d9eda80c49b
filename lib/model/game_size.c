#include <stddef.h>
#include <stdint.h>

#include "model/rounding.h"
#include "quarter/game.h"

/* As many looks as its game has places, or the build holds. */
static size_t count_looks(const qtr_mission *mission) {
  size_t looks = mission->places;
  for (unsigned place = 0; QTR_TERMS && looks < QTR_MAX_PLACES && place < mission->places; place++)
    if (mission->detection[place] != 1.0 && mission->looks[place] > 1) looks += mission->looks[place] - 1u;
  return looks < QTR_MAX_PLACES ? looks : QTR_MAX_PLACES;
}

/* Each seeker may have a start of its own. */
size_t qtr_game_bytes(const qtr_mission *mission) {
  const size_t places = count_looks(mission);
  const size_t nodes = places + (mission->seekers < QTR_MAX_SEEKERS ? mission->seekers : QTR_MAX_SEEKERS);
  const size_t classes = mission->classes < QTR_MAX_CLASSES ? mission->classes : QTR_MAX_CLASSES;
  const size_t bytes = offsetof(qtr_game, steps) + 4 * nodes * places * classes;
  return (bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t) * sizeof(uint64_t);
}
