#include "host/input/value.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "host/base/file.h"
#include "host/base/near.h"
#include "host/base/text.h"

int value_fault(const value_site *site, const char *format, ...) {
  char message[FAULT_LINE];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(message, sizeof message, format, arguments);
  va_end(arguments);
  return file_fault(site->why, site->path, site->line, site->column, "%s", message);
}

static int wrong(const value_site *site, const char *key, const char *text, const char *wanted) {
  if (text[0] == '\0') return value_fault(site, "'%s' has no value; give %s", key, wanted);
  return value_fault(site, "'%s' is \"%.60s\"; give %s", key, text, wanted);
}

int value_number(double *out, const value_site *site, const char *key, const char *text) {
  if (text[0] == '\0') return wrong(site, key, text, "a number");
  const char *what = text_number(out, text, strlen(text));
  if (what == NULL) return 0;
  return value_fault(site, "'%s' is \"%.60s\", which %s; give a number", key, text, what);
}

int value_integer(long *out, const value_site *site, const char *key, const char *text) {
  double number;
  if (text_integer(out, text, strlen(text))) return 0;
  const bool whole = text_number(&number, text, strlen(text)) == NULL && fabs(number) < 1e9 && number == floor(number);
  if (!whole) return wrong(site, key, text, "a whole number");
  *out = (long)number; /* 4.0, as programs write it */
  return 0;
}

int value_text(const value_site *site, const char *key, const char *text) {
  return text[0] != '\0' ? 0 : wrong(site, key, text, "a text");
}

void value_words(char *out, size_t size, const char *const *words) {
  char list[400];
  near_list(list, sizeof list, words);
  snprintf(out, size, "one of %s", list);
}

int value_word(int *out, const value_site *site, const char *key, const char *text, const char *const *words) {
  char wanted[420];
  for (int i = 0; words[i] != NULL; i++) {
    if (strcasecmp(words[i], text) != 0) continue;
    *out = i;
    return 0;
  }
  value_words(wanted, sizeof wanted, words);
  return wrong(site, key, text, wanted);
}
