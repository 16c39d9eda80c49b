/* A set of keys as people read of it: a table of Markdown for a mapping, then those that it holds. */
#ifndef QUARTER_HOST_REFERENCE_H
#define QUARTER_HOST_REFERENCE_H

#include <stdio.h>

#include "host/input/keys.h"

/* What a key takes: "a number above 0 and up to 1". */
void reference_write_values(FILE *out, const key_record *r);

void reference_write(FILE *out, const key_set *set);

#endif
