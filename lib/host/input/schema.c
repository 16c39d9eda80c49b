#include "host/input/schema.h"

#include <math.h>
#include <string.h>

#include "host/base/json.h"

static void write_strings(json *j, const char *key, const char *const *words) {
  json_flat_array(j, key);
  for (int i = 0; words[i] != NULL; i++) json_string(j, NULL, words[i]);
  json_end_array(j);
}

/* A name may well be a number for YAML. */
static void write_text_or_number(json *j) {
  static const char *const types[] = {"string", "number", NULL};
  write_strings(j, "type", types);
}

static void write_range(json *j, const key_record *r) {
  if (r->least == 0.0 && r->most == 0.0) return;
  json_number(j, r->least_out ? "exclusiveMinimum" : "minimum", r->least);
  if (!isinf(r->most)) json_number(j, r->most_out ? "exclusiveMaximum" : "maximum", r->most);
}

static void write_set(json *j, const key_set *set);

static void write_items(json *j, const key_record *r) {
  json_string(j, "type", "array");
  json_object(j, "items");
  if (r->items != NULL)
    write_set(j, r->items);
  else
    write_text_or_number(j);
  json_end_object(j);
}

static void write_polygons(json *j, const key_record *r) {
  static const char *const types[] = {"array", "string", NULL};
  write_strings(j, "type", types);
  json_object(j, "items");
  json_string(j, "type", "array");
  json_integer(j, "minItems", 3);
  json_object(j, "items");
  write_set(j, r->items);
  json_end_object(j);
  json_end_object(j);
}

static void write_named(json *j, const key_record *r) {
  json_string(j, "type", "object");
  json_object(j, "additionalProperties");
  write_set(j, r->items);
  json_end_object(j);
}

static void write_compound(json *j, const key_record *r) {
  switch (r->kind) {
  case KEY_LIST: write_items(j, r); break;
  case KEY_POLYGONS: write_polygons(j, r); break;
  case KEY_MAPPING: write_set(j, r->items); break;
  default: write_named(j, r); break;
  }
}

static void write_type(json *j, const key_record *r) {
  switch (r->kind) {
  case KEY_TEXT:
  case KEY_NAME: write_text_or_number(j); break;
  case KEY_FILE: json_string(j, "type", "string"); break;
  case KEY_WORD: write_strings(j, "enum", r->words); break;
  case KEY_SWITCH: json_string(j, "type", "boolean"); break;
  case KEY_INTEGER:
  case KEY_NUMBER:
    json_string(j, "type", r->kind == KEY_INTEGER ? "integer" : "number");
    write_range(j, r);
    break;
  default: write_compound(j, r); break;
  }
}

/* "side of a cell, m; ROS maps only; default 1" */
static void write_description(json *j, const key_record *r) {
  char text[600];
  size_t used = (size_t)snprintf(text, sizeof text, "%s%s%s", r->help, r->unit != NULL ? "; in " : "",
                                 r->unit != NULL ? r->unit : "");
  if (r->where != NULL && used < sizeof text)
    used += (size_t)snprintf(text + used, sizeof text - used, "; %s only", r->where);
  if (r->standard != NULL && used < sizeof text)
    snprintf(text + used, sizeof text - used, "; default: %s", r->standard);
  json_string(j, "description", text);
}

static void write_property(json *j, const key_record *r, const char *name) {
  json_object(j, name);
  write_description(j, r);
  write_type(j, r);
  json_end_object(j);
}

static void write_properties(json *j, const key_set *set) {
  json_object(j, "properties");
  for (const key_record *r = set->records; r->name != NULL; r++) {
    write_property(j, r, r->name);
    for (int i = 0; r->also != NULL && r->also[i] != NULL; i++) write_property(j, r, r->also[i]);
  }
  json_end_object(j);
}

static void write_needed(json *j, const key_set *set) {
  json_flat_array(j, "required");
  for (const key_record *r = set->records; r->name != NULL; r++)
    if (r->needed) json_string(j, NULL, r->name);
  json_end_array(j);
}

/* Exactly one group has its first key, and no key is there without the others of its group. */
static void write_either(json *j, const key_group *groups) {
  if (groups == NULL) return;
  json_array(j, "oneOf");
  for (const key_group *g = groups; g->what != NULL; g++) {
    json_flat_object(j, NULL);
    json_flat_array(j, "required");
    json_string(j, NULL, g->names[0]);
    json_end_array(j);
    json_end_object(j);
  }
  json_end_array(j);
  json_object(j, "dependencies");
  for (const key_group *g = groups; g->what != NULL; g++)
    for (int i = 0; i < KEYS_GROUP; i++) {
      json_flat_array(j, g->names[i]);
      json_string(j, NULL, g->names[KEYS_GROUP - 1 - i]);
      json_end_array(j);
    }
  json_end_object(j);
}

/* Of the words for one key one is there. */
static void write_words_apart(json *j, const key_set *set) {
  json_array(j, "allOf");
  for (const key_record *r = set->records; r->name != NULL; r++)
    for (int i = 0; r->also != NULL && r->also[i] != NULL; i++)
      for (int k = -1; k < i; k++) {
        const char *const pair[] = {k < 0 ? r->name : r->also[k], r->also[i], NULL};
        json_flat_object(j, NULL);
        json_flat_object(j, "not");
        write_strings(j, "required", pair);
        json_end_object(j);
        json_end_object(j);
      }
  json_end_array(j);
}

static bool has_other_words(const key_set *set) {
  for (const key_record *r = set->records; r->name != NULL; r++)
    if (r->also != NULL) return true;
  return false;
}

static void write_set(json *j, const key_set *set) {
  json_string(j, "title", set->title);
  json_string(j, "type", "object");
  write_properties(j, set);
  write_needed(j, set);
  json_bool(j, "additionalProperties", false);
  write_either(j, set->either);
  if (has_other_words(set)) write_words_apart(j, set);
}

void schema_write(FILE *out, const key_set *set) {
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "$schema", "http://json-schema.org/draft-07/schema#");
  write_set(&j, set);
  json_end_object(&j);
}
