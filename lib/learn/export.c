#include "quarter/export.h"

#include <stddef.h>
#include <string.h>

#include "bytes.h"
#include "crc.h"
#include "quarter/policy.h"
#include "quarter/status.h"

static uint8_t encoding_of(const qtr_mission *mission) {
  const uint32_t cells = (uint32_t)mission->columns * mission->rows;
  for (uint32_t cell = 0; cell < cells; cell++)
    if (mission->cost[cell] > 1) return QTR_GRID_BYTES;
  return QTR_GRID_BITS;
}

static uint32_t record_bytes(const qtr_board *board) {
  return 4u * board->key_words + 4u;
}

uint32_t qtr_export_size(const qtr_learner *learner) {
  const qtr_board *board = &learner->game->board;
  const qtr_mission *mission = learner->game->mission;
  const uint32_t nodes = (uint32_t)board->places + board->starts;
  return QTR_POLICY_HEADER_BYTES + (board->seekers + 3u) / 4u * 4u + 4u * nodes + 4u * board->places +
         4u * nodes * board->places + learner->best.choices * record_bytes(board) +
         qtr_grid_size((uint32_t)mission->columns * mission->rows, encoding_of(mission));
}

/* ---- header ---- */

static void store_double(uint8_t *bytes, double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  store64_le(bytes, bits);
}

static void write_dimensions(uint8_t *bytes, const qtr_learner *learner, uint32_t size) {
  const qtr_board *board = &learner->game->board;
  const qtr_mission *mission = learner->game->mission;
  memcpy(bytes + QTR_POLICY_MAGIC, "QTRP", 4);
  store16_le(bytes + QTR_POLICY_VERSION, QTR_POLICY_FORMAT);
  store16_le(bytes + QTR_POLICY_HEADER, QTR_POLICY_HEADER_BYTES);
  store32_le(bytes + QTR_POLICY_SIZE, size);
  store16_le(bytes + QTR_POLICY_COLUMNS, mission->columns);
  store16_le(bytes + QTR_POLICY_ROWS, mission->rows);
  store16_le(bytes + QTR_POLICY_PLACES, board->places);
  bytes[QTR_POLICY_SEEKERS] = board->seekers;
  bytes[QTR_POLICY_STARTS] = board->starts;
  bytes[QTR_POLICY_RULE] = board->rule;
  bytes[QTR_POLICY_OBJECTIVE] = mission->objective;
  bytes[QTR_POLICY_GRID] = encoding_of(mission);
  bytes[QTR_POLICY_KEY_WORDS] = board->key_words;
  store32_le(bytes + QTR_POLICY_RECORDS, learner->best.choices);
  store32_le(bytes + QTR_POLICY_CELL_SIZE, mission->frame.cell_size_um);
  store64_le(bytes + QTR_POLICY_ORIGIN_X, (uint64_t)mission->frame.origin_x_um);
  store64_le(bytes + QTR_POLICY_ORIGIN_Y, (uint64_t)mission->frame.origin_y_um);
}

static void write_certificate(uint8_t *bytes, const qtr_learner *learner) {
  qtr_certificate certificate;
  qtr_learner_certificate(learner, &certificate);
  bytes[QTR_POLICY_CERTIFIED] = certificate.certified;
  store32_le(bytes + QTR_POLICY_PRODUCER,
             (uint32_t)QTR_VERSION_MAJOR << 16 | (uint32_t)QTR_VERSION_MINOR << 8 | (uint32_t)QTR_VERSION_PATCH);
  store64_le(bytes + QTR_POLICY_SEED, learner->config.seed);
  store_double(bytes + QTR_POLICY_GAMMA, learner->game->mission->gamma);
  store_double(bytes + QTR_POLICY_VALUE, certificate.value);
  store_double(bytes + QTR_POLICY_TIME, certificate.expected_time);
  store_double(bytes + QTR_POLICY_BOUND, certificate.bound);
  store_double(bytes + QTR_POLICY_GAP, certificate.gap);
}

/* ---- sections: each returns where the next one begins ---- */

static uint32_t fixed_point(double probability) {
  const double scaled = probability * 4294967296.0 + 0.5;
  if (scaled < 1.0) return 1;
  return scaled < 4294967295.0 ? (uint32_t)scaled : UINT32_MAX;
}

