/* Records of a table under way: the state's key and the choice made there (robot/layout.h). */
#ifndef QUARTER_RECORD_H
#define QUARTER_RECORD_H

#include "quarter/joint.h"
#include "robot/layout.h"

/* Write the record of a state, somebody's turn it being, and the choice made there: record_shape_written().bytes. */
void qtr_record_write(uint8_t *record, const qtr_joint *joint, const qtr_board *board, uint16_t choice);

/* How records of a board are laid out in the tables that are written. */
static inline qtr_record_shape record_shape_written(const qtr_board *board) {
  return record_shape_of(QTR_POLICY_FORMAT, board);
}

#endif
