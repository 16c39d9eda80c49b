#include "host/input/csv.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "host/base/count.h"
#include "host/base/text.h"
#include "host/input/foreign.h"
#include "host/input/sites.h"

#define FIELDS 3

enum column { X, Y, COLUMN, ROW, WEIGHT, COLUMNS };
static const char *const NAMES[COLUMNS] = {"x", "y", "column", "row", "weight"};

/* The fields of a line; a number other than FIELDS is a fault. */
static int split(text_field fields[FIELDS], const input *in, const text_lines *lines, fault *why) {
  const char *rest = lines->line, *end = lines->line + lines->length;
  int count = 0;
  while (rest != NULL) {
    text_field next = text_next_field(&rest, end);
    if (count < FIELDS) fields[count] = next;
    count++;
  }
  if (count == FIELDS) return 0;
  return file_fault(why, in->csv, lines->number, 0, "the line has %s, not %d; write \"x,y,weight\" with commas",
                    counted((uint64_t)count, "field").text, FIELDS);
}

static int column_of(text_field it) {
  for (int i = 0; i < COLUMNS; i++) {
    if (it.length == strlen(NAMES[i]) && strncasecmp(it.text, NAMES[i], it.length) == 0) return i;
  }
  return -1;
}

static bool is_geographic(const text_field fields[FIELDS]) {
  static const char *const words[] = {"lat", "latitude", "lon", "lng", "long", "longitude"};
  for (int i = 0; i < FIELDS; i++)
    for (size_t w = 0; w < sizeof words / sizeof words[0]; w++)
      if (fields[i].length == strlen(words[w]) && strncasecmp(fields[i].text, words[w], fields[i].length) == 0)
        return true;
  return false;
}

static int no_header(const input *in, const text_lines *lines, const text_field fields[FIELDS], fault *why) {
  if (is_geographic(fields))
    return file_fault(why, in->csv, lines->number, 0,
                      "latitudes and longitudes are not read; give metres in the map frame, under \"x,y,weight\"");
  return file_fault(
      why, in->csv, lines->number, 0,
      "the first line is not the header \"x,y,weight\" (or \"column,row,weight\"); write it above the places");
}

/* order[i] = which column the i-th field is. */
static int read_header(int order[FIELDS], const input *in, const text_lines *lines, fault *why) {
  text_field fields[FIELDS];
  bool seen[COLUMNS] = {false};
  if (split(fields, in, lines, why)) return -1;
  for (int i = 0; i < FIELDS; i++) {
    order[i] = column_of(fields[i]);
    if (order[i] < 0 || seen[order[i]]) break;
    seen[order[i]] = true;
  }
  if (seen[WEIGHT] && ((seen[X] && seen[Y]) || (seen[COLUMN] && seen[ROW]))) return 0;
  return no_header(in, lines, fields, why);
}

static int read_place(input *in, const int order[FIELDS], const text_lines *lines, fault *why) {
  text_field fields[FIELDS];
  double values[COLUMNS] = {0};
  if (split(fields, in, lines, why)) return -1;
  for (int i = 0; i < FIELDS; i++) {
    const char *name = NAMES[order[i]];
    int shown = fields[i].length < 60 ? (int)fields[i].length : 60;
    const char *wrong = text_number(&values[order[i]], fields[i].text, fields[i].length);
    if (wrong == NULL) continue;
    return file_fault(why, in->csv, lines->number, 0, "the %s \"%.*s\" %s; write a number", name, shown, fields[i].text,
                      wrong);
  }
  input_origin origin = {INPUT_FROM_CSV, lines->number, 0};
  bool metres = order[0] == X || order[0] == Y || order[1] == X || order[1] == Y;
  const input_position position = {metres, values[metres ? X : COLUMN], values[metres ? Y : ROW]};
  const input_site site = {position, values[WEIGHT], ""};
  return sites_add_place(in, &site, origin, why);
}

int csv_read(input *in, const file_bytes *bytes, fault *why) {
  text_lines lines;
  int order[FIELDS];
  bool header = false;
  const char *foreign = foreign_what(bytes);
  if (foreign != NULL && strncmp(foreign, "a CSV", 5) != 0) return file_fault(why, in->csv, 0, 0, "is %s", foreign);
  text_start(&lines, bytes);
  while (text_next(&lines)) {
    if (text_blank(lines.line, lines.length) || lines.line[0] == '#') continue;
    if (header ? read_place(in, order, &lines, why) : read_header(order, in, &lines, why)) return -1;
    header = true;
  }
  if (header) return 0;
  return file_fault(why, in->csv, 0, 0, "holds no header; start it with \"x,y,weight\"");
}
