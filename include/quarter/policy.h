/* A policy table, read in place: from flash on a robot, from a file on the host. docs/policy-format.md has the bytes.
 *
 * The table holds all that a robot needs to act on its own. It is checked whole on opening, so that what is read from
 * it afterwards lies in range; a table that is cut short or has a bit flipped is refused.
 */
#ifndef QUARTER_POLICY_H
#define QUARTER_POLICY_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/grid.h"
#include "quarter/joint.h"

#define QTR_POLICY_NO_REGION 0xFFFFu
#define QTR_POLICY_FORMAT 1 /* raised when the bytes change their meaning; apart from the library's version */

/* Byte offsets in the header. */
enum {
  QTR_POLICY_MAGIC = 0,      /* "QTRP" */
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

/* An open table: views into its bytes, which must stay where they are and unchanged as long as it is used. */
typedef struct {
  const uint8_t *bytes;
  qtr_grid grid;
  qtr_frame frame;
  qtr_board board;
  uint32_t records;       /* state/choice records */
  const uint8_t *cells;   /* of the nodes, 4 bytes each */
  const uint8_t *weights; /* of the places, 4 bytes each */
  const uint8_t *record;  /* the first record */
  const uint8_t *regions; /* of the cells, 2 bytes each; NULL: only the starts themselves are known */
} qtr_policy;

/* Open the table of `size` bytes at `bytes` (no alignment needed). QTR_OK; QTR_ERR_TRUNCATED, _MAGIC, _FORMAT, _CHECKSUM,
 * _CORRUPT, _TRAVEL, _CERTIFICATE or _SELFTEST if it is not whole and sound; QTR_ERR_LIMIT if this build's arrays are too
 * small for it; QTR_ERR_CONFIG if the caller was built under other sizes. What docs/policy-format.md says of each number is
 * checked, and what the numbers say of one another; not the travel times against the grid, which takes a search a place. */
#define qtr_policy_open(policy, bytes, size) qtr_policy_open_built(policy, bytes, size, QTR_CONFIG_ID)
int qtr_policy_open_built(qtr_policy *policy, const void *bytes, uint32_t size, uint32_t config_id);

/* Put the seekers elsewhere than at the mission's starts: seeker i at cell `starts[i]`. Every robot must be told the same
 * cells, before its executor is initialised. On a table for any start they may be any free cells, and stand for their
 * regions; on others they must be start cells of the table. QTR_OK, or QTR_ERR_START with nothing changed. */
int qtr_policy_deploy(qtr_policy *policy, const qtr_cell *starts);

/* The cell of a node: of place p for p < places, of start s for places + s; QTR_NO_CELL if there is no such node. */
qtr_cell qtr_policy_cell(const qtr_policy *policy, unsigned node);

/* A place's likelihood in units of 2^-32, 1 or more; 0 if there is no such place. */
uint32_t qtr_policy_weight(const qtr_policy *policy, unsigned place);

/* Look a state up. False if the table has no record of it. */
bool qtr_policy_lookup(const qtr_policy *policy, const qtr_joint *joint, uint16_t *choice);

/* What `seeker`, whose turn it is, chooses: by the table, and off the table the place with the most weight for a step of
 * travel (the lowest of equal ones). `*off_table` (may be NULL) says which. QTR_STAND_DOWN for a seeker that is none. */
uint16_t qtr_policy_choose(const qtr_policy *policy, const qtr_joint *joint, int seeker, bool *off_table);

/* Play the joint game on in nominal time until `seeker` makes its next choice. Returns that choice, or QTR_STAND_DOWN
 * when it has none left or is none. `*now` (may be NULL) is moved on by the time that passes; `*off_table` (may be NULL) counts
 * the choices made off the table. */
uint16_t qtr_policy_play(const qtr_policy *policy, qtr_joint *joint, int seeker, qtr_steps *now, uint32_t *off_table);

/* A digest of the nominal game from the starts: who chooses what, when. It is stored in the table and compared on
 * opening, so that a robot whose build plays otherwise than the learner's fails loudly instead of searching wrongly. */
uint32_t qtr_policy_digest(const qtr_policy *policy);

#endif
