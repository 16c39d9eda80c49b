#include "quarter/key.h"

#include <stdbool.h>

#include "core/apart.h"
#include "quarter/status.h"
#include "robot/bits.h"

/* ---- digits: key = key * base + digit, over so many words; returns how many it takes then ---- */

static unsigned append_digit(qtr_key *key, unsigned words, uint32_t digit, uint32_t base) {
  uint64_t carry = digit;
  QTR_ASSERT(digit < base); /* or two states would have one key */
  for (unsigned w = 0; w < words; w++) {
    carry += (uint64_t)key->word[w] * base;
    key->word[w] = (uint32_t)(carry & 0xFFFFFFFFu);
    carry >>= 32;
  }
  if (carry > 0u) {
    key->word[words++] = (uint32_t)carry;
  }
  return words;
}

/* A whole word of bits is a base of 2^32, which moves all words up by one. A key of 0 has no words yet. */
static unsigned append_bits(qtr_key *key, unsigned words, uint32_t value, unsigned bits) {
  if (bits < 32u) {
    return append_digit(key, words, value, (uint32_t)1 << bits);
  }
  for (unsigned w = words; w > 0u; w--) {
    key->word[w] = key->word[w - 1u];
  }
  key->word[0] = value;
  return ((words > 0u) || (value > 0u)) ? (words + 1u) : 0u;
}

/* ---- what a state is made of ---- */

/* A seeker that stood down is one node more, the last. */
static unsigned append_seeker(qtr_key *key, unsigned words, const qtr_key_shape *shape, uint32_t node,
                              qtr_steps remaining) {
  words = append_digit(key, words, (node < shape->nodes) ? node : shape->nodes, shape->nodes + 1u);
  return append_digit(key, words, remaining, shape->longest + 1u);
}

/* Visited places come last: they are the digits of the lowest value, and states of one formation stand together in a
 * table. */
static unsigned append_places(qtr_key *key, unsigned words, const qtr_key_shape *shape, const qtr_places *places) {
  for (unsigned first = 0; first < shape->places; first += 32u) {
    const unsigned left = shape->places - first;
    words = append_bits(key, words, places->word[first / 32u], (left < 32u) ? left : 32u);
  }
  return words;
}

/* Without a clock there is no digit for it, and keys are as long as if there were no such thing. */
static unsigned append_clock(qtr_key *key, unsigned words, const qtr_key_shape *shape, qtr_steps clock) {
  return (shape->clock > 0u) ? append_digit(key, words, clock, shape->clock + 1u) : words;
}

static bool comes_before(const qtr_key_shape *shape, const uint16_t *node, const qtr_steps *remaining, unsigned i,
                         unsigned other) {
  if (shape->kind[i] != shape->kind[other]) {
    return shape->kind[i] < shape->kind[other];
  }
  return (node[i] != node[other]) ? node[i] < node[other] : (remaining[i] < remaining[other]);
}

/* Seekers of a kind are interchangeable: sorted, who is who is gone from the key. Kinds stay apart, in one order
 * always. */
QTR_APART static void sort_seekers(uint8_t order[QTR_MAX_SEEKERS], const qtr_key_shape *shape, const uint16_t *node,
                                   const qtr_steps *remaining) {
  for (unsigned i = 0; i < shape->seekers; i++) {
    unsigned at = i;
    for (; (at > 0u) && comes_before(shape, node, remaining, i, order[at - 1u]); at--) {
      order[at] = order[at - 1u];
    }
    order[at] = (uint8_t)i;
  }
}

/* Of `words` words, the others being 0. */
static bool fits_in_bits(const qtr_key *key, unsigned words, unsigned bits) {
  return ((32u * words) <= bits) || ((words == ((bits / 32u) + 1u)) && ((key->word[words - 1u] >> (bits % 32u)) == 0u));
}

/* Seekers, clock and visited places: what is to come depends on nothing else, so two ways to one key are one state. */
void qtr_key_make(qtr_key *key, const qtr_key_shape *shape, const qtr_places *visited, qtr_steps clock,
                  const uint16_t *node, const qtr_steps *remaining) {
  uint8_t order[QTR_MAX_SEEKERS];
  sort_seekers(order, shape, node, remaining);
  unsigned words = 0;
  for (unsigned i = 0; i < shape->seekers; i++) {
    words = append_seeker(key, words, shape, node[order[i]], remaining[order[i]]);
  }
  words = append_clock(key, words, shape, clock);
  words = append_places(key, words, shape, visited);
  /* No key is greater than the one that was measured: the bits above it are the Q-table's. */
  QTR_ASSERT((words <= shape->words) && fits_in_bits(key, words, shape->bits));
  while (words < shape->words) {
    key->word[words++] = 0;
  }
}

/* The key is greatest where every digit is, for it is monotone in each: all places visited, and all seekers stood down,
 * with the longest way to go. */
void qtr_key_measure(qtr_key_shape *shape) {
  uint16_t node[QTR_MAX_SEEKERS];
  qtr_steps remaining[QTR_MAX_SEEKERS];
  qtr_key key;
  qtr_places all;
  qtr_places_clear(&all);
  for (unsigned place = 0; place < shape->places; place++) {
    place_put(&all, place);
  }
  for (unsigned i = 0; i < shape->seekers; i++) {
    node[i] = shape->nodes;
    remaining[i] = shape->longest;
  }
  shape->words = QTR_KEY_WORDS;
  shape->bits = 32 * QTR_KEY_WORDS;
  qtr_key_make(&key, shape, &all, shape->clock, node, remaining);
  while (key.word[shape->words - 1u] == 0u) {
    QTR_ASSERT(shape->words > 1); /* the greatest key is not 0, for no game is without places */
    shape->words--;
  }
  shape->bits = (uint16_t)(32u * shape->words);
  for (uint32_t top = key.word[shape->words - 1u]; (top & 0x80000000u) == 0u; top <<= 1) {
    shape->bits--;
  }
}
