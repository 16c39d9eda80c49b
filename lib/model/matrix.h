/* Travel times from nodes to places, solved on the grid: the elemental tasks (paper, section 4.1) as a board reads
 * them. */
#ifndef QUARTER_MATRIX_H
#define QUARTER_MATRIX_H

#include "quarter/mission.h"
#include "quarter/travel.h"

/* Fill `steps`, a row of 4-byte times for every place and then for every one of the `starts` cells. One search a place
 * gives the times to it from everywhere; the mission's watch is asked between two. Returns the places done: all, but
 * after a stop. `used` (may be NULL) is widened by all cells that a place can be reached from, and by the starts. */
uint16_t qtr_matrix_fill(uint8_t *steps, const qtr_mission *mission, const qtr_cell *start, unsigned starts,
                         qtr_travel *travel, qtr_box *used);

#endif
