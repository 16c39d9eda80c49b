/* Moving AI benchmark maps (movingai.com): "type octile", "height", "width", "map", then a character a cell.
 *
 * Passable at cost 1: '.', 'G' and 'S' (swamp, whose cost the format leaves open). Blocked: '@', 'O', 'T' and 'W':
 * water cannot be entered from the ground on which the robots drive. */
#ifndef QUARTER_HOST_MOVINGAI_H
#define QUARTER_HOST_MOVINGAI_H

#include <stdbool.h>

#include "host/base/file.h"
#include "host/input/input.h"

/* Fill the input's cells; in->map is the map's path. 0, or -1 with *fault set. */
int movingai_read(input *in, const file_bytes *bytes, fault *why);

/* Whether the first line is "type ...". */
bool movingai_looks_like_one(const file_bytes *bytes);

#endif
