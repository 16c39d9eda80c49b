/* Sets of places as fixed arrays of 32-bit words: 16 places cost one word. A place of QTR_MAX_PLACES or more is in no
 * set, and cannot be put into one. */
#ifndef QUARTER_PLACES_H
#define QUARTER_PLACES_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

QTR_C_BEGIN

#define QTR_PLACE_WORDS ((QTR_MAX_PLACES + 31) / 32)

typedef struct {
  uint32_t word[QTR_PLACE_WORDS];
} qtr_places;

/* The word that a place's bit is in: where there is but one, nothing is reckoned. */
#define QTR_PLACE_WORD(place) ((QTR_PLACE_WORDS > 1) ? ((place) / 32u) : 0u)

static inline void qtr_places_clear(qtr_places *set) {
  for (int w = 0; w < QTR_PLACE_WORDS; w++) {
    set->word[w] = 0;
  }
}

static inline bool qtr_places_has(const qtr_places *set, unsigned place) {
  return (place < QTR_MAX_PLACES) && (((set->word[QTR_PLACE_WORD(place)] >> (place % 32u)) & 1u) != 0u);
}

static inline void qtr_places_add(qtr_places *set, unsigned place) {
  if (place < QTR_MAX_PLACES) {
    set->word[QTR_PLACE_WORD(place)] |= (uint32_t)1 << (place % 32u);
  }
}

static inline void qtr_places_remove(qtr_places *set, unsigned place) {
  if (place < QTR_MAX_PLACES) {
    set->word[QTR_PLACE_WORD(place)] &= ~((uint32_t)1 << (place % 32u));
  }
}

QTR_C_END

#endif
