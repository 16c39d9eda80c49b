#include "quarter/writer.h"

#include <stddef.h>
#include <string.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "model/doubles.h"
#include "quarter/nominal.h"
#include "quarter/policy.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "robot/layout.h"

static uint8_t encoding_of(const qtr_mission *mission) {
  const uint32_t cells = qtr_mission_cells(mission);
  for (uint32_t cell = 0; cell < cells; cell++)
    if (mission->cost[cell] > 1) return QTR_GRID_BYTES;
  return QTR_GRID_BITS;
}

static table_layout layout_of(const qtr_table_content *content) {
  const qtr_board *board = content->board;
  const table_dimensions dimensions = {.cells = qtr_mission_cells(content->mission),
                                       .records = content->record_count,
                                       .places = board->places,
                                       .starts = board->starts,
                                       .seekers = board->seekers,
                                       .key_words = board->keys.words,
                                       .grid_encoding = encoding_of(content->mission),
                                       .any_start = content->region != NULL};
  table_layout layout;
  qtr_layout_find(&layout, &dimensions);
  return layout;
}

uint32_t qtr_table_size(const qtr_table_content *content) {
  const table_layout layout = layout_of(content);
  return layout.end <= UINT32_MAX ? (uint32_t)layout.end : UINT32_MAX;
}

/* ---- header ---- */

static void write_dimensions(uint8_t *bytes, const qtr_table_content *content, uint32_t size) {
  const qtr_board *board = content->board;
  const qtr_mission *mission = content->mission;
  memcpy(bytes + QTR_POLICY_MAGIC, QTR_POLICY_MAGIC_BYTES, QTR_POLICY_VERSION);
  store16_le(bytes + QTR_POLICY_VERSION, QTR_POLICY_FORMAT);
  store16_le(bytes + QTR_POLICY_HEADER, QTR_POLICY_HEADER_BYTES);
  store32_le(bytes + QTR_POLICY_SIZE, size);
  store16_le(bytes + QTR_POLICY_COLUMNS, mission->columns);
  store16_le(bytes + QTR_POLICY_ROWS, mission->rows);
  store16_le(bytes + QTR_POLICY_PLACES, board->places);
  bytes[QTR_POLICY_SEEKERS] = board->seekers;
  bytes[QTR_POLICY_ANY_START] = content->region != NULL;
  bytes[QTR_POLICY_RULE] = board->rule;
  bytes[QTR_POLICY_OBJECTIVE] = mission->aim.kind;
  bytes[QTR_POLICY_GRID] = encoding_of(mission);
  bytes[QTR_POLICY_KEY_WORDS] = board->keys.words;
  store16_le(bytes + QTR_POLICY_STARTS, board->starts);
  store32_le(bytes + QTR_POLICY_RECORDS, content->record_count);
  store32_le(bytes + QTR_POLICY_CELL_SIZE, mission->frame.cell_size_um);
  store64_le(bytes + QTR_POLICY_ORIGIN_X, (uint64_t)mission->frame.origin_x_um);
  store64_le(bytes + QTR_POLICY_ORIGIN_Y, (uint64_t)mission->frame.origin_y_um);
}

static void write_certificate(uint8_t *bytes, const qtr_table_content *content) {
  const qtr_certificate *certificate = content->certificate;
  bytes[QTR_POLICY_CERTIFIED] = certificate->certified;
  store32_le(bytes + QTR_POLICY_PRODUCER,
             (uint32_t)QTR_VERSION_MAJOR << 16 | (uint32_t)QTR_VERSION_MINOR << 8 | (uint32_t)QTR_VERSION_PATCH);
  store64_le(bytes + QTR_POLICY_SEED, content->seed);
  store_double(bytes + QTR_POLICY_GAMMA, content->mission->aim.gamma);
  store_double(bytes + QTR_POLICY_VALUE, certificate->value);
  store_double(bytes + QTR_POLICY_TIME, certificate->expected_time);
  store_double(bytes + QTR_POLICY_BOUND, certificate->bound);
  store_double(bytes + QTR_POLICY_GAP, certificate->gap);
}

