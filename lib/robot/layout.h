/* Where everything stands in a policy table (docs/policy-format.md): stated here alone, for those who open a table and
 * for those who write one. */
#ifndef QUARTER_LAYOUT_H
#define QUARTER_LAYOUT_H

#include <stdbool.h>
#include <stdint.h>

#include "core/bytes.h"

/* ---- the header, by byte offsets ---- */

#define QTR_POLICY_MAGIC_BYTES "QTRP"

enum {
  QTR_POLICY_MAGIC = 0,      /* QTR_POLICY_MAGIC_BYTES */
  QTR_POLICY_VERSION = 4,    /* u16, QTR_POLICY_FORMAT */
  QTR_POLICY_HEADER = 6,     /* u16, bytes of the header */
  QTR_POLICY_SIZE = 8,       /* u32, bytes of the whole table */
  QTR_POLICY_CRC = 12,       /* u32, CRC-32 of all that follows */
  QTR_POLICY_COLUMNS = 16,   /* u16 */
  QTR_POLICY_ROWS = 18,      /* u16 */
  QTR_POLICY_PLACES = 20,    /* u16 */
  QTR_POLICY_SEEKERS = 22,   /* u8 */
  QTR_POLICY_ANY_START = 23, /* u8, 1: each region is a start, and a section tells the cells' regions */
  QTR_POLICY_RULE = 24,      /* u8, enum qtr_rule */
  QTR_POLICY_OBJECTIVE = 25, /* u8, enum qtr_objective_kind */
  QTR_POLICY_GRID = 26,      /* u8, enum qtr_grid_encoding */
  QTR_POLICY_CERTIFIED = 27, /* u8, 1: the gap is within what was asked for */
  QTR_POLICY_KEY_WORDS = 28, /* u8, then a byte of 0 */
  QTR_POLICY_STARTS = 30,    /* u16, start cells */
  QTR_POLICY_RECORDS = 32,   /* u32 */
  QTR_POLICY_DIGEST = 36,    /* u32, of the nominal game: qtr_policy_digest() */
  QTR_POLICY_PRODUCER = 40,  /* u32, library version that wrote it: major << 16 | minor << 8 | patch; then 4 of 0 */
  QTR_POLICY_SEED = 48,      /* u64 */
  QTR_POLICY_GAMMA = 56,     /* IEEE 754 double, as the four below */
  QTR_POLICY_VALUE = 64,     /* discounted value */
  QTR_POLICY_TIME = 72,      /* expected step of the find */
  QTR_POLICY_BOUND = 80,     /* of the objective: no policy does better */
  QTR_POLICY_GAP = 88,       /* relative */
  QTR_POLICY_CELL_SIZE = 96, /* u32, micrometres a cell; 0: no metres; then 4 of 0 */
  QTR_POLICY_ORIGIN_X = 104, /* i64, micrometres: lower-left corner of the grid in the map frame */
  QTR_POLICY_ORIGIN_Y = 112, /* i64 */
  QTR_POLICY_HEADER_BYTES = 120
};

/* ---- the sections, in their order after the header ---- */

enum section {
  SECTION_SEATS,   /* u16 start of each seeker, then 0 up to a multiple of 4 */
  SECTION_CELLS,   /* u32 cell of each node */
  SECTION_WEIGHTS, /* u32 likelihood of each place */
  SECTION_TRAVEL,  /* u32 steps from each node (row) to each place (column) */
  SECTION_RECORDS,
  SECTION_GRID,
  SECTION_REGIONS, /* u16 start that stands for each cell; none unless the table is for any start */
  SECTIONS
};

/* What the sizes of the sections follow from: there is no offset in the file to be wrong. */
typedef struct {
  uint32_t cells; /* of the grid */
  uint32_t records;
  uint16_t places;
  uint16_t starts;
  uint8_t seekers;
  uint8_t key_words;
  uint8_t grid_encoding;
  bool any_start;
} table_dimensions;

typedef struct {
  uint32_t at[SECTIONS]; /* where each begins, if the end is one of 32 bits */
  uint64_t end;          /* bytes of the whole table */
} table_layout;

/* The dimensions must lie in their ranges; records may be any number. */
void qtr_layout_find(table_layout *layout, const table_dimensions *dimensions);

/* ---- a record: the key's words, the least significant first; u16 choice; u16 0 ---- */

static inline uint32_t record_size(unsigned key_words) {
  return 4u * key_words + 4u;
}

static inline uint32_t record_choice_at(unsigned key_words) {
  return 4u * key_words;
}

static inline uint32_t record_spare_at(unsigned key_words) {
  return 4u * key_words + 2u;
}

static inline uint32_t record_word(const uint8_t *record, unsigned w) {
  return load32_le(record + 4u * w);
}

/* Below 0, 0 or above 0, as record `a`'s key is less than, equal to or greater than `b`'s. */
static inline int record_compare(const uint8_t *a, const uint8_t *b, unsigned key_words) {
  for (unsigned w = key_words; w-- > 0;) {
    const uint32_t x = record_word(a, w);
    const uint32_t y = record_word(b, w);
    if (x != y) return x < y ? -1 : 1;
  }
  return 0;
}

#endif
