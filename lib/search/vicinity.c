#include "search/vicinity.h"

#include <string.h>

#include "robot/board.h"

#if QTR_VICINITY_PLACES > 1

static uint64_t steps_around(const qtr_game *game, unsigned place, unsigned other) {
  return (uint64_t)qtr_steps_between(&game->board, 0, place, other) + qtr_steps_between(&game->board, 0, other, place);
}

/* Of equals the lower number comes first. */
static void find_near(qtr_vicinity *v, const qtr_game *game, unsigned place) {
  uint64_t steps[QTR_VICINITY];
  unsigned count = 0;
  for (unsigned other = 0; other < game->board.places; other++) {
    if (other == place) continue;
    const uint64_t around = steps_around(game, place, other);
    if (count == QTR_VICINITY && around >= steps[count - 1]) continue;
    unsigned at = count < QTR_VICINITY ? count++ : count - 1;
    for (; at > 0 && steps[at - 1] > around; at--) {
      steps[at] = steps[at - 1];
      v->near[place][at] = v->near[place][at - 1];
    }
    steps[at] = around;
    v->near[place][at] = (uint16_t)other;
  }
}

void qtr_vicinity_init(qtr_vicinity *v, const qtr_game *game) {
  v->in_use = game->board.places > QTR_SEARCHED_WHOLE;
  if (!v->in_use) return;
  for (unsigned place = 0; place < game->board.places; place++) memset(v->set[place], 0, sizeof v->set[place]);
  for (unsigned place = 0; place < game->board.places; place++) {
    find_near(v, game, place);
    for (unsigned i = 0; i < QTR_VICINITY; i++) {
      const unsigned other = v->near[place][i];
      v->set[place][other / 32] |= (uint32_t)1 << (other % 32);
      v->set[other][place / 32] |= (uint32_t)1 << (place % 32);
    }
  }
}

#else

void qtr_vicinity_init(qtr_vicinity *v, const qtr_game *game) {
  (void)game;
  v->in_use = false;
}

#endif
