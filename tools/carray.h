/* A policy table as a C source file, to be linked into firmware. */
#ifndef QUARTER_TOOLS_CARRAY_H
#define QUARTER_TOOLS_CARRAY_H

#include <stdint.h>
#include <stdio.h>

/* Write `const uint8_t NAME[]` and `const uint32_t NAME_size`, NAME being made from the file's name: a C identifier. */
void carray_write(FILE *out, const char *path, const uint8_t *bytes, uint32_t size);

#endif
