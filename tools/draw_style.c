#include <string.h>

#include "draw_parts.h"
#include "host/base/utf8.h"

enum { COLOURS = 7 };

static const unsigned char palette[COLOURS][3] = {
    {0x00, 0x72, 0xB2}, {0xD5, 0x5E, 0x00}, {0x00, 0x9E, 0x73}, {0xCC, 0x79, 0xA7},
    {0xE6, 0x9F, 0x00}, {0x56, 0xB4, 0xE9}, {0xB3, 0xA2, 0x00},
};

/* The palette as it is, then darker, then paler, then again. */
static int channel(int seeker, int c) {
  const int base = palette[seeker % COLOURS][c];
  switch (seeker / COLOURS % 3) {
  case 1: return base * 11 / 20;
  case 2: return 255 - (255 - base) * 11 / 20;
  default: return base;
  }
}

const char *draw_colour(char text[8], int seeker) {
  snprintf(text, 8, "#%02x%02x%02x", channel(seeker, 0) & 0xFF, channel(seeker, 1) & 0xFF, channel(seeker, 2) & 0xFF);
  return text;
}

const char *draw_ink(int seeker) {
  const int light = 299 * channel(seeker, 0) + 587 * channel(seeker, 1) + 114 * channel(seeker, 2);
  return light > 140 * 1000 ? "#111" : "#fff";
}

const char *draw_dashes(int seeker) {
  static const char *const dashes[] = {"", " stroke-dasharray=\"7 4\"", " stroke-dasharray=\"2 4\""};
  return dashes[seeker / COLOURS % 3];
}

double draw_text_width(const char *text, double size) {
  double characters = 0;
  while (*text != '\0') {
    const int length = utf8_length(text);
    text += length > 0 ? length : 1;
    characters++;
  }
  return 0.58 * size * characters;
}

void draw_number(FILE *out, double number) {
  char text[64];
  int length = snprintf(text, sizeof text, "%.2f", number);
  while (text[length - 1] == '0') length--;
  if (text[length - 1] == '.') length--;
  text[length] = '\0';
  fputs(strcmp(text, "-0") == 0 ? "0" : text, out);
}
