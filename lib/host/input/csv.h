/* The places of a CSV file: a header that names keys of a place in any order (mission_keys.h), then a place a row:
 * "x,y,weight,name". Columns of other names are left alone, and a note says which. How the bytes are read, separated.h
 * says. */
#ifndef QUARTER_HOST_CSV_H
#define QUARTER_HOST_CSV_H

#include "host/base/file.h"
#include "host/input/input.h"

/* Add the places of the file in->csv, whose contents are `bytes`, which are changed. 0, or -1 with *fault set. */
int csv_read(input *in, file_bytes *bytes, fault *why);

#endif
