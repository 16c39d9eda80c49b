#include <stddef.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/digest.h"
#include "quarter/policy.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "robot/layout.h"

/* Bytes of a format's header; 0 for a format that this build does not read. */
static uint32_t header_bytes_of(unsigned format) {
  if (is_format_1(format)) {
    return QTR_POLICY_HEADER_1;
  }
  return (format == QTR_POLICY_FORMAT) ? QTR_POLICY_HEADER_BYTES : 0;
}

/* A header in a format that is read: sets which, and how many bytes it says there are. */
static int read_format(qtr_policy *policy, uint32_t size) {
  const uint8_t *bytes = policy->bytes;
  if ((size >= QTR_POLICY_VERSION) && (qtr_load32(bytes) != QTR_POLICY_MAGIC_WORD)) {
    return QTR_ERR_MAGIC;
  }
  if (size < QTR_POLICY_COLUMNS) {
    return QTR_ERR_TRUNCATED;
  }
  const unsigned format = (unsigned)qtr_load16(bytes + QTR_POLICY_VERSION);
  policy->format = (uint8_t)format;
  policy->size = qtr_load32(bytes + QTR_POLICY_SIZE);
  return (header_bytes_of(format) > 0u) ? QTR_OK : QTR_ERR_FORMAT;
}

/* All of it is there. Behind a table a host may keep names, but not behind one of format 1. */
static int check_size(const qtr_policy *policy, uint32_t size) {
  const uint32_t header = header_bytes_of(policy->format);
  if ((size < header) || (policy->size > size)) {
    return QTR_ERR_TRUNCATED;
  }
  if ((policy->size < header) || (qtr_load16(policy->bytes + QTR_POLICY_HEADER) != header)) {
    return QTR_ERR_CORRUPT;
  }
  return (is_format_1(policy->format) && (policy->size != size)) ? QTR_ERR_CORRUPT : QTR_OK;
}

/* Of all but what tells how many bytes it is of: those have been held against the bytes that are there. */
static int check_sum(const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const uint32_t crc = qtr_crc32_add(0, bytes + QTR_POLICY_COLUMNS, policy->size - QTR_POLICY_COLUMNS);
  return (crc == qtr_load32(bytes + QTR_POLICY_CRC)) ? QTR_OK : QTR_ERR_CHECKSUM;
}

/* What this version does not know it cannot play without. In format 1 these bits are bytes of 0 that mean nothing. */
static int read_features(qtr_policy *policy) {
  const uint32_t features = qtr_load32(policy->bytes + QTR_POLICY_FEATURES);
  policy->any_start = policy->bytes[QTR_POLICY_ANY_START] != 0u;
  policy->features = (uint8_t)(features & 0xFFu);
  if (features <= (uint32_t)QTR_FEATURES) {
    return QTR_OK;
  }
  return is_format_1(policy->format) ? QTR_ERR_CORRUPT : QTR_ERR_FORMAT;
}

/* What the header says of terms: how many classes, and what the section of terms holds. */
static void read_terms(qtr_policy *policy) {
#if QTR_TERMS
  qtr_terms *terms = &policy->board.terms;
  if ((policy->features & QTR_FEATURE_TERMS) != 0) {
    const uint8_t *bytes = policy->bytes;
    policy->terms = bytes[QTR_POLICY_TERMS];
    policy->board.classes = bytes[QTR_POLICY_CLASSES];
    terms->clock = qtr_load32(bytes + QTR_POLICY_CLOCK);
    terms->rules = policy->terms & (uint8_t)QTR_TERM_RULES;
  }
#else
  (void)policy;
#endif
}

/* And what that section holds, one after another as there is. */
static void find_terms(qtr_policy *policy) {
#if QTR_TERMS
  qtr_board *board = &policy->board;
  qtr_terms *terms = &board->terms;
  if ((policy->features & QTR_FEATURE_TERMS) == 0) {
    return;
  }
  const uint8_t *at = section_of(policy, SECTION_TERMS) + QTR_TERMS_CLASS +
                      (QTR_TERMS_CLASS_BYTES * (uint32_t)qtr_board_classes(board));
  bytes_copy(board->class_of, at, board->seekers);
  at += board->seekers;
  if ((policy->terms & (unsigned)QTR_TERM_READY) != 0u) {
    terms->ready = at;
    at += 4u * board->seekers;
  }
  if ((policy->terms & (unsigned)QTR_TERM_END) != 0u) {
    terms->end = at;
    terms->home = at + (4u * board->seekers);
    at = terms->home + ((uint32_t)board->step_bytes * board->places * board->seekers);
  }
  if ((policy->terms & (unsigned)QTR_TERM_LOOKS) != 0u) {
    terms->look_of = at;
  }
#else
  (void)policy;
#endif
}

