/* The places nearest to each place, which searches on large games go by: what is put beside a place that is far off is
 * hardly ever a gain, and there are n^2 of these against n of those. Games of fewer places are searched whole.
 */
#ifndef QUARTER_SEARCH_VICINITY_H
#define QUARTER_SEARCH_VICINITY_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/game.h"
#include "quarter/play.h"

typedef struct {
  bool in_use;                                      /* else all are near one another */
  uint16_t near[QTR_VICINITY_PLACES][QTR_VICINITY]; /* of each place, the nearest first, there and back */
  uint32_t set[QTR_VICINITY_PLACES][(QTR_VICINITY_PLACES + 31) / 32]; /* each place's, and whose it is one of */
} qtr_vicinity;

/* Find them, where the game is large. */
void qtr_vicinity_init(qtr_vicinity *vicinity, const qtr_game *game);

static inline bool qtr_vicinity_in_use(const qtr_vicinity *vicinity) {
  return QTR_VICINITY_PLACES > 1 && vicinity->in_use;
}

/* Whether one of two places is near the other one; true where all are. */
static inline bool qtr_vicinity_has(const qtr_vicinity *vicinity, unsigned place, unsigned other) {
  return !qtr_vicinity_in_use(vicinity) || (vicinity->set[place][other / 32] >> (other % 32) & 1u) != 0;
}

#endif
