#include "table/record.h"

#include "quarter/status.h"
#include "robot/bits.h"

/* The least significant byte first, so that records are compared from their last key byte down, as numbers are. */
void qtr_record_write(uint8_t *record, const qtr_joint *joint, const qtr_board *board, uint16_t choice) {
  const qtr_record_shape shape = record_shape_written(board);
  qtr_key key;
  /* A record answers for the seeker whose turn it is. */
  QTR_ASSERT(qtr_joint_chooser(joint, board) != QTR_NOBODY);
  QTR_ASSERT(choice < board->places || choice == QTR_STAND_DOWN);
  qtr_joint_key(&key, joint, &board->keys);
  for (uint32_t i = 0; i < shape.key_bytes; i++) record[i] = bits_byte(key.word, i);
  if (shape.choice_bytes == 2)
    qtr_store16(record + shape.key_bytes, choice);
  else
    record[shape.key_bytes] = choice == QTR_STAND_DOWN ? 0xFFu : (uint8_t)choice;
}
