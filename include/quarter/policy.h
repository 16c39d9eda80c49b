/* A policy table, read in place: from flash on a robot, from a file on the host. docs/policy-format.md has the bytes.
 *
 * The table holds all that a robot needs to act on its own. It is checked whole on opening, so that what is read from
 * it afterwards lies in range; a table that is cut short or has a bit flipped is refused. Once open, a policy is never
 * changed: any number of executors share one.
 */
#ifndef QUARTER_POLICY_H
#define QUARTER_POLICY_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/board.h"
#include "quarter/config.h"
#include "quarter/grid.h"

QTR_C_BEGIN

#define QTR_POLICY_FORMAT 2 /* raised when the bytes change their meaning; apart from the library's version */
#define QTR_POLICY_NO_REGION 0xFFFFu
#define QTR_POLICY_SECTIONS 10
#define QTR_RECORD_BYTES ((4 * QTR_KEY_WORDS) + 4) /* of the largest record of a table */

/* Whether tables of format 1, which Quarter 0.1 wrote, are opened too. A host does; a robot's table is learnt anew. */
#ifndef QTR_READ_FORMAT_1
#ifdef QTR_PROFILE_MCU
#define QTR_READ_FORMAT_1 0
#else
#define QTR_READ_FORMAT_1 1
#endif
#endif

/* How a record is laid out: a key, the least significant byte first, then a choice; what is left over is 0. */
typedef struct {
  uint16_t bytes; /* of the whole record */
  uint16_t key_bytes;
  uint8_t choice_bytes; /* 1 or 2; all ones: stand down */
} qtr_record_shape;

/* An open table: views into its bytes, which must stay where they are and unchanged as long as it is used. */
typedef struct {
  const uint8_t *bytes;
  uint32_t size; /* of the part that a robot reads; a host may keep names behind it */
  uint8_t format;
  uint8_t features; /* what the table makes use of: docs/policy-format.md */
  uint8_t terms;    /* which of the field's terms it has: docs/policy-format.md */
  bool any_start;   /* each region is a start, and the cells' regions are known */
  qtr_record_shape records_shape;
  qtr_board board;                  /* its starts are the mission's own */
  uint32_t records;                 /* state/choice records */
  uint32_t at[QTR_POLICY_SECTIONS]; /* where each section begins */
  qtr_grid grid;                    /* what of the map can be reached */
} qtr_policy;

/* Open the table of `size` bytes at `bytes` (no alignment needed); bytes behind the robot's part are not looked at.
 * QTR_OK; QTR_ERR_TRUNCATED, _MAGIC, _FORMAT, _CHECKSUM, _CORRUPT or _SELFTEST if it is not whole, holds what would be
 * read out of bounds, or is played otherwise by this build than by the one that wrote it; QTR_ERR_LIMIT if this build's
 * arrays are too small for it; QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_policy_open(policy, bytes, size) qtr_policy_open_built(policy, bytes, size, QTR_CONFIG_ID)
int qtr_policy_open_built(qtr_policy *policy, const void *bytes, uint32_t size, uint32_t config_id);

/* Whether what an open table says can be true of any map and any play, number by number and of one another: QTR_OK;
 * QTR_ERR_CORRUPT, _TRAVEL or _CERTIFICATE. Every host program that writes or reads a table asks it
 * (docs/policy-format.md). A robot need not: whatever its table says, it announces nothing but what it has scanned,
 * takes a place for blocked that it has no way to, and comes to an end. */
int qtr_policy_check(const qtr_policy *policy);

/* Where the table's grid lies in the world, read from the table at each call; a cell_size_um of 0: the map has no
 * metres. */
qtr_frame qtr_policy_frame(const qtr_policy *policy);

/* The cell of a node: of place p for p < places, of start s for places + s; QTR_NO_CELL if there is no such node,
 * or the table puts it off the grid. */
qtr_cell qtr_policy_cell(const qtr_policy *policy, unsigned node);

/* The place of the mission that one of the table's is a look at: itself, where it is the first. A number that is none
 * is given back. */
unsigned qtr_policy_place(const qtr_policy *policy, unsigned place);

/* The ground as a seeker may enter it: the table's grid, for one that keeps off rough ground without that. */
qtr_grid qtr_policy_ground(const qtr_policy *policy, unsigned seeker);

/* A place's likelihood in units of 2^-32, 1 or more; 0 if there is no such place. */
uint32_t qtr_policy_weight(const qtr_policy *policy, unsigned place);

/* The start that stands for a cell: QTR_POLICY_NO_REGION for one that is blocked or outside, and on a table that is not
 * for any start. */
unsigned qtr_policy_region(const qtr_policy *policy, qtr_cell cell);

QTR_C_END

#endif
