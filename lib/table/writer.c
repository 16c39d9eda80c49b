#include "quarter/writer.h"

#include <stddef.h>
#include <string.h>

#include "core/bytes.h"
#include "core/crc.h"
#include "model/doubles.h"
#include "model/rounding.h"
#include "quarter/digest.h"
#include "quarter/policy.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "robot/layout.h"
#include "table/record.h"

/* ---- what of the map is held ---- */

/* Robots for any start need all of the map; else what no robot can reach takes no byte of flash. */
static qtr_box box_of(const qtr_table_content *content) {
  const qtr_mission *mission = content->mission;
  return content->used != NULL ? *content->used : (qtr_box){0, 0, mission->columns, mission->rows};
}

static uint16_t columns_of(const qtr_box *box) {
  return (uint16_t)(box->right - box->left);
}

static uint16_t rows_of(const qtr_box *box) {
  return (uint16_t)(box->bottom - box->top);
}

static uint32_t cells_of(const qtr_box *box) {
  return (uint32_t)columns_of(box) * rows_of(box);
}

/* A cell of the table's grid, as one of the map. */
static uint32_t on_map(const qtr_mission *mission, const qtr_box *box, uint32_t cell) {
  return (box->top + cell / columns_of(box)) * mission->columns + box->left + cell % columns_of(box);
}

/* And the other way. */
static uint32_t in_table(const qtr_mission *mission, const qtr_box *box, uint32_t cell) {
  QTR_ASSERT(cell % mission->columns >= box->left && cell / mission->columns >= box->top); /* nodes lie in the box */
  return (cell / mission->columns - box->top) * columns_of(box) + cell % mission->columns - box->left;
}

/* Where the table's grid lies: its cells have the same middles in both frames. */
static qtr_frame frame_of(const qtr_table_content *content) {
  const qtr_box box = box_of(content);
  const qtr_grid whole = qtr_mission_grid(content->mission);
  const qtr_grid part = {columns_of(&box), rows_of(&box), QTR_GRID_BYTES, whole.cells};
  qtr_frame frame = content->mission->frame;
  int64_t x = 0, y = 0, x_here = 0, y_here = 0;
  if (!qtr_frame_centre(&frame, &whole, (qtr_cell)on_map(content->mission, &box, 0), &x, &y)) return frame;
  frame.origin_x_um = frame.origin_y_um = 0;
  qtr_frame_centre(&frame, &part, 0, &x_here, &y_here);
  frame.origin_x_um = x - x_here;
  frame.origin_y_um = y - y_here;
  return frame;
}

/* A bit a cell where all free cells cost alike, a byte where ground differs. */
static uint8_t encoding_of(const qtr_table_content *content) {
  const qtr_box box = box_of(content);
  for (uint32_t cell = 0; cell < cells_of(&box); cell++)
    if (content->mission->cost[on_map(content->mission, &box, cell)] > 1) return QTR_GRID_BYTES;
  return QTR_GRID_BITS;
}

/* ---- sizes ---- */

/* Which of the terms that robots play by there are: enum qtr_table_term. */
static uint8_t terms_of(const qtr_board *board) {
  const qtr_terms *terms = &board->terms;
  return (uint8_t)(terms->rules | (terms->ready != NULL ? QTR_TERM_READY : 0) |
                   (terms->end != NULL ? QTR_TERM_END : 0) | (terms->look_of != NULL ? QTR_TERM_LOOKS : 0));
}

/* The longest way in the fewest bytes, all ones being none. */
static uint8_t step_bytes_of(const qtr_board *board) {
  qtr_steps longest = board->keys.longest;
  for (unsigned i = 0; board->terms.end != NULL && i < board->seekers; i++) {
    for (unsigned place = 0; place < board->places; place++) {
      const qtr_steps home = qtr_board_home(board, i, place);
      if (home != QTR_NEVER && home > longest) longest = home;
    }
  }
  if (longest < 0xFFu) return 1;
  return longest < 0xFFFFu ? 2 : 4;
}

/* Whether the mission is none of the paper's, so that a robot or a host must know more to play it or to tell its
 * worth. */
static bool has_terms(const qtr_table_content *content) {
  const qtr_mission *mission = content->mission;
  const qtr_objective_terms *worth = content->terms;
  if (mission->classes > 1 || terms_of(content->board) != 0 || content->board->terms.clock > 0) return true;
  if (worth != NULL && (worth->findable != 1.0 || worth->home_weight > 0.0)) return true;
  const qtr_robot_class *all = &mission->robot_class[0];
  for (unsigned place = 0; place < mission->places; place++)
    if (all->scan[place] > 0) return true;
  return all->cell_steps > 1 || all->smooth_only;
}

