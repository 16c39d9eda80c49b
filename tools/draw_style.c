#include <string.h>

#include "draw_parts.h"
#include "host/base/utf8.h"

enum { COLOURS = 7 };

static const unsigned char palette[COLOURS][3] = {
    {0x00, 0x72, 0xB2}, {0xD5, 0x5E, 0x00}, {0x00, 0x9E, 0x73}, {0xCC, 0x79, 0xA7},
    {0xE6, 0x9F, 0x00}, {0x56, 0xB4, 0xE9}, {0xB3, 0xA2, 0x00},
};

const draw_theme *draw_theme_of(const drawing *d) {
  static const draw_theme light = {"#fbfaf7", "#ffffff", "#1f2a36", "#5d6976", "#3d4a57", "#d3d8dd", "#8a6d3b", 0.17};
  static const draw_theme dark = {"#12161b", "#161b21", "#e8ecf0", "#a3afbb", "#66727e", "#2c343d", "#b08d52", 0.26};
  return d->dark ? &dark : &light;
}

/* The palette as it is, then darker, then paler, then again; on dark pages first paler, for darker could hardly be
 * seen. */
static int channel(const draw_page *page, int seeker, int c) {
  const int base = palette[seeker % COLOURS][c], round = seeker / COLOURS % 3;
  if (round == 0) return base;
  return (round == 1) == page->d->dark ? 255 - (255 - base) * 11 / 20 : base * 11 / 20;
}

const char *draw_colour(const draw_page *page, char text[8], int seeker) {
  snprintf(text, 8, "#%02x%02x%02x", channel(page, seeker, 0) & 0xFF, channel(page, seeker, 1) & 0xFF,
           channel(page, seeker, 2) & 0xFF);
  return text;
}

const char *draw_ink(const draw_page *page, int seeker) {
  const int light = 299 * channel(page, seeker, 0) + 587 * channel(page, seeker, 1) + 114 * channel(page, seeker, 2);
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
