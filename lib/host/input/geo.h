/* Where on the globe a mission's map lies: its key `geo`. */
#ifndef QUARTER_HOST_GEO_H
#define QUARTER_HOST_GEO_H

#include "host/input/input.h"
#include "host/input/tree.h"

/* Read `geo`, if the mission has it, into in->geo, once the map is read. 0, or -1 with the fault set. */
int geo_read(input *in, tree *yaml, tree_node *root);

#endif
