/* What of a seeker outlasts a reset. All else follows from the table, so a restart plays the division anew from the
 * very same starts and is told again what was known (tests/inside/test_incidents.c).
 *
 *   0  u8   'Q'
 *   1  u8   format, 1
 *   2  u8   self
 *   3  u8   1: found
 *   4  u32  identity of the division
 *   8  u32  run
 *  12  u16  places h
 *  14  u8   seekers k
 *  15  u8   0
 *  16  k u16: each seeker's start
 *      bits of h places each: cleared beforehand, visited, blocked; of k seekers each: territories done, seekers lost
 *      u32  CRC-32 of all before
 */
#include <stddef.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/seeker.h"
#include "quarter/status.h"
#include "robot/bits.h"

enum { MARK = 'Q', FORMAT = 1, SELF = 2, FOUND = 3, IDENTITY = 4, RUN = 8, PLACES = 12, SEEKERS = 14, STARTS = 16 };

static uint32_t size_of(const qtr_board *board) {
  return STARTS + (2u * board->seekers) + (3u * bits_size(board->places)) + (2u * bits_size(board->seekers)) + 4u;
}

static uint8_t *store_bits(uint8_t *bytes, const uint32_t *word, unsigned members) {
  for (uint32_t i = 0; i < bits_size(members); i++) {
    *bytes++ = bits_byte(word, i);
  }
  return bytes;
}

/* Of the last byte, only the members that there are. */
static const uint8_t *load_bits(const uint8_t *bytes, uint32_t *word, unsigned members) {
  for (unsigned i = 0; i < bits_size(members); i++) {
    const unsigned here = members - (8u * i);
    bits_add(word, i, (uint8_t)((here < 8u) ? (*bytes & ((1u << here) - 1u)) : *bytes));
    bytes++;
  }
  return bytes;
}

int32_t qtr_seeker_save(const qtr_seeker *seeker, uint8_t *bytes, uint32_t size) {
  const qtr_board *board = &seeker->policy->board;
  const uint32_t needed = size_of(board);
  if (size < needed) {
    return QTR_ERR_SPACE;
  }
  bytes[0] = MARK;
  bytes[1] = FORMAT;
  bytes[SELF] = seeker->self;
  bytes[FOUND] = seeker->found;
  qtr_store32(bytes + IDENTITY, seeker->identity);
  qtr_store32(bytes + RUN, seeker->run);
  qtr_store16(bytes + PLACES, board->places);
  bytes[SEEKERS] = board->seekers;
  bytes[SEEKERS + 1] = 0;
  uint8_t *at = bytes + STARTS;
  for (unsigned i = 0; i < board->seekers; i++, at += 2u) {
    qtr_store16(at, seeker->deployment.start_of[i]);
  }
  at = store_bits(at, seeker->deployment.cleared.word, board->places);
  at = store_bits(at, seeker->visited.word, board->places);
  /* On the last round, what was blocked before it: that is tried once more after a reset, too. */
  at = store_bits(at, (seeker->last_round ? &seeker->retry : &seeker->blocked)->word, board->places);
  at = store_bits(at, seeker->done.word, board->seekers);
  at = store_bits(at, seeker->lost.word, board->seekers);
  qtr_store32(at, qtr_crc32_add(0, bytes, needed - 4u));
  return (int32_t)needed;
}

/* Whole, and of this robot and a table of these dimensions. */
static bool is_sound(const qtr_board *board, unsigned self, const uint8_t *bytes, uint32_t size) {
  const uint32_t needed = size_of(board);
  if ((size < needed) || (bytes[0] != MARK) || (bytes[1] != FORMAT)) {
    return false;
  }
  if (qtr_load32(bytes + needed - 4u) != qtr_crc32_add(0, bytes, needed - 4u)) {
    return false;
  }
  return (bytes[SELF] == self) && (qtr_load16(bytes + PLACES) == board->places) && (bytes[SEEKERS] == board->seekers);
}

/* The deployment of then. False if it is none of this policy's. */
static bool load_deployment(qtr_deployment *deployment, const qtr_policy *policy, const uint8_t *bytes) {
  const qtr_board *board = &policy->board;
  for (unsigned i = 0; i < board->seekers; i++) {
    const uint32_t start = qtr_load16(bytes + STARTS + (2u * i));
    if (start >= board->starts) {
      return false;
    }
    deployment->start_of[i] = (uint16_t)start;
  }
  qtr_places_clear(&deployment->cleared);
  (void)load_bits(bytes + STARTS + (2u * board->seekers), deployment->cleared.word, board->places);
  return qtr_deployment_identity(deployment, policy) == qtr_load32(bytes + IDENTITY);
}

int qtr_seeker_restore_built(qtr_seeker *seeker, const qtr_policy *policy, unsigned self, const uint8_t *bytes,
                             uint32_t size, uint32_t config_id) {
  const qtr_board *board = &policy->board;
  qtr_deployment deployment;
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  if ((self >= board->seekers) || !is_sound(board, self, bytes, size)) {
    return QTR_ERR_SAVE;
  }
  if (!load_deployment(&deployment, policy, bytes)) {
    return QTR_ERR_SAVE;
  }
  const int status = qtr_seeker_init(seeker, policy, self, &deployment, qtr_load32(bytes + RUN));
  if (status != QTR_OK) {
    return status;
  }
  const uint8_t *at = bytes + STARTS + (2u * board->seekers) + bits_size(board->places);
  at = load_bits(at, seeker->visited.word, board->places);
  at = load_bits(at, seeker->blocked.word, board->places);
  at = load_bits(at, seeker->done.word, board->seekers);
  (void)load_bits(at, seeker->lost.word, board->seekers);
  seeker->found = bytes[FOUND] != 0u;
  seeker->found_unsaid = seeker->found;
  return QTR_OK;
}
