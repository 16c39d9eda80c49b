#include "quarter/nominal.h"

#include <stddef.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/status.h"
#include "robot/bits.h"
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

/* Records are sorted by key and each key is there once: halves of [low, high), in which alone the key can be. */
bool qtr_policy_lookup(const qtr_policy *policy, const qtr_joint *joint, uint16_t *choice) {
  const qtr_record_shape *shape = &policy->records_shape;
  qtr_key key;
  qtr_joint_key(&key, joint, &policy->board);
  uint32_t low = 0;
  uint32_t high = policy->records;
  while (low < high) {
    const uint32_t middle = low + ((high - low) / 2u);
    const uint8_t *record = policy->record + (middle * shape->bytes);
    const int order = compare_key(record, &key, shape->key_bytes);
    if (order == 0) {
      *choice = record_choice(record, shape);
      return true;
    }
    if (order < 0) {
      low = middle + 1u;
    } else {
      high = middle;
    }
  }
  return false;
}

/* ---- off the table ---- */

/* weight a / steps a > weight b / steps b, without a division. */
/* The likeliest per step of travel first, as in Smith's rule for the least weighted sum of times; of equal ones the lowest
 * number, or robots would differ. Products of 32-bit numbers fit 64 bits, and a place on the spot (0 steps) beats all. */
static uint16_t choose_by_rate(const qtr_policy *policy, const qtr_joint *joint, unsigned seeker,
                               const qtr_places *choices) {
  uint16_t best = QTR_STAND_DOWN;
  uint64_t best_weight = 0;
  uint64_t best_steps = 1;
  for (uint16_t place = 0; place < policy->board.places; place++) {
    if (!qtr_places_has(choices, place)) {
      continue;
    }
    const uint64_t weight = qtr_policy_weight(policy, place);
    const uint64_t steps = qtr_board_steps(&policy->board, seeker, joint->node[seeker], place);
    if ((best != QTR_STAND_DOWN) && ((weight * best_steps) <= (best_weight * steps))) {
      continue;
    }
    best = place;
    best_weight = weight;
    best_steps = steps;
  }
  return best;
}

static bool is_seeker(const qtr_policy *policy, int seeker) {
  return (seeker >= 0) && (seeker < policy->board.seekers);
}

/* ---- the game ---- */

/* Whoever asks for a seeker that is none is told to stand, and is not off the table: no choice was due. */
uint16_t qtr_policy_choose(const qtr_policy *policy, const qtr_joint *joint, int seeker, bool *off_table) {
  qtr_places choices;
  uint16_t choice = QTR_STAND_DOWN;
  const bool may_stand_down = qtr_joint_choices(joint, &policy->board, seeker, &choices);
  /* A record that allows no such choice can only be a forged one; it counts as none. */
  const bool known = qtr_policy_lookup(policy, joint, &choice) &&
                     ((choice == QTR_STAND_DOWN) ? may_stand_down : qtr_places_has(&choices, choice));
  const bool is_one = is_seeker(policy, seeker);
  if (off_table != NULL) {
    *off_table = is_one && !known;
  }
  if (known) {
    return choice;
  }
  if (!is_one) {
    return QTR_STAND_DOWN;
  }
  return choose_by_rate(policy, joint, (unsigned)seeker, &choices);
}

/* Ends, for each time round somebody chooses, and there are no more choices than QTR_MAX_MOVES and one to stand down for
 * each seeker; or time passes to an arrival. */
uint16_t qtr_policy_play(const qtr_policy *policy, qtr_joint *joint, int seeker, qtr_steps *now, uint32_t *off_table) {
  while (is_seeker(policy, seeker) && (joint->node[seeker] != QTR_STAND_DOWN)) {
    const int chooser = qtr_joint_chooser(joint, &policy->board);
    if (chooser == QTR_NOBODY) {
      const qtr_steps passed = qtr_joint_advance(joint, &policy->board, NULL);
      if (passed == 0u) {
        break;
      }
      if (now != NULL) {
        *now += passed;
      }
      continue;
    }
    bool off = false;
    const uint16_t choice = qtr_policy_choose(policy, joint, chooser, &off);
    if (off && (off_table != NULL)) {
      ++*off_table;
    }
    (void)qtr_joint_choose(joint, &policy->board, chooser, choice);
    if (chooser == seeker) {
      return choice;
    }
  }
  return QTR_STAND_DOWN;
}
