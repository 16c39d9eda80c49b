#include "quarter/policy.h"

#include <stddef.h>
#include <string.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/status.h"

static const uint8_t magic[4] = {'Q', 'T', 'R', 'P'};

static uint32_t record_bytes(const qtr_policy *policy) {
  return 4u * policy->board.keys.words + 4u;
}

/* ---- opening ---- */

static int check_frame(const uint8_t *bytes, uint32_t size) {
  if (size < sizeof magic) return QTR_ERR_TRUNCATED;
  if (memcmp(bytes, magic, sizeof magic) != 0) return QTR_ERR_MAGIC;
  if (size < QTR_POLICY_HEADER_BYTES) return QTR_ERR_TRUNCATED;
  if (load16_le(bytes + QTR_POLICY_VERSION) != QTR_POLICY_FORMAT) return QTR_ERR_FORMAT;
  if (load16_le(bytes + QTR_POLICY_HEADER) != QTR_POLICY_HEADER_BYTES) return QTR_ERR_CORRUPT;
  const uint32_t whole = load32_le(bytes + QTR_POLICY_SIZE);
  if (whole > size) return QTR_ERR_TRUNCATED;
  if (whole != size) return QTR_ERR_CORRUPT;
  const uint32_t crc = crc32_add(0, bytes + QTR_POLICY_COLUMNS, size - QTR_POLICY_COLUMNS);
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
  const bool known = bytes[QTR_POLICY_RULE] <= QTR_RULE_PAPER && bytes[QTR_POLICY_OBJECTIVE] <= 1 &&
                     bytes[QTR_POLICY_CERTIFIED] <= 1 && bytes[QTR_POLICY_ANY_START] <= 1 &&
                     bytes[QTR_POLICY_GRID] <= QTR_GRID_BYTES;
  const bool reserved = bytes[QTR_POLICY_KEY_WORDS + 1] != 0 || load32_le(bytes + QTR_POLICY_PRODUCER + 4) != 0 ||
                        load32_le(bytes + QTR_POLICY_CELL_SIZE + 4) != 0;
  return known && !reserved ? QTR_OK : QTR_ERR_CORRUPT;
}

/* Find the sections, whose sizes follow from the dimensions alone: there is no offset in the file to be wrong. */
static int find_sections(qtr_policy *policy, uint32_t size) {
  qtr_board *board = &policy->board;
  const uint32_t nodes = (uint32_t)board->places + board->starts;
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  const uint64_t travel = 4u * (uint64_t)nodes * board->places;
  const uint64_t seats = (board->seekers + 1u) / 2u * 4u;
  const uint64_t regions = policy->bytes[QTR_POLICY_ANY_START] != 0 ? 2u * (uint64_t)cells : 0;
  const uint64_t fixed = QTR_POLICY_HEADER_BYTES + seats + 4u * (uint64_t)nodes + 4u * (uint64_t)board->places +
                         travel + qtr_grid_size(cells, policy->grid.encoding) + regions;
  if (fixed > size) return QTR_ERR_CORRUPT;
  const uint8_t *at = policy->bytes + QTR_POLICY_HEADER_BYTES;
  for (unsigned i = 0; i < board->seekers; i++) board->start_of[i] = (uint16_t)load16_le(at + 2 * i);
  policy->cells = at + seats;
  policy->weights = policy->cells + 4u * nodes;
  board->steps = policy->weights + 4u * board->places;
  policy->record = board->steps + travel;
  if (qtr_board_init(board) != QTR_OK) return QTR_ERR_CORRUPT;
  if (board->keys.words != policy->bytes[QTR_POLICY_KEY_WORDS]) return QTR_ERR_SELFTEST;
  const uint64_t records = (uint64_t)policy->records * record_bytes(policy);
  if (fixed + records != size) return QTR_ERR_CORRUPT;
  policy->grid.cells = policy->record + records;
  policy->regions = regions > 0 ? policy->grid.cells + qtr_grid_size(cells, policy->grid.encoding) : NULL;
  return QTR_OK;
}

