#include "search/looks.h"

#include "core/bytes.h"

#if QTR_TERMS

static bool are_places(const qtr_targets *targets, unsigned places) {
  if (targets->count != places) return false;
  for (unsigned place = 0; place < places; place++)
    if (qtr_targets_of(targets, place) != place) return false;
  return true;
}

/* Later looks stand behind all first ones, and behind those that come before them. */
static void chain(qtr_looks *looks, const uint8_t *look_of) {
  uint16_t last[QTR_MAX_PLACES];
  looks->firsts = 0;
  for (uint16_t look = 0; look < looks->count; look++) {
    const unsigned first = qtr_load16(look_of + 2 * (size_t)look);
    looks->before[look] = looks->next[look] = QTR_STAND_DOWN;
    if (first == look) {
      looks->firsts++;
    } else {
      looks->before[look] = last[first];
      looks->next[last[first]] = look;
    }
    last[first] = look;
  }
}

#endif

void qtr_looks_init(qtr_looks *looks, const qtr_environment *environment) {
  const qtr_board *board = &environment->game->board;
  looks->count = looks->firsts = environment->targets.count;
#if QTR_TERMS
  if (board->terms.look_of != NULL && are_places(&environment->targets, board->places))
    chain(looks, board->terms.look_of);
#else
  (void)board;
#endif
}
