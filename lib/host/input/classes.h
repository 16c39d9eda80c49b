/* Classes of robots, as a mission states them. Robots that name none are together in one without a name. */
#ifndef QUARTER_HOST_CLASSES_H
#define QUARTER_HOST_CLASSES_H

#include "host/input/input.h"
#include "host/input/tree.h"

/* The key `classes`: all but the places that they avoid, which are not known yet. 0, or -1 with the fault set. */
int classes_read(input *in, tree *yaml, tree_node *root);

/* Put a robot into the class of that name; of none, where it is empty. 0, or -1 with *why set: there is no such class,
 * or there are more than the build holds. */
int classes_join(input *in, unsigned seeker, const char *name, input_origin origin, fault *why);

/* The rest, when map, robots and places are known: what they avoid, that speeds are of metres, and that the
 * objective's own keys are there with it alone. 0, or -1 with the fault set. */
int classes_finish(input *in, tree *yaml, tree_node *root);

#endif
