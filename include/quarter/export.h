/* The learner's result as the bytes of a policy table (docs/policy-format.md). */
#ifndef QUARTER_EXPORT_H
#define QUARTER_EXPORT_H

#include <stdint.h>

#include "quarter/learner.h"

/* What a table is made of; all pointers are the caller's. */
typedef struct {
  const qtr_mission *mission;
  const qtr_board *board;    /* over the places, its starts those of `start` */
  const double *probability; /* of each place */
  const qtr_cell *start;     /* cells of the board's starts */
  const uint16_t *region;    /* of each cell, a start of the board: the table is for any start; NULL: it is not */
  const uint8_t *records;    /* qtr_record_bytes() each, sorted by key, each key once */
  uint32_t record_count;
  const qtr_certificate *certificate; /* of the mission's own starts */
  uint64_t seed;
} qtr_table_content;

/* Bytes of a record: the board's key, the choice, 2 of 0. */
uint32_t qtr_record_bytes(const qtr_board *board);

/* Write the record of a state, somebody's turn it being, and the choice made there. */
void qtr_record_write(uint8_t *record, const qtr_joint *joint, const qtr_board *board, uint16_t choice);

/* Below 0, 0 or above 0, as record `a`'s key is less than, equal to or greater than `b`'s. */
int qtr_record_compare(const uint8_t *a, const uint8_t *b, const qtr_board *board);

/* Bytes that a table takes. */
uint32_t qtr_table_size(const qtr_table_content *content);

/* Write a table to `bytes`, which holds `size`, and open it once to be sure that a robot will. Returns the bytes written,
 * or QTR_ERR_SPACE, or an error of qtr_policy_open(). */
int32_t qtr_table_write(const qtr_table_content *content, uint8_t *bytes, uint32_t size);

/* The table of the best game that a learner found, and its size. */
uint32_t qtr_export_size(const qtr_learner *learner);
int32_t qtr_export(qtr_learner *learner, uint8_t *bytes, uint32_t size);

#endif
