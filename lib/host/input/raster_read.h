/* A raster of whatever format. */
#ifndef QUARTER_HOST_RASTER_READ_H
#define QUARTER_HOST_RASTER_READ_H

#include "host/base/fault.h"
#include "host/input/raster.h"

/* Read the file, which `named_by` ("mission.yaml:3") asked for. 0, or -1 with *fault set and nothing to free. */
int raster_read(raster *it, const char *path, const char *named_by, fault *why);

#endif
