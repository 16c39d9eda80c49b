#include "host/input/kind.h"

#include <stdbool.h>
#include <string.h>
#include <strings.h>

#include "host/base/text.h"
#include "host/input/decode.h"
#include "host/input/drawing.h"
#include "host/input/foreign.h"
#include "host/input/movingai.h"

static bool has_extension(const char *path, const char *extension) {
  size_t length = strlen(path), tail = strlen(extension);
  return length > tail && strcasecmp(path + length - tail, extension) == 0;
}

/* "key: value" or "key:". No drawing has that: its only letter is S. */
static bool is_key_line(const char *line, size_t length) {
  /* A NUL ends the file, if nothing else ends the word. */
  size_t word = strspn(line, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_");
  if (word < 2) return false;
  while (word < length && text_blank(line + word, 1)) word++;
  if (word >= length || line[word] != ':') return false;
  return word + 1 == length || text_blank(line + word + 1, 1);
}

/* The same, or the brace or dashes that a YAML may start with. */
static bool is_yaml_line(const char *line, size_t length) {
  return line[0] == '{' || (length >= 3 && memcmp(line, "---", 3) == 0) || is_key_line(line, length);
}

/* Decided by the first line that is neither empty nor a YAML comment. */
static bool looks_like_yaml(const file_bytes *bytes) {
  text_lines lines;
  text_start(&lines, bytes);
  while (text_next(&lines)) {
    if (text_blank(lines.line, lines.length) || lines.line[0] == '#' || lines.line[0] == '%') continue;
    return is_yaml_line(lines.line, lines.length);
  }
  return false;
}

enum kind kind_of(const char *path, const file_bytes *bytes) {
  static const struct {
    const char *extension;
    enum kind kind;
  } by_name[] = {{".yaml", KIND_YAML}, {".yml", KIND_YAML},  {".map", KIND_MOVINGAI},
                 {".pgm", KIND_IMAGE}, {".png", KIND_IMAGE}, {".bmp", KIND_IMAGE}};
  if (decode_is_image(bytes)) return KIND_IMAGE;
  if (movingai_looks_like_one(bytes)) return KIND_MOVINGAI;
  if (drawing_looks_like_one(bytes)) return KIND_DRAWING;
  if (foreign_what(bytes) != NULL) return KIND_FOREIGN;
  if (looks_like_yaml(bytes)) return KIND_YAML;
  for (size_t i = 0; i < sizeof by_name / sizeof by_name[0]; i++)
    if (has_extension(path, by_name[i].extension)) return by_name[i].kind;
  return KIND_DRAWING;
}
