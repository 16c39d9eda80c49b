/* Text from outside: lines, numbers, and characters that can be shown. */
#ifndef QUARTER_HOST_TEXT_H
#define QUARTER_HOST_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "host/base/file.h"

/* Lines of a file, one by one. A byte order mark at the start and the \r of \r\n are dropped. */
typedef struct {
  const char *line; /* the current one, not terminated */
  size_t length;
  int number; /* of the current line, from 1 */
  const char *next, *end;
} text_lines;

void text_start(text_lines *lines, const file_bytes *bytes);
bool text_next(text_lines *lines); /* false: no line is left */

/* Whether there is nothing but spaces and tabs. */
bool text_blank(const char *text, size_t length);

/* Without the spaces and tabs on both sides. */
void text_trim(const char **text, size_t *length);

/* A part of a text; not terminated. */
typedef struct {
  const char *text;
  size_t length;
} text_field;

bool text_field_is(text_field field, const char *word);

/* A decimal number, all of text[length]. NULL, or what is wrong with it ("is not a number"). */
const char *text_number(double *out, const char *text, size_t length);

/* A decimal integer of at most 9 digits. False if it is something else. */
bool text_integer(long *out, const char *text, size_t length);

/* A byte for a message: 'x' where it can be shown, 0x1b otherwise. Returns out. */
#define TEXT_GLYPH_SIZE 8
const char *text_glyph(char out[TEXT_GLYPH_SIZE], char byte);

#endif