/* ---- sections ---- */

static void write_cells(uint8_t *at, const qtr_table_content *content) {
  const qtr_board *board = content->board;
  for (unsigned place = 0; place < board->places; place++, at += 4) store32_le(at, content->mission->place[place]);
  for (unsigned start = 0; start < board->starts; start++, at += 4) store32_le(at, content->start[start]);
}

static uint32_t fixed_point(double probability) {
  const double scaled = probability * 4294967296.0 + 0.5;
  if (scaled < 1.0) return 1;
  return scaled < 4294967295.0 ? (uint32_t)scaled : UINT32_MAX;
}

static void write_weights(uint8_t *at, const qtr_table_content *content) {
  for (unsigned place = 0; place < content->board->places; place++)
    store32_le(at + 4 * place, fixed_point(content->probability[place]));
}

static void write_grid(uint8_t *at, const qtr_mission *mission) {
  const uint32_t cells = qtr_mission_cells(mission);
  const uint8_t encoding = encoding_of(mission);
  for (uint32_t cell = 0; cell < cells; cell++) {
    if (encoding == QTR_GRID_BYTES)
      at[cell] = mission->cost[cell];
    else if (mission->cost[cell] > 0)
      at[cell / 8] = (uint8_t)(at[cell / 8] | 1u << cell % 8);
  }
}

static void write_regions(uint8_t *at, const qtr_table_content *content) {
  for (uint32_t cell = 0; content->region != NULL && cell < qtr_mission_cells(content->mission); cell++)
    store16_le(at + 2 * cell, content->region[cell]);
}

static void write_sections(uint8_t *bytes, const table_layout *layout, const qtr_table_content *content) {
  const qtr_board *board = content->board;
  const uint32_t records = content->record_count * record_size(board->keys.words);
  qtr_board_store_seats(board, bytes + layout->at[SECTION_SEATS]);
  write_cells(bytes + layout->at[SECTION_CELLS], content);
  write_weights(bytes + layout->at[SECTION_WEIGHTS], content);
  memcpy(bytes + layout->at[SECTION_TRAVEL], board->steps, 4u * qtr_board_nodes(board) * board->places);
  if (records > 0) memcpy(bytes + layout->at[SECTION_RECORDS], content->records, records);
  write_grid(bytes + layout->at[SECTION_GRID], content->mission);
  write_regions(bytes + layout->at[SECTION_REGIONS], content);
}

/* ---- the whole ---- */

static void seal(uint8_t *bytes, uint32_t size) {
  store32_le(bytes + QTR_POLICY_CRC, qtr_crc32_add(0, bytes + QTR_POLICY_COLUMNS, size - QTR_POLICY_COLUMNS));
}

int32_t qtr_table_write(const qtr_table_content *content, uint8_t *bytes, uint32_t size) {
  const table_layout layout = layout_of(content);
  qtr_policy policy;
  if (layout.end > size || layout.end > INT32_MAX) return QTR_ERR_SPACE;
  const uint32_t needed = (uint32_t)layout.end;
  memset(bytes, 0, needed);
  write_dimensions(bytes, content, needed);
  write_certificate(bytes, content);
  write_sections(bytes, &layout, content);
  seal(bytes, needed);
  /* The robot's own code says what the digest is: opening stops at it, and then must not. */
  int status = qtr_policy_open(&policy, bytes, needed);
  if (status != QTR_OK && status != QTR_ERR_SELFTEST) return status;
  store32_le(bytes + QTR_POLICY_DIGEST, qtr_policy_digest(&policy));
  seal(bytes, needed);
  status = qtr_policy_open(&policy, bytes, needed);
  return status == QTR_OK ? (int32_t)needed : status;
}
