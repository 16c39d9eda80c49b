#include "host/input/csv.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "host/base/count.h"
#include "host/base/near.h"
#include "host/base/separated.h"
#include "host/input/foreign.h"
#include "host/input/mission_keys.h"
#include "host/input/sites.h"

#define WORD 32

/* A column: a key of a place, by whatever word, or one that is not used. */
typedef struct {
  key_record record; /* without a name: not used */
  char word[WORD];   /* as the header has it, in small letters */
} column;

typedef struct {
  input *in;
  fault *why;
  separated rows;
  int columns; /* 0: the header is yet to come */
  column column[SEPARATED_MOST];
  int group; /* how positions are stated */
} reading;

static value_site site_of(const reading *r, int i) {
  return (value_site){r->why, r->in->csv, r->rows.field[i].line, r->rows.field[i].column};
}

static int header_fault(const reading *r, const char *what) {
  return file_fault(r->why, r->in->csv, r->rows.line, 0, "%s", what);
}

/* ---- the header ---- */

static bool has_column(const reading *r, const char *name) {
  for (int i = 0; i < r->columns; i++)
    if (r->column[i].record.name != NULL && strcmp(keys_find(&mission_place_keys, r->column[i].word)->name, name) == 0)
      return true;
  return false;
}

static bool is_geographic(const reading *r) {
  static const char *const words[] = {"lat", "latitude", "lon", "lng", "long", "longitude"};
  for (int i = 0; i < r->columns; i++)
    for (size_t w = 0; w < sizeof words / sizeof words[0]; w++)
      if (strcmp(r->column[i].word, words[w]) == 0) return true;
  return false;
}

static void take_word(char word[WORD], const char *text) {
  size_t i = 0;
  for (; text[i] != '\0' && i + 1 < WORD; i++) word[i] = (char)tolower((unsigned char)text[i]);
  word[i] = '\0';
}

/* Values of a place that a field can hold. */
static const key_record *record_of(const char *word) {
  const key_record *r = keys_find(&mission_place_keys, word);
  return r != NULL && r->kind < KEY_LIST ? r : NULL;
}

static int take_column(reading *r, int i) {
  column *c = &r->column[i];
  const value_site site = site_of(r, i);
  take_word(c->word, r->rows.field[i].text);
  const key_record *record = record_of(c->word);
  *c = (column){.record = record != NULL ? *record : (key_record){.name = NULL}};
  take_word(c->word, r->rows.field[i].text);
  if (record == NULL) return 0;
  for (int other = 0; other < i; other++)
    if (r->column[other].record.name != NULL && record_of(r->column[other].word) == record)
      return value_fault(&site, "the column '%s' is there twice, as '%s' in column %d of the file; keep one", c->word,
                         r->column[other].word, other + 1);
  c->record.name = c->word;
  return 0;
}

/* A column that is not used, but is likely a slip of one that would be: `near` says which slips count. */
static int check_slips(const reading *r, const char *(*near)(const char *, const char *const *)) {
  const char *names[TREE_KEYS_MOST + 1];
  keys_words(names, &mission_place_keys);
  for (int i = 0; i < r->columns; i++) {
    const value_site site = site_of(r, i);
    const char *meant = r->column[i].record.name == NULL ? near(r->column[i].word, names) : NULL;
    if (meant != NULL && !has_column(r, keys_find(&mission_place_keys, meant)->name))
      return value_fault(&site, "unknown column '%s'; did you mean '%s'?", r->column[i].word, meant);
  }
  return 0;
}

static int no_position(const reading *r) {
  bool any = false;
  for (int i = 0; i < r->columns; i++) any = any || r->column[i].record.name != NULL;
  if (is_geographic(r))
    return header_fault(r, "latitudes and longitudes are not read here; give metres in the map frame, under "
                           "\"x,y,weight\", or a GeoJSON (places_geojson)");
  if (check_slips(r, near_word) != 0) return -1;
  if (any) return header_fault(r, "the header has no position; give it the columns x and y, or column and row");
  return header_fault(
      r, "the first line is not the header \"x,y,weight\" (or \"column,row,weight\"); write it above the places");
}

/* Whether a group's columns are there; -1 with the fault set: one without the other. */
static int check_group(const reading *r, const key_group *group) {
  const bool first = has_column(r, group->names[0]), second = has_column(r, group->names[1]);
  if (first == second) return first;
  return file_fault(r->why, r->in->csv, r->rows.line, 0, "the header has '%s' and lacks '%s'; add that column",
                    group->names[first ? 0 : 1], group->names[first ? 1 : 0]);
}

