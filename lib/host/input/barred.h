/* What a mission says of its ground beside the map: `terrain`, `keepout` and `no_go`. */
#ifndef QUARTER_HOST_BARRED_H
#define QUARTER_HOST_BARRED_H

#include "host/input/input.h"
#include "host/input/tree.h"

/* Lay them over the map, once it is read. 0, or -1 with the fault set. */
int barred_read(input *in, tree *yaml, tree_node *root);

#endif
