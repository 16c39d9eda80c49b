#include "host/base/separated.h"

#include <string.h>

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/* ---- a row ---- */

/* Where the current line begins, for columns. */
typedef struct {
  char *at, *line;
} cursor;

static bool is_end_of_field(const separated *s, const char *at) {
  return at >= s->end || *at == s->separator || *at == '\n';
}

static void skip_blanks(const separated *s, cursor *c) {
  while (c->at < s->end && is_blank(*c->at)) c->at++;
}

static int begin_field(separated *s, const cursor *c) {
  if (s->count == SEPARATED_MOST)
    return file_fault(s->why, s->path, s->line, 0, "more than %d fields in a line; leave some columns out",
                      SEPARATED_MOST);
  s->field[s->count] = (separated_field){c->at, s->next_line, c->at - c->line + 1};
  return 0;
}

/* Unquote in place: what is read is never shorter than what is written. */
static int read_quoted(separated *s, cursor *c) {
  separated_field *field = &s->field[s->count];
  char *to = ++c->at;
  field->text = to;
  for (;; *to++ = *c->at++) {
    if (c->at >= s->end)
      return file_fault(s->why, s->path, field->line, field->column, "a quote begins here and has no end; close it");
    if (*c->at == '"' && (++c->at >= s->end || *c->at != '"')) break;
    if (*c->at == '\n') {
      s->next_line++;
      c->line = c->at + 1;
    }
  }
  skip_blanks(s, c);
  if (!is_end_of_field(s, c->at))
    return file_fault(s->why, s->path, s->next_line, c->at - c->line + 1,
                      "text stands behind a closing quote; write quotes inside a field twice");
  *to = '\0';
  return 0;
}

static void read_plain(separated *s, cursor *c, char **stop) {
  while (!is_end_of_field(s, c->at)) c->at++;
  *stop = c->at;
  while (*stop > s->field[s->count].text && is_blank((*stop)[-1])) --*stop;
}

/* Past what ends a field; *more is whether that is a separator. */
static void end_field(separated *s, cursor *c, bool *more) {
  *more = false;
  if (c->at >= s->end) return;
  *more = *c->at == s->separator;
  if (!*more) s->next_line++;
  c->at++;
}

/* A field and what ends it; *more is whether that is a separator. */
static int read_field(separated *s, cursor *c, bool *more) {
  char *stop = NULL;
  skip_blanks(s, c);
  if (begin_field(s, c) != 0) return -1;
  if (c->at < s->end && *c->at == '"') {
    if (read_quoted(s, c) != 0) return -1;
  } else {
    read_plain(s, c, &stop);
  }
  end_field(s, c, more);
  if (stop != NULL) *stop = '\0'; /* the bytes end in a NUL of their own */
  s->count++;
  return 0;
}

/* Pass over blank lines and remarks. False: nothing is left. */
static bool find_row(separated *s) {
  while (s->next < s->end) {
    char *stop = memchr(s->next, '\n', (size_t)(s->end - s->next)), *at = s->next;
    if (stop == NULL) stop = s->end;
    while (at < stop && is_blank(*at)) at++;
    if (at < stop && *s->next != '#') return true;
    s->next = stop < s->end ? stop + 1 : stop;
    s->next_line++;
  }
  return false;
}

/* Outside of quotes, in the line that is next. */
static bool line_has(const separated *s, char separator) {
  bool quoted = false;
  for (const char *at = s->next; at < s->end && *at != '\n'; at++) {
    if (*at == '"') quoted = !quoted;
    if (*at == separator && !quoted) return true;
  }
  return false;
}

void separated_begin(separated *s, file_bytes *bytes, const char *path, fault *why) {
  char *at = (char *)bytes->data;
  *s = (separated){.path = path, .why = why, .next = at, .end = at + bytes->size, .next_line = 1};
  if (bytes->size >= 3 && memcmp(at, "\xef\xbb\xbf", 3) == 0) s->next += 3;
  s->separator = find_row(s) && line_has(s, ';') ? ';' : ',';
}

int separated_next(separated *s) {
  bool more = true;
  if (!find_row(s)) return 0;
  cursor c = {s->next, s->next};
  s->line = s->next_line;
  s->count = 0;
  while (more)
    if (read_field(s, &c, &more) != 0) return -1;
  s->next = c.at;
  return 1;
}

/* ---- numbers, and writing ---- */

const char *separated_number(const separated *s, const char *text, char out[SEPARATED_NUMBER]) {
  const char *comma = strchr(text, ',');
  const size_t length = strlen(text);
  if (s->separator == ',' || comma == NULL || strpbrk(comma + 1, ",.") != NULL || length >= SEPARATED_NUMBER ||
      memchr(text, '.', (size_t)(comma - text)) != NULL)
    return text;
  memcpy(out, text, length + 1);
  out[comma - text] = '.';
  return out;
}

void separated_put(FILE *out, const char *text) {
  if (strpbrk(text, ",;\"\r\n") == NULL) {
    fputs(text, out);
    return;
  }
  fputc('"', out);
  for (; *text != '\0'; text++) {
    if (*text == '"') fputc('"', out);
    fputc(*text, out);
  }
  fputc('"', out);
}