static uint8_t *write_nodes(uint8_t *at, const qtr_game *game) {
  const qtr_board *board = &game->board;
  memcpy(at, board->start_of, board->seekers);
  at += (board->seekers + 3u) / 4u * 4u;
  for (unsigned place = 0; place < board->places; place++, at += 4) store32_le(at, game->mission->place[place]);
  for (unsigned start = 0; start < board->starts; start++, at += 4)
    store32_le(at, game->mission->start[game->first_at[start]]);
  for (unsigned place = 0; place < board->places; place++, at += 4)
    store32_le(at, fixed_point(game->probability[place]));
  return at;
}

static uint8_t *write_travel(uint8_t *at, const qtr_game *game) {
  const uint32_t bytes = 4u * ((uint32_t)game->board.places + game->board.starts) * game->board.places;
  memcpy(at, game->steps, bytes);
  return at + bytes;
}

static int compare_records(const uint8_t *a, const uint8_t *b, unsigned words) {
  for (unsigned w = words; w-- > 0;) {
    const uint32_t x = load32_le(a + 4 * w);
    const uint32_t y = load32_le(b + 4 * w);
    if (x != y) return x < y ? -1 : 1;
  }
  return 0;
}

/* Sorted by insertion: a game has few choices. */
static void insert_record(uint8_t *records, unsigned count, const uint8_t *record, const qtr_board *board) {
  const uint32_t bytes = record_bytes(board);
  uint8_t *at = records + count * bytes;
  while (at > records && compare_records(record, at - bytes, board->key_words) < 0) {
    memcpy(at, at - bytes, bytes);
    at -= bytes;
  }
  memcpy(at, record, bytes);
}

/* The states that the best game meets, each with the choice made there. */
static uint8_t *write_records(uint8_t *records, const qtr_learner *learner) {
  const qtr_game *game = learner->game;
  const qtr_play *best = &learner->best;
  qtr_state state;
  qtr_outcome outcome;
  qtr_game_start(game, &state);
  for (unsigned i = 0; i < best->choices; i++) {
    uint8_t record[4 * (QTR_KEY_WORDS + 1)] = {0};
    qtr_key key;
    qtr_joint_key(&key, &state.joint, &game->board);
    for (unsigned w = 0; w < game->board.key_words; w++) store32_le(record + 4 * w, key.word[w]);
    store16_le(record + 4 * game->board.key_words, best->choice[i]);
    insert_record(records, i, record, &game->board);
    qtr_game_choose(game, &state, best->seeker[i], best->choice[i]);
    qtr_game_pass(game, &state, &outcome);
  }
  return records + best->choices * record_bytes(&game->board);
}

static void write_grid(uint8_t *at, const qtr_mission *mission) {
  const uint32_t cells = (uint32_t)mission->columns * mission->rows;
  const uint8_t encoding = encoding_of(mission);
  memset(at, 0, qtr_grid_size(cells, encoding));
  for (uint32_t cell = 0; cell < cells; cell++) {
    if (encoding == QTR_GRID_BYTES)
      at[cell] = mission->cost[cell];
    else if (mission->cost[cell] > 0)
      at[cell / 8] = (uint8_t)(at[cell / 8] | 1u << cell % 8);
  }
}

/* ---- the whole ---- */

static void seal(uint8_t *bytes, uint32_t size) {
  store32_le(bytes + QTR_POLICY_CRC, crc32_add(0, bytes + QTR_POLICY_COLUMNS, size - QTR_POLICY_COLUMNS));
}

int32_t qtr_export(const qtr_learner *learner, uint8_t *bytes, uint32_t size) {
  const uint32_t needed = qtr_export_size(learner);
  qtr_policy policy;
  if (size < needed || needed > INT32_MAX) return QTR_ERR_SPACE;
  memset(bytes, 0, needed);
  write_dimensions(bytes, learner, needed);
  write_certificate(bytes, learner);
  uint8_t *at = write_nodes(bytes + QTR_POLICY_HEADER_BYTES, learner->game);
  at = write_travel(at, learner->game);
  at = write_records(at, learner);
  write_grid(at, learner->game->mission);
  seal(bytes, needed);
  /* The robot's own code says what the digest is: opening stops at it, and then must not. */
  int status = qtr_policy_open(&policy, bytes, needed);
  if (status != QTR_OK && status != QTR_ERR_SELFTEST) return status;
  store32_le(bytes + QTR_POLICY_DIGEST, qtr_policy_digest(&policy));
  seal(bytes, needed);
  status = qtr_policy_open(&policy, bytes, needed);
  return status == QTR_OK ? (int32_t)needed : status;
}
