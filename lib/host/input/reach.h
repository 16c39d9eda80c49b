/* The ground that the robots can get to. */
#ifndef QUARTER_HOST_REACH_H
#define QUARTER_HOST_REACH_H

#include "host/input/input.h"

/* A byte a cell, for free(): 1 for a free cell that a robot can get to or, where no robot stands on a free cell, for
 * any free one. NULL with no memory. */
uint8_t *reach_mark(const input *in);

#endif
