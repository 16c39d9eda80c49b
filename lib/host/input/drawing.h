/* Drawings: a character a cell. `#` blocked, `.` free, `~` terrain of cost 3, `S` a start, `1`..`9` a place of that
 * weight; a line that starts with `;` is a comment. */
#ifndef QUARTER_HOST_DRAWING_H
#define QUARTER_HOST_DRAWING_H

#include <stdbool.h>

#include "host/base/file.h"
#include "host/input/input.h"

#define DRAWING_TERRAIN_COST 3

/* Which marks become starts and places; the others' cells are plain free cells. */
typedef struct {
  bool starts, places;
} drawing_marks;

/* Fill the input's cells, starts and places; in->map is the drawing's path. 0, or -1 with *fault set. */
int drawing_read(input *in, const file_bytes *bytes, drawing_marks marks, fault *why);

/* Whether there are rows of equal length, and nothing but a drawing's characters and comments. */
bool drawing_looks_like_one(const file_bytes *bytes);

#endif
