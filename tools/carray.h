/* A policy table as a C source file, to be linked into firmware. */
#ifndef QUARTER_TOOLS_CARRAY_H
#define QUARTER_TOOLS_CARRAY_H

#include <stdio.h>

#include "quarter/policy.h"

/* Write what a robot reads of an open table as `const uint8_t NAME[]` and `const uint32_t NAME_size`, NAME being made
 * from the file's name: a C identifier. Before them stand the array sizes that it needs, and where the compiler finds
 * Quarter's config.h a check that the build has them. */
void carray_write(FILE *out, const char *path, const qtr_policy *policy);

#endif
