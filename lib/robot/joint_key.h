/* The order of seekers in the key of a state, and the key as format 1 had it. */
#ifndef QUARTER_ROBOT_JOINT_KEY_H
#define QUARTER_ROBOT_JOINT_KEY_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/joint.h"
#include "quarter/key.h"
#include "robot/board.h"

/* By kind, then by node. */
static inline uint32_t standing_of(const qtr_joint *joint, const qtr_key_shape *shape, unsigned seeker) {
  return ((uint32_t)kind_of_seeker(shape, seeker) << 16) | joint->node[seeker];
}

static inline bool comes_before(const qtr_joint *joint, const qtr_key_shape *shape, unsigned i, unsigned other) {
  const uint32_t rank = standing_of(joint, shape, i);
  const uint32_t others = standing_of(joint, shape, other);
  if (rank != others) {
    return rank < others;
  }
  return joint->remaining[i] < (joint->remaining[other] + ((i < other) ? 1u : 0u));
}

/* How many seekers stand behind this one in a key: those of a higher kind, then of a higher node, then with longer to
 * go. Each gets a number of its own. Seekers of a kind are interchangeable: in this order, who is who is gone from the
 * key. Kinds stay apart, in one order always. */
static inline unsigned qtr_joint_behind(const qtr_joint *joint, const qtr_key_shape *shape, unsigned seeker) {
  unsigned behind = 0;
  for (unsigned other = 0; other < shape->seekers; other++) {
    behind += comes_before(joint, shape, seeker, other) ? 1u : 0u;
  }
  return behind;
}

/* The key in format 1, which knew no clock; all words of it are written. Returns how many it takes. */
unsigned qtr_joint_key_1(qtr_key *key, const qtr_joint *joint, const qtr_key_shape *shape);

/* Words of the greatest key in format 1: what each of its keys takes in a record. */
unsigned qtr_key_words_1(const qtr_key_shape *shape);

#endif
