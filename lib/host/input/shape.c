#include "host/input/shape.h"

#include <stdbool.h>
#include <yaml.h>

#include "host/base/text.h"

#define MOST_NESTED 32
#define MOST_NAMES 256 /* anchors and aliases */
#define MOST_DIRECTIVES 8

typedef struct {
  int depth, names;
} shape;

static void count_event(shape *so_far, const yaml_event_t *event) {
  switch (event->type) {
  case YAML_ALIAS_EVENT: so_far->names++; break;
  case YAML_SCALAR_EVENT: so_far->names += event->data.scalar.anchor != NULL; break;
  case YAML_SEQUENCE_START_EVENT:
    so_far->names += event->data.sequence_start.anchor != NULL;
    so_far->depth++;
    break;
  case YAML_MAPPING_START_EVENT:
    so_far->names += event->data.mapping_start.anchor != NULL;
    so_far->depth++;
    break;
  case YAML_SEQUENCE_END_EVENT:
  case YAML_MAPPING_END_EVENT: so_far->depth--; break;
  default: break;
  }
}

/* Directives are all read before the first event comes. */
static int check_directives(const char *path, const file_bytes *bytes, fault *why) {
  text_lines lines;
  int directives = 0;
  text_start(&lines, bytes);
  while (text_next(&lines)) {
    directives += lines.length > 0 && lines.line[0] == '%';
    if (directives > MOST_DIRECTIVES) {
      return file_fault(why, path, lines.number, 0, "more than %d directives (lines that start with %%); delete them",
                        MOST_DIRECTIVES);
    }
  }
  return 0;
}

static int check_event(const char *path, const shape *so_far, const yaml_event_t *event, fault *why) {
  long line = (long)event->start_mark.line + 1;
  if (so_far->depth > MOST_NESTED) {
    return file_fault(why, path, line, 0, "lists or mappings nested more than %d deep; check the brackets",
                      MOST_NESTED);
  }
  if (so_far->names > MOST_NAMES) {
    return file_fault(why, path, line, 0, "more than %d anchors and aliases; write the values out", MOST_NAMES);
  }
  return 0;
}

int shape_check(const char *path, const file_bytes *bytes, fault *why) {
  yaml_parser_t parser;
  shape so_far = {0, 0};
  int result = 0;
  bool more = true;
  if (check_directives(path, bytes, why)) return -1;
  if (!yaml_parser_initialize(&parser)) return file_fault(why, path, 0, 0, "no memory to parse it");
  yaml_parser_set_input_string(&parser, bytes->data, bytes->size);
  while (more && result == 0) {
    yaml_event_t event;
    if (!yaml_parser_parse(&parser, &event)) break;
    count_event(&so_far, &event);
    result = check_event(path, &so_far, &event, why);
    more = event.type != YAML_STREAM_END_EVENT;
    yaml_event_delete(&event);
  }
  yaml_parser_delete(&parser);
  return result;
}