/* 0 of anything is a damaged table; more than the arrays hold may be a good one for another build, and is called
 * that. */
static int read_dimensions(qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  qtr_board *board = &policy->board;
  policy->grid.columns = (uint16_t)qtr_load16(bytes + QTR_POLICY_COLUMNS);
  policy->grid.rows = (uint16_t)qtr_load16(bytes + QTR_POLICY_ROWS);
  policy->grid.encoding = bytes[QTR_POLICY_GRID];
  policy->records = qtr_load32(bytes + QTR_POLICY_RECORDS);
  read_terms(policy);
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  board->places = (uint16_t)qtr_load16(bytes + QTR_POLICY_PLACES);
  board->seekers = bytes[QTR_POLICY_SEEKERS];
  board->starts = (uint16_t)qtr_load16(bytes + QTR_POLICY_STARTS);
  board->rule = bytes[QTR_POLICY_RULE];
  board->step_bytes = is_format_1(policy->format) ? 4 : bytes[QTR_POLICY_STEP_BYTES];
  const int status = (cells == 0u) ? QTR_ERR_ARGUMENT : qtr_board_check(board);
  if (status == QTR_ERR_ARGUMENT) {
    return QTR_ERR_CORRUPT;
  }
  return (cells > QTR_MAX_CELLS) ? QTR_ERR_LIMIT : status;
}

/* What stands before the records: who sits where, nodes, weights, travel times and terms. How long keys are follows
 * from it. */
static int read_board(qtr_policy *policy) {
  qtr_board *board = &policy->board;
  if (qtr_layout_find(policy) > policy->size) {
    return QTR_ERR_CORRUPT;
  }
  qtr_board_load_seats(board, section_of(policy, SECTION_SEATS));
  board->steps = section_of(policy, SECTION_TRAVEL);
  find_terms(policy);
  if (qtr_board_derive(board) != QTR_OK) {
    return QTR_ERR_CORRUPT;
  }
  policy->records_shape = record_shape_of(policy->format, board);
  const unsigned key_words = is_format_1(policy->format) ? (policy->records_shape.key_bytes / 4u) : board->keys.words;
  return (key_words == policy->bytes[QTR_POLICY_KEY_WORDS]) ? QTR_OK : QTR_ERR_SELFTEST;
}

/* The table must end where its last section does: no byte is left that nobody answers for. */
static int find_the_rest(qtr_policy *policy) {
  if (qtr_layout_find(policy) != policy->size) {
    return QTR_ERR_CORRUPT;
  }
  policy->grid.cells = section_of(policy, SECTION_GRID);
  return QTR_OK;
}

/* From the outside in: nothing is read before what says that it is there, and the game is played last, over numbers
 * that are in their ranges. */
int qtr_policy_open_built(qtr_policy *policy, const void *bytes, uint32_t size, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  bytes_clear(policy, (uint32_t)sizeof *policy);
  policy->bytes = (const uint8_t *)bytes;
  int status = read_format(policy, size);
  if (status == QTR_OK) {
    status = check_size(policy, size);
  }
  if (status == QTR_OK) {
    status = check_sum(policy);
  }
  if (status == QTR_OK) {
    status = read_features(policy);
  }
  if (status == QTR_OK) {
    status = read_dimensions(policy);
  }
  if (status == QTR_OK) {
    status = read_board(policy);
  }
  if (status == QTR_OK) {
    status = find_the_rest(policy);
  }
  if ((status == QTR_OK) && (qtr_policy_digest(policy) != qtr_load32(policy->bytes + QTR_POLICY_DIGEST))) {
    status = QTR_ERR_SELFTEST;
  }
  return status;
}
