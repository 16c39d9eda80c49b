#include "host/input/tree.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

#include "host/base/near.h"
#include "host/base/text.h"

#define MOST_NESTED 32
#define MOST_NAMES 256 /* anchors and aliases */
#define MOST_DIRECTIVES 8
#define TREE_KEYS_LIST 800 /* bytes of their names in a message */

int tree_line(tree_node *node) {
  return (int)node->start_mark.line + 1;
}

int tree_fault(tree *yaml, tree_node *node, const char *format, ...) {
  char message[FAULT_LINE];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(message, sizeof message, format, arguments);
  va_end(arguments);
  return file_fault(yaml->why, yaml->path, tree_line(node), 0, "%s", message);
}

/* Whether a line of the text starts with blanks among which there is a tab. */
static bool has_tab_indent(const file_bytes *bytes, long line) {
  text_lines lines;
  text_start(&lines, bytes);
  while (text_next(&lines)) {
    if (lines.number != line) continue;
    const char *tab = memchr(lines.line, '\t', lines.length);
    return tab != NULL && text_blank(lines.line, (size_t)(tab - lines.line));
  }
  return false;
}

/* What the text was meant to be: JSON is YAML, too. */
static const char *meant_as(const file_bytes *bytes) {
  size_t i = 0;
  while (i < bytes->size && strchr(" \t\r\n", bytes->data[i]) != NULL) i++;
  return i < bytes->size && bytes->data[i] == '{' ? "JSON" : "YAML";
}

static int syntax_fault(tree *yaml, const yaml_parser_t *parser, const file_bytes *bytes) {
  const char *problem = parser->problem != NULL ? parser->problem : "unknown";
  const long line = (long)parser->problem_mark.line + 1;
  if (parser->error == YAML_MEMORY_ERROR) return file_fault(yaml->why, yaml->path, 0, 0, "no memory to parse it");
  if (parser->error == YAML_READER_ERROR) {
    return file_fault(yaml->why, yaml->path, 0, 0, "is not YAML text: %s at byte %zu; check that it is the right file",
                      problem, parser->problem_offset);
  }
  const char *meant = meant_as(bytes);
  if (meant[0] == 'Y' && has_tab_indent(bytes, line))
    return file_fault(yaml->why, yaml->path, line, 0,
                      "the line is indented by a tab, which YAML does not take; use blanks instead");
  return file_fault(yaml->why, yaml->path, line, (long)parser->problem_mark.column + 1,
                    "not valid %s: %s; mend the line or the one above it", meant, problem);
}

/* That no second document follows. */
static int check_single(tree *yaml, yaml_parser_t *parser, const file_bytes *bytes) {
  yaml_document_t next;
  if (!yaml_parser_load(parser, &next)) return syntax_fault(yaml, parser, bytes);
  tree_node *root = yaml_document_get_root_node(&next);
  int line = root == NULL ? 0 : tree_line(root);
  yaml_document_delete(&next);
  if (line == 0) return 0;
  return file_fault(yaml->why, yaml->path, line, 0, "a second YAML document starts here; keep one in a file");
}

static int check_root(tree *yaml) {
  tree_node *root = tree_root(yaml);
  if (root == NULL) return file_fault(yaml->why, yaml->path, 0, 0, "holds no keys; write \"key: value\" lines");
  if (root->type == YAML_MAPPING_NODE) return 0;
  return tree_fault(yaml, root, "holds no keys, but a %s; write \"key: value\" lines",
                    root->type == YAML_SEQUENCE_NODE ? "list" : "single value");
}

/* ---- what libyaml would take minutes for ---- */

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

/* libyaml's time is quadratic in nesting, directives, anchors and aliases: a few hundred kilobytes of brackets would
 * hang the tool, and no map or mission has many. Text that is not valid YAML is let through, for the parser to
 * report. */
