/* ESRI ASCII grids: a header of names and numbers, then values row by row from the top. */
#ifndef QUARTER_HOST_ASC_H
#define QUARTER_HOST_ASC_H

#include <stdbool.h>

#include "host/base/file.h"
#include "host/input/raster.h"

bool asc_looks_like_one(const file_bytes *bytes);

/* Values that are the header's NODATA_value (-9999 where it has none) become NaN; one that is no finite number is
 * refused. The sides of the grid are checked against the file's size before anything is allocated. 0, or -1 with *fault
 * set and nothing to free. */
int asc_read(raster *it, const char *path, const file_bytes *bytes, fault *why);

#endif
