#include "host/input/raster.h"

#include <stdlib.h>

void raster_free(raster *it) {
  free(it->value);
  it->value = NULL;
}
