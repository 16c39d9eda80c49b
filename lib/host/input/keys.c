#include "host/input/keys.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "host/base/naming.h"
#include "host/base/text.h"

#define RADIANS 0.017453292519943295 /* of a degree */

/* ---- ranges ---- */

static bool has_range(const key_record *r) {
  return r->least != 0.0 || r->most != 0.0;
}

static bool is_in_range(const key_record *r, double value) {
  if (!has_range(r)) return true;
  if (r->least_out ? !(value > r->least) : !(value >= r->least)) return false;
  return r->most_out ? value < r->most : value <= r->most;
}

void keys_range(char out[KEYS_RANGE_SIZE], const key_record *r) {
  out[0] = '\0';
  if (!has_range(r)) return;
  if (isinf(r->most)) {
    snprintf(out, KEYS_RANGE_SIZE, r->least_out ? "above %.6g" : "of %.6g or more", r->least);
    return;
  }
  snprintf(out, KEYS_RANGE_SIZE, "%s %.6g %s %.6g", r->least_out ? "above" : "from", r->least,
           r->most_out    ? r->least_out ? "and below" : "to below"
           : r->least_out ? "and up to"
                          : "to",
           r->most);
}

static int out_of_range(const key_record *r, const value_site *site, double value) {
  char range[KEYS_RANGE_SIZE];
  keys_range(range, r);
  const char *noun = r->noun != NULL ? r->noun : r->kind == KEY_INTEGER ? "a whole number" : "a number";
  char turn[60] = "";
  if (r->unit != NULL && strcmp(r->unit, "radians") == 0)
    snprintf(turn, sizeof turn, " (%.6g degrees are %.6g)", value, value * RADIANS);
  return value_fault(site, "'%s' is %.6g%s%s; give %s %s, such as %s%s", r->name, value, r->unit != NULL ? " " : "",
                     r->unit != NULL ? r->unit : "", noun, range, r->example, turn);
}

/* ---- values ---- */

static int take_number(double *field, const key_record *r, const value_site *site, const char *text) {
  double number;
  const char *wrong = text_number(&number, text, strlen(text));
  if (wrong != NULL && text[0] != '\0' && r->unit != NULL)
    return value_fault(site, "'%s' is \"%.60s\", which %s; give a number alone, in %s, such as %s", r->name, text,
                       wrong, r->unit, r->example);
  if (value_number(&number, site, r->name, text)) return -1;
  if (!is_in_range(r, number)) return out_of_range(r, site, number);
  *field = number;
  return 0;
}

static void store(void *field, size_t size, long value) {
  const int8_t byte = (int8_t)value;
  const int16_t half = (int16_t)value;
  const int32_t word = (int32_t)value;
  const int64_t all = value;
  const void *from = size == sizeof byte   ? (const void *)&byte
                     : size == sizeof half ? (const void *)&half
                     : size == sizeof word ? (const void *)&word
                                           : (const void *)&all;
  memcpy(field, from, size);
}

static int take_integer(void *field, const key_record *r, const value_site *site, const char *text) {
  long number;
  if (value_integer(&number, site, r->name, text)) return -1;
  if (!is_in_range(r, (double)number)) return out_of_range(r, site, (double)number);
  store(field, r->size, number);
  return 0;
}

static const char *const *words_of(const key_record *r) {
  static const char *const truth[] = {"false", "true", NULL};
  return r->kind == KEY_SWITCH ? truth : r->words;
}

static int take_word(void *field, const key_record *r, const value_site *site, const char *text) {
  int word;
  if (value_word(&word, site, r->name, text, words_of(r))) return -1;
  store(field, r->size, word);
  return 0;
}

static int take_name(char *field, const key_record *r, const value_site *site, const char *text) {
  if (value_text(site, r->name, text)) return -1;
  const char *wrong = naming_wrong(text);
  if (wrong == NULL) return snprintf(field, r->size, "%s", text) < 0;
  return value_fault(site, "'%s' is \"%.60s\", which %s; give a text of at most %zu bytes in one line", r->name, text,
                     wrong, r->size - 1);
}

static int take_text(char *field, const key_record *r, const value_site *site, const char *text) {
  if (value_text(site, r->name, text)) return -1;
  if (strlen(text) >= r->size)
    return value_fault(site, "'%s' has %zu bytes; shorten it to %zu", r->name, strlen(text), r->size - 1);
  strcpy(field, text);
  return 0;
}

int keys_take(void *settings, const key_record *r, const value_site *site, const char *text) {
  void *field = (char *)settings + r->at;
  if (r->given != 0) *(bool *)((char *)settings + r->given) = true;
  switch (r->kind) {
  case KEY_NUMBER: return take_number(field, r, site, text);
  case KEY_INTEGER: return take_integer(field, r, site, text);
  case KEY_WORD:
  case KEY_SWITCH: return take_word(field, r, site, text);
  case KEY_TEXT: return take_text(field, r, site, text);
  case KEY_NAME: return take_name(field, r, site, text);
  case KEY_FILE:
    return value_text(site, r->name, text) ? -1 : file_path_beside(field, r->size, site->path, text, site->why);
  default: return 0;
  }
}

/* ---- which keys there are ---- */

static bool is_called(const key_record *r, const char *name) {
  if (strcmp(r->name, name) == 0) return true;
  for (int i = 0; r->also != NULL && r->also[i] != NULL; i++)
    if (strcmp(r->also[i], name) == 0) return true;
  return false;
}

const key_record *keys_find(const key_set *set, const char *name) {
  for (const key_record *r = set->records; r->name != NULL; r++)
    if (is_called(r, name)) return r;
  return NULL;
}

