/* A number for each piece of the ground: an image's greys, or an ESRI ASCII grid. */
#ifndef QUARTER_HOST_RASTER_H
#define QUARTER_HOST_RASTER_H

#include <stdbool.h>

typedef struct {
  int columns, rows;
  bool placed;       /* it says where it lies; false: an image, which covers the map */
  double x, y, size; /* placed: its lower left corner and the side of a value, as positions on the map are stated */
  double *value;     /* row by row from the top; of an image 0, black, to 255, white; NaN: there is none */
} raster;

void raster_free(raster *it);

#endif
