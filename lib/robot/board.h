/* The one place where a travel time is read; inline, for the joint game reads little else. */
#ifndef QUARTER_ROBOT_BOARD_H
#define QUARTER_ROBOT_BOARD_H

#include "core/bytes.h"
#include "quarter/board.h"

/* qtr_board_steps() for what is known to lie in its ranges. */
static inline qtr_steps steps_between(const qtr_board *board, unsigned seeker, unsigned node, unsigned place) {
  (void)seeker; /* all travel alike */
  return load32_le(board->steps + 4 * ((uint32_t)node * board->places + place));
}

#endif
