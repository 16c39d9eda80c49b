#include "quarter/status.h"
#include "robot/bits.h"
#include "robot/joint_key.h"

/* Mixed radix: key = key * base + digit, over so many words; returns how many it takes then. */
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

/* A seeker that stood down is one node more, the last. */
static unsigned append_seeker(qtr_key *key, unsigned words, const qtr_key_shape *shape, uint32_t node,
                              qtr_steps remaining) {
  words = append_digit(key, words, (node < shape->nodes) ? node : shape->nodes, shape->nodes + 1u);
  return append_digit(key, words, remaining, shape->longest + 1u);
}

static unsigned append_places(qtr_key *key, unsigned words, const qtr_key_shape *shape, const qtr_places *places) {
  for (unsigned first = 0; first < shape->places; first += 32u) {
    const unsigned left = shape->places - first;
    words = append_bits(key, words, places->word[first / 32u], (left < 32u) ? left : 32u);
  }
  return words;
}

/* The seeker with so many behind it. */
static unsigned find_seeker(const qtr_joint *joint, const qtr_key_shape *shape, unsigned behind) {
  unsigned seeker = 0;
  while (qtr_joint_behind(joint, shape, seeker) != behind) {
    seeker++;
  }
  return seeker;
}

unsigned qtr_joint_key_1(qtr_key *key, const qtr_joint *joint, const qtr_key_shape *shape) {
  unsigned words = 0;
  for (unsigned ahead = 0; ahead < shape->seekers; ahead++) {
    const unsigned seeker = find_seeker(joint, shape, shape->seekers - 1u - ahead);
    words = append_seeker(key, words, shape, joint->node[seeker], joint->remaining[seeker]);
  }
  words = append_places(key, words, shape, &joint->visited);
  for (unsigned w = words; w < QTR_KEY_WORDS; w++) {
    key->word[w] = 0;
  }
  return words;
}

/* The key is greatest where every digit is, for it is monotone in each: all places visited, and all seekers stood down,
 * with the longest way to go. */
unsigned qtr_key_words_1(const qtr_key_shape *shape) {
  qtr_joint greatest;
  qtr_key key;
  qtr_places_clear(&greatest.visited);
  for (unsigned place = 0; place < shape->places; place++) {
    place_put(&greatest.visited, place);
  }
  for (unsigned i = 0; i < shape->seekers; i++) {
    greatest.node[i] = shape->nodes;
    greatest.remaining[i] = shape->longest;
  }
  return qtr_joint_key_1(&key, &greatest, shape);
}