/* A map without metres lies nowhere; one with metres has a middle of its first cell. */
static int check_place_in_world(const qtr_policy *policy) {
  const qtr_frame *frame = &policy->frame;
  int64_t x_um;
  int64_t y_um;
  const bool is_known = frame->cell_size_um > 0 ? qtr_frame_centre(frame, &policy->grid, 0, &x_um, &y_um)
                                                : frame->origin_x_um == 0 && frame->origin_y_um == 0;
  return is_known ? QTR_OK : QTR_ERR_CORRUPT;
}

/* Bytes that mean nothing are 0: what fills up the seats, and the bits behind the last cell. */
static int check_padding(const qtr_policy *policy) {
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  const uint8_t *seats = policy->bytes + QTR_POLICY_HEADER_BYTES;
  if (policy->board.seekers % 2 == 1 && load16_le(seats + 2u * policy->board.seekers) != 0) return QTR_ERR_CORRUPT;
  if (policy->grid.encoding != QTR_GRID_BITS || cells % 8 == 0) return QTR_OK;
  return policy->grid.cells[cells / 8] >> (cells % 8) == 0 ? QTR_OK : QTR_ERR_CORRUPT;
}

static int check_nodes(const qtr_policy *policy) {
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  for (uint32_t node = 0; node < (uint32_t)policy->board.places + policy->board.starts; node++) {
    const uint32_t cell = load32_le(policy->cells + 4 * node);
    if (cell >= cells || qtr_grid_cost(&policy->grid, (qtr_cell)cell) == 0) return QTR_ERR_CORRUPT;
  }
  return QTR_OK;
}

/* Likelihoods of sum 1, each rounded, and none below 1. */
static int check_weights(const qtr_policy *policy) {
  const uint64_t one = (uint64_t)1 << 32;
  const unsigned places = policy->board.places;
  uint64_t sum = 0;
  for (unsigned place = 0; place < places; place++) {
    if (qtr_policy_weight(policy, place) == 0) return QTR_ERR_CORRUPT;
    sum += qtr_policy_weight(policy, place);
  }
  return sum + places >= one && sum <= one + places ? QTR_OK : QTR_ERR_CORRUPT;
}

/* A cell outside is of no region, nor is the cell of a start that is none. */
static uint32_t region_of(const qtr_policy *policy, uint32_t cell) {
  return cell < qtr_grid_cells(&policy->grid) ? load16_le(policy->regions + 2 * cell) : QTR_POLICY_NO_REGION;
}

/* Every free cell belongs to a region, whose start lies in it; blocked cells belong to none. */
static int check_regions(const qtr_policy *policy) {
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  for (uint32_t cell = 0; policy->regions != NULL && cell < cells; cell++) {
    const bool is_free = qtr_grid_cost(&policy->grid, (qtr_cell)cell) > 0;
    const uint32_t region = region_of(policy, cell);
    if ((region == QTR_POLICY_NO_REGION) == is_free) return QTR_ERR_CORRUPT;
    const qtr_cell start = qtr_policy_cell(policy, policy->board.places + region);
    if (is_free && region_of(policy, start) != region) return QTR_ERR_CORRUPT;
  }
  return QTR_OK;
}

static int compare_keys(const uint8_t *record, const uint32_t *word, unsigned words) {
  for (unsigned w = words; w-- > 0;) {
    const uint32_t stored = load32_le(record + 4 * w);
    if (stored != word[w]) return stored < word[w] ? -1 : 1;
  }
  return 0;
}

static int check_records(const qtr_policy *policy) {
  qtr_key key;
  for (uint32_t r = 0; r < policy->records; r++) {
    const uint8_t *record = policy->record + r * record_bytes(policy);
    if (r > 0 && compare_keys(record, key.word, policy->board.keys.words) <= 0) return QTR_ERR_CORRUPT;
    for (unsigned w = 0; w < policy->board.keys.words; w++) key.word[w] = load32_le(record + 4 * w);
    const uint32_t choice = load16_le(record + 4 * policy->board.keys.words);
    if (load16_le(record + 4 * policy->board.keys.words + 2) != 0) return QTR_ERR_CORRUPT;
    if (choice >= policy->board.places && choice != QTR_STAND_DOWN) return QTR_ERR_CORRUPT;
  }
  return QTR_OK;
}

