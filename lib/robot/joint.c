#include "quarter/joint.h"

#include <stddef.h>

#include "core/bytes.h"
#include "quarter/status.h"

qtr_steps qtr_board_steps(const qtr_board *board, unsigned node, unsigned place) {
  if (place >= board->places || node >= (unsigned)board->places + board->starts) return QTR_NEVER;
  return load32_le(board->steps + 4 * ((uint32_t)node * board->places + place));
}

/* ---- keys: an integer in mixed radix, grown digit by digit ---- */

static unsigned append_digit(qtr_key *key, unsigned words, uint32_t digit, uint32_t base) {
  uint64_t carry = digit;
  for (unsigned w = 0; w < words; w++) {
    carry += (uint64_t)key->word[w] * base;
    key->word[w] = (uint32_t)(carry & 0xFFFFFFFFu);
    carry >>= 32;
  }
  if (carry > 0) key->word[words++] = (uint32_t)carry;
  return words;
}

static unsigned append_bits(qtr_key *key, unsigned words, uint32_t value, unsigned bits) {
  if (bits < 32) return append_digit(key, words, value, (uint32_t)1 << bits);
  for (unsigned w = words; w > 0; w--) key->word[w] = key->word[w - 1];
  key->word[0] = value;
  return words > 0 || value > 0 ? words + 1 : 0;
}

static uint32_t node_base(const qtr_board *board) {
  return (uint32_t)board->places + board->starts + 1;
}

static unsigned append_seeker(qtr_key *key, unsigned words, const qtr_board *board, uint32_t node,
                              qtr_steps remaining) {
  const uint32_t base = node_base(board);
  words = append_digit(key, words, node < base ? node : base - 1, base);
  return append_digit(key, words, remaining, board->longest + 1);
}

static unsigned append_places(qtr_key *key, unsigned words, const qtr_board *board, const qtr_places *places) {
  for (unsigned first = 0; first < board->places; first += 32) {
    const unsigned left = board->places - first;
    words = append_bits(key, words, places->word[first / 32], left < 32 ? left : 32);
  }
  return words;
}

/* Seekers that are alike are interchangeable: sorted, who is who is gone from the key. */
static void sort_seekers(uint8_t order[QTR_MAX_SEEKERS], const qtr_joint *joint, const qtr_board *board) {
  for (uint8_t i = 0; i < board->seekers; i++) {
    uint8_t at = i;
    for (; at > 0; at--) {
      const uint8_t before = order[at - 1];
      const bool less = joint->node[i] != joint->node[before] ? joint->node[i] < joint->node[before]
                                                              : joint->remaining[i] < joint->remaining[before];
      if (!less) break;
      order[at] = before;
    }
    order[at] = i;
  }
}

void qtr_joint_key(qtr_key *key, const qtr_joint *joint, const qtr_board *board) {
  uint8_t order[QTR_MAX_SEEKERS];
  sort_seekers(order, joint, board);
  unsigned words = 0;
  for (unsigned i = 0; i < board->seekers; i++)
    words = append_seeker(key, words, board, joint->node[order[i]], joint->remaining[order[i]]);
  words = append_places(key, words, board, &joint->visited);
  while (words < board->key_words) key->word[words++] = 0;
}

/* ---- the board ---- */

static int find_longest(qtr_board *board) {
  const uint32_t nodes = (uint32_t)board->places + board->starts;
  board->longest = 0;
  for (uint32_t node = 0; node < nodes; node++) {
    for (unsigned place = 0; place < board->places; place++) {
      const qtr_steps steps = qtr_board_steps(board, node, place);
      if (steps != QTR_NEVER && steps > board->longest) board->longest = steps;
    }
  }
  /* Sums over a whole game must fit qtr_steps. */
  return board->longest > (QTR_NEVER - 1) / (board->places + 1u) ? QTR_ERR_LIMIT : QTR_OK;
}

void qtr_board_measure_keys(qtr_board *board) {
  qtr_key key;
  qtr_places all;
  unsigned words = 0;
  for (unsigned w = 0; w < QTR_PLACE_WORDS; w++) all.word[w] = UINT32_MAX;
  if (board->places % 32 != 0) all.word[board->places / 32] = ((uint32_t)1 << board->places % 32) - 1;
  for (unsigned i = 0; i < board->seekers; i++)
    words = append_seeker(&key, words, board, QTR_STAND_DOWN, board->longest);
  words = append_places(&key, words, board, &all);
  unsigned bits = 32 * words;
  for (uint32_t top = key.word[words - 1]; (top & 0x80000000u) == 0; top <<= 1) bits--;
  board->key_bits = (uint16_t)bits;
  board->key_words = (uint8_t)words;
}

static int check_numbers(const qtr_board *board) {
  if (board->places > QTR_MAX_PLACES || board->seekers > QTR_MAX_SEEKERS) return QTR_ERR_LIMIT;
  if (board->places == 0 || board->seekers == 0 || board->rule > QTR_RULE_PAPER) return QTR_ERR_ARGUMENT;
  if (board->starts == 0 || board->starts > QTR_MAX_STARTS) return QTR_ERR_ARGUMENT;
  for (unsigned i = 0; i < board->seekers; i++)
    if (board->start_of[i] >= board->starts) return QTR_ERR_ARGUMENT;
  return QTR_OK;
}

int qtr_board_init_built(qtr_board *board, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  int status = check_numbers(board);
  if (status == QTR_OK) status = find_longest(board);
  if (status == QTR_OK) qtr_board_measure_keys(board);
  return status;
}

/* ---- the game ---- */

static bool is_idle(const qtr_joint *joint, unsigned seeker) {
  return joint->node[seeker] != QTR_STAND_DOWN && joint->remaining[seeker] == 0;
}

