#include "host/base/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/utf8.h"

static bool is_flat(const json *j) {
  return j->flat > 0 && j->depth >= j->flat;
}

static void new_line(const json *j) {
  if (is_flat(j)) return;
  fputc('\n', j->out);
  for (int i = 0; i < j->depth; i++) fputs("  ", j->out);
}

static void write_text(FILE *out, const char *text) {
  fputc('"', out);
  for (const char *c = text; *c != '\0';) {
    const int length = utf8_length(c);
    const unsigned char first = (unsigned char)*c;
    if (length == 0)
      fputs(UTF8_REPLACEMENT, out);
    else if (*c == '"' || *c == '\\')
      fprintf(out, "\\%c", *c);
    else if (first < 0x20 || first == 0x7F)
      fprintf(out, "\\u%04x", first);
    else
      fwrite(c, 1, (size_t)length, out);
    c += length > 0 ? length : 1;
  }
  fputc('"', out);
}

/* The comma, the line and the key before a value. */
static void before_value(json *j, const char *key) {
  if (j->depth > 0) {
    if (j->filled[j->depth]) fputs(is_flat(j) ? ", " : ",", j->out);
    j->filled[j->depth] = true;
    new_line(j);
  }
  if (key == NULL) return;
  write_text(j->out, key);
  fputs(": ", j->out);
}

static void begin(json *j, const char *key, char bracket, bool flat) {
  before_value(j, key);
  fputc(bracket, j->out);
  if (j->depth + 1 >= JSON_DEPTH) abort();
  j->depth++;
  j->filled[j->depth] = false;
  if (flat && j->flat == 0) j->flat = j->depth;
}

static void end(json *j, char bracket) {
  const bool flat = is_flat(j);
  const bool filled = j->filled[j->depth];
  if (j->flat == j->depth) j->flat = 0;
  j->depth--;
  if (filled && !flat) new_line(j);
  fputc(bracket, j->out);
  if (j->depth == 0) fputc('\n', j->out);
}

void json_begin(json *j, FILE *out) {
  memset(j, 0, sizeof *j);
  j->out = out;
}

void json_object(json *j, const char *key) {
  begin(j, key, '{', false);
}

void json_array(json *j, const char *key) {
  begin(j, key, '[', false);
}

void json_flat_object(json *j, const char *key) {
  begin(j, key, '{', true);
}

void json_flat_array(json *j, const char *key) {
  begin(j, key, '[', true);
}

void json_end_object(json *j) {
  end(j, '}');
}

void json_end_array(json *j) {
  end(j, ']');
}

void json_number(json *j, const char *key, double value) {
  char text[32];
  if (!isfinite(value)) {
    json_null(j, key);
    return;
  }
  before_value(j, key);
  for (int digits = 15; digits <= 17; digits++) {
    snprintf(text, sizeof text, "%.*g", digits, value);
    if (strtod(text, NULL) == value) break;
  }
  fputs(text, j->out);
}

void json_integer(json *j, const char *key, int64_t value) {
  before_value(j, key);
  fprintf(j->out, "%lld", (long long)value);
}

void json_natural(json *j, const char *key, uint64_t value) {
  before_value(j, key);
  fprintf(j->out, "%llu", (unsigned long long)value);
}

void json_bool(json *j, const char *key, bool value) {
  before_value(j, key);
  fputs(value ? "true" : "false", j->out);
}

void json_null(json *j, const char *key) {
  before_value(j, key);
  fputs("null", j->out);
}

void json_string(json *j, const char *key, const char *value) {
  before_value(j, key);
  write_text(j->out, value);
}
