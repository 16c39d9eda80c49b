/* The places of a CSV file: a header "x,y,weight" (metres in the map frame) or "column,row,weight" (cells), the columns
 * in any order, then a place a line. Commas only; spaces around a field, quotes around it, \r\n and a byte order mark
 * are allowed, empty lines and lines that start with # skipped. */
#ifndef QUARTER_HOST_CSV_H
#define QUARTER_HOST_CSV_H

#include "host/base/file.h"
#include "host/input/input.h"

/* Add the places of the file in->csv, whose contents are `bytes`. 0, or -1 with *fault set. */
int csv_read(input *in, const file_bytes *bytes, fault *why);

#endif