static int check_position(reading *r) {
  int whole = -1;
  for (int g = 0; mission_place_keys.either[g].what != NULL; g++) {
    const int has = check_group(r, &mission_place_keys.either[g]);
    if (has < 0) return -1;
    if (has > 0 && whole >= 0)
      return header_fault(r, "the header has both metres and cells; keep x and y, or column and row");
    if (has > 0) whole = g;
  }
  r->group = whole;
  return whole >= 0 ? 0 : no_position(r);
}

/* What is not used is said once. */
static void note_unused(reading *r) {
  char list[300] = "";
  size_t used = 0;
  int count = 0;
  for (int i = 0; i < r->columns; i++) {
    if (r->column[i].record.name != NULL || r->rows.field[i].text[0] == '\0') continue;
    if (used < sizeof list)
      used +=
          (size_t)snprintf(list + used, sizeof list - used, "%s'%.40s'", count > 0 ? ", " : "", r->rows.field[i].text);
    count++;
  }
  if (count > 0)
    notes_add(&r->in->note, "%s: %s not used: %s", file_short_path(r->in->csv),
              count == 1 ? "a column is" : "columns are", list);
}

static int read_header(reading *r) {
  r->columns = r->rows.count;
  for (int i = 0; i < r->columns; i++)
    if (take_column(r, i) != 0) return -1;
  if (check_position(r) != 0 || check_slips(r, near_slip) != 0) return -1;
  note_unused(r);
  return 0;
}

/* ---- places ---- */

/* A header again, where files were put one below the other. */
static bool is_header(const reading *r) {
  char word[WORD];
  for (int i = 0; i < r->rows.count; i++) {
    take_word(word, r->rows.field[i].text);
    if (strcmp(word, r->column[i].word) != 0) return false;
  }
  return true;
}

static int wrong_count(const reading *r) {
  const bool commas = r->rows.separator == ',' && r->rows.count > r->columns;
  return file_fault(r->why, r->in->csv, r->rows.line, 0, "the line has %s, not %d as the header; %s",
                    counted((uint64_t)r->rows.count, "field").text, r->columns,
                    commas ? "quote texts that hold commas, write 0.5 and not 0,5, or put ; between all fields"
                           : "write as many, an empty one where there is nothing to say");
}

/* A name may be left out, and what the mission says for all. */
static bool may_be_empty(const key_record *record) {
  static const char *const words[] = {"scan_seconds", "detection", "looks"};
  for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
    if (strcmp(record->name, words[i]) == 0) return true;
  return record->kind == KEY_TEXT || record->kind == KEY_NAME;
}

static int take_field(reading *r, mission_site *place, int i) {
  char number[SEPARATED_NUMBER];
  const key_record *record = &r->column[i].record;
  const value_site site = site_of(r, i);
  const char *text = r->rows.field[i].text;
  const bool is_text = record->kind == KEY_TEXT || record->kind == KEY_NAME;
  if (record->name == NULL || (text[0] == '\0' && may_be_empty(record))) return 0;
  return keys_take(place, record, &site, is_text ? text : separated_number(&r->rows, text, number));
}

static int read_place(reading *r) {
  mission_site place = {.it.weight = 1.0};
  if (r->rows.count != r->columns) return wrong_count(r);
  if (is_header(r)) return header_fault(r, "the header is there twice; delete this line");
  for (int i = 0; i < r->columns; i++)
    if (take_field(r, &place, i) != 0) return -1;
  const input_origin origin = {INPUT_FROM_CSV, (int)r->rows.line, 0};
  const input_site site = mission_site_of(&place, r->group);
  return sites_add_place(r->in, &site, origin, r->why);
}

int csv_read(input *in, file_bytes *bytes, fault *why) {
  static reading r;
  int more;
  const char *foreign = foreign_what(bytes);
  if (foreign != NULL && strncmp(foreign, "a CSV", 5) != 0) return file_fault(why, in->csv, 0, 0, "is %s", foreign);
  r = (reading){.in = in, .why = why};
  separated_begin(&r.rows, bytes, in->csv, why);
  if ((more = separated_next(&r.rows)) > 0 && read_header(&r) != 0) return -1;
  while (more > 0 && (more = separated_next(&r.rows)) > 0)
    if (!input_goes_on(in, read_place(&r), why)) return -1;
  if (more < 0 || r.columns > 0) return more;
  return file_fault(why, in->csv, 0, 0, "holds no header; start it with \"x,y,weight\"");
}
