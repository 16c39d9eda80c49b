#include "host/base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

void text_start(text_lines *lines, const file_bytes *bytes) {
  lines->next = (const char *)bytes->data;
  lines->end = lines->next + bytes->size;
  lines->line = lines->next;
  lines->length = 0;
  lines->number = 0;
  if (bytes->size >= 3 && memcmp(bytes->data, "\xef\xbb\xbf", 3) == 0) lines->next += 3;
}

bool text_next(text_lines *lines) {
  if (lines->next >= lines->end) return false;
  lines->line = lines->next;
  const char *stop = memchr(lines->line, '\n', (size_t)(lines->end - lines->line));
  lines->next = stop == NULL ? lines->end : stop + 1;
  if (stop == NULL) stop = lines->end;
  if (stop > lines->line && stop[-1] == '\r') stop--;
  lines->length = (size_t)(stop - lines->line);
  lines->number++;
  return true;
}

bool text_blank(const char *text, size_t length) {
  for (size_t i = 0; i < length; i++) {
    if (text[i] != ' ' && text[i] != '\t') return false;
  }
  return true;
}

void text_trim(const char **text, size_t *length) {
  while (*length > 0 && text_blank(*text, 1)) {
    (*text)++;
    (*length)--;
  }
  while (*length > 0 && text_blank(*text + *length - 1, 1)) (*length)--;
}

static bool is_not_finite(const char *text) {
  static const char *const words[] = {"nan", "inf", "infinity"};
  if (*text == '+' || *text == '-') text++;
  if (*text == '.') text++; /* as YAML writes them */
  for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
    if (strcasecmp(text, words[i]) == 0) return true;
  }
  return false;
}

const char *text_number(double *out, const char *text, size_t length) {
  char copy[64];
  if (length == 0) return "is missing";
  if (length >= sizeof copy) return "is not a number of at most 63 characters";
  memcpy(copy, text, length);
  copy[length] = '\0';
  if (is_not_finite(copy)) return "is not a finite number";
  if (length > 1 && strspn(copy, "0123456789+-,.") == length && strchr(copy, ',') != NULL)
    return "has a comma where a point should be";
  if (strspn(copy, "0123456789+-.eE") != length) return "is not a number";
  char *end;
  double value = strtod(copy, &end);
  if (end != copy + length) return "is not a number";
  if (!isfinite(value)) return "is too large a number";
  *out = value;
  return NULL;
}

bool text_integer(long *out, const char *text, size_t length) {
  size_t i = length > 0 && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  if (i == length || length - i > 9) return false;
  long value = 0;
  for (; i < length; i++) {
    if (text[i] < '0' || text[i] > '9') return false;
    value = value * 10 + (text[i] - '0');
  }
  *out = text[0] == '-' ? -value : value;
  return true;
}

const char *text_glyph(char out[TEXT_GLYPH_SIZE], char byte) {
  unsigned char value = (unsigned char)byte;
  if (value > 0x20 && value < 0x7f) {
    snprintf(out, TEXT_GLYPH_SIZE, "'%c'", byte);
  } else {
    snprintf(out, TEXT_GLYPH_SIZE, "0x%02x", value);
  }
  return out;
}

bool text_field_is(text_field field, const char *word) {
  return field.length == strlen(word) && memcmp(field.text, word, field.length) == 0;
}
