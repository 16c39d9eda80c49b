#include "host/input/asc.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "host/base/text.h"
#include "host/input/image.h"

/* Words of the file, one by one. */
typedef struct {
  const char *path;
  fault *why;
  text_lines lines;
  size_t at; /* in the line, behind the word */
  text_field word;
} words;

enum { COLUMNS, ROWS, X_CORNER, Y_CORNER, X_CENTRE, Y_CENTRE, SIZE, NO_DATA, FIELDS };

static const char *const names[FIELDS] = {"ncols",     "nrows",     "xllcorner", "yllcorner",
                                          "xllcenter", "yllcenter", "cellsize",  "nodata_value"};

typedef struct {
  bool given[FIELDS];
  double value[FIELDS];
} header;

static bool is_blank(char byte) {
  return byte == ' ' || byte == '\t';
}

/* False: no word is left. */
static bool next_word(words *w) {
  for (;;) {
    while (w->at < w->lines.length && is_blank(w->lines.line[w->at])) w->at++;
    if (w->at < w->lines.length) break;
    if (!text_next(&w->lines)) return false;
    w->at = 0;
  }
  const size_t from = w->at;
  while (w->at < w->lines.length && !is_blank(w->lines.line[w->at])) w->at++;
  w->word = (text_field){w->lines.line + from, w->at - from};
  return true;
}

static int word_fault(const words *w, const char *what) {
  const long column = w->word.text - w->lines.line + 1;
  return file_fault(w->why, w->path, w->lines.number, column, "\"%.*s\" %s",
                    (int)(w->word.length < 60 ? w->word.length : 60), w->word.text, what);
}

static int take_number(double *out, const words *w) {
  const char *wrong = text_number(out, w->word.text, w->word.length);
  char text[120];
  if (wrong == NULL) return 0;
  snprintf(text, sizeof text, "%s; give a number (NODATA_value stands for none)", wrong);
  return word_fault(w, text);
}

/* ---- the header ---- */

static int field_of(text_field word) {
  for (int i = 0; i < FIELDS; i++)
    if (strlen(names[i]) == word.length && strncasecmp(names[i], word.text, word.length) == 0) return i;
  return -1;
}

static int take_field(header *h, words *w) {
  const int field = field_of(w->word);
  if (field < 0)
    return word_fault(w,
                      "is no word of an ASCII grid's header; it has ncols, nrows, xllcorner, yllcorner, cellsize and "
                      "NODATA_value");
  if (h->given[field]) return word_fault(w, "is there twice; keep one");
  h->given[field] = true;
  if (!next_word(w)) return file_fault(w->why, w->path, 0, 0, "ends within the header; copy the file anew");
  return take_number(&h->value[field], w);
}

static int lacks(const words *w, const char *what) {
  return file_fault(w->why, w->path, 0, 0, "the header lacks '%s'; add the line", what);
}

static int check_corner(const words *w, const header *h) {
  for (int axis = 0; axis < 2; axis++) {
    const bool corner = h->given[X_CORNER + axis], centre = h->given[X_CENTRE + axis];
    if (!corner && !centre) return lacks(w, names[X_CORNER + axis]);
    if (corner && centre)
      return file_fault(w->why, w->path, 0, 0, "the header has both '%s' and '%s'; keep one", names[X_CORNER + axis],
                        names[X_CENTRE + axis]);
  }
  return 0;
}

/* Each value takes two bytes of the file at least, a digit and what stands behind it. */
static int check_sides(const words *w, const header *h, size_t bytes) {
  const double columns = h->value[COLUMNS], rows = h->value[ROWS];
  if (!(columns >= 1.0) || !(rows >= 1.0) || columns != floor(columns) || rows != floor(rows))
    return file_fault(w->why, w->path, 0, 0, "%g columns and %g rows are no grid; mend ncols and nrows", columns, rows);
  if (columns > IMAGE_MAX_SIDE || rows > IMAGE_MAX_SIDE || columns * rows > (double)IMAGE_MAX_PIXELS)
    return file_fault(w->why, w->path, 0, 0,
                      "%.0f x %.0f values are more than %ld, or than %d along a side, the most that are read; cut the "
                      "grid, or make its cells larger",
                      columns, rows, IMAGE_MAX_PIXELS, IMAGE_MAX_SIDE);
  if (2.0 * columns * rows <= (double)bytes + 1.0) return 0;
  return file_fault(w->why, w->path, 0, 0, "ends before its %.0f x %.0f values; copy the file anew", columns, rows);
}

static int check_header(const words *w, const header *h, size_t bytes) {
  if (!h->given[COLUMNS]) return lacks(w, names[COLUMNS]);
  if (!h->given[ROWS]) return lacks(w, names[ROWS]);
  if (!h->given[SIZE]) return lacks(w, names[SIZE]);
  if (check_corner(w, h) != 0) return -1;
  if (!(h->value[SIZE] > 0.0))
    return file_fault(w->why, w->path, 0, 0, "'cellsize' is %g; give a length above 0", h->value[SIZE]);
  return check_sides(w, h, bytes);
}

/* Up to the first value, which is the word then. */
static int read_header(header *h, words *w) {
  while (next_word(w)) {
    if (!isalpha((unsigned char)w->word.text[0]) || strncasecmp(w->word.text, "nan", 3) == 0) return 0;
    if (take_field(h, w) != 0) return -1;
  }
  return file_fault(w->why, w->path, 0, 0, "holds no values; copy the file anew");
}

/* ---- values ---- */

static int read_values(raster *it, const header *h, words *w) {
  const size_t count = (size_t)it->columns * (size_t)it->rows;
  const double none = h->given[NO_DATA] ? h->value[NO_DATA] : -9999.0;
  for (size_t i = 0; i < count; i++) {
    if (i > 0 && !next_word(w))
      return file_fault(w->why, w->path, w->lines.number, 0, "ends after %zu of %zu values; copy the file anew", i,
                        count);
    if (take_number(&it->value[i], w) != 0) return -1;
    if (it->value[i] == none) it->value[i] = NAN;
  }
  if (!next_word(w)) return 0;
  return word_fault(w, "stands behind the last value; mend ncols and nrows, or delete it");
}

bool asc_looks_like_one(const file_bytes *bytes) {
  words w = {.path = NULL};
  text_start(&w.lines, bytes);
  return next_word(&w) && field_of(w.word) >= 0;
}

int asc_read(raster *it, const char *path, const file_bytes *bytes, fault *why) {
  header h = {{false}, {0.0}};
  words w = {.path = path, .why = why};
  text_start(&w.lines, bytes);
  if (read_header(&h, &w) != 0 || check_header(&w, &h, bytes->size) != 0) return -1;
  const double half = h.value[SIZE] / 2.0;
  *it = (raster){.columns = (int)h.value[COLUMNS], .rows = (int)h.value[ROWS], .placed = true, .size = h.value[SIZE]};
  it->x = h.given[X_CORNER] ? h.value[X_CORNER] : h.value[X_CENTRE] - half;
  it->y = h.given[Y_CORNER] ? h.value[Y_CORNER] : h.value[Y_CENTRE] - half;
  it->value = malloc((size_t)it->columns * (size_t)it->rows * sizeof *it->value);
  if (it->value == NULL) return file_fault(why, path, 0, 0, "no memory for its values; make its cells larger");
  if (read_values(it, &h, &w) == 0) return 0;
  raster_free(it);
  return -1;
}
