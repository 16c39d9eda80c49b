#include <stddef.h>
#include <string.h>

#include "core/crc.h"
#include "quarter/claim.h"
#include "quarter/nominal.h"
#include "quarter/policy.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "robot/checks.h"
#include "robot/layout.h"

static int check_frame(const uint8_t *bytes, uint32_t size) {
  if (size < QTR_POLICY_VERSION) return QTR_ERR_TRUNCATED;
  if (memcmp(bytes, QTR_POLICY_MAGIC_BYTES, QTR_POLICY_VERSION) != 0) return QTR_ERR_MAGIC;
  if (size < QTR_POLICY_HEADER_BYTES) return QTR_ERR_TRUNCATED;
  if (load16_le(bytes + QTR_POLICY_VERSION) != QTR_POLICY_FORMAT) return QTR_ERR_FORMAT;
  if (load16_le(bytes + QTR_POLICY_HEADER) != QTR_POLICY_HEADER_BYTES) return QTR_ERR_CORRUPT;
  const uint32_t whole = load32_le(bytes + QTR_POLICY_SIZE);
  if (whole > size) return QTR_ERR_TRUNCATED;
  if (whole != size) return QTR_ERR_CORRUPT;
  const uint32_t crc = qtr_crc32_add(0, bytes + QTR_POLICY_COLUMNS, size - QTR_POLICY_COLUMNS);
  return crc == load32_le(bytes + QTR_POLICY_CRC) ? QTR_OK : QTR_ERR_CHECKSUM;
}

static int read_dimensions(qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  policy->grid.columns = (uint16_t)load16_le(bytes + QTR_POLICY_COLUMNS);
  policy->grid.rows = (uint16_t)load16_le(bytes + QTR_POLICY_ROWS);
  policy->grid.encoding = bytes[QTR_POLICY_GRID];
  policy->board.places = (uint16_t)load16_le(bytes + QTR_POLICY_PLACES);
  policy->board.seekers = bytes[QTR_POLICY_SEEKERS];
  policy->board.starts = (uint16_t)load16_le(bytes + QTR_POLICY_STARTS);
  policy->board.rule = bytes[QTR_POLICY_RULE];
  policy->records = load32_le(bytes + QTR_POLICY_RECORDS);
  policy->frame.cell_size_um = load32_le(bytes + QTR_POLICY_CELL_SIZE);
  policy->frame.origin_x_um = (int64_t)load64_le(bytes + QTR_POLICY_ORIGIN_X);
  policy->frame.origin_y_um = (int64_t)load64_le(bytes + QTR_POLICY_ORIGIN_Y);
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  if (cells == 0 || policy->board.places == 0 || policy->board.seekers == 0) return QTR_ERR_CORRUPT;
  if (policy->board.starts == 0 || policy->board.starts > QTR_MAX_STARTS) return QTR_ERR_CORRUPT;
  if (cells > QTR_MAX_CELLS || policy->board.places > QTR_MAX_PLACES) return QTR_ERR_LIMIT;
  return policy->board.seekers > QTR_MAX_SEEKERS ? QTR_ERR_LIMIT : QTR_OK;
}

static int check_words(const uint8_t *bytes) {
  const bool known = bytes[QTR_POLICY_RULE] <= QTR_RULE_PAPER && qtr_claim_knows(bytes[QTR_POLICY_OBJECTIVE]) &&
                     bytes[QTR_POLICY_CERTIFIED] <= 1 && bytes[QTR_POLICY_ANY_START] <= 1 &&
                     bytes[QTR_POLICY_GRID] <= QTR_GRID_BYTES;
  const bool reserved = bytes[QTR_POLICY_KEY_WORDS + 1] != 0 || load32_le(bytes + QTR_POLICY_PRODUCER + 4) != 0 ||
                        load32_le(bytes + QTR_POLICY_CELL_SIZE + 4) != 0;
  return known && !reserved ? QTR_OK : QTR_ERR_CORRUPT;
}

static table_dimensions dimensions_of(const qtr_policy *policy, uint32_t records) {
  const table_dimensions dimensions = {.cells = qtr_grid_cells(&policy->grid),
                                       .records = records,
                                       .places = policy->board.places,
                                       .starts = policy->board.starts,
                                       .seekers = policy->board.seekers,
                                       .key_words = policy->board.keys.words,
                                       .grid_encoding = policy->grid.encoding,
                                       .any_start = policy->bytes[QTR_POLICY_ANY_START] != 0};
  return dimensions;
}

/* What stands before the records: who sits where, nodes, weights and travel times. How long keys are follows from it. */
static int read_board(qtr_policy *policy, uint32_t size) {
  const table_dimensions dimensions = dimensions_of(policy, 0);
  qtr_board *board = &policy->board;
  table_layout layout;
  qtr_layout_find(&layout, &dimensions);
  if (layout.end > size) return QTR_ERR_CORRUPT;
  qtr_board_load_seats(board, policy->bytes + layout.at[SECTION_SEATS]);
  policy->cells = policy->bytes + layout.at[SECTION_CELLS];
  policy->weights = policy->bytes + layout.at[SECTION_WEIGHTS];
  board->steps = policy->bytes + layout.at[SECTION_TRAVEL];
  if (qtr_board_init(board) != QTR_OK) return QTR_ERR_CORRUPT;
  return board->keys.words == policy->bytes[QTR_POLICY_KEY_WORDS] ? QTR_OK : QTR_ERR_SELFTEST;
}

static int find_the_rest(qtr_policy *policy, uint32_t size) {
  const table_dimensions dimensions = dimensions_of(policy, policy->records);
  table_layout layout;
  qtr_layout_find(&layout, &dimensions);
  if (layout.end != size) return QTR_ERR_CORRUPT;
  policy->record = policy->bytes + layout.at[SECTION_RECORDS];
  policy->grid.cells = policy->bytes + layout.at[SECTION_GRID];
  policy->regions = dimensions.any_start ? policy->bytes + layout.at[SECTION_REGIONS] : NULL;
  return QTR_OK;
}

static int check_content(const qtr_policy *policy) {
  int status = qtr_check_sections(policy);
  if (status == QTR_OK) status = qtr_check_travel(policy);
  if (status == QTR_OK) status = qtr_check_certificate(policy);
  return status;
}

int qtr_policy_open_built(qtr_policy *policy, const void *bytes, uint32_t size, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  policy->bytes = bytes;
  int status = check_frame(bytes, size);
  if (status == QTR_OK) status = check_words(bytes);
  if (status == QTR_OK) status = read_dimensions(policy);
  if (status == QTR_OK) status = read_board(policy, size);
  if (status == QTR_OK) status = find_the_rest(policy, size);
  if (status == QTR_OK) status = check_content(policy);
  if (status == QTR_OK && qtr_policy_digest(policy) != load32_le(policy->bytes + QTR_POLICY_DIGEST))
    status = QTR_ERR_SELFTEST;
  return status;
}
