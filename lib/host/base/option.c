#include "host/base/option.h"

#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/near.h"
#include "host/base/refusal.h"

enum {
  OPTIONS_MOST = 96,
  LONG_ONE = 256 /* what getopt returns for the first long option: no letter, and none of its own signs */
};

static const char name_letters[] = "abcdefghijklmnopqrstuvwxyz-";

/* ---- values ---- */

int option_number(double *number, const char *name, const char *value, const char *range, double least, double most,
                  fault *why) {
  char *end;
  errno = 0;
  *number = strtod(value, &end);
  if (end != value && *end == '\0' && *number >= least && *number <= most && errno != ERANGE) return 0;
  if (range != NULL) return fault_set(why, "--%s %s: not a number %s", name, value, range);
  return fault_set(why, "--%s %s: not a number from %g to %g", name, value, least, most);
}

int option_count(uint64_t *count, const char *name, const char *value, uint64_t first, uint64_t last, fault *why) {
  char *end;
  errno = 0;
  *count = strtoull(value, &end, 10);
  if (value[0] >= '0' && value[0] <= '9' && *end == '\0' && errno != ERANGE && *count >= first && *count <= last)
    return 0;
  return fault_set(why, "--%s %s: not a whole number from %llu to %llu", name, value, (unsigned long long)first,
                   (unsigned long long)last);
}

int option_word(int *index, const char *name, const char *value, size_t length, const char *const *words, fault *why) {
  char known[200];
  for (*index = 0; words[*index] != NULL; ++*index)
    if (strlen(words[*index]) == length && strncmp(words[*index], value, length) == 0) return 0;
  near_choice(known, sizeof known, words);
  return fault_set(why, "--%s %s: say %s", name, value, known);
}

static void store(void *field, size_t size, uint64_t value) {
  const uint8_t byte = (uint8_t)value;
  const uint32_t word = (uint32_t)value;
  const void *from = size == sizeof byte ? (const void *)&byte : size == sizeof word ? (const void *)&word : &value;
  memcpy(field, from, size);
}

static int take_number(double *number, const option_record *r, const char *value, fault *why) {
  if (option_number(number, r->name, value, r->range, r->least, r->most, why) != 0) return -1;
  if (!r->open || (*number > r->least && *number < r->most)) return 0;
  return fault_set(why, "--%s %s: not a number %s", r->name, value, r->range);
}

static int take_count(void *field, const option_record *r, const char *value, fault *why) {
  uint64_t count;
  if (option_count(&count, r->name, value, r->first, r->last, why) != 0) return -1;
  store(field, r->size, count);
  return 0;
}

static int take_word(void *field, const option_record *r, const char *value, fault *why) {
  int index;
  if (option_word(&index, r->name, value, strlen(value), r->words, why) != 0) return -1;
  store(field, r->size, (uint64_t)index);
  return 0;
}

static int take(void *settings, const option_record *r, const char *value, fault *why) {
  void *field = (char *)settings + r->at;
  switch (r->kind) {
  case OPTION_MARK: store(field, r->size, 1); return 0;
  case OPTION_NUMBER: return take_number(field, r, value, why);
  case OPTION_COUNT: return take_count(field, r, value, why);
  case OPTION_WORD: return take_word(field, r, value, why);
  case OPTION_OWN: return r->take(settings, r, value, why);
  case OPTION_FILE:
    if (value[0] == '\0') return fault_set(why, "--%s: the name of the file is empty", r->name);
    break;
  case OPTION_TEXT: break;
  }
  memcpy(field, &value, sizeof value);
  return 0;
}

/* ---- which options there are ---- */

static const option_record *find(const option_record *table, const char *name, size_t length) {
  while (table->name != NULL && (strlen(table->name) != length || strncmp(table->name, name, length) != 0)) table++;
  return table->name != NULL ? table : NULL;
}

/* The next name of a line's options from *at on, which is moved behind it; its length, or 0 at the end. */
static size_t next_name(const char **at, const char **name) {
  *name = *at + strcspn(*at, name_letters);
  const size_t length = strspn(*name, name_letters);
  *at = *name + length;
  return length;
}

bool option_is_taken(const option_set *set, const char *name) {
  if (strcmp(name, "help") == 0) return true;
  for (const option_line *line = set->lines; line->options != NULL; line++) {
    const char *at = line->options, *named;
    for (size_t length; (length = next_name(&at, &named)) > 0;)
      if (strlen(name) == length && strncmp(name, named, length) == 0) return true;
  }
  return false;
}

