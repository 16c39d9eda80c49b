#include <stddef.h>

#include "core/crc.h"
#include "quarter/claim.h"
#include "quarter/digest.h"
#include "quarter/policy.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "robot/checks.h"
#include "robot/layout.h"

/* Bytes of a format's header; 0 for a format that this build does not read. */
static uint32_t header_bytes_of(uint32_t format) {
  if (QTR_READ_FORMAT_1 && (format == 1u)) {
    return QTR_POLICY_HEADER_1;
  }
  return (format == QTR_POLICY_FORMAT) ? QTR_POLICY_HEADER_BYTES : 0;
}

/* Of `size` bytes that are there, `header` being those of a header in the table's format. */
static int check_size(const qtr_policy *policy, uint32_t size, uint32_t header) {
  if (header == 0u) {
    return QTR_ERR_FORMAT;
  }
  if ((size < header) || (policy->size > size)) {
    return QTR_ERR_TRUNCATED;
  }
  const bool may_go_on = policy->format != 1u; /* with what a host keeps there */
  const bool agrees = (policy->size >= header) && (may_go_on || (policy->size == size));
  return (agrees && (load16_le(policy->bytes + QTR_POLICY_HEADER) == header)) ? QTR_OK : QTR_ERR_CORRUPT;
}

/* The bytes are all there: sets where they lie, how many, and in which format. */
static int check_frame(qtr_policy *policy, const uint8_t *bytes, uint32_t size) {
  policy->bytes = bytes;
  if (size < QTR_POLICY_VERSION) {
    return QTR_ERR_TRUNCATED;
  }
  if (!bytes_begin(bytes, QTR_POLICY_MAGIC_BYTES)) {
    return QTR_ERR_MAGIC;
  }
  if (size < QTR_POLICY_COLUMNS) {
    return QTR_ERR_TRUNCATED;
  }
  policy->format = (uint8_t)load16_le(bytes + QTR_POLICY_VERSION);
  policy->size = load32_le(bytes + QTR_POLICY_SIZE);
  return check_size(policy, size, header_bytes_of(load16_le(bytes + QTR_POLICY_VERSION)));
}

/* Of all but what tells how many bytes it is of: those have been held against the bytes that are there. */
static int check_sum(const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const uint32_t crc = qtr_crc32_add(0, bytes + QTR_POLICY_COLUMNS, policy->size - QTR_POLICY_COLUMNS);
  return (crc == load32_le(bytes + QTR_POLICY_CRC)) ? QTR_OK : QTR_ERR_CHECKSUM;
}

/* A map of format 1 was never turned: those bytes were no part of its header. */
static void read_frame(qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const bool can_turn = policy->format != 1u;
  policy->frame.cell_size_um = load32_le(bytes + QTR_POLICY_CELL_SIZE);
  policy->frame.origin_x_um = (int64_t)load64_le(bytes + QTR_POLICY_ORIGIN_X);
  policy->frame.origin_y_um = (int64_t)load64_le(bytes + QTR_POLICY_ORIGIN_Y);
  policy->frame.cosine = can_turn ? (int32_t)load32_le(bytes + QTR_POLICY_COSINE) : 0;
  policy->frame.sine = can_turn ? (int32_t)load32_le(bytes + QTR_POLICY_SINE) : 0;
}

/* 0 of anything is a damaged table; more than the arrays hold may be a good one for another build, and is called that. */
static int read_dimensions(qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  read_frame(policy);
  policy->grid.columns = (uint16_t)load16_le(bytes + QTR_POLICY_COLUMNS);
  policy->grid.rows = (uint16_t)load16_le(bytes + QTR_POLICY_ROWS);
  policy->grid.encoding = bytes[QTR_POLICY_GRID];
  policy->board.places = (uint16_t)load16_le(bytes + QTR_POLICY_PLACES);
  policy->board.seekers = bytes[QTR_POLICY_SEEKERS];
  policy->board.starts = (uint16_t)load16_le(bytes + QTR_POLICY_STARTS);
  policy->board.rule = bytes[QTR_POLICY_RULE];
  policy->records = load32_le(bytes + QTR_POLICY_RECORDS);
  policy->board.step_bytes = (policy->format == 1u) ? 4 : bytes[QTR_POLICY_STEP_BYTES];
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  if ((cells == 0u) || (policy->board.places == 0u) || (policy->board.seekers == 0u)) {
    return QTR_ERR_CORRUPT;
  }
  if ((policy->board.starts == 0u) || (policy->board.starts > QTR_MAX_STARTS)) {
    return QTR_ERR_CORRUPT;
  }
  if ((cells > QTR_MAX_CELLS) || (policy->board.places > QTR_MAX_PLACES)) {
    return QTR_ERR_LIMIT;
  }
  policy->cell_bytes = cell_bytes_of(policy->format, cells);
  return (policy->board.seekers > QTR_MAX_SEEKERS) ? QTR_ERR_LIMIT : QTR_OK;
}

