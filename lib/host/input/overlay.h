/* A raster laid over the planning grid. */
#ifndef QUARTER_HOST_OVERLAY_H
#define QUARTER_HOST_OVERLAY_H

#include "host/input/input.h"
#include "host/input/raster.h"

/* Where a value lies, in cells from the grid's lower left corner. */
typedef struct {
  double left, bottom;   /* the raster's corner */
  double across, upward; /* a value's sides */
} overlay;

/* -1 with *fault set, which names the raster by `path`: an image of other proportions than the map, or a grid that does
 * not lie on it. */
int overlay_find(overlay *over, const raster *it, const input *in, const char *path, fault *why);

/* What to do for a value and a cell that lie over each other: `part` of the value, 0..1, lies in the cell. */
typedef void overlay_visit(void *context, qtr_cell cell, double value, double part);

/* For each value but NaN and each cell under it, row by row from the raster's top. */
void overlay_each(const overlay *over, const raster *it, const input *in, overlay_visit *visit, void *context);

#endif
