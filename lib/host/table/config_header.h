/* A robot's array sizes from the header of its own that -DQTR_CONFIG_HEADER names. */
#ifndef QUARTER_HOST_CONFIG_HEADER_H
#define QUARTER_HOST_CONFIG_HEADER_H

#include "host/base/fault.h"
#include "host/table/robot_sizes.h"

/* Set those of `sizes` that `path` states by `#define QTR_MAX_CELLS 400` and the like; the others stay. It is not
 * compiled: a size that is no plain number, is stated twice or stands under a condition is refused, and so are a file
 * that states none and one that includes others of its own, for they might. 0, or -1 with *why set. */
int config_header_read(robot_sizes *sizes, const char *path, fault *why);

#endif
