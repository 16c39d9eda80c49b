#include "host/base/fault.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void fault_clean(char *text) {
  for (char *c = text; *c != '\0'; c++)
    if ((unsigned char)*c < 0x20 || (unsigned char)*c == 0x7f) *c = '?';
}

static void write_line(char *text, const char *format, va_list arguments) {
  int length = vsnprintf(text, FAULT_LINE, format, arguments);
  if (length < 0) strcpy(text, "an error that could not be put in words");
  if (length >= FAULT_LINE) memcpy(text + FAULT_LINE - 4, "...", 4);
  fault_clean(text);
}

int fault_set(fault *why, const char *format, ...) {
  va_list arguments;
  why->status = EXIT_BAD_INPUT;
  va_start(arguments, format);
  write_line(why->text, format, arguments);
  va_end(arguments);
  return -1;
}

int fault_add(fault *why, const char *format, ...) {
  why->status = EXIT_BAD_INPUT;
  size_t used = strlen(why->text);
  if (used + FAULT_LINE + 8 > sizeof why->text) {
    if (strcmp(why->text + used - 3, "...") != 0) strcpy(why->text + used, "\n...");
    return -1;
  }
  va_list arguments;
  va_start(arguments, format);
  why->text[used] = '\n';
  write_line(why->text + used + 1, format, arguments);
  va_end(arguments);
  return -1;
}

bool fault_keep(fault *all, fault *why) {
  if (all == NULL) return false;
  for (char *line = why->text; line != NULL && *line != '\0';) {
    char *end = strchr(line, '\n');
    if (end != NULL) *end = '\0';
    if (all->text[0] == '\0')
      fault_set(all, "%s", line);
    else
      fault_add(all, "%s", line);
    line = end != NULL ? end + 1 : NULL;
  }
  why->text[0] = '\0';
  return true;
}

int fault_exit(const fault *why) {
  for (const char *line = why->text; line != NULL;) {
    const char *end = strchr(line, '\n');
    fprintf(stderr, "quarter: %.*s\n", end != NULL ? (int)(end - line) : (int)strlen(line), line);
    line = end != NULL ? end + 1 : NULL;
  }
  return why->status;
}
