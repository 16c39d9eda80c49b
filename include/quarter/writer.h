/* The bytes of a policy table (docs/policy-format.md), from what it is to hold. */
#ifndef QUARTER_WRITER_H
#define QUARTER_WRITER_H

#include <stdint.h>

#include "quarter/learner.h"

QTR_C_BEGIN

/* What a table is made of; all pointers are the caller's. */
typedef struct {
  const qtr_mission *mission;
  const qtr_board *board;    /* over the places, its starts those of `start` */
  const double *probability; /* of each place */
  const qtr_cell *start;     /* cells of the board's starts */
  const uint16_t *region;    /* of each cell, a start of the board: the table is for any start; NULL: it is not */
  const uint8_t *records;    /* of the states that are met, sorted by key, each key once */
  uint32_t record_count;
  const qtr_certificate *certificate; /* of the mission's own starts */
  uint64_t seed;
  const qtr_box *used;              /* part of the map that robots get about in; NULL: all of it */
  const qtr_places *cleared;        /* before the start, known to all; NULL: none */
  const qtr_objective_terms *terms; /* what worths depend on besides; NULL: nothing */
} qtr_table_content;

/* Bytes that a table takes. */
uint32_t qtr_table_size(const qtr_table_content *content);

/* Write a table to `bytes`, which holds `size`, and open it once to be sure that a robot will. Returns the bytes
 * written, or QTR_ERR_SPACE, or an error of qtr_policy_open() or qtr_policy_check(). */
int32_t qtr_table_write(const qtr_table_content *content, uint8_t *bytes, uint32_t size);

QTR_C_END

#endif
