#include "robot/joint_key.h"

#include <stdbool.h>

#include "core/apart.h"
#include "quarter/status.h"

/* By kind, then by node. */
static uint32_t standing_of(const qtr_joint *joint, const qtr_key_shape *shape, unsigned seeker) {
  return (QTR_TERMS ? ((uint32_t)shape->kind[seeker] << 16) : 0u) | joint->node[seeker];
}

static bool comes_before(const qtr_joint *joint, const qtr_key_shape *shape, unsigned i, unsigned other) {
  const uint32_t rank = standing_of(joint, shape, i);
  const uint32_t others = standing_of(joint, shape, other);
  if (rank != others) {
    return rank < others;
  }
  return joint->remaining[i] < (joint->remaining[other] + ((i < other) ? 1u : 0u));
}

unsigned qtr_joint_behind(const qtr_joint *joint, const qtr_key_shape *shape, unsigned seeker) {
  unsigned behind = 0;
  for (unsigned other = 0; other < shape->seekers; other++) {
    behind += comes_before(joint, shape, seeker, other) ? 1u : 0u;
  }
  return behind;
}

/* A digit at its own bits, where the key is 0: they lie in one word, or in two. Returns where the next ones begin. */
QTR_APART static unsigned put(qtr_key *key, unsigned at, uint32_t digit, unsigned bits) {
  const unsigned shift = at % 32u;
  QTR_ASSERT((bits == 32u) || ((digit >> bits) == 0u)); /* or two states would have one key */
  key->word[at / 32u] |= digit << shift;
  if ((shift + bits) > 32u) {
    key->word[(at / 32u) + 1u] |= digit >> (32u - shift);
  }
  return at + bits;
}

/* From the lowest bit up: visited places, clock, seekers. What is to come depends on nothing else, so two ways to one
 * key are one state. A seeker that stood down is one node more, the last. */
void qtr_joint_key(qtr_key *key, const qtr_joint *joint, const qtr_key_shape *shape) {
  for (unsigned w = 0; w < shape->words; w++) {
    key->word[w] = (w < QTR_PLACE_WORDS) ? joint->visited.word[w] : 0u;
  }
  /* Visited are places of the board's. */
  QTR_ASSERT((key->word[shape->places / 32u] >> (shape->places % 32u)) == 0u);
  unsigned seekers_at = shape->places;
  if (QTR_TERMS) {
    const qtr_steps clock = (joint->now < shape->clock) ? joint->now : shape->clock;
    seekers_at = put(key, seekers_at, clock, shape->clock_bits);
  }
  const unsigned seeker_bits = (unsigned)shape->node_bits + shape->remaining_bits;
  /* No key is longer than was measured: the bits above it are the Q-table's. */
  QTR_ASSERT((seekers_at + (shape->seekers * seeker_bits)) == shape->bits);
  for (unsigned i = 0; i < shape->seekers; i++) {
    const unsigned at = seekers_at + (seeker_bits * qtr_joint_behind(joint, shape, i));
    const unsigned node_at = put(key, at, joint->remaining[i], shape->remaining_bits);
    (void)put(key, node_at, (joint->node[i] < shape->nodes) ? joint->node[i] : shape->nodes, shape->node_bits);
  }
}