/* ---- parsing ---- */

static int argument_of(const option_record *r) {
  return r->argument == NULL ? no_argument : r->argument[0] == '[' ? optional_argument : required_argument;
}

/* getopt's tables for what this command takes: a long option returns its record's number, counted from LONG_ONE. */
static void make_tables(const option_set *set, struct option *longs, char *shorts) {
  int count = 0;
  *shorts++ = ':';
  for (const option_record *r = set->table; r->name != NULL; r++) {
    if (!option_is_taken(set, r->name)) continue;
    longs[count++] = (struct option){r->name, argument_of(r), NULL, (int)(r - set->table) + LONG_ONE};
    if (r->letter == 0) continue;
    *shorts++ = r->letter;
    if (argument_of(r) == required_argument) *shorts++ = ':';
  }
  longs[count] = (struct option){NULL, 0, NULL, 0};
  *shorts = '\0';
}

static const option_record *record_of(const option_record *table, int code) {
  if (code >= LONG_ONE) return &table[code - LONG_ONE];
  while (table->letter != code) table++;
  return table;
}

int option_parse(void *settings, const option_set *set, int argc, char **argv, fault *why) {
  struct option longs[OPTIONS_MOST + 1];
  char shorts[3 * OPTIONS_MOST];
  int code;
  make_tables(set, longs, shorts);
  opterr = 0;
  optind = 1;
  while ((code = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
    if (code == '?' || code == ':') return refuse_option(set->name, code, argv[optind - 1], longs, why);
    if (take(settings, record_of(set->table, code), optarg, why) != 0) return -1;
  }
  return 0;
}

/* ---- help ---- */

/* "--name ARGUMENT", or with the letter before it. The number of characters. */
static int print_option(FILE *out, const option_record *r, bool with_letter) {
  int length = 0;
  if (with_letter && r->letter != 0) length += fprintf(out, "-%c, ", r->letter);
  length += fprintf(out, "--%s", r->name);
  if (r->argument != NULL) length += fprintf(out, "%s%s", r->argument[0] == '[' ? "" : " ", r->argument);
  return length;
}

/* The options of a line, as far as the text: the column that they end in. The letters of the first one alone are
 * shown. */
static int print_options(FILE *out, const option_set *set, const option_line *line) {
  const char *at = line->options, *from = at, *name;
  const option_record *first = find(set->table, at, strspn(at, name_letters));
  int column = fprintf(out, "%*s", first->letter != 0 ? 2 : 6, "");
  for (size_t length; (length = next_name(&at, &name)) > 0; from = at) {
    const bool wraps = name > from && name[-1] == '\n';
    column += fprintf(out, "%.*s", (int)(name - from), from);
    if (wraps) column = fprintf(out, "%6s", "");
    column += print_option(out, find(set->table, name, length), name == line->options);
  }
  return column + fprintf(out, "%s", from);
}

/* The default of the next option of a line that has one. */
static const char *next_standard(const option_set *set, const char **at) {
  const char *name;
  for (size_t length; (length = next_name(at, &name)) > 0;) {
    const option_record *r = find(set->table, name, length);
    if (r->standard != NULL) return r->standard;
  }
  return "";
}

static void print_line(FILE *out, const option_set *set, const option_line *line) {
  const char *names = line->options;
  const int column = line->column > 0 ? line->column : OPTION_COLUMN;
  const char *text = line->text != NULL ? line->text : find(set->table, names, strspn(names, name_letters))->help;
  const int apart = column - print_options(out, set, line);
  fprintf(out, "%*s", apart > 0 ? apart : 1, "");
  for (; *text != '\0'; text++) {
    if (strncmp(text, "%s", 2) == 0)
      fputs(next_standard(set, &names), out), text++;
    else if (*text == '\n')
      fprintf(out, "\n%*s", column, "");
    else
      fputc(*text, out);
  }
  fputc('\n', out);
}

int option_help(FILE *out, const option_set *set) {
  fputs(set->intro, out);
  for (const option_line *line = set->lines; line->options != NULL; line++) print_line(out, set, line);
  fputs(set->outro, out);
  return EXIT_SUCCESS;
}
