#include "host/base/xml.h"

#include <stdbool.h>
#include <string.h>

#include "host/base/utf8.h"

/* XML 1.0 has no way to write most control characters, nor U+FFFE and U+FFFF. */
static bool xml_holds(const char *text, int length) {
  if (length == 0) return false;
  if (length == 1) return (unsigned char)*text >= 0x20 && *text != 0x7F;
  return strncmp(text, "\xEF\xBF\xBE", 3) != 0 && strncmp(text, "\xEF\xBF\xBF", 3) != 0;
}

static void put_character(FILE *out, const char *text, int length) {
  switch (*text) {
  case '<': fputs("&lt;", out); break;
  case '>': fputs("&gt;", out); break;
  case '&': fputs("&amp;", out); break;
  case '"': fputs("&quot;", out); break;
  case '\t': fputc(' ', out); break;
  default: fwrite(text, 1, (size_t)length, out);
  }
}

void xml_text(FILE *out, const char *text, int most) {
  for (int written = 0; *text != '\0'; written++) {
    const int length = utf8_length(text);
    if (written == most) {
      fputs("\xE2\x80\xA6", out);
      return;
    }
    if (xml_holds(text, length) || *text == '\t')
      put_character(out, text, length);
    else
      fputs(UTF8_REPLACEMENT, out);
    text += length > 0 ? length : 1;
  }
}