/* ---- opening: what the travel times say of one another ---- */

static bool is_way(const qtr_policy *policy, uint32_t node, uint32_t place) {
  return qtr_board_steps(&policy->board, QTR_ANY_SEEKER, node, place) != QTR_NEVER;
}

/* The first place that a node reaches; `places` if there is none. */
static uint32_t first_in_reach(const qtr_policy *policy, uint32_t node) {
  uint32_t place = 0;
  while (place < policy->board.places && !is_way(policy, node, place)) place++;
  return place;
}

/* Moves can be undone, so a map falls into parts: what lies in one part is in reach of one another, and of nothing else. A
 * node thus reaches what the first place in its reach does, and two places reach each other or neither does. */
static bool reach_agrees(const qtr_policy *policy, uint32_t node) {
  const uint32_t places = policy->board.places;
  const uint32_t first = first_in_reach(policy, node);
  for (uint32_t place = 0; place < places; place++) {
    const bool way = is_way(policy, node, place);
    if (first < places && way != is_way(policy, first, place)) return false;
    if (node < places && way != is_way(policy, place, node)) return false;
  }
  return true;
}

/* A way takes no time where it ends in the cell that it begins in, and nowhere else. No two places share a cell. */
static bool times_fit_cells(const qtr_policy *policy, uint32_t node) {
  const uint32_t places = policy->board.places;
  for (uint32_t place = 0; place < places; place++) {
    const bool is_here = qtr_policy_cell(policy, node) == qtr_policy_cell(policy, place);
    if (is_here != (qtr_board_steps(&policy->board, QTR_ANY_SEEKER, node, place) == 0)) return false;
    if (is_here && node < places && node != place) return false;
  }
  return true;
}

static bool some_seeker_reaches(const qtr_policy *policy, uint32_t place) {
  const qtr_board *board = &policy->board;
  for (unsigned i = 0; i < board->seekers; i++)
    if (qtr_board_steps(board, i, (unsigned)board->places + board->start_of[i], place) != QTR_NEVER) return true;
  return false;
}

static int check_travel(const qtr_policy *policy) {
  const uint32_t places = policy->board.places;
  for (uint32_t node = 0; node < places + policy->board.starts; node++)
    if (!reach_agrees(policy, node) || !times_fit_cells(policy, node)) return QTR_ERR_TRAVEL;
  for (uint32_t place = 0; place < places; place++)
    if (!some_seeker_reaches(policy, place)) return QTR_ERR_TRAVEL;
  return QTR_OK;
}

/* ---- opening: the certificate, by the bits of its doubles ---- */

#define DOUBLE_ONE ((int64_t)0x3FF0000000000000)
#define DOUBLE_NORMAL ((int64_t)0x0010000000000000) /* the least that has all its digits */
#define DOUBLE_INFINITE ((int64_t)0x7FF0000000000000)

/* A number that is ordered as the doubles are, with one 0; beyond DOUBLE_INFINITE are those that are none. */
static int64_t rank_of(const qtr_policy *policy, uint32_t offset) {
  const uint64_t bits = load64_le(policy->bytes + offset);
  const int64_t magnitude = (int64_t)(bits & 0x7FFFFFFFFFFFFFFFu);
  return bits >> 63 != 0 ? -magnitude : magnitude;
}

static bool is_finite(int64_t rank) {
  return rank > -DOUBLE_INFINITE && rank < DOUBLE_INFINITE;
}

/* Open where, and only where, value and bound differ. Of values so small that they lose digits little is known. */
static bool gap_agrees(int64_t gap, int64_t objective, int64_t bound, bool is_certified) {
  if (gap < 0 || gap > DOUBLE_INFINITE || (is_certified && !is_finite(gap))) return false;
  if (objective < DOUBLE_NORMAL) return true;
  return is_finite(gap) && (gap == 0) == (objective == bound);
}

static bool is_amount(int64_t rank) {
  return rank >= 0 && is_finite(rank);
}

