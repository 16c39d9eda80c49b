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

/* Records are sorted by key and each key is there once: halves of [low, high), in which alone the key can be. */
bool qtr_policy_lookup(const qtr_policy *policy, const qtr_joint *joint, uint16_t *choice) {
  const qtr_record_shape *shape = &policy->records_shape;
  qtr_key key;
  make_key(&key, policy, joint);
  uint32_t low = 0;
  uint32_t high = policy->records;
  while (low < high) {
    const uint32_t middle = low + ((high - low) / 2u);
    const uint8_t *record = section_of(policy, SECTION_RECORDS) + (middle * shape->bytes);
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

/* Of a place: its weight, and the steps to it. */
typedef struct {
  uint32_t weight;
  qtr_steps steps;
} rate;

static uint64_t product(uint32_t a, uint32_t b) {
  const uint32_t low = (a & 0xFFFFu) * (b & 0xFFFFu);
  const uint32_t middle = ((a >> 16) * (b & 0xFFFFu)) + (low >> 16);
  const uint32_t other = ((a & 0xFFFFu) * (b >> 16)) + (middle & 0xFFFFu);
  const uint32_t high = ((a >> 16) * (b >> 16)) + (middle >> 16) + (other >> 16);
  return ((uint64_t)high << 32) | ((other << 16) | (low & 0xFFFFu));
}

/* As in Smith's rule for the least weighted sum of times; of equal ones the lowest number, or robots would differ. */
QTR_APART static uint16_t choose_by_rate(const qtr_policy *policy, const qtr_joint *joint, unsigned seeker,
                                         const qtr_places *choices) {
  unsigned best = QTR_STAND_DOWN;
  rate most = {0, 1};
  for (unsigned place = 0; place < policy->board.places; place++) {
    if (!place_is_in(choices, place)) {
      continue;
    }
    const rate of = {qtr_policy_weight(policy, place),
                     qtr_steps_between(&policy->board, seeker, joint->node[seeker], place)};
    if (product(of.weight, most.steps) > product(most.weight, of.steps)) {
      best = place;
      most = of;
    }
  }
  return (uint16_t)best;
}

/* ---- the game ---- */

/* A record that allows no such choice can only be a forged one; it counts as none. */
static uint16_t choose(const qtr_policy *policy, const qtr_joint *joint, unsigned seeker, bool *off_table) {
  qtr_places choices;
  uint16_t choice = QTR_STAND_DOWN;
  const bool may_stand_down = qtr_joint_options(joint, &policy->board, seeker, &choices);
  *off_table = !qtr_policy_lookup(policy, joint, &choice) ||
               ((choice == QTR_STAND_DOWN) ? !may_stand_down : !qtr_places_has(&choices, choice));
  return *off_table ? choose_by_rate(policy, joint, seeker, &choices) : choice;
}

/* Whose turn it is not may choose nothing, and stands. */
uint16_t qtr_policy_choose(const qtr_policy *policy, const qtr_joint *joint, int seeker, bool *off_table) {
  bool is_off_table = false;
  uint16_t choice = QTR_STAND_DOWN;
  if (qtr_joint_can_choose(joint, &policy->board, seeker)) {
    choice = choose(policy, joint, (unsigned)seeker, &is_off_table);
  }
  if (off_table != NULL) {
    *off_table = is_off_table;
  }
  return choice;
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
  move->choice = choose(policy, joint, (unsigned)move->seeker, &move->off_table);
  (void)qtr_joint_go(joint, &policy->board, (unsigned)move->seeker, move->choice);
  return true;
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
