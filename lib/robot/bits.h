/* Sets of 32-bit words from the inside: a member that is known to be one, and the whole set as bytes, in which member
 * i is bit i % 8 of byte i / 8. */
#ifndef QUARTER_BITS_H
#define QUARTER_BITS_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/places.h"

/* qtr_places_has() and its like without their question, which costs more than the answer: the place is one of the
 * build's. */
static inline uint32_t place_bit(unsigned place) {
  return (uint32_t)1 << ((QTR_MAX_PLACES > 32) ? (place % 32u) : place);
}

static inline bool place_is_in(const qtr_places *set, unsigned place) {
  return (set->word[QTR_PLACE_WORD(place)] & place_bit(place)) != 0u;
}

static inline void place_put(qtr_places *set, unsigned place) {
  set->word[QTR_PLACE_WORD(place)] |= place_bit(place);
}

static inline void place_take(qtr_places *set, unsigned place) {
  set->word[QTR_PLACE_WORD(place)] &= ~place_bit(place);
}

static inline uint32_t bits_size(unsigned members) {
  return (members + 7u) / 8u;
}

static inline uint8_t bits_byte(const uint32_t *word, uint32_t i) {
  return (uint8_t)((word[i / 4u] >> (8u * (i % 4u))) & 0xFFu);
}

/* Add a byte to a set that is clear there. */
static inline void bits_add(uint32_t *word, uint32_t i, uint8_t byte) {
  word[i / 4u] |= (uint32_t)byte << (8u * (i % 4u));
}

#endif