static bool is_discount(int64_t rank) {
  return rank > 0 && rank < DOUBLE_ONE;
}

/* Expected time's bound may lie below 0: stopped early, it may say nothing. */
static int check_certificate(const qtr_policy *policy) {
  const bool by_time = policy->bytes[QTR_POLICY_OBJECTIVE] != 0;
  const int64_t value = rank_of(policy, QTR_POLICY_VALUE);
  const int64_t time = rank_of(policy, QTR_POLICY_TIME);
  const int64_t bound = rank_of(policy, QTR_POLICY_BOUND);
  const int64_t gap = rank_of(policy, QTR_POLICY_GAP);
  if (!is_discount(rank_of(policy, QTR_POLICY_GAMMA)) || !is_amount(value) || !is_amount(time) || !is_finite(bound))
    return QTR_ERR_CERTIFICATE;
  if (by_time ? bound > time : bound < value) return QTR_ERR_CERTIFICATE;
  const bool agrees = gap_agrees(gap, by_time ? time : value, bound, policy->bytes[QTR_POLICY_CERTIFIED] != 0);
  return agrees ? QTR_OK : QTR_ERR_CERTIFICATE;
}

/* ---- opening: the whole ---- */

static int check_content(const qtr_policy *policy) {
  static int (*const checks[])(const qtr_policy *) = {check_place_in_world, check_padding,    check_nodes,
                                                      check_weights,        check_regions,    check_records,
                                                      check_travel,         check_certificate};
  int status = QTR_OK;
  for (unsigned i = 0; i < sizeof checks / sizeof checks[0] && status == QTR_OK; i++) status = checks[i](policy);
  return status;
}

int qtr_policy_open_built(qtr_policy *policy, const void *bytes, uint32_t size, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  policy->bytes = bytes;
  int status = check_frame(bytes, size);
  if (status == QTR_OK) status = check_words(bytes);
  if (status == QTR_OK) status = read_dimensions(policy);
  if (status == QTR_OK) status = find_sections(policy, size);
  if (status == QTR_OK) status = check_content(policy);
  if (status == QTR_OK && qtr_policy_digest(policy) != load32_le(policy->bytes + QTR_POLICY_DIGEST))
    status = QTR_ERR_SELFTEST;
  return status;
}

/* ---- reading ---- */

/* The start that stands for a cell: its region's, or on a table without regions the start at that cell; `starts` if there
 * is none. */
static unsigned start_at(const qtr_policy *policy, qtr_cell cell) {
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  unsigned start = 0;
  if (cell >= cells || qtr_grid_cost(&policy->grid, cell) == 0) return policy->board.starts;
  if (policy->regions != NULL) return region_of(policy, cell);
  while (start < policy->board.starts && qtr_policy_cell(policy, policy->board.places + start) != cell) start++;
  return start;
}

/* The mission's own start of a seeker. */
static unsigned home_of(const qtr_policy *policy, unsigned seeker) {
  return load16_le(policy->bytes + QTR_POLICY_HEADER_BYTES + 2 * seeker);
}

int qtr_policy_deploy(qtr_policy *policy, const qtr_cell *starts) {
  bool home = true;
  for (unsigned i = 0; i < policy->board.seekers; i++) {
    home = home && starts[i] == qtr_policy_cell(policy, policy->board.places + home_of(policy, i));
    if (start_at(policy, starts[i]) >= policy->board.starts) return QTR_ERR_START;
  }
  for (unsigned i = 0; i < policy->board.seekers; i++)
    policy->board.start_of[i] = (uint16_t)(home ? home_of(policy, i) : start_at(policy, starts[i]));
  return QTR_OK;
}

qtr_cell qtr_policy_cell(const qtr_policy *policy, unsigned node) {
  if (node >= (unsigned)policy->board.places + policy->board.starts) return QTR_NO_CELL;
  return (qtr_cell)load32_le(policy->cells + 4 * node);
}

uint32_t qtr_policy_weight(const qtr_policy *policy, unsigned place) {
  return place < policy->board.places ? load32_le(policy->weights + 4 * place) : 0;
}

