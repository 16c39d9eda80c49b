#include "fault.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int fault_set(fault *why, const char *format, ...) {
  va_list arguments;
  why->status = EXIT_BAD_INPUT;
  va_start(arguments, format);
  int length = vsnprintf(why->text, sizeof why->text, format, arguments);
  va_end(arguments);
  if (length < 0) strcpy(why->text, "an error that could not be put in words");
  if (length >= (int)sizeof why->text) memcpy(why->text + sizeof why->text - 4, "...", 4);
  /* Names and contents of files end up in here: one line must stay one line, and a terminal must not be steered. */
  for (char *c = why->text; *c != '\0'; c++) {
    if ((unsigned char)*c < 0x20 || (unsigned char)*c == 0x7f) *c = '?';
  }
  return -1;
}

int fault_exit(const fault *why) {
  fprintf(stderr, "quarter: %s\n", why->text);
  return why->status;
}
