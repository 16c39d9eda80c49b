/* An image of blocked, free and slow pixels, grown by the robot's radius and coarsened to planning cells. */
#ifndef QUARTER_HOST_PIXELS_H
#define QUARTER_HOST_PIXELS_H

#include <stdint.h>

#include "host/base/fault.h"

typedef struct {
  int width, height; /* 1..65535 */
  uint8_t *blocked;  /* row by row from the top, 1 = blocked */
  uint8_t *slow;     /* likewise, steps that entering takes beyond the first, up to 254; NULL: none does */
} pixels;

/* Block every pixel whose middle lies within `radius` (in pixels) of a blocked pixel, a square of side 1; touching
 * counts. Exact, in time linear in the pixels. 0, or -1 with no memory.
 *
 * So a disc of that radius touches no obstacle wherever its own middle is between the middles of neighbouring free
 * pixels, not only on them: obstacles are unions of whole pixels, so between two such middles no obstacle comes nearer
 * than it does to one of them. The way between two free cells' middles lies there. The image's edge is no obstacle. */
int pixels_grow(pixels *map, double radius);

/* Cells of `ratio` pixels a side that cover `map` pixels. A ratio within a millionth of a whole number is that
 * number, and an overlap below 1e-4 of a pixel is none: both are rounding. May exceed what an int holds. */
double pixels_cells(int map, double ratio);

/* Fill cost[rows * columns], row 0 on top, with 0 for cells that a blocked pixel or the image's edge cuts, for others
 * with the steps of their slowest pixel. Cell edges start at the lower-left corner of the image. `columns` and `rows`
 * are those of pixels_cells(). 0, or -1 with no memory. */
int pixels_coarsen(uint8_t *cost, int columns, int rows, const pixels *map, double ratio);

#endif
