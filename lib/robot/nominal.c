#include "quarter/nominal.h"

#include <stddef.h>

#include "core/apart.h"
#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/status.h"
#include "robot/bits.h"
#include "robot/board.h"
#include "robot/joint.h"
#include "robot/layout.h"

/* ---- by the table ---- */

/* Below 0, 0 or above 0, as the record's key is less than, equal to or greater than `key`. */
static int compare_key(const uint8_t *record, const qtr_key *key, unsigned bytes) {
  for (unsigned i = bytes; i-- > 0u;) {
    const uint8_t digit = bits_byte(key->word, i);
    if (record[i] != digit) {
      return (record[i] < digit) ? -1 : 1;
    }
  }
  return 0;
}

static void make_key(qtr_key *key, const qtr_policy *policy, const qtr_joint *joint) {
  if (is_format_1(policy->format)) {
    (void)qtr_joint_key_1(key, joint, &policy->board.keys);
  } else {
    qtr_joint_key(key, joint, &policy->board.keys);
  }
}

/* The record of a state; NULL: there is none. Records are sorted by key and each key is there once: halves of [low,
 * high), in which alone the key can be. */
static const uint8_t *find_record(const qtr_policy *policy, const qtr_joint *joint) {
  qtr_key key;
  make_key(&key, policy, joint);
  uint32_t low = 0;
  uint32_t high = policy->records;
  while (low < high) {
    const uint32_t middle = low + ((high - low) / 2u);
    const uint8_t *record = section_of(policy, SECTION_RECORDS) + (middle * policy->records_shape.bytes);
    const int order = compare_key(record, &key, policy->records_shape.key_bytes);
    if (order == 0) {
      return record;
    }
    if (order < 0) {
      low = middle + 1u;
    } else {
      high = middle;
    }
  }
  return NULL;
}

bool qtr_policy_lookup(const qtr_policy *policy, const qtr_joint *joint, uint16_t *choice) {
  const uint8_t *record = find_record(policy, joint);
  if (record == NULL) {
    return false;
  }
  *choice = record_choice(record, &policy->records_shape);
  return true;
}

/* ---- off the table ---- */

static uint64_t product(uint32_t a, uint32_t b) {
  const uint32_t low = (a & 0xFFFFu) * (b & 0xFFFFu);
  const uint32_t middle = ((a >> 16) * (b & 0xFFFFu)) + (low >> 16);
  const uint32_t other = ((a & 0xFFFFu) * (b >> 16)) + (middle & 0xFFFFu);
  const uint32_t high = ((a >> 16) * (b >> 16)) + (middle >> 16) + (other >> 16);
  return ((uint64_t)high << 32) | ((other << 16) | (low & 0xFFFFu));
}

/* As in Smith's rule for the least weighted sum of times; of equal ones the lowest number, or robots would differ. */
QTR_APART static void choose_by_rate(const qtr_policy *policy, const qtr_joint *joint, qtr_move *move,
                                     const qtr_places *choices) {
  const unsigned seeker = (unsigned)move->seeker;
  uint32_t most_weight = 0;
  qtr_steps most_steps = 1;
  move->choice = QTR_STAND_DOWN;
  for (unsigned place = 0; place < policy->board.places; place++) {
    if (!place_is_in(choices, place)) {
      continue;
    }
    const uint32_t weight = qtr_policy_weight(policy, place);
    const qtr_steps steps = qtr_steps_between(&policy->board, seeker, joint->node[seeker], place);
    if (product(weight, most_steps) > product(most_weight, steps)) {
      move->choice = (uint16_t)place;
      most_weight = weight;
      most_steps = steps;
    }
  }
}

/* ---- the game ---- */

/* Whether the table has a choice for whose turn it is, and one that is allowed: else it can only be a forged one, and
 * counts as none. */
static bool choose_by_table(const qtr_policy *policy, const qtr_joint *joint, qtr_move *move,
                            const qtr_places *choices) {
  const uint8_t *record = find_record(policy, joint);
  if (record == NULL) {
    return false;
  }
  move->choice = record_choice(record, &policy->records_shape);
  return (move->choice == QTR_STAND_DOWN) ? qtr_joint_may_leave(joint, &policy->board, (unsigned)move->seeker, choices)
                                          : qtr_places_has(choices, move->choice);
}

static void choose(const qtr_policy *policy, const qtr_joint *joint, qtr_move *move) {
  qtr_places choices;
  qtr_places_clear(&choices);
  (void)qtr_joint_options(joint, &policy->board, (unsigned)move->seeker, &choices);
  move->off_table = !choose_by_table(policy, joint, move, &choices);
  if (move->off_table) {
    choose_by_rate(policy, joint, move, &choices);
  }
}

/* Time passes only when nobody has to choose, and each time it passes somebody arrives: between two choices there are
 * no more advances than seekers, so that a call is short. */
bool qtr_policy_move(const qtr_policy *policy, qtr_joint *joint, qtr_move *move) {
  move->seeker = qtr_joint_chooser(joint, &policy->board);
  while (move->seeker == QTR_NOBODY) {
    if (qtr_joint_pass(joint, &policy->board) == 0u) {
      return false;
    }
    move->seeker = qtr_joint_chooser(joint, &policy->board);
  }
  choose(policy, joint, move);
  (void)qtr_joint_go(joint, &policy->board, (unsigned)move->seeker, move->choice);
  return true;
}

/* As the next move, of a game that is left as it is. Whose turn it is not may choose nothing, and stands. */
uint16_t qtr_policy_choose(const qtr_policy *policy, const qtr_joint *joint, int seeker, bool *off_table) {
  qtr_joint next;
  qtr_move move;
  next = *joint;
  move.choice = QTR_STAND_DOWN;
  move.off_table = false;
  if ((seeker != QTR_NOBODY) && (qtr_joint_chooser(joint, &policy->board) == seeker)) {
    (void)qtr_policy_move(policy, &next, &move);
  }
  if (off_table != NULL) {
    *off_table = move.off_table;
  }
  return move.choice;
}

/* Ends, for each time round somebody chooses, and there are no more choices than QTR_MAX_MOVES and one to stand down
 * for each seeker. */
uint16_t qtr_policy_play(const qtr_policy *policy, qtr_joint *joint, int seeker, qtr_steps *now, uint32_t *off_table) {
  if ((seeker < 0) || (seeker >= policy->board.seekers)) {
    return QTR_STAND_DOWN;
  }
  while (joint->node[seeker] != QTR_STAND_DOWN) {
    qtr_move move;
    const qtr_steps before = joint->now;
    const bool goes_on = qtr_policy_move(policy, joint, &move);
    if (now != NULL) {
      *now += joint->now - before;
    }
    if (!goes_on) {
      break;
    }
    if (off_table != NULL) {
      *off_table += move.off_table;
    }
    if (move.seeker == seeker) {
      return move.choice;
    }
  }
  return QTR_STAND_DOWN;
}
