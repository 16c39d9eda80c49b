/* YAML that libyaml would take minutes for. */
#ifndef QUARTER_HOST_SHAPE_H
#define QUARTER_HOST_SHAPE_H

#include "host/base/file.h"

/* That a text is nested, and uses directives, anchors and aliases, as little as any map or mission does: libyaml's time
 * is quadratic in each of them, so that a few hundred kilobytes of brackets would hang the tool. 0, or -1 with *why set.
 * Text that is not valid YAML is let through, for the parser to report. */
int shape_check(const char *path, const file_bytes *bytes, fault *why);

#endif
