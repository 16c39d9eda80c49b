/* Values with separators between (CSV, RFC 4180): rows of a file, one by one. Fields may be quoted, and then hold
 * separators, line breaks and doubled quotes. */
#ifndef QUARTER_HOST_SEPARATED_H
#define QUARTER_HOST_SEPARATED_H

#include <stdbool.h>
#include <stdio.h>

#include "host/base/file.h"

#define SEPARATED_MOST 64

typedef struct {
  const char *text;  /* without the blanks and quotes around it; stands in the file's bytes */
  long line, column; /* where it begins, from 1 */
} separated_field;

typedef struct {
  const char *path;
  fault *why;
  char separator;
  char *next, *end; /* of the bytes that are left */
  long next_line;
  long line; /* of the current row */
  int count; /* of its fields */
  separated_field field[SEPARATED_MOST];
} separated;

/* Begin to read bytes, which are changed by it and must outlive the fields. The separator is ';' where the first row
 * has one, else ','. */
void separated_begin(separated *s, file_bytes *bytes, const char *path, fault *why);

/* The next row; rows that are blank or begin with # are passed over. 1, 0 where none is left, or -1 with *why set: a
 * quote without its end, text behind one, or more than SEPARATED_MOST fields. */
int separated_next(separated *s);

/* A number's text with a point for a comma, where the separator leaves commas to numbers: 0,5 is 0.5. */
#define SEPARATED_NUMBER 64
const char *separated_number(const separated *s, const char *text, char out[SEPARATED_NUMBER]);

/* Write a field, quoted where need be. */
void separated_put(FILE *out, const char *text);

#endif
