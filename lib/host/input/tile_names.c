#include "host/input/tile_names.h"

#include <stdio.h>
#include <string.h>

#include "host/base/naming.h"

enum { REFERENCE_BYTES = 48 };

/* A, B ... Z, AA, AB ..., and the row with as many digits as the last one has. */
static void refer(char out[REFERENCE_BYTES], const tile_naming *tile) {
  char letters[16];
  size_t at = sizeof letters;
  for (size_t left = tile->column + 1; left > 0; left = (left - 1) / 26) letters[--at] = (char)('A' + (left - 1) % 26);
  const int digits = snprintf(NULL, 0, "%zu", tile->rows);
  snprintf(out, REFERENCE_BYTES, "%.*s%0*zu", (int)(sizeof letters - at), letters + at, digits, tile->row + 1);
}

/* The file's name without folders and ending. */
static void find_stem(char *out, size_t size, const char *path) {
  const char *slash = strrchr(path, '/'), *from = slash != NULL ? slash + 1 : path, *dot = strrchr(from, '.');
  snprintf(out, size, "%.*s", (int)(dot != NULL && dot > from ? (size_t)(dot - from) : strlen(from)), from);
}

static bool is_taken(const input *in, const char *name) {
  for (int i = 0; i < in->mission.places; i++)
    if (strcmp(in->names.place[i], name) == 0) return true;
  return false;
}

/* False: it may not be a name, or another place has it. */
static bool take(char name[QTR_SITE_NAME_BYTES], const char *before, const char *after, const input *in) {
  char text[2 * QTR_SITE_NAME_BYTES + REFERENCE_BYTES];
  snprintf(text, sizeof text, "%s%s%s", before, before[0] != '\0' && after[0] != '\0' ? " " : "", after);
  if (naming_wrong(text) != NULL || is_taken(in, text)) return false;
  memcpy(name, text, strlen(text) + 1);
  return true;
}

void tile_name(char name[QTR_SITE_NAME_BYTES], const tile_naming *tile, const input *in) {
  char reference[REFERENCE_BYTES], stem[2 * QTR_SITE_NAME_BYTES];
  const char *area = tile->area != NULL ? tile->area->name : "";
  refer(reference, tile);
  find_stem(stem, sizeof stem, tile->file);
  name[0] = '\0';
  if (area[0] != '\0' && tile->area->tiles == 1 && take(name, area, "", in)) return;
  if (area[0] != '\0' && take(name, area, reference, in)) return;
  if (tile->plain && take(name, "", reference, in)) return;
  take(name, stem, reference, in);
}
