/* The one place where a travel time is read; inline, for the joint game reads little else. */
#ifndef QUARTER_ROBOT_BOARD_H
#define QUARTER_ROBOT_BOARD_H

#include "core/bytes.h"
#include "quarter/board.h"
#include "quarter/status.h"

/* qtr_board_steps() for what is known to lie in its ranges. */
static inline qtr_steps steps_between(const qtr_board *board, unsigned seeker, unsigned node, unsigned place) {
  (void)seeker; /* all travel alike */
  /* A seeker stands on a node of the board, and goes to one of its places. */
  QTR_ASSERT(seeker < board->seekers && node < (unsigned)board->places + board->starts && place < board->places);
  return load32_le(board->steps + 4 * ((uint32_t)node * board->places + place));
}

#endif
