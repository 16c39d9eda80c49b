/* The ground that the robots can get to. */
#ifndef QUARTER_HOST_REACH_H
#define QUARTER_HOST_REACH_H

#include "host/input/input.h"

/* Classes of robots, a bit each. */
typedef uint64_t reach;

/* For each cell, for free(): which classes have a robot that can get there, over ground that the class may enter. Where
 * no robot stands on a free cell, all can get to any. NULL with no memory. */
reach *reach_mark(const input *in);

#endif
