/* Starts and places that are on no free cell of their own. */
#ifndef QUARTER_READER_SNAP_H
#define QUARTER_READER_SNAP_H

#include "input.h"

/* Move what options->snap allows to the nearest free cell, leave out what options->skip allows, and note each. All that
 * is left over is one fault with a line each. 0, or -1 with *fault set. */
int snap_all(input *in, const input_options *options, fault *why);

#endif
