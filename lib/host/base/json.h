/* A small JSON writer: indented, in the order of the calls, without allocation. */
#ifndef QUARTER_HOST_JSON_H
#define QUARTER_HOST_JSON_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#define JSON_DEPTH 16

typedef struct {
  FILE *out;
  int depth;
  int flat;                /* depth from which on all stands on one line; 0: nowhere */
  bool filled[JSON_DEPTH]; /* the object or array at this depth has a member already */
} json;

void json_begin(json *j, FILE *out);

/* Inside an object every value takes a key, inside an array it is NULL. */
void json_object(json *j, const char *key);
void json_array(json *j, const char *key);
/* The same on one line, with all that they hold. */
void json_flat_object(json *j, const char *key);
void json_flat_array(json *j, const char *key);
/* End the object or array begun last; the outermost one ends with a newline. */
void json_end_object(json *j);
void json_end_array(json *j);

/* The shortest decimal that reads back as the same double; null for NaN and the infinities. */
void json_number(json *j, const char *key, double value);
void json_integer(json *j, const char *key, int64_t value);
void json_natural(json *j, const char *key, uint64_t value);
void json_bool(json *j, const char *key, bool value);
void json_null(json *j, const char *key);
/* Control characters are escaped, bytes that are no UTF-8 become U+FFFD. */
void json_string(json *j, const char *key, const char *value);

#endif