/* Bits of what an older build would have to know to play the table: one that it does not know it refuses. */
static uint8_t features_of(const qtr_table_content *content) {
  return (uint8_t)((content->cleared != NULL ? QTR_FEATURE_CLEARED : 0) |
                   (content->mission->number != NULL ? QTR_FEATURE_NUMBERS : 0) |
                   (has_terms(content) ? QTR_FEATURE_TERMS : 0));
}

/* The table's dimensions, as a robot reads them. */
static qtr_policy layout_of(const qtr_table_content *content) {
  const qtr_box box = box_of(content);
  qtr_policy policy;
  memset(&policy, 0, sizeof policy);
  policy.format = QTR_POLICY_FORMAT;
  policy.features = features_of(content);
  policy.any_start = content->region != NULL;
  policy.terms = terms_of(content->board);
  policy.records = content->record_count;
  policy.records_shape = record_shape_written(content->board);
  policy.board = *content->board;
  policy.board.step_bytes = step_bytes_of(content->board);
  policy.grid.columns = columns_of(&box);
  policy.grid.rows = rows_of(&box);
  policy.grid.encoding = encoding_of(content);
  policy.size = qtr_layout_find(&policy);
  return policy;
}

/* UINT32_MAX is no size: no table has as many bytes, and the writer refuses it. */
uint32_t qtr_table_size(const qtr_table_content *content) {
  return layout_of(content).size;
}

/* ---- header ---- */

/* Where the crop lies on the map, and on Earth: what a robot and what a host want of it. */
static void write_map(uint8_t *bytes, const qtr_table_content *content) {
  const qtr_box box = box_of(content);
  const qtr_frame frame = frame_of(content);
  qtr_store16(bytes + QTR_POLICY_COLUMNS, columns_of(&box));
  qtr_store16(bytes + QTR_POLICY_ROWS, rows_of(&box));
  bytes[QTR_POLICY_GRID] = encoding_of(content);
  qtr_store32(bytes + QTR_POLICY_CELL_SIZE, frame.cell_size_um);
  qtr_store64(bytes + QTR_POLICY_ORIGIN_X, (uint64_t)frame.origin_x_um);
  qtr_store64(bytes + QTR_POLICY_ORIGIN_Y, (uint64_t)frame.origin_y_um);
  qtr_store32(bytes + QTR_POLICY_COSINE, (uint32_t)frame.cosine);
  qtr_store32(bytes + QTR_POLICY_SINE, (uint32_t)frame.sine);
  qtr_store16(bytes + QTR_POLICY_LEFT, box.left);
  qtr_store16(bytes + QTR_POLICY_TOP, box.top);
  qtr_store16(bytes + QTR_POLICY_MAP_COLUMNS, content->mission->columns);
  qtr_store16(bytes + QTR_POLICY_MAP_ROWS, content->mission->rows);
}

static void write_dimensions(uint8_t *bytes, const qtr_table_content *content, uint32_t size) {
  const qtr_board *board = content->board;
  memcpy(bytes + QTR_POLICY_MAGIC, QTR_POLICY_MAGIC_BYTES, QTR_POLICY_VERSION);
  qtr_store16(bytes + QTR_POLICY_VERSION, QTR_POLICY_FORMAT);
  qtr_store16(bytes + QTR_POLICY_HEADER, QTR_POLICY_HEADER_BYTES);
  qtr_store32(bytes + QTR_POLICY_SIZE, size);
  qtr_store16(bytes + QTR_POLICY_PLACES, board->places);
  bytes[QTR_POLICY_SEEKERS] = board->seekers;
  bytes[QTR_POLICY_ANY_START] = content->region != NULL;
  bytes[QTR_POLICY_RULE] = board->rule;
  bytes[QTR_POLICY_OBJECTIVE] = content->mission->aim.kind;
  bytes[QTR_POLICY_KEY_WORDS] = board->keys.words;
  bytes[QTR_POLICY_STEP_BYTES] = step_bytes_of(board);
  qtr_store16(bytes + QTR_POLICY_STARTS, board->starts);
  qtr_store32(bytes + QTR_POLICY_RECORDS, content->record_count);
  qtr_store32(bytes + QTR_POLICY_FEATURES, features_of(content));
  qtr_store32(bytes + QTR_POLICY_STEP_TIME, content->mission->step_time_us);
}

/* What of the terms stands in the header; without them it stays 0. */
static void write_terms_words(uint8_t *bytes, const qtr_table_content *content) {
  const qtr_mission *mission = content->mission;
  if (!has_terms(content)) return;
  store_double(bytes + QTR_POLICY_FOUND, content->certificate->found);
  qtr_store32(bytes + QTR_POLICY_DEADLINE, mission->aim.kind == QTR_DEADLINE ? mission->aim.deadline : 0);
  qtr_store32(bytes + QTR_POLICY_CLOCK, content->board->terms.clock);
  qtr_store16(bytes + QTR_POLICY_OWN_PLACES, mission->places);
  bytes[QTR_POLICY_CLASSES] = (uint8_t)qtr_board_classes(content->board);
  bytes[QTR_POLICY_TERMS] = terms_of(content->board);
}

