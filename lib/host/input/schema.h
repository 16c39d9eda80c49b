/* A set of keys as a JSON Schema (draft 7, which editors know), so that an editor completes and checks a file. */
#ifndef QUARTER_HOST_SCHEMA_H
#define QUARTER_HOST_SCHEMA_H

#include <stdio.h>

#include "host/input/keys.h"

void schema_write(FILE *out, const key_set *set);

#endif
