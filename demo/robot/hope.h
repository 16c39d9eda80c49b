/* Whether a robot may still get to its target: no longer where the grid has no way from where it is, or where it has
 * come no nearer for so long that whatever is in the way will hardly go. */
#ifndef QUARTER_DEMO_HOPE_H
#define QUARTER_DEMO_HOPE_H

#include <stdbool.h>
#include <stdint.h>

#include "ground.h"
#include "quarter/field.h"

#define HOPE_PATIENCE 60000000 /* microseconds without coming nearer, on good ground; on slow ground all takes longer */

typedef struct {
  qtr_cell cell;  /* where it was last */
  unsigned least; /* steps of its way from wherever it has been, at the least */
  int64_t since;  /* utime: when it came that near, or began */
} hope;

/* It sets out for a new target. */
void hope_begin(hope *h, int64_t utime);

/* It is at a point; `way` leads to its target; `speed` is a robot's, 1 for one that takes a second for a cell. False:
 * there is no hope. */
bool hope_left(hope *h, const qtr_field *way, const ground *g, point at, double speed, int64_t utime);

/* Steps from a cell to a way's end, by the ground; UINT_MAX: there is no way. */
unsigned hope_steps(const qtr_field *way, const qtr_grid *grid, qtr_cell cell);

#endif
