/* Where everything stands in a policy table (docs/policy-format.md): stated here alone, for those who open a table and
 * for those who write one. */
#ifndef QUARTER_LAYOUT_H
#define QUARTER_LAYOUT_H

#include <stdbool.h>
#include <stdint.h>

#include "core/bytes.h"
#include "quarter/policy.h"
#include "robot/joint_key.h"

/* ---- the header, by byte offsets ---- */

#define QTR_POLICY_MAGIC_BYTES "QTRP"
#define QTR_POLICY_MAGIC_WORD 0x50525451u /* the same, read as a number */

enum {
  QTR_POLICY_MAGIC = 0,         /* QTR_POLICY_MAGIC_BYTES */
  QTR_POLICY_VERSION = 4,       /* u16, QTR_POLICY_FORMAT */
  QTR_POLICY_HEADER = 6,        /* u16, bytes of the header */
  QTR_POLICY_SIZE = 8,          /* u32, bytes of the whole table */
  QTR_POLICY_CRC = 12,          /* u32, CRC-32 of all that follows */
  QTR_POLICY_COLUMNS = 16,      /* u16 */
  QTR_POLICY_ROWS = 18,         /* u16 */
  QTR_POLICY_PLACES = 20,       /* u16 */
  QTR_POLICY_SEEKERS = 22,      /* u8 */
  QTR_POLICY_ANY_START = 23,    /* u8, 1: each region is a start, and a section tells the cells' regions */
  QTR_POLICY_RULE = 24,         /* u8, enum qtr_rule */
  QTR_POLICY_OBJECTIVE = 25,    /* u8, enum qtr_objective_kind */
  QTR_POLICY_GRID = 26,         /* u8, enum qtr_grid_encoding */
  QTR_POLICY_CERTIFIED = 27,    /* u8, 1: the gap is within what was asked for */
  QTR_POLICY_KEY_WORDS = 28,    /* u8, 32-bit words of a key */
  QTR_POLICY_STEP_BYTES = 29,   /* u8, 1, 2 or 4: of a travel time. Format 1: 0, and they are of 4 */
  QTR_POLICY_STARTS = 30,       /* u16, start cells */
  QTR_POLICY_RECORDS = 32,      /* u32 */
  QTR_POLICY_DIGEST = 36,       /* u32, of the nominal game: qtr_policy_digest() */
  QTR_POLICY_PRODUCER = 40,     /* u32, library version that wrote it: major << 16 | minor << 8 | patch */
  QTR_POLICY_FEATURES = 44,     /* u32, a bit for each that the table makes use of: enum qtr_table_feature */
  QTR_POLICY_SEED = 48,         /* u64 */
  QTR_POLICY_GAMMA = 56,        /* IEEE 754 double, as the four below */
  QTR_POLICY_VALUE = 64,        /* discounted value */
  QTR_POLICY_TIME = 72,         /* expected step of the find */
  QTR_POLICY_BOUND = 80,        /* of the objective: no policy does better */
  QTR_POLICY_GAP = 88,          /* relative */
  QTR_POLICY_CELL_SIZE = 96,    /* u32, micrometres a cell; 0: no metres */
  QTR_POLICY_STEP_TIME = 100,   /* u32, microseconds a step; 0: not said */
  QTR_POLICY_ORIGIN_X = 104,    /* i64, micrometres: lower-left corner of the grid in the map frame */
  QTR_POLICY_ORIGIN_Y = 112,    /* i64 */
  QTR_POLICY_HEADER_1 = 120,    /* bytes of format 1's header: what follows is as in a table that makes no use of it */
  QTR_POLICY_COSINE = 120,      /* i32, of the grid's turn against the map frame, in units of 2^-30 */
  QTR_POLICY_SINE = 124,        /* i32 */
  QTR_POLICY_LEFT = 128,        /* u16, columns of the map to the left of the table's grid */
  QTR_POLICY_TOP = 130,         /* u16, rows above it */
  QTR_POLICY_MAP_COLUMNS = 132, /* u16, of the whole map */
  QTR_POLICY_MAP_ROWS = 134,    /* u16 */
  /* Of a table with terms (quarter/terms.h); else 0. */
  QTR_POLICY_FOUND = 136,      /* IEEE 754 double, probability of a find */
  QTR_POLICY_DEADLINE = 144,   /* u32, step of the deadline, where that is the objective */
  QTR_POLICY_CLOCK = 148,      /* u32, the greatest step that a key tells */
  QTR_POLICY_OWN_PLACES = 152, /* u16, of the mission: those behind them are later looks */
  QTR_POLICY_CLASSES = 154,    /* u8, of seekers */
  QTR_POLICY_TERMS = 155,      /* u8, a bit for each that there is: enum qtr_table_term */
  QTR_POLICY_SPARE = 156,      /* 4 of 0, for what later features need */
  QTR_POLICY_HEADER_BYTES = 160
};

