#include "host/base/notes.h"

#include <stdarg.h>

#include "host/base/fault.h"

void notes_add(notes *n, const char *format, ...) {
  if (n->count >= NOTES_MOST) return;
  char *text = n->text[n->count++];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, NOTES_SIZE, format, arguments);
  va_end(arguments);
  fault_clean(text);
}

void notes_print(const notes *n, int from) {
  for (int i = from; i < n->count; i++) fprintf(stderr, "quarter: note: %s\n", n->text[i]);
}

void notes_json(const notes *n, json *j) {
  json_array(j, "notes");
  for (int i = 0; i < n->count; i++) json_string(j, NULL, n->text[i]);
  json_end_array(j);
}