/* As the learner gave it. Opening holds value, bound and gap against one another, so a writer's slip shows at once. */
static void write_certificate(uint8_t *bytes, const qtr_table_content *content) {
  const qtr_certificate *certificate = content->certificate;
  bytes[QTR_POLICY_CERTIFIED] = certificate->certified;
  qtr_store32(bytes + QTR_POLICY_PRODUCER, QTR_VERSION);
  qtr_store64(bytes + QTR_POLICY_SEED, content->seed);
  store_double(bytes + QTR_POLICY_GAMMA, content->mission->aim.gamma);
  store_double(bytes + QTR_POLICY_VALUE, certificate->value);
  store_double(bytes + QTR_POLICY_TIME, certificate->expected_time);
  store_double(bytes + QTR_POLICY_BOUND, certificate->bound);
  store_double(bytes + QTR_POLICY_GAP, certificate->gap);
}

/* ---- sections ---- */

/* The mission's place that one of the board's is a look at. */
static unsigned place_at(const qtr_board *board, unsigned place) {
  return board->terms.look_of == NULL ? place : qtr_load16(board->terms.look_of + 2 * (size_t)place);
}

static void write_cells(uint8_t *at, const qtr_table_content *content) {
  const qtr_board *board = content->board;
  const qtr_box box = box_of(content);
  const uint8_t bytes = cell_bytes_of(QTR_POLICY_FORMAT, cells_of(&box));
  for (unsigned node = 0; node < qtr_board_nodes(board); node++, at += bytes) {
    const qtr_cell on =
        node < board->places ? content->mission->place[place_at(board, node)] : content->start[node - board->places];
    const uint32_t cell = in_table(content->mission, &box, on);
    if (bytes == 2)
      qtr_store16(at, cell);
    else
      qtr_store32(at, cell);
  }
}

/* Times as they are, but QTR_NEVER, which is cut to its lowest bytes: all ones at any width. */
static uint8_t *write_steps(uint8_t *at, qtr_steps steps, uint8_t bytes) {
  for (unsigned i = 0; i < bytes; i++) at[i] = (uint8_t)(steps >> (8 * i) & 0xFFu);
  return at + bytes;
}

static void write_travel(uint8_t *at, const qtr_board *board) {
  const uint8_t bytes = step_bytes_of(board);
  for (unsigned of_class = 0; of_class < qtr_board_classes(board); of_class++)
    for (unsigned node = 0; node < qtr_board_nodes(board); node++)
      for (unsigned place = 0; place < board->places; place++)
        at = write_steps(at, qtr_board_class_steps(board, of_class, node, place), bytes);
}

static uint8_t *write_classes(uint8_t *at, const qtr_table_content *content) {
  const qtr_board *board = content->board;
  for (unsigned i = 0; i < qtr_board_classes(board); i++, at += QTR_TERMS_CLASS_BYTES) {
    qtr_store16(at, content->mission->robot_class[i].cell_steps);
    at[2] = content->mission->robot_class[i].smooth_only;
  }
  for (unsigned i = 0; i < board->seekers; i++) *at++ = board->class_of[i];
  return at;
}

static uint8_t *write_ends(uint8_t *at, const qtr_board *board) {
  const uint8_t bytes = step_bytes_of(board);
  for (unsigned i = 0; i < board->seekers; i++, at += 4) qtr_store32(at, qtr_board_end(board, i));
  for (unsigned i = 0; i < board->seekers; i++)
    for (unsigned place = 0; place < board->places; place++)
      at = write_steps(at, qtr_board_home(board, i, place), bytes);
  return at;
}

/* In the order in which a robot finds them; of ends there are ways home, too. */
static void write_terms(uint8_t *at, const qtr_table_content *content) {
  const qtr_board *board = content->board;
  if (!has_terms(content)) return;
  store_double(at + QTR_TERMS_FINDABLE, content->terms != NULL ? content->terms->findable : 1.0);
  store_double(at + QTR_TERMS_HOME_WEIGHT, content->terms != NULL ? content->terms->home_weight : 0.0);
  at = write_classes(at + QTR_TERMS_CLASS, content);
  for (unsigned i = 0; board->terms.ready != NULL && i < board->seekers; i++, at += 4)
    qtr_store32(at, qtr_board_ready(board, i));
  if (board->terms.end != NULL) at = write_ends(at, board);
  for (unsigned place = 0; board->terms.look_of != NULL && place < board->places; place++, at += 2)
    qtr_store16(at, place_at(board, place));
}

