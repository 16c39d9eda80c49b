#include "host/table/config_header.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/file.h"
#include "host/base/text.h"

#define HEADER_LIMIT ((size_t)1 << 20)
#define LINE_LIMIT 1000
#define DEPTH_LIMIT 32

/* ---- a line without its comments ---- */

typedef struct {
  text_lines lines;
  bool in_comment;
  char text[LINE_LIMIT + 1];
} header_lines;

/* The end of the string or character that begins at `at`, or of the line. */
static size_t skip_quoted(const char *line, size_t length, size_t at) {
  const char mark = line[at++];
  while (at < length && line[at] != mark) at += line[at] == '\\' ? 2 : 1;
  return at < length ? at + 1 : length;
}

static bool stands_at(const char *line, size_t length, size_t at, const char *mark) {
  return at + 1 < length && line[at] == mark[0] && line[at + 1] == mark[1];
}

/* A comment becomes a blank, as it does for the compiler. */
static void strip(header_lines *header, const char *line, size_t length) {
  size_t out = 0, at = 0;
  while (at < length) {
    if (header->in_comment) {
      header->in_comment = !stands_at(line, length, at, "*/");
      at += header->in_comment ? 1 : 2;
    } else if (stands_at(line, length, at, "//")) {
      break;
    } else if (stands_at(line, length, at, "/*")) {
      header->in_comment = true;
      header->text[out++] = ' ';
      at += 2;
    } else {
      const size_t end = line[at] == '"' || line[at] == '\'' ? skip_quoted(line, length, at) : at + 1;
      while (at < end) header->text[out++] = line[at++];
    }
  }
  header->text[out] = '\0';
}

/* False at the end; a line that is too long is cut: what is looked for stands in short ones. */
static bool next_line(header_lines *header) {
  if (!text_next(&header->lines)) return false;
  strip(header, header->lines.line, header->lines.length < LINE_LIMIT ? header->lines.length : LINE_LIMIT);
  return true;
}

#define BLANKS " \t\f\v"

/* The word at *at, which is moved behind it: up to a blank, or to what an argument or a file's name begins with. */
static text_field take_word(const char **at) {
  *at += strspn(*at, BLANKS);
  const text_field word = {*at, strcspn(*at, BLANKS "(<\"")};
  *at += word.length;
  return word;
}

/* ---- directives ---- */

typedef struct {
  const char *path;
  robot_sizes *sizes;
  long stated[ROBOT_SIZES]; /* in which line; 0: in none */
  bool open[DEPTH_LIMIT];   /* of each condition around the line: it is none, but a guard whose name is defined next */
  int depth;
  text_field guard; /* of the #ifndef that stands right before; length 0: none */
  char guard_text[LINE_LIMIT + 1];
  header_lines header;
} reader;

static int refuse(const reader *r, const char *what, fault *why) {
  return file_fault(why, r->path, r->header.lines.number, 0, "%s", what);
}

static int size_of_name(text_field name) {
  for (int i = 0; i < ROBOT_SIZES; i++)
    if (text_field_is(name, robot_size_macro[i])) return i;
  return -1;
}

/* A number as C writes it, with its suffixes. */
static bool read_number(uint32_t *number, const char *text) {
  char *end;
  if (strspn(text, "0123456789") == 0) return false;
  errno = 0;
  const unsigned long long value = strtoull(text, &end, 0);
  end += strspn(end, "uUlL");
  *number = (uint32_t)value;
  return errno == 0 && value >= 1 && value <= UINT32_MAX && text_blank(end, strlen(end));
}