bool qtr_policy_lookup(const qtr_policy *policy, const qtr_joint *joint, uint16_t *choice) {
  qtr_key key;
  qtr_joint_key(&key, joint, &policy->board);
  uint32_t low = 0;
  uint32_t high = policy->records;
  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;
    const uint8_t *record = policy->record + middle * record_bytes(policy);
    const int order = compare_keys(record, key.word, policy->board.keys.words);
    if (order == 0) {
      *choice = (uint16_t)load16_le(record + 4 * policy->board.keys.words);
      return true;
    }
    if (order < 0)
      low = middle + 1;
    else
      high = middle;
  }
  return false;
}

/* weight a / steps a > weight b / steps b, without a division. */
static uint16_t choose_by_rate(const qtr_policy *policy, const qtr_joint *joint, unsigned seeker,
                               const qtr_places *choices) {
  uint16_t best = QTR_STAND_DOWN;
  uint64_t best_weight = 0;
  uint64_t best_steps = 1;
  for (uint16_t place = 0; place < policy->board.places; place++) {
    if (!qtr_places_has(choices, place)) continue;
    const uint64_t weight = qtr_policy_weight(policy, place);
    const uint64_t steps = qtr_board_steps(&policy->board, seeker, joint->node[seeker], place);
    if (best != QTR_STAND_DOWN && weight * best_steps <= best_weight * steps) continue;
    best = place;
    best_weight = weight;
    best_steps = steps;
  }
  return best;
}

static bool is_seeker(const qtr_policy *policy, int seeker) {
  return seeker >= 0 && seeker < policy->board.seekers;
}

uint16_t qtr_policy_choose(const qtr_policy *policy, const qtr_joint *joint, int seeker, bool *off_table) {
  qtr_places choices;
  uint16_t choice = QTR_STAND_DOWN;
  const bool may_stand_down = qtr_joint_choices(joint, &policy->board, seeker, &choices);
  /* A record that allows no such choice can only be a forged one; it counts as none. */
  const bool known = qtr_policy_lookup(policy, joint, &choice) &&
                     (choice == QTR_STAND_DOWN ? may_stand_down : qtr_places_has(&choices, choice));
  const bool is_one = is_seeker(policy, seeker);
  if (off_table != NULL) *off_table = is_one && !known;
  if (known) return choice;
  if (!is_one) return QTR_STAND_DOWN;
  return choose_by_rate(policy, joint, (unsigned)seeker, &choices);
}

uint16_t qtr_policy_play(const qtr_policy *policy, qtr_joint *joint, int seeker, qtr_steps *now, uint32_t *off_table) {
  while (is_seeker(policy, seeker) && joint->node[seeker] != QTR_STAND_DOWN) {
    const int chooser = qtr_joint_chooser(joint, &policy->board);
    if (chooser == QTR_NOBODY) {
      const qtr_steps passed = qtr_joint_advance(joint, &policy->board, NULL);
      if (passed == 0) break;
      if (now != NULL) *now += passed;
      continue;
    }
    bool off = false;
    const uint16_t choice = qtr_policy_choose(policy, joint, chooser, &off);
    if (off && off_table != NULL) ++*off_table;
    qtr_joint_choose(joint, &policy->board, chooser, choice);
    if (chooser == seeker) return choice;
  }
  return QTR_STAND_DOWN;
}

uint32_t qtr_policy_digest(const qtr_policy *policy) {
  uint32_t digest = 0;
  for (uint8_t seeker = 0; seeker < policy->board.seekers; seeker++) {
    qtr_joint joint;
    qtr_steps now = 0;
    uint16_t choice = 0;
    qtr_joint_start(&joint, &policy->board, NULL, NULL);
    while (choice != QTR_STAND_DOWN) {
      uint8_t line[8] = {seeker, 0, 0, 0, 0, 0, 0, 0};
      choice = qtr_policy_play(policy, &joint, seeker, &now, NULL);
      store16_le(line + 2, choice);
      store32_le(line + 4, now);
      digest = crc32_add(digest, line, sizeof line);
    }
  }
  return digest;
}
