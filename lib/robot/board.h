/* What only the core asks of a board: travel times, read in this one place and inline, for the joint game reads little
 * else; and its seekers as a table has them. */
#ifndef QUARTER_ROBOT_BOARD_H
#define QUARTER_ROBOT_BOARD_H

#include "core/bytes.h"
#include "quarter/board.h"
#include "quarter/status.h"

/* Number `i` of times of so many bytes each. */
inline qtr_steps qtr_load_steps(const uint8_t *times, unsigned bytes, uint32_t i) {
  const uint8_t *at = times + (bytes * i);
  if (bytes == 4u) {
    return qtr_load32(at);
  }
  const uint32_t steps = (bytes == 1u) ? at[0] : qtr_load16(at);
  return (steps == ((bytes == 1u) ? 0xFFu : 0xFFFFu)) ? QTR_NEVER : steps;
}

/* qtr_board_class_steps() for what is known to lie in its ranges. */
inline qtr_steps qtr_steps_of_class(const qtr_board *board, unsigned of_class, unsigned node, unsigned place) {
  const uint32_t nodes = (uint32_t)board->places + board->starts;
  /* A seeker stands on a node of the board, and goes to one of its places. */
  QTR_ASSERT((node < nodes) && (place < board->places));
  const uint32_t row = (QTR_TERMS ? (of_class * nodes) : 0u) + node;
  return qtr_load_steps(board->steps, board->step_bytes, (row * board->places) + place);
}

/* qtr_board_steps() likewise. */
static inline qtr_steps qtr_steps_between(const qtr_board *board, unsigned seeker, unsigned node, unsigned place) {
  QTR_ASSERT(seeker < board->seekers);
  return qtr_steps_of_class(board, QTR_TERMS ? board->class_of[seeker] : 0u, node, place);
}

/* Without terms all are of one kind, and nothing is kept of it. */
static inline unsigned kind_of_seeker(const qtr_key_shape *shape, unsigned seeker) {
  return QTR_TERMS ? shape->kind[seeker] : 0u;
}

/* Whether a board's numbers, without its seats and travel times, are in their ranges: QTR_OK; QTR_ERR_LIMIT,
 * QTR_ERR_ARGUMENT. */
int qtr_board_check(const qtr_board *board);

/* qtr_board_init() for a board that has been checked: looks at the rest, and derives what follows from it. QTR_OK;
 * QTR_ERR_ARGUMENT, QTR_ERR_LIMIT. */
int qtr_board_derive(qtr_board *board);

/* What a table says of each seeker, from the board's seekers on: where it starts. 2 bytes each. */
void qtr_board_load_seats(qtr_board *board, const uint8_t *bytes);
void qtr_board_store_seats(const qtr_board *board, uint8_t *bytes);

#endif