/* Of a format 1 header these are bytes of 0 that mean nothing. */
static bool spare_is_clear(const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  if (policy->format == 1u) {
    return (bytes[QTR_POLICY_STEP_BYTES] == 0u) && (load32_le(bytes + QTR_POLICY_FEATURES) == 0u) &&
           (load32_le(bytes + QTR_POLICY_STEP_TIME) == 0u);
  }
  for (unsigned at = QTR_POLICY_SPARE; at < QTR_POLICY_HEADER_BYTES; at++) {
    if (bytes[at] != 0u) {
      return false;
    }
  }
  return true;
}

/* Words that this version has no meaning for are refused, not taken for the nearest one it knows. */
static int check_words(const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const bool known = (bytes[QTR_POLICY_RULE] <= QTR_RULE_PAPER) && qtr_claim_knows(bytes[QTR_POLICY_OBJECTIVE]) &&
                     (bytes[QTR_POLICY_CERTIFIED] <= 1u) && (bytes[QTR_POLICY_ANY_START] <= 1u) &&
                     (bytes[QTR_POLICY_GRID] <= QTR_GRID_BYTES);
  if ((policy->format != 1u) && ((load32_le(bytes + QTR_POLICY_FEATURES) & ~(uint32_t)QTR_FEATURES) != 0u)) {
    return QTR_ERR_FORMAT; /* of a later version: it cannot be played without */
  }
  return (known && spare_is_clear(policy)) ? QTR_OK : QTR_ERR_CORRUPT;
}

/* Sizes are worked out of these alone, by the function that the writer lays its table out with. */
static table_dimensions dimensions_of(const qtr_policy *policy, uint32_t records) {
  const table_dimensions dimensions = {.cells = qtr_grid_cells(&policy->grid),
                                       .records = records,
                                       .features = load32_le(policy->bytes + QTR_POLICY_FEATURES),
                                       .places = policy->board.places,
                                       .starts = policy->board.starts,
                                       .format = policy->format,
                                       .seekers = policy->board.seekers,
                                       .step_bytes = policy->board.step_bytes,
                                       .record_bytes = policy->records_shape.bytes,
                                       .grid_encoding = policy->grid.encoding,
                                       .any_start = policy->bytes[QTR_POLICY_ANY_START] != 0u};
  return dimensions;
}

/* What stands before the records: who sits where, nodes, weights and travel times. How long keys are follows from it. */
static int read_board(qtr_policy *policy) {
  const table_dimensions dimensions = dimensions_of(policy, 0);
  qtr_board *board = &policy->board;
  table_layout layout;
  qtr_layout_find(&layout, &dimensions);
  if (layout.end > policy->size) {
    return QTR_ERR_CORRUPT;
  }
  qtr_board_load_seats(board, policy->bytes + layout.at[SECTION_SEATS]);
  policy->cells = policy->bytes + layout.at[SECTION_CELLS];
  policy->weights = policy->bytes + layout.at[SECTION_WEIGHTS];
  board->steps = policy->bytes + layout.at[SECTION_TRAVEL];
  if (qtr_board_init(board) != QTR_OK) {
    return QTR_ERR_CORRUPT;
  }
  return (board->keys.words == policy->bytes[QTR_POLICY_KEY_WORDS]) ? QTR_OK : QTR_ERR_SELFTEST;
}

/* The table must end where its last section does: no byte is left that nobody answers for. */
static int find_the_rest(qtr_policy *policy) {
  policy->records_shape = record_shape_of(policy->format, &policy->board);
  const table_dimensions dimensions = dimensions_of(policy, policy->records);
  table_layout layout;
  qtr_layout_find(&layout, &dimensions);
  if (layout.end != policy->size) {
    return QTR_ERR_CORRUPT;
  }
  policy->record = policy->bytes + layout.at[SECTION_RECORDS];
  policy->grid.cells = policy->bytes + layout.at[SECTION_GRID];
  policy->regions = dimensions.any_start ? (policy->bytes + layout.at[SECTION_REGIONS]) : NULL;
  policy->cleared =
      ((dimensions.features & QTR_FEATURE_CLEARED) != 0u) ? (policy->bytes + layout.at[SECTION_CLEARED]) : NULL;
  return QTR_OK;
}

/* From the outside in: nothing is read before what says that it is there, and the game is played last, over numbers that
 * are in their ranges. */
int qtr_policy_open_built(qtr_policy *policy, const void *bytes, uint32_t size, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  int status = check_frame(policy, (const uint8_t *)bytes, size);
  if (status == QTR_OK) {
    status = check_sum(policy);
  }
  if (status == QTR_OK) {
    status = check_words(policy);
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
  if (status == QTR_OK) {
    status = qtr_check_nodes(policy);
  }
  if ((status == QTR_OK) && (qtr_policy_digest(policy) != load32_le(policy->bytes + QTR_POLICY_DIGEST))) {
    status = QTR_ERR_SELFTEST;
  }
  return status;
}
