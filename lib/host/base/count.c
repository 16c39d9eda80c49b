#include "host/base/count.h"

#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static count_text join(const char *number, const char *noun) {
  count_text it;
  const size_t length = strlen(noun);
  const bool y = length > 1 && noun[length - 1] == 'y' && strchr("aeiou", noun[length - 2]) == NULL;
  const char *tail = strcmp(number, "1") == 0 ? "" : y ? "ies" : "s";
  const size_t stem = tail[0] != '\0' && y ? length - 1 : length;
  snprintf(it.text, sizeof it.text, "%s %.*s%s", number, (int)stem, noun, tail);
  return it;
}

count_text counted(uint64_t number, const char *noun) {
  char text[24];
  snprintf(text, sizeof text, "%" PRIu64, number);
  return join(text, noun);
}

count_text measured(double number, const char *noun) {
  char text[32];
  snprintf(text, sizeof text, "%.6g", number);
  return join(text, noun);
}