static int check_shape(const char *path, const file_bytes *bytes, fault *why) {
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

/* ---- reading ---- */

/* Parse what has been looked at. */
static int load(tree *yaml, yaml_parser_t *parser, const file_bytes *bytes) {
  yaml_parser_set_input_string(parser, bytes->data, bytes->size);
  if (!yaml_parser_load(parser, yaml->document)) return syntax_fault(yaml, parser, bytes);
  int result = check_root(yaml);
  if (result == 0) result = check_single(yaml, parser, bytes);
  if (result != 0) yaml_document_delete(yaml->document);
  return result;
}

int tree_read(tree *yaml, const char *path, const file_bytes *bytes, fault *why) {
  yaml_parser_t parser;
  *yaml = (tree){path, why, NULL, NULL};
  if (bytes->size > FILE_TEXT_LIMIT) {
    return file_fault(why, path, 0, 0,
                      "holds more than the %zu MiB that a YAML may have; check that it is the right one",
                      FILE_TEXT_LIMIT >> 20);
  }
  if (check_shape(path, bytes, why)) return -1;
  yaml->document = malloc(sizeof *yaml->document);
  if (yaml->document == NULL || !yaml_parser_initialize(&parser)) {
    free(yaml->document);
    return file_fault(why, path, 0, 0, "no memory to parse it");
  }
  const int result = load(yaml, &parser, bytes);
  if (result != 0) free(yaml->document);
  yaml_parser_delete(&parser);
  return result;
}

void tree_free(tree *yaml) {
  yaml_document_delete(yaml->document);
  free(yaml->document);
}

tree_node *tree_root(tree *yaml) {
  return yaml_document_get_root_node(yaml->document);
}

static tree_node *node_at(tree *yaml, int index) {
  return yaml_document_get_node(yaml->document, index);
}

/* A scalar's text; NULL for another node or one with a NUL inside. */
static const char *scalar_text(tree_node *node) {
  if (node->type != YAML_SCALAR_NODE) return NULL;
  const char *text = (const char *)node->data.scalar.value;
  return strlen(text) == node->data.scalar.length ? text : NULL;
}

static int unknown_key(tree *yaml, tree_node *node, const char *what, const char *key, tree_keys known) {
  char list[TREE_KEYS_LIST];
  const char *nearest = near_word(key, known);
  if (nearest != NULL)
    return tree_fault(yaml, node, "unknown key '%.60s' of %s; did you mean '%s'?", key, what, nearest);
  near_list(list, sizeof list, known);
  return tree_fault(yaml, node, "unknown key '%.60s' of %s; known are %s", key, what, list);
}

static int known_index(const char *key, tree_keys known) {
  for (int i = 0; known[i] != NULL; i++) {
    if (strcmp(known[i], key) == 0) return i;
  }
  return -1;
}

/* A key of a mapping; line_of[] is where the known ones were met. */
static int check_key(tree *yaml, tree_node *key, const char *what, tree_keys known, bool others, int *line_of) {
  const char *text = scalar_text(key);
  if (text == NULL) return tree_fault(yaml, key, "a key of %s is not a plain word; check the line", what);
  const int index = known_index(text, known);
  if (index < 0) return others && near_word(text, known) == NULL ? 0 : unknown_key(yaml, key, what, text, known);
  if (line_of[index] != 0)
    return tree_fault(yaml, key, "key '%s' of %s is there twice (first in line %d); keep one", text, what,
                      line_of[index]);
  line_of[index] = tree_line(key);
  return 0;
}

int tree_check_keys(tree *yaml, tree_node *node, const char *what, tree_keys known, bool others) {
  int line_of[TREE_KEYS_MOST] = {0}, status = 0;
  if (node->type != YAML_MAPPING_NODE) {
    char list[TREE_KEYS_LIST];
    near_list(list, sizeof list, known);
    return tree_fault(yaml, node, "%s is not a mapping; give it the keys %s", what, list);
  }
  for (const yaml_node_pair_t *pair = node->data.mapping.pairs.start; pair < node->data.mapping.pairs.top; pair++) {
    if (check_key(yaml, node_at(yaml, pair->key), what, known, others, line_of) == 0) continue;
    status = -1;
    if (!fault_keep(yaml->all, yaml->why)) return -1;
  }
  return status;
}

tree_node *tree_find(tree *yaml, tree_node *mapping, const char *key) {
  if (mapping->type != YAML_MAPPING_NODE) return NULL;
  for (const yaml_node_pair_t *pair = mapping->data.mapping.pairs.start; pair < mapping->data.mapping.pairs.top;
       pair++) {
    const char *text = scalar_text(node_at(yaml, pair->key));
    if (text != NULL && strcmp(text, key) == 0) return node_at(yaml, pair->value);
  }
  return NULL;
}

tree_node *tree_need(tree *yaml, tree_node *mapping, const char *what, const char *key, const char *example) {
  tree_node *node = tree_find(yaml, mapping, key);
  if (node == NULL) tree_fault(yaml, mapping, "%s lacks the key '%s'; add \"%s: %s\"", what, key, key, example);
  return node;
}

int tree_count(tree_node *list) {
  if (list->type != YAML_SEQUENCE_NODE) return -1;
  return (int)(list->data.sequence.items.top - list->data.sequence.items.start);
}

tree_node *tree_item(tree *yaml, tree_node *list, int index) {
  return node_at(yaml, list->data.sequence.items.start[index]);
}

int tree_pairs(tree_node *mapping) {
  if (mapping->type != YAML_MAPPING_NODE) return -1;
  return (int)(mapping->data.mapping.pairs.top - mapping->data.mapping.pairs.start);
}

tree_node *tree_pair(tree *yaml, tree_node *mapping, int index, const char **key) {
  const yaml_node_pair_t *pair = &mapping->data.mapping.pairs.start[index];
  *key = scalar_text(node_at(yaml, pair->key));
  return node_at(yaml, pair->value);
}

bool tree_plain(tree *yaml, tree_node *node, const char **text) {
  (void)yaml;
  *text = scalar_text(node);
  return *text != NULL;
}

bool tree_has_number_key(tree *yaml, tree_node *mapping) {
  if (mapping->type != YAML_MAPPING_NODE) return false;
  for (const yaml_node_pair_t *pair = mapping->data.mapping.pairs.start; pair < mapping->data.mapping.pairs.top;
       pair++) {
    const char *text = scalar_text(node_at(yaml, pair->key));
    double number;
    if (text != NULL && text_number(&number, text, strlen(text)) == NULL) return true;
  }
  return false;
}

/* A value that is no single one. */
static int wrong_type(tree *yaml, tree_node *node, const char *key, const char *wanted) {
  static const char *const kinds[] = {"nothing", "a single value", "a list", "a mapping"};
  return tree_fault(yaml, node, "'%s' is %s; give %s", key, kinds[node->type & 3], wanted);
}

value_site tree_site(tree *yaml, tree_node *node) {
  return (value_site){yaml->why, yaml->path, tree_line(node), 0};
}

const char *tree_scalar(tree *yaml, tree_node *node, const char *key, const char *wanted) {
  const char *text = scalar_text(node);
  if (text == NULL) wrong_type(yaml, node, key, wanted);
  return text;
}

int tree_number(tree *yaml, tree_node *node, const char *key, double *out) {
  const value_site site = tree_site(yaml, node);
  const char *text = tree_scalar(yaml, node, key, "a number");
  return text == NULL ? -1 : value_number(out, &site, key, text);
}

int tree_integer(tree *yaml, tree_node *node, const char *key, long *out) {
  const value_site site = tree_site(yaml, node);
  const char *text = tree_scalar(yaml, node, key, "a whole number");
  return text == NULL ? -1 : value_integer(out, &site, key, text);
}

int tree_text(tree *yaml, tree_node *node, const char *key, const char **out) {
  const value_site site = tree_site(yaml, node);
  *out = tree_scalar(yaml, node, key, "a text");
  return *out == NULL ? -1 : value_text(&site, key, *out);
}

int tree_word(tree *yaml, tree_node *node, const char *key, tree_keys words, int *out) {
  char wanted[420];
  const value_site site = tree_site(yaml, node);
  value_words(wanted, sizeof wanted, words);
  const char *text = tree_scalar(yaml, node, key, wanted);
  return text == NULL ? -1 : value_word(out, &site, key, text, words);
}
