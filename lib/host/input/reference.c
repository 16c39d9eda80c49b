#include "host/input/reference.h"

static void write_words(FILE *out, const char *const *words) {
  for (int i = 0; words[i] != NULL; i++)
    fprintf(out, "%s`%s`", i == 0 ? "" : words[i + 1] == NULL ? " or " : ", ", words[i]);
}

static void write_name(FILE *out, const key_record *r) {
  fprintf(out, "`%s`", r->name);
  if (r->also == NULL) return;
  fputs(", also ", out);
  write_words(out, r->also);
}

void reference_write_values(FILE *out, const key_record *r) {
  static const char *const kinds[] = {[KEY_TEXT] = "a text",
                                      [KEY_NAME] = "a name of its own",
                                      [KEY_FILE] = "a file, relative to this one",
                                      [KEY_NUMBER] = "a number",
                                      [KEY_INTEGER] = "a whole number",
                                      [KEY_SWITCH] = "`true` or `false`",
                                      [KEY_LIST] = "a list",
                                      [KEY_POLYGONS] = "a list of lists, or a file",
                                      [KEY_MAPPING] = "keys of its own, below",
                                      [KEY_NAMED] = "names of your own, each with the keys below"};
  char range[KEYS_RANGE_SIZE];
  if (r->kind == KEY_WORD) {
    write_words(out, r->words);
    return;
  }
  keys_range(range, r);
  fputs(kinds[r->kind], out);
  if (range[0] != '\0') fprintf(out, " %s", range);
}

static void write_row(FILE *out, const key_record *r) {
  fputs("| ", out);
  write_name(out, r);
  fprintf(out, " | %s", r->help);
  if (r->where != NULL) fprintf(out, "; %s only", r->where);
  fputs(" | ", out);
  reference_write_values(out, r);
  fprintf(out, " | %s | %s | `%s` |\n", r->unit != NULL ? r->unit : "",
          r->needed             ? "needed"
          : r->standard != NULL ? r->standard
                                : "",
          r->example);
}

static void write_groups(FILE *out, const key_group *groups) {
  for (const key_group *g = groups; g->what != NULL; g++)
    fprintf(out, "%s`%s` and `%s`", g == groups ? "" : ", or ", g->names[0], g->names[1]);
}

void reference_write(FILE *out, const key_set *set) {
  fprintf(out, "\n## %s\n", set->title);
  if (set->either != NULL) {
    fprintf(out, "Its %s is needed, in one way: ", set->either_what);
    write_groups(out, set->either);
    fputs(".\n", out);
  }
  fputs("\n| key | what | values | unit | default | example |\n| --- | --- | --- | --- | --- | --- |\n", out);
  for (const key_record *r = set->records; r->name != NULL; r++) write_row(out, r);
  for (const key_record *r = set->records; r->name != NULL; r++)
    if (r->items != NULL) reference_write(out, r->items);
}
