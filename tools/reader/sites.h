/* The starts and places of an input: added by the readers one by one, checked together once the map is known. */
#ifndef QUARTER_READER_SITES_H
#define QUARTER_READER_SITES_H

#include "input.h"

/* The path that an origin's source stands for. */
const char *sites_path(const input *in, input_origin origin);

/* -1 with *fault set: more than the build holds; for a place also a weight that is not above 0. */
int sites_add_start(input *in, qtr_cell cell, input_origin origin, fault *why);
int sites_add_place(input *in, qtr_cell cell, double weight, input_origin origin, fault *why);

/* -1 with *fault set: `columns` x `rows` cells are more than the build holds, or none. Nothing was allocated or
 * written for them yet. `line` is where the numbers stand, 0 for nowhere. */
int sites_check_size(const char *path, long line, double columns, double rows, fault *why);

/* All starts and places against the map and one another, and the number of robots asked for (0: as many as there are
 * starts). Gives every robot its start. */
int sites_finish(input *in, int robots, fault *why);

#endif
