/* A mission's key `places_raster`: places out of a likelihood for each piece of the ground. */
#ifndef QUARTER_HOST_LIKELIHOOD_H
#define QUARTER_HOST_LIKELIHOOD_H

#include "host/input/input.h"
#include "host/input/tree.h"

/* Add its places, if the mission has it, once map, robots and all other places are read. 0, or -1 with the fault
 * set. */
int likelihood_read(input *in, tree *yaml, tree_node *root);

#endif
