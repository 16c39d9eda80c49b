/* A mission's key `places_geojson`: places out of points and polygons. */
#ifndef QUARTER_HOST_GEOPLACES_H
#define QUARTER_HOST_GEOPLACES_H

#include "host/input/input.h"
#include "host/input/tree.h"

/* Add its places, if the mission has it, once map, `geo`, robots and listed places are read: a place a point, and tiles
 * of the polygons. 0, or -1 with the fault set. */
int geoplaces_read(input *in, tree *yaml, tree_node *root);

#endif