static int read_size(reader *r, int size, const char *value, fault *why) {
  const char *const macro = robot_size_macro[size];
  const long line = r->header.lines.number;
  for (int i = 0; i < r->depth; i++)
    if (!r->open[i])
      return file_fault(why, r->path, line, 0,
                        "%s stands under a condition, and which way that goes the compiler alone "
                        "knows; name a header that states it plainly",
                        macro);
  if (r->stated[size] > 0)
    return file_fault(why, r->path, line, 0, "%s is stated in line %ld already; state it once", macro, r->stated[size]);
  value += strspn(value, BLANKS);
  if (!read_number(&r->sizes->of[size], value))
    return file_fault(why, r->path, line, 0, "%s is '%.60s', no plain number of 1 or more; write the number", macro,
                      value);
  if (r->sizes->of[size] > robot_size_most[size])
    return file_fault(why, r->path, line, 0,
                      "%s is %" PRIu32 ", and quarter/config.h takes at most %" PRIu32 "; lower it", macro,
                      r->sizes->of[size], robot_size_most[size]);
  r->stated[size] = line;
  return 0;
}

/* Names of arguments are no part of a macro's. */
static int read_define(reader *r, const char *rest, fault *why) {
  const text_field name = take_word(&rest);
  const bool guarded = r->guard.length == name.length && memcmp(r->guard.text, name.text, name.length) == 0;
  if (guarded && r->depth > 0) r->open[r->depth - 1] = true;
  r->guard.length = 0;
  const int size = size_of_name(name);
  return size >= 0 ? read_size(r, size, rest, why) : 0;
}

static int begin_condition(reader *r, bool negated, const char *rest, fault *why) {
  if (r->depth == DEPTH_LIMIT) return refuse(r, "more than 32 conditions within one another", why);
  r->open[r->depth++] = false;
  if (!negated) return 0;
  strcpy(r->guard_text, rest);
  rest = r->guard_text;
  r->guard = take_word(&rest);
  return 0;
}

/* #else and what else begins with "el" leaves the other branch. */
static void go_on_with_condition(reader *r, text_field word) {
  if (r->depth == 0) return;
  if (text_field_is(word, "endif")) r->depth--;
  if (word.length >= 4 && memcmp(word.text, "el", 2) == 0) r->open[r->depth - 1] = false;
}

static int read_other(reader *r, text_field word, const char *rest, fault *why) {
  if (text_field_is(word, "undef") && size_of_name(take_word(&rest)) >= 0)
    return refuse(r, "a size is undefined; state it once", why);
  if (text_field_is(word, "include") && rest[strspn(rest, BLANKS)] != '<')
    return refuse(r, "what is included here is not read; name a header that states the sizes itself", why);
  go_on_with_condition(r, word);
  return 0;
}

static int read_directive(reader *r, const char *rest, fault *why) {
  const text_field word = take_word(&rest);
  if (text_field_is(word, "define")) return read_define(r, rest, why);
  r->guard.length = 0;
  const bool negated = text_field_is(word, "ifndef");
  if (negated || text_field_is(word, "if") || text_field_is(word, "ifdef"))
    return begin_condition(r, negated, rest, why);
  return read_other(r, word, rest, why);
}

static int read_lines(reader *r, fault *why) {
  while (next_line(&r->header)) {
    const char *text = r->header.text + strspn(r->header.text, BLANKS);
    if (*text == '#' && read_directive(r, text + 1, why) != 0) return -1;
  }
  for (int i = 0; i < ROBOT_SIZES; i++)
    if (r->stated[i] > 0) return 0;
  return file_fault(why, r->path, 0, 0,
                    "states none of %s, %s and %s; name the header that QTR_CONFIG_HEADER names, or say mcu",
                    robot_size_macro[ROBOT_CELLS], robot_size_macro[ROBOT_PLACES], robot_size_macro[ROBOT_SEEKERS]);
}

int config_header_read(robot_sizes *sizes, const char *path, fault *why) {
  file_bytes bytes;
  reader r = {.path = path, .sizes = sizes};
  if (file_read(&bytes, path, HEADER_LIMIT, "--profile", why) != 0) return -1;
  text_start(&r.header.lines, &bytes);
  const int status = read_lines(&r, why);
  file_free(&bytes);
  return status;
}
