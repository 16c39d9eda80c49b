/* A set of keys as people read of it: a table of Markdown for a mapping, then those that it holds. */
#ifndef QUARTER_HOST_REFERENCE_H
#define QUARTER_HOST_REFERENCE_H

#include <stdio.h>

#include "host/input/keys.h"

void reference_write(FILE *out, const key_set *set);

#endif
