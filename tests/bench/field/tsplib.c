#include "field/tsplib.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/file.h"
#include "host/base/memory.h"
#include "host/base/text.h"

#define MOST_TOWNS 5000
#define MOST_COORDINATE 1e8 /* so that distances fit their 32 bits */

static const char *const kind_names[TSPLIB_KINDS] = {"EUC_2D", "CEIL_2D", "ATT", "GEO", "EXPLICIT"};

/* Which of a town's distances a file names: by rows or columns, below or above the diagonal, with it or without. */
typedef struct {
  const char *name;
  bool below, by_columns, diagonal, whole;
} shape;

static const shape shapes[] = {
    {"FULL_MATRIX", true, false, true, true},     {"UPPER_ROW", false, false, false, false},
    {"LOWER_ROW", true, false, false, false},     {"UPPER_DIAG_ROW", false, false, true, false},
    {"LOWER_DIAG_ROW", true, false, true, false}, {"UPPER_COL", false, true, false, false},
    {"LOWER_COL", true, true, false, false},      {"UPPER_DIAG_COL", false, true, true, false},
    {"LOWER_DIAG_COL", true, true, true, false},
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

typedef struct {
  tsplib *instance;
  const char *path;
  fault *why;
  text_lines lines;
  const char *at, *end; /* what is left of the line at hand */
  int kind, shape;      /* -1: not said yet */
} reader;

static int fail(const reader *r, const char *what, const char *about) {
  return file_fault(r->why, r->path, r->lines.number, 0, "%s%s", about, what);
}

/* ---- words ---- */

static bool next_line(reader *r) {
  if (!text_next(&r->lines)) return false;
  r->at = r->lines.line;
  r->end = r->lines.line + r->lines.length;
  return true;
}

static bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/* The next word of the line; an empty one at its end. */
static text_field next_word(reader *r) {
  text_field word = {NULL, 0};
  while (r->at < r->end && is_blank(*r->at)) r->at++;
  word.text = r->at;
  while (r->at < r->end && !is_blank(*r->at)) r->at++;
  word.length = (size_t)(r->at - word.text);
  return word;
}

/* The next word of the section, on whatever line. */
static bool next_word_anywhere(reader *r, text_field *word) {
  for (;;) {
    *word = next_word(r);
    if (word->length > 0) return true;
    if (!next_line(r)) return false;
  }
}

/* ---- what a file says of itself ---- */

static int find_word(text_field word, const char *const *names, int count) {
  for (int i = 0; i < count; i++)
    if (text_field_is(word, names[i])) return i;
  return -1;
}

static int read_type(const reader *r, text_field value) {
  static const char *const types[] = {"TSP", "ATSP"};
  if (find_word(value, types, 2) >= 0) return 0;
  return fail(r, "of the types TSP and ATSP alone are read", "TYPE: ");
}

static int read_dimension(const reader *r, text_field value) {
  long towns;
  if (!text_integer(&towns, value.text, value.length) || towns < 2 || towns > MOST_TOWNS)
    return fail(r, "is not a number of towns from 2 to 5000", "DIMENSION: ");
  r->instance->towns = (unsigned)towns;
  return 0;
}

static int read_kind(reader *r, text_field value) {
  r->kind = find_word(value, kind_names, TSPLIB_KINDS);
  if (r->kind >= 0) return 0;
  return fail(r, "is none of EUC_2D, CEIL_2D, ATT, GEO and EXPLICIT", "EDGE_WEIGHT_TYPE: ");
}

static int read_shape(reader *r, text_field value) {
  for (r->shape = SHAPES - 1; r->shape >= 0; r->shape--)
    if (text_field_is(value, shapes[r->shape].name)) return 0;
  return fail(r, "is no full matrix, and no triangle by rows or columns", "EDGE_WEIGHT_FORMAT: ");
}

static int read_name(const reader *r, text_field value) {
  if (value.length == 0 || value.length >= TSPLIB_NAME) return fail(r, "is not of 1 to 63 characters", "NAME: ");
  memcpy(r->instance->name, value.text, value.length);
  r->instance->name[value.length] = '\0';
  fault_clean(r->instance->name);
  return 0;
}

/* ---- sections ---- */

static int begin_section(const reader *r, const char *section) {
  if (r->instance->towns == 0) return fail(r, "comes before DIMENSION", section);
  if (r->kind < 0) return fail(r, "comes before EDGE_WEIGHT_TYPE", section);
  if (r->instance->distance != NULL) return fail(r, "gives distances once more", section);
  r->instance->line = r->lines.number;
  r->instance->distance = memory_take((size_t)r->instance->towns * r->instance->towns * sizeof(uint32_t), r->why);
  return r->instance->distance == NULL ? -1 : 0;
}

/* "number x y", each town once. */
static int read_town(reader *r, double *coordinates, bool *known) {
  long town;
  const text_field number = next_word(r);
  if (!text_integer(&town, number.text, number.length) || town < 1 || town > (long)r->instance->towns)
    return fail(r, "is not a town's number, 1 to DIMENSION", "NODE_COORD_SECTION: ");
  if (known[town - 1]) return fail(r, "tells of a town once more", "NODE_COORD_SECTION: ");
  known[town - 1] = true;
  for (int axis = 0; axis < 2; axis++) {
    const text_field word = next_word(r);
    double *to = &coordinates[2 * (town - 1) + axis];
    const char *wrong = text_number(to, word.text, word.length);
    if (wrong != NULL) return fail(r, wrong, "NODE_COORD_SECTION: a coordinate ");
    if (*to > MOST_COORDINATE || *to < -MOST_COORDINATE)
      return fail(r, "is beyond 1e8", "NODE_COORD_SECTION: a coordinate ");
  }
  return next_word(r).length > 0 ? fail(r, "has more than a number and two coordinates", "NODE_COORD_SECTION: ") : 0;
}

static int read_towns(reader *r, double *coordinates, bool *known) {
  for (unsigned i = 0; i < r->instance->towns; i++) {
    do {
      if (!next_line(r)) return fail(r, "ends before all towns have coordinates", "NODE_COORD_SECTION: ");
    } while (text_blank(r->lines.line, r->lines.length));
    if (read_town(r, coordinates, known) != 0) return -1;
  }
  return 0;
}

static void measure(const reader *r, const double *coordinates) {
  const unsigned towns = r->instance->towns;
  for (unsigned from = 0; from < towns; from++)
    for (unsigned to = 0; to < towns; to++)
      r->instance->distance[(size_t)from * towns + to] =
          from == to ? 0
                     : tsplib_distance((enum tsplib_kind)r->kind, coordinates + 2 * (size_t)from,
                                       coordinates + 2 * (size_t)to);
}

static int read_coordinates(reader *r) {
  if (r->kind == TSPLIB_EXPLICIT) return fail(r, "stands in a file of EXPLICIT distances", "NODE_COORD_SECTION ");
  if (begin_section(r, "NODE_COORD_SECTION ") != 0) return -1;
  double *coordinates = memory_take(2 * (size_t)r->instance->towns * sizeof *coordinates, r->why);
  bool *known = coordinates != NULL ? memory_take(r->instance->towns * sizeof *known, r->why) : NULL;
  const int status = known != NULL ? read_towns(r, coordinates, known) : -1;
  if (status == 0) measure(r, coordinates);
  free(known);
  free(coordinates);
  return status;
}

static int read_weight(reader *r, unsigned from, unsigned to) {
  const unsigned towns = r->instance->towns;
  text_field word;
  long distance;
  if (!next_word_anywhere(r, &word)) return fail(r, "ends before all distances are there", "EDGE_WEIGHT_SECTION: ");
  if (!text_integer(&distance, word.text, word.length))
    return fail(r, "holds what is no whole number of at most 9 digits", "EDGE_WEIGHT_SECTION: ");
  if (distance < 0) return fail(r, "holds a distance below 0", "EDGE_WEIGHT_SECTION: ");
  r->instance->distance[(size_t)from * towns + to] = (uint32_t)distance;
  if (!shapes[r->shape].whole) r->instance->distance[(size_t)to * towns + from] = (uint32_t)distance;
  return 0;
}

/* Those of a town's row that the file gives. The columns of one triangle are the rows of the other. */
static int read_row(reader *r, const shape *s, unsigned from) {
  const bool below = s->below != s->by_columns;
  const unsigned first = s->whole || below ? 0 : from + !s->diagonal;
  const unsigned last = s->whole || !below ? r->instance->towns : from + s->diagonal;
  for (unsigned to = first; to < last; to++)
    if (read_weight(r, from, to) != 0) return -1;
  return 0;
}

static int read_weights(reader *r) {
  if (r->shape < 0) return fail(r, "comes before EDGE_WEIGHT_FORMAT", "EDGE_WEIGHT_SECTION ");
  if (begin_section(r, "EDGE_WEIGHT_SECTION ") != 0) return -1;
  r->at = r->end;
  for (unsigned from = 0; from < r->instance->towns; from++)
    if (read_row(r, &shapes[r->shape], from) != 0) return -1;
  if (next_word(r).length > 0) return fail(r, "holds more distances than DIMENSION tells of", "EDGE_WEIGHT_SECTION: ");
  return 0;
}

/* Where the towns are drawn: not what they are apart. */
static int skip_drawing(reader *r) {
  for (unsigned i = 0; i < r->instance->towns && next_line(r); i++) continue;
  return 0;
}

static int read_section(reader *r, text_field name) {
  if (text_field_is(name, "NODE_COORD_SECTION")) return read_coordinates(r);
  if (text_field_is(name, "EDGE_WEIGHT_SECTION"))
    return r->kind == TSPLIB_EXPLICIT ? read_weights(r) : fail(r, "stands beside coordinates", "EDGE_WEIGHT_SECTION ");
  if (text_field_is(name, "DISPLAY_DATA_SECTION")) return skip_drawing(r);
  return fail(r, "is no keyword of a TSP that is read", "the first word ");
}

/* ---- the file ---- */

static int read_entry(reader *r, text_field key, text_field value) {
  static const char *const told[] = {"COMMENT", "NODE_COORD_TYPE", "DISPLAY_DATA_TYPE", "CAPACITY"};
  if (text_field_is(key, "NAME")) return read_name(r, value);
  if (text_field_is(key, "TYPE")) return read_type(r, value);
  if (text_field_is(key, "DIMENSION")) return read_dimension(r, value);
  if (text_field_is(key, "EDGE_WEIGHT_TYPE")) return read_kind(r, value);
  if (text_field_is(key, "EDGE_WEIGHT_FORMAT")) return read_shape(r, value);
  if (find_word(key, told, sizeof told / sizeof *told) >= 0) return 0;
  return fail(r, "is no keyword of a TSP that is read", "the first word ");
}

static text_field trimmed(const char *from, const char *to) {
  text_field field = {from, (size_t)(to - from)};
  text_trim(&field.text, &field.length);
  return field;
}

static int read_line(reader *r, bool *done) {
  const text_field whole = trimmed(r->at, r->end);
  const char *colon = memchr(r->at, ':', (size_t)(r->end - r->at));
  if (whole.length == 0) return 0;
  *done = text_field_is(whole, "EOF");
  if (*done) return 0;
  if (colon == NULL) return read_section(r, whole);
  const text_field key = trimmed(r->at, colon);
  /* Some files put a colon behind the name of a section, too. */
  if (key.length > 8 && memcmp(key.text + key.length - 8, "_SECTION", 8) == 0) return read_section(r, key);
  return read_entry(r, key, trimmed(colon + 1, r->end));
}

static int read_all(reader *r) {
  bool done = false;
  while (!done && next_line(r))
    if (read_line(r, &done) != 0) return -1;
  if (r->instance->distance == NULL) return fail(r, "the file gives no distances", "");
  if (r->instance->name[0] == '\0') return fail(r, "the file gives no NAME", "");
  return 0;
}

int tsplib_read(tsplib *instance, const char *path, fault *why) {
  file_bytes bytes;
  reader r = {.instance = instance, .path = path, .why = why, .kind = -1, .shape = -1};
  *instance = (tsplib){0};
  if (file_read(&bytes, path, FILE_MAP_LIMIT, NULL, why) != 0) return -1;
  text_start(&r.lines, &bytes);
  const int status = read_all(&r);
  file_free(&bytes);
  if (status != 0) tsplib_free(instance);
  return status;
}

void tsplib_free(tsplib *instance) {
  free(instance->distance);
  *instance = (tsplib){0};
}
