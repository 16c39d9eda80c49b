#include "table/record.h"

#include "quarter/status.h"

void qtr_record_write(uint8_t *record, const qtr_joint *joint, const qtr_board *board, uint16_t choice) {
  const unsigned words = board->keys.words;
  qtr_key key;
  /* A record answers for the seeker whose turn it is. */
  QTR_ASSERT(qtr_joint_chooser(joint, board) != QTR_NOBODY);
  QTR_ASSERT(choice < board->places || choice == QTR_STAND_DOWN);
  qtr_joint_key(&key, joint, board);
  for (unsigned w = 0; w < words; w++) store32_le(record + 4 * w, key.word[w]);
  store16_le(record + record_choice_at(words), choice);
  store16_le(record + record_spare_at(words), 0);
}
