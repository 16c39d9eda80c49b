/* Values as users write them, in whatever file: text made what it must be, or a fault that names the key and the place
 * where it stands. */
#ifndef QUARTER_HOST_VALUE_H
#define QUARTER_HOST_VALUE_H

#include "host/base/fault.h"

/* Where a value stands. */
typedef struct {
  fault *why;
  const char *path;
  long line, column; /* from 1; 0: not known */
} value_site;

int value_fault(const value_site *site, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* `text` as what it must be; `key` names it in the fault. 0, or -1 with the fault set. */
int value_number(double *out, const value_site *site, const char *key, const char *text);
int value_integer(long *out, const value_site *site, const char *key, const char *text);
int value_text(const value_site *site, const char *key, const char *text); /* that it is not empty */

/* One of `words` (ended by NULL, case ignored), as its index. */
int value_word(int *out, const value_site *site, const char *key, const char *text, const char *const *words);

/* What a word of `words` is called in a fault: "one of a, b and c". */
void value_words(char *out, size_t size, const char *const *words);

#endif