void keys_words(const char *names[TREE_KEYS_MOST + 1], const key_set *set) {
  int count = 0;
  for (const key_record *r = set->records; r->name != NULL; r++) {
    if (count < TREE_KEYS_MOST) names[count++] = r->name;
    for (int i = 0; r->also != NULL && r->also[i] != NULL && count < TREE_KEYS_MOST; i++) names[count++] = r->also[i];
  }
  names[count] = NULL;
}

/* The node under the i-th word for a key, the name itself being the first; *word is that word, NULL behind the last. */
static tree_node *node_under(tree *yaml, tree_node *mapping, const key_record *r, int i, const char **word) {
  *word = i == 0 ? r->name : r->also != NULL ? r->also[i - 1] : NULL;
  return *word != NULL ? tree_find(yaml, mapping, *word) : NULL;
}

static tree_node *find_under(tree *yaml, tree_node *mapping, const key_record *r, const char **word) {
  for (int i = 0;; i++) {
    tree_node *node = node_under(yaml, mapping, r, i, word);
    if (node != NULL || *word == NULL) return node;
  }
}

tree_node *keys_node(tree *yaml, tree_node *mapping, const key_record *r) {
  const char *word;
  return find_under(yaml, mapping, r, &word);
}

/* That a key is not there under two words. */
static int check_once(tree *yaml, tree_node *mapping, const key_record *r, const char *what) {
  const char *word, *first = NULL;
  for (int i = 0; r->also != NULL && (i == 0 || r->also[i - 1] != NULL); i++) {
    tree_node *node = node_under(yaml, mapping, r, i, &word);
    if (node == NULL) continue;
    if (first != NULL)
      return tree_fault(yaml, node, "%s has both '%s' and '%s', which are one; keep one", what, first, word);
    first = word;
  }
  return 0;
}

/* ---- keys that are given together ---- */

static bool has_any(tree *yaml, tree_node *mapping, const key_group *group) {
  for (int i = 0; i < KEYS_GROUP; i++)
    if (tree_find(yaml, mapping, group->names[i]) != NULL) return true;
  return false;
}

/* "x and y, or column and row" */
static void list_groups(char *out, size_t size, const key_group *groups) {
  size_t used = 0;
  out[0] = '\0';
  for (const key_group *g = groups; g->what != NULL && used < size; g++)
    used +=
        (size_t)snprintf(out + used, size - used, "%s%s and %s", g == groups ? "" : ", or ", g->names[0], g->names[1]);
}

static int check_either(const key_set *set, tree *yaml, tree_node *mapping, const char *what, int *chosen) {
  char list[200];
  const key_group *first = NULL;
  list_groups(list, sizeof list, set->either);
  for (const key_group *g = set->either; g->what != NULL; g++) {
    if (!has_any(yaml, mapping, g)) continue;
    if (first != NULL)
      return tree_fault(yaml, mapping, "%s has both %s and %s; keep %s", what, first->what, g->what, list);
    first = g;
  }
  if (first == NULL) return tree_fault(yaml, mapping, "%s has no %s; give it %s", what, set->either_what, list);
  for (int i = 0; i < KEYS_GROUP; i++)
    if (tree_need(yaml, mapping, what, first->names[i], keys_find(set, first->names[i])->example) == NULL) return -1;
  if (chosen != NULL) *chosen = (int)(first - set->either);
  return 0;
}

/* ---- reading ---- */

static int check_list(const key_record *r, tree *yaml, tree_node *node) {
  const char *file;
  if (tree_count(node) >= 0 || (r->kind == KEY_POLYGONS && tree_plain(yaml, node, &file))) return 0;
  return tree_fault(yaml, node, "'%s' is not a list; write one, such as \"%s: %s\": %s", r->name, r->name, r->example,
                    r->help);
}

static int take_node(void *settings, const key_record *r, tree *yaml, tree_node *node) {
  static const char *const wanted[] = {"a text", "a text", "a text", "a number", "a whole number"};
  char words[420];
  const value_site site = tree_site(yaml, node);
  if (r->kind == KEY_LIST || r->kind == KEY_POLYGONS) return check_list(r, yaml, node);
  if (r->kind == KEY_MAPPING || r->kind == KEY_NAMED) return 0;
  const bool is_word = r->kind == KEY_WORD || r->kind == KEY_SWITCH;
  if (is_word) value_words(words, sizeof words, words_of(r));
  const char *text = tree_scalar(yaml, node, r->name, is_word ? words : wanted[r->kind]);
  return text == NULL ? -1 : keys_take(settings, r, &site, text);
}

static int read_key(void *settings, const key_record *r, tree *yaml, tree_node *mapping, const char *what) {
  key_record named = *r; /* by the word that the user took */
  if (check_once(yaml, mapping, r, what)) return -1;
  tree_node *node = find_under(yaml, mapping, r, &named.name);
  if (node != NULL) return take_node(settings, &named, yaml, node);
  return r->needed && tree_need(yaml, mapping, what, r->name, r->example) == NULL ? -1 : 0;
}

int keys_read(void *settings, const key_set *set, tree *yaml, tree_node *mapping, const char *what, int *group) {
  const char *names[TREE_KEYS_MOST + 1];
  keys_words(names, set);
  int status = tree_check_keys(yaml, mapping, what, names, false);
  if (status != 0 && (!fault_keep(yaml->all, yaml->why) || tree_pairs(mapping) < 0)) return -1;
  if (set->either != NULL && check_either(set, yaml, mapping, what, group)) {
    if (!fault_keep(yaml->all, yaml->why)) return -1;
    status = -1;
  }
  for (const key_record *r = set->records; r->name != NULL; r++) {
    if (read_key(settings, r, yaml, mapping, what) == 0) continue;
    if (!fault_keep(yaml->all, yaml->why)) return -1;
    status = -1;
  }
  return status;
}
