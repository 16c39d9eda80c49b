#include "host/input/movingai.h"

#include <string.h>

#include "host/base/count.h"
#include "host/base/text.h"
#include "host/input/sites.h"

typedef struct {
  long width, height; /* 0: not stated yet */
  int width_line, height_line;
} header;

/* "keyword value" with any blanks between: the value, or NULL if the line is not the keyword's. */
static const char *value_of(const text_lines *lines, const char *keyword, size_t *length) {
  size_t word = strlen(keyword);
  if (lines->length <= word || memcmp(lines->line, keyword, word) != 0) return NULL;
  if (!text_blank(lines->line + word, 1)) return NULL;
  const char *value = lines->line + word;
  *length = lines->length - word;
  text_trim(&value, length);
  return value;
}

bool movingai_looks_like_one(const file_bytes *bytes) {
  text_lines lines;
  size_t length;
  text_start(&lines, bytes);
  return text_next(&lines) && value_of(&lines, "type", &length) != NULL;
}

static int read_length(const input *in, const text_lines *lines, const char *keyword, long *out, int *out_line,
                       fault *why) {
  size_t length;
  const char *value = value_of(lines, keyword, &length);
  if (*out != 0) {
    return file_fault(why, in->map, lines->number, 0, "%s is stated twice (first in line %d); keep one", keyword,
                      *out_line);
  }
  if (!text_integer(out, value, length) || *out < 1) {
    return file_fault(why, in->map, lines->number, 0, "%s is not a whole number of 1 or more; write \"%s 32\"", keyword,
                      keyword);
  }
  *out_line = lines->number;
  return 0;
}

static bool is_word(const text_lines *lines, const char *word) {
  const char *text = lines->line;
  size_t length = lines->length;
  text_trim(&text, &length);
  return length == strlen(word) && memcmp(text, word, length) == 0;
}

static int read_type(const input *in, text_lines *lines, fault *why) {
  size_t length = 0;
  const char *type = text_next(lines) ? value_of(lines, "type", &length) : NULL;
  if (type == NULL) {
    return file_fault(why, in->map, 1, 0,
                      "is not a Moving AI map: its first line is not \"type octile\"; check the file");
  }
  if (length != 6 || memcmp(type, "octile", 6) != 0) {
    return file_fault(why, in->map, 1, 0, "the type is not octile, the only one there is; check the file");
  }
  return 0;
}

/* The line "map": both lengths must stand above it. */
static int check_lengths(const input *in, const text_lines *lines, const header *head, fault *why) {
  if (head->height != 0 && head->width != 0) return 0;
  const char *lacking = head->height == 0 ? "height" : "width";
  return file_fault(why, in->map, lines->number, 0, "\"map\" before the %s is stated; write \"%s 32\" above it",
                    lacking, lacking);
}

/* Up to and including the line "map". */
static int read_header(const input *in, text_lines *lines, header *head, fault *why) {
  size_t length;
  memset(head, 0, sizeof *head);
  if (read_type(in, lines, why)) return -1;
  while (text_next(lines)) {
    int result;
    if (is_word(lines, "map")) return check_lengths(in, lines, head, why);
    if (value_of(lines, "height", &length) != NULL) {
      result = read_length(in, lines, "height", &head->height, &head->height_line, why);
    } else if (value_of(lines, "width", &length) != NULL) {
      result = read_length(in, lines, "width", &head->width, &head->width_line, why);
    } else {
      result = file_fault(why, in->map, lines->number, 0,
                          "a line of the header is not \"height\", \"width\" or \"map\"; check the file");
    }
    if (result != 0) return -1;
  }
  return file_fault(why, in->map, lines->number, 0, "ends before the line \"map\"; copy the file anew");
}

static int read_row(input *in, const text_lines *lines, int row, fault *why) {
  qtr_mission *mission = &in->mission;
  if (lines->length != mission->columns) {
    return file_fault(why, in->map, lines->number, 0, "the row has %s, but the width is %u; make them agree",
                      counted(lines->length, "cell").text, (unsigned)mission->columns);
  }
  uint8_t *cost = mission->cost + (size_t)row * mission->columns;
  for (size_t i = 0; i < lines->length; i++) {
    char glyph = lines->line[i], shown[TEXT_GLYPH_SIZE];
    if (glyph == '\0' || strchr(".GS@OTW", glyph) == NULL) {
      return file_fault(why, in->map, lines->number, (long)i + 1,
                        "unknown character %s in a Moving AI map; use . G S @ O T and W", text_glyph(shown, glyph));
    }
    cost[i] = strchr(".GS", glyph) != NULL;
  }
  return 0;
}

int movingai_read(input *in, const file_bytes *bytes, fault *why) {
  text_lines lines;
  header head;
  text_start(&lines, bytes);
  if (read_header(in, &lines, &head, why)) return -1;
  if (sites_check_size(in->map, head.height_line, (double)head.width, (double)head.height, "cut the map", why))
    return -1;
  in->mission.columns = (uint16_t)head.width;
  in->mission.rows = (uint16_t)head.height;
  for (int row = 0; row < head.height; row++) {
    if (!text_next(&lines)) {
      return file_fault(why, in->map, lines.number, 0,
                        "ends after %d of %s; copy the file anew, or mend its height (line %d)", row,
                        counted((uint64_t)head.height, "row").text, head.height_line);
    }
    if (read_row(in, &lines, row, why)) return -1;
  }
  while (text_next(&lines)) {
    if (text_blank(lines.line, lines.length)) continue;
    return file_fault(why, in->map, lines.number, 0, "goes on after the %s of its height (line %d); make them agree",
                      counted((uint64_t)head.height, "row").text, head.height_line);
  }
  return 0;
}