/* In units of 2^-32, to the nearest; never 0, for a place that holds nothing is none of the mission's. */
static uint32_t fixed_point(double probability) {
  const double scaled = probability * 4294967296.0 + 0.5;
  if (scaled < 1.0) return 1;
  return scaled < 4294967295.0 ? (uint32_t)scaled : UINT32_MAX;
}

static void write_weights(uint8_t *at, const qtr_table_content *content) {
  for (unsigned place = 0; place < content->board->places; place++)
    qtr_store32(at + 4 * place, fixed_point(content->probability[place]));
}

/* A bit a cell from the lowest of each byte on, as sets of places are. */
static void write_grid(uint8_t *at, const qtr_table_content *content) {
  const qtr_box box = box_of(content);
  const uint8_t encoding = encoding_of(content);
  for (uint32_t cell = 0; cell < cells_of(&box); cell++) {
    const uint8_t cost = content->mission->cost[on_map(content->mission, &box, cell)];
    if (encoding == QTR_GRID_BYTES)
      at[cell] = cost;
    else if (cost > 0)
      at[cell / 8] = (uint8_t)(at[cell / 8] | 1u << cell % 8);
  }
}

static void write_regions(uint8_t *at, const qtr_table_content *content) {
  const qtr_box box = box_of(content);
  for (uint32_t cell = 0; content->region != NULL && cell < cells_of(&box); cell++)
    qtr_store16(at + 2 * cell, content->region[on_map(content->mission, &box, cell)]);
}

/* Both sections may be missing: then their bytes are none, and nothing is written. */
static void write_places(uint8_t *cleared, uint8_t *numbers, const qtr_table_content *content) {
  for (unsigned place = 0; place < content->board->places; place++) {
    if (content->cleared != NULL && qtr_places_has(content->cleared, place))
      cleared[place / 8] = (uint8_t)(cleared[place / 8] | 1u << place % 8);
    if (content->mission->number != NULL)
      qtr_store16(numbers + 2 * place, content->mission->number[place_at(content->board, place)]);
  }
}

/* All bytes are 0 before: bits are added, and what is nobody's stays 0, as opening asks. */
static void write_sections(uint8_t *bytes, const qtr_policy *layout, const qtr_table_content *content) {
  const qtr_board *board = content->board;
  const uint32_t records = content->record_count * record_shape_written(board).bytes;
  qtr_board_store_seats(board, bytes + layout->at[SECTION_SEATS]);
  write_cells(bytes + layout->at[SECTION_CELLS], content);
  write_weights(bytes + layout->at[SECTION_WEIGHTS], content);
  write_travel(bytes + layout->at[SECTION_TRAVEL], board);
  write_terms(bytes + layout->at[SECTION_TERMS], content);
  if (records > 0) memcpy(bytes + layout->at[SECTION_RECORDS], content->records, records);
  write_grid(bytes + layout->at[SECTION_GRID], content);
  write_regions(bytes + layout->at[SECTION_REGIONS], content);
  write_places(bytes + layout->at[SECTION_CLEARED], bytes + layout->at[SECTION_NUMBERS], content);
}

/* ---- the whole ---- */

/* Of all behind itself, up to the end. */
static void seal(uint8_t *bytes, uint32_t size) {
  qtr_store32(bytes + QTR_POLICY_CRC, qtr_crc32_add(0, bytes + QTR_POLICY_COLUMNS, size - QTR_POLICY_COLUMNS));
}

int32_t qtr_table_write(const qtr_table_content *content, uint8_t *bytes, uint32_t size) {
  const qtr_policy layout = layout_of(content);
  qtr_policy policy;
  if (layout.size > size || layout.size > INT32_MAX) return QTR_ERR_SPACE;
  const uint32_t needed = layout.size;
  memset(bytes, 0, needed);
  write_dimensions(bytes, content, needed);
  write_map(bytes, content);
  write_terms_words(bytes, content);
  write_certificate(bytes, content);
  write_sections(bytes, &layout, content);
  seal(bytes, needed);
  /* The robot's own code says what the digest is: opening stops at it, and then must not. */
  int status = qtr_policy_open(&policy, bytes, needed);
  if (status != QTR_OK && status != QTR_ERR_SELFTEST) return status;
  qtr_store32(bytes + QTR_POLICY_DIGEST, qtr_policy_digest(&policy));
  seal(bytes, needed);
  status = qtr_policy_open(&policy, bytes, needed);
  if (status == QTR_OK) status = qtr_policy_check(&policy);
  return status == QTR_OK ? (int32_t)needed : status;
}
