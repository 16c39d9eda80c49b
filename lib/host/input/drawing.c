#include "host/input/drawing.h"

#include <string.h>

#include "host/base/count.h"
#include "host/base/text.h"
#include "host/input/sites.h"

/* Steps that entering a cell drawn like this takes, 0 blocked, -1 not a drawing's character. */
static int glyph_cost(char glyph) {
  if (glyph == '#') return 0;
  if (glyph == '~') return DRAWING_TERRAIN_COST;
  if (glyph == '.' || glyph == 'S' || (glyph >= '1' && glyph <= '9')) return 1;
  return -1;
}

static bool is_comment(const text_lines *lines) {
  return lines->length > 0 && lines->line[0] == ';';
}

static int unknown_glyph(const input *in, const text_lines *lines, size_t column, fault *why) {
  char shown[TEXT_GLYPH_SIZE];
  return file_fault(why, in->map, lines->number, (long)column + 1,
                    "unknown character %s in a drawing; use # . ~ S and 1 to 9, or start the line with ; for a comment",
                    text_glyph(shown, lines->line[column]));
}

static int read_row(input *in, const text_lines *lines, drawing_marks marks, fault *why) {
  qtr_mission *mission = &in->mission;
  const unsigned row = mission->rows++;
  for (size_t i = 0; i < lines->length; i++) {
    char glyph = lines->line[i];
    qtr_cell cell = (qtr_cell)((size_t)row * mission->columns + i);
    input_origin origin = {INPUT_FROM_MAP, lines->number, (int)i + 1};
    int cost = glyph_cost(glyph);
    if (cost < 0) return unknown_glyph(in, lines, i, why);
    mission->cost[cell] = (uint8_t)cost;
    const input_site site = {.position = {false, (double)i, row}, .weight = glyph - '0'};
    if (glyph == 'S' && marks.starts && sites_add_start(in, &site, origin, why)) return -1;
    bool digit = glyph >= '1' && glyph <= '9';
    if (digit && marks.places && sites_add_place(in, &site, origin, why)) return -1;
  }
  return 0;
}

/* The row's length against the first row's and the build's limits. */
static int check_row(input *in, const text_lines *lines, int *first, fault *why) {
  qtr_mission *mission = &in->mission;
  /* An unknown character is the likelier fault of a first line that is too long: say that first. */
  for (size_t i = 0; i < lines->length; i++) {
    if (glyph_cost(lines->line[i]) < 0) return unknown_glyph(in, lines, i, why);
  }
  if (mission->rows > 0 && lines->length != mission->columns) {
    return file_fault(why, in->map, lines->number, 0,
                      "the row has %s, but the first one (line %d) has %u; make all rows equally long",
                      counted(lines->length, "cell").text, *first, (unsigned)mission->columns);
  }
  double rows = mission->rows + 1.0;
  if (sites_check_size(in->map, lines->number, (double)lines->length, rows, "cut the drawing", why)) return -1;
  if (mission->rows == 0) {
    *first = lines->number;
    mission->columns = (uint16_t)lines->length;
  }
  return 0;
}

int drawing_read(input *in, const file_bytes *bytes, drawing_marks marks, fault *why) {
  text_lines lines;
  int first = 0, gap = 0; /* lines: of the first row, and of an empty line after it */
  text_start(&lines, bytes);
  while (text_next(&lines)) {
    if (is_comment(&lines)) continue;
    if (text_blank(lines.line, lines.length)) {
      if (gap == 0 && first != 0) gap = lines.number;
      continue;
    }
    if (gap != 0) return file_fault(why, in->map, gap, 0, "an empty line between the rows of the drawing; delete it");
    if (check_row(in, &lines, &first, why) || read_row(in, &lines, marks, why)) return -1;
  }
  if (first == 0) return file_fault(why, in->map, 0, 0, "holds no rows; draw the map with # and .");
  return 0;
}

bool drawing_looks_like_one(const file_bytes *bytes) {
  text_lines lines;
  size_t columns = 0;
  text_start(&lines, bytes);
  while (text_next(&lines)) {
    if (lines.length == 0 || is_comment(&lines)) continue;
    if (columns == 0) columns = lines.length;
    if (lines.length != columns) return false;
    for (size_t i = 0; i < columns; i++) {
      if (glyph_cost(lines.line[i]) < 0) return false;
    }
  }
  return columns > 0;
}