enum qtr_table_feature {
  QTR_FEATURE_CLEARED = 1,           /* the mission itself has places cleared beforehand */
  QTR_FEATURE_NUMBERS = 2,           /* the input numbers its places otherwise, for some were left out */
  QTR_FEATURE_TERMS = 4,             /* the mission makes use of the field's terms */
  QTR_FEATURES = (QTR_TERMS ? 7 : 3) /* all that this build knows: the lowest bits, without a gap */
};

enum qtr_table_term {
  QTR_TERM_RULES = 3, /* as in qtr_terms, both of them */
  QTR_TERM_READY = 4, /* the section of terms has ready times */
  QTR_TERM_END = 8,   /* ends, and ways home */
  QTR_TERM_LOOKS = 16 /* which place each is a look at */
};

/* A section of terms: what a host wants to know first, then what a robot plays by (docs/policy-format.md). */
enum {
  QTR_TERMS_FINDABLE = 0,    /* IEEE 754 double, probability of what can be found at all */
  QTR_TERMS_HOME_WEIGHT = 8, /* IEEE 754 double, as a likelihood */
  QTR_TERMS_CLASS = 16,      /* for each class: u16 steps a cell, u8 1 if it may not enter rough ground, u8 0 */
  QTR_TERMS_CLASS_BYTES = 4
};

/* ---- the sections, in their order after the header ---- */

enum section {
  SECTION_SEATS,   /* u16 start of each seeker; in format 1 then 0 up to a multiple of 4 */
  SECTION_CELLS,   /* cell of each node: u16 where the grid has no more than 65,536, else u32; in format 1 u32 */
  SECTION_WEIGHTS, /* u32 likelihood of each place */
  SECTION_TRAVEL,  /* for each class: steps from each node (row) to each place (column), in QTR_POLICY_STEP_BYTES; all
                     ones: no way */
  SECTION_TERMS,   /* QTR_FEATURE_TERMS; before the records, for the length of keys depends on it */
  SECTION_RECORDS,
  SECTION_GRID,
  SECTION_REGIONS, /* u16 start that stands for each cell; none unless the table is for any start */
  SECTION_CLEARED, /* a bit a place; QTR_FEATURE_CLEARED */
  SECTION_NUMBERS /* u16 number in the input of each place; QTR_FEATURE_NUMBERS. The last: QTR_POLICY_SECTIONS in all */
};

/* What a build is told that reads no other format it need not ask: what depends on it takes no code there. */
static inline bool is_format_1(unsigned format) {
  return QTR_READ_FORMAT_1 && (format == 1u);
}

/* Bytes that a cell's index takes. */
static inline uint8_t cell_bytes_of(unsigned format, uint32_t cells) {
  return (is_format_1(format) || ((QTR_MAX_CELLS > 65536) && (cells > 65536u))) ? 4 : 2;
}

/* Where the policy's sections begin, by its dimensions: grid, board, features, format, and its records' shape and
 * number. They must lie in their ranges; records may be any number. There is no offset in a table to be wrong. Returns
 * the bytes of the whole table; UINT32_MAX: more than any table has. */
uint32_t qtr_layout_find(qtr_policy *policy);

static inline const uint8_t *section_of(const qtr_policy *policy, enum section section) {
  return policy->bytes + policy->at[section];
}

/* ---- a record: the key, the least significant byte first; then the choice ---- */

/* Format 1 has whole words, and 2 bytes of 0 at the end; since then a key and a choice take the bytes that they
 * need. */
static inline qtr_record_shape record_shape_of(unsigned format, const qtr_board *board) {
  const unsigned key_bytes =
      is_format_1(format) ? (4u * qtr_key_words_1(&board->keys)) : ((board->keys.bits + 7u) / 8u);
  const unsigned choice_bytes = (is_format_1(format) || ((QTR_MAX_PLACES >= 255) && (board->places >= 255u))) ? 2u : 1u;
  const unsigned bytes = key_bytes + (is_format_1(format) ? 4u : choice_bytes);
  return (qtr_record_shape){(uint16_t)bytes, (uint16_t)key_bytes, (uint8_t)choice_bytes};
}

static inline uint16_t record_choice(const uint8_t *record, const qtr_record_shape *shape) {
  const bool may_be_wide = QTR_READ_FORMAT_1 || (QTR_MAX_PLACES >= 255);
  if (may_be_wide && (shape->choice_bytes == 2u)) {
    return (uint16_t)qtr_load16(record + shape->key_bytes);
  }
  return (record[shape->key_bytes] == 0xFFu) ? QTR_STAND_DOWN : record[shape->key_bytes];
}

/* Below 0, 0 or above 0, as record `a`'s key is less than, equal to or greater than `b`'s. */
static inline int record_compare(const uint8_t *a, const uint8_t *b, const qtr_record_shape *shape) {
  for (unsigned i = shape->key_bytes; i-- > 0u;) {
    if (a[i] != b[i]) {
      return (a[i] < b[i]) ? -1 : 1;
    }
  }
  return 0;
}

#endif
