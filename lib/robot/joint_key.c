#include "robot/joint_key.h"

#include <stdbool.h>

#include "core/apart.h"
#include "core/bytes.h"
#include "quarter/status.h"

/* A digit at its own bits, where the key is 0: they lie in one word, or in two. */
QTR_APART static void put(qtr_key *key, unsigned at, uint32_t digit, unsigned bits) {
  uint32_t *word = &key->word[at / 32u];
  const unsigned shift = at % 32u;
  QTR_ASSERT((bits == 32u) || ((digit >> bits) == 0u)); /* or two states would have one key */
  word[0] |= digit << shift;
  if ((shift + bits) > 32u) {
    word[1] |= digit >> (32u - shift);
  }
}

/* From the lowest bit up: visited places, clock, seekers. What is to come depends on nothing else, so two ways to one
 * key are one state. A seeker that stood down is one node more, the last. */
void qtr_joint_key(qtr_key *key, const qtr_joint *joint, const qtr_key_shape *shape) {
  bytes_clear(key, 4u * shape->words);
  for (unsigned w = 0; (w < QTR_PLACE_WORDS) && (w < shape->words); w++) {
    key->word[w] = joint->visited.word[w];
  }
  /* Visited are places of the board's. */
  QTR_ASSERT((key->word[shape->places / 32u] >> (shape->places % 32u)) == 0u);
  const unsigned seekers_at = (unsigned)shape->places + (QTR_TERMS ? shape->clock_bits : 0u);
  if (QTR_TERMS) {
    put(key, shape->places, (joint->now < shape->clock) ? joint->now : shape->clock, shape->clock_bits);
  }
  const unsigned seeker_bits = (unsigned)shape->node_bits + shape->remaining_bits;
  /* No key is longer than was measured: the bits above it are the Q-table's. */
  QTR_ASSERT((seekers_at + (shape->seekers * seeker_bits)) == shape->bits);
  for (unsigned i = 0; i < shape->seekers; i++) {
    const unsigned at = seekers_at + (seeker_bits * qtr_joint_behind(joint, shape, i));
    put(key, at, joint->remaining[i], shape->remaining_bits);
    put(key, at + shape->remaining_bits, (joint->node[i] < shape->nodes) ? joint->node[i] : shape->nodes,
        shape->node_bits);
  }
}