static bool can_choose(const qtr_joint *joint, const qtr_board *board, int seeker) {
  return seeker >= 0 && seeker < board->seekers && is_idle(joint, (unsigned)seeker);
}

/* Add to `choices` (may be NULL) the unvisited places in reach of `node`, and say whether there are any. */
static bool find_in_reach(const qtr_joint *joint, const qtr_board *board, unsigned node, bool unbound_only,
                          qtr_places *choices) {
  bool any = false;
  for (unsigned place = 0; place < board->places && !(any && choices == NULL); place++) {
    if (qtr_places_has(&joint->visited, place)) continue;
    if (unbound_only && qtr_places_has(&joint->bound, place)) continue;
    if (qtr_board_steps(board, node, place) == QTR_NEVER) continue;
    if (choices != NULL) qtr_places_add(choices, place);
    any = true;
  }
  return any;
}

/* The places that an idle seeker at `node` may choose, and whether there are any. By Table 1 those that others are
 * bound for come in when fewer places than seekers are left; so too when a seeker has no others within its reach. */
static bool find_choices(const qtr_joint *joint, const qtr_board *board, unsigned node, qtr_places *choices) {
  const bool may_follow = board->rule == QTR_RULE_PAPER;
  if (may_follow && joint->unvisited < board->seekers) return find_in_reach(joint, board, node, false, choices);
  if (find_in_reach(joint, board, node, true, choices)) return true;
  return may_follow && find_in_reach(joint, board, node, false, choices);
}

/* Nothing comes back within a seeker's reach later: whoever has nothing to choose is out of the game. */
static void stand_down_the_useless(qtr_joint *joint, const qtr_board *board) {
  for (unsigned i = 0; i < board->seekers; i++)
    if (is_idle(joint, i) && !find_choices(joint, board, joint->node[i], NULL)) joint->node[i] = QTR_STAND_DOWN;
}

static void visit(qtr_joint *joint, unsigned place) {
  qtr_places_add(&joint->visited, place);
  qtr_places_remove(&joint->bound, place);
  joint->unvisited--;
}

void qtr_joint_start(qtr_joint *joint, const qtr_board *board, const qtr_places *cleared) {
  qtr_places_clear(&joint->visited);
  qtr_places_clear(&joint->bound);
  joint->unvisited = board->places;
  for (unsigned place = 0; cleared != NULL && place < board->places; place++)
    if (qtr_places_has(cleared, place)) visit(joint, place);
  for (unsigned i = 0; i < board->seekers; i++) {
    joint->node[i] = (uint16_t)(board->places + board->start_of[i]);
    joint->remaining[i] = 0;
  }
  stand_down_the_useless(joint, board);
}

int qtr_joint_chooser(const qtr_joint *joint, const qtr_board *board) {
  int chooser = QTR_NOBODY;
  for (int i = 0; i < board->seekers; i++)
    if (is_idle(joint, (unsigned)i) && (chooser == QTR_NOBODY || joint->node[i] < joint->node[chooser])) chooser = i;
  return chooser;
}

static bool other_can_reach(const qtr_joint *joint, const qtr_board *board, int seeker, unsigned place) {
  for (int i = 0; i < board->seekers; i++) {
    if (i == seeker || joint->node[i] == QTR_STAND_DOWN) continue;
    if (qtr_board_steps(board, joint->node[i], place) != QTR_NEVER) return true;
  }
  return false;
}

bool qtr_joint_choices(const qtr_joint *joint, const qtr_board *board, int seeker, qtr_places *choices) {
  qtr_places_clear(choices);
  if (!can_choose(joint, board, seeker) || !find_choices(joint, board, joint->node[seeker], choices)) return false;
  if (board->rule == QTR_RULE_PAPER) return false;
  /* Ways go both ways, so whoever can reach one of these places can reach them all. */
  unsigned place = 0;
  while (!qtr_places_has(choices, place)) place++;
  return other_can_reach(joint, board, seeker, place);
}

bool qtr_joint_choose(qtr_joint *joint, const qtr_board *board, int seeker, uint16_t choice) {
  if (!can_choose(joint, board, seeker)) return false;
  if (choice == QTR_STAND_DOWN) {
    joint->node[seeker] = QTR_STAND_DOWN;
    return false;
  }
  const qtr_steps steps = qtr_board_steps(board, joint->node[seeker], choice);
  if (steps == QTR_NEVER || qtr_places_has(&joint->visited, choice)) return false;
  joint->node[seeker] = choice;
  joint->remaining[seeker] = steps;
  if (steps == 0)
    visit(joint, choice);
  else
    qtr_places_add(&joint->bound, choice);
  stand_down_the_useless(joint, board);
  return steps == 0;
}

static qtr_steps least_remaining(const qtr_joint *joint, const qtr_board *board) {
  qtr_steps least = QTR_NEVER;
  for (unsigned i = 0; i < board->seekers; i++)
    if (joint->remaining[i] > 0 && joint->remaining[i] < least) least = joint->remaining[i];
  return least;
}

qtr_steps qtr_joint_advance(qtr_joint *joint, const qtr_board *board, qtr_places *arrived) {
  const qtr_steps least = least_remaining(joint, board);
  if (joint->unvisited == 0 || least == QTR_NEVER) return 0;
  for (unsigned i = 0; i < board->seekers; i++) {
    if (joint->remaining[i] == 0) continue;
    joint->remaining[i] -= least;
    if (joint->remaining[i] > 0 || qtr_places_has(&joint->visited, joint->node[i])) continue;
    visit(joint, joint->node[i]);
    if (arrived != NULL) qtr_places_add(arrived, joint->node[i]);
  }
  stand_down_the_useless(joint, board);
  return least;
}
