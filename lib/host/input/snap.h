/* Starts and places that are on no free cell of their own. */
#ifndef QUARTER_HOST_SNAP_H
#define QUARTER_HOST_SNAP_H

#include "host/input/input.h"

/* Move what options->snap allows to the nearest free cell, leave out what options->skip allows, and note each. All that
 * is left over is one fault with a line each. 0, or -1 with *fault set. */
int snap_all(input *in, const input_options *options, fault *why);

#endif
