/* The starts and places of an input: added by the readers one by one, checked together once the map is known. */
#ifndef QUARTER_HOST_SITES_H
#define QUARTER_HOST_SITES_H

#include "host/input/input.h"

/* A start or place in the map as read so far; on an obstacle or outside it is taken too, for sites_finish to judge. -1
 * with *fault set: more than the build holds, or a name that another one has. */
int sites_add_start(input *in, const input_site *site, input_origin origin, fault *why);
int sites_add_place(input *in, const input_site *site, input_origin origin, fault *why);

/* -1 with *fault set: `columns` x `rows` cells are more than the build holds, or none. Nothing was allocated or
 * written for them yet. `line` is where the numbers stand, 0 for nowhere; `mend` is what to do about too many. */
int sites_check_size(const char *path, long line, double columns, double rows, const char *mend, fault *why);

/* All starts and places against the map and one another, and the number of robots asked for. Gives every robot its
 * start. Moves to free cells and leaves out what the options allow, and notes it; all that is left on no free cell of
 * its own is one fault, a line each. */
int sites_finish(input *in, const input_options *options, fault *why);

#endif
