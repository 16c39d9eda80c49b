/* Travel times between the nodes of a mission, by shortest ways on its grid: a matrix for each class of robots. */
#ifndef QUARTER_MODEL_MATRIX_H
#define QUARTER_MODEL_MATRIX_H

#include <stdint.h>

#include "quarter/mission.h"
#include "quarter/travel.h"

/* What the rows and columns are: a row for each place, then for each start, a column for each place. A place is a look
 * at one of the mission's. */
typedef struct {
  const qtr_mission *mission;
  unsigned places;        /* the mission's and their later looks */
  const uint8_t *look_of; /* u16 each: which of the mission's; NULL: the mission's own, in their order */
  const qtr_cell *start;  /* cells of the starts */
  unsigned starts;
} qtr_matrix_nodes;

/* The mission's grid for robots of a class. */
qtr_grid qtr_matrix_grid(const qtr_mission *mission, unsigned of_class);

/* Which of the mission's places a place is a look at. */
unsigned qtr_matrix_place(const qtr_matrix_nodes *nodes, unsigned place);

/* Fill in the matrices of all classes, one after another, 4 bytes a time, scans included. `used` (may be NULL) grows by
 * what of the map there is a way to a place from, and the starts. Returns how many of the mission's places were done:
 * fewer than there are if its watch ended it. */
uint16_t qtr_matrix_fill(uint8_t *steps, const qtr_matrix_nodes *nodes, qtr_travel *travel, qtr_box *used);

/* Fill in a row of times from each place to `start`, the ways home of a seeker of that class: 4 bytes each. */
void qtr_matrix_fill_home(uint8_t *home, const qtr_matrix_nodes *nodes, unsigned of_class, qtr_cell start,
                          qtr_travel *travel);

#endif
