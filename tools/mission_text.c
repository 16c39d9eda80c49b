#include "mission_text.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "host/input/frame.h"
#include "host/input/mapfile.h"
#include "host/input/mission_keys.h"
#include "host/input/reference.h"

enum { WIDTH = 110, TEXT_SIZE = 2048, ITEM_INDENT = 4 };

/* ---- comments ---- */

/* A paragraph behind "# ", its first line `indent` blanks left of the others. */
static void wrap(FILE *out, const char *text, int indent) {
  int column = fprintf(out, "#");
  for (const char *word = text; *word != '\0';) {
    const int length = (int)strcspn(word, " ");
    if (column > 1 + indent && column + 1 + length > WIDTH) column = fprintf(out, "\n#%*s", indent, "") - 1;
    column += fprintf(out, " %.*s", length, word);
    word += length;
    word += strspn(word, " ");
  }
  fputc('\n', out);
}

static void __attribute__((format(printf, 3, 4))) comment(FILE *out, int indent, const char *format, ...) {
  char text[TEXT_SIZE];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  wrap(out, text, indent);
}

/* ---- keys ---- */

/* "a number above 0, in m; default: the map's resolution" */
static void describe(char text[TEXT_SIZE], const key_record *r) {
  char *values = NULL;
  size_t length;
  FILE *out = open_memstream(&values, &length);
  text[0] = '\0';
  if (out == NULL) return;
  reference_write_values(out, r);
  if (r->unit != NULL) fprintf(out, ", in %s", r->unit);
  if (r->where != NULL) fprintf(out, "; %s only", r->where);
  if (r->standard != NULL) fprintf(out, "; default: %s", r->standard);
  if (fclose(out) == 0) snprintf(text, TEXT_SIZE, "%s", values);
  free(values);
}

static bool is_position(const key_set *set, const char *name) {
  for (const key_group *g = set->either; g != NULL && g->what != NULL; g++)
    for (int i = 0; i < KEYS_GROUP; i++)
      if (strcmp(g->names[i], name) == 0) return true;
  return false;
}

/* What an item of a list, or a mapping of its own, may say. */
static void write_items(FILE *out, const key_set *set) {
  char values[TEXT_SIZE];
  for (const key_record *r = set->records; r->name != NULL; r++) {
    if (is_position(set, r->name)) continue;
    describe(values, r);
    comment(out, ITEM_INDENT, "  %s: %s (%s)", r->name, r->help, values);
  }
}

static void write_sites(FILE *out, const mission_text *text, const key_record *r);

/* The keys that a mission begins with; all others are comments. */
static bool write_stated(FILE *out, const mission_text *text, const key_record *r) {
  const input *in = text->in;
  if (strcmp(r->name, "map") == 0) {
    fputs("map: ", out);
    mapfile_write_name(out, text->map);
    fputc('\n', out);
    return true;
  }
  if (strcmp(r->name, "cell_size") == 0 && in->ground.cell_size > 0.0) {
    fprintf(out, "cell_size: %.9g\n", in->ground.cell_size);
    return true;
  }
  if (strcmp(r->name, "robots") != 0 && strcmp(r->name, "places") != 0) return false;
  write_sites(out, text, r);
  return true;
}

static bool is_of_use(const mission_text *text, const key_record *r) {
  return text->ros || r->where == NULL || strncmp(r->where, MISSION_ROS_MAPS, strlen(MISSION_ROS_MAPS)) != 0;
}

static void write_key(FILE *out, const mission_text *text, const key_record *r) {
  char values[TEXT_SIZE];
  describe(values, r);
  fputc('\n', out);
  comment(out, 0, "%c%s (%s)", toupper((unsigned char)r->help[0]), r->help + 1, values);
  if (r->items != NULL) write_items(out, r->items);
  if (!write_stated(out, text, r)) fprintf(out, "#%s: %s\n", r->name, r->example);
}

/* ---- robots and places ---- */

/* The fewest decimals that still are in the cell. */
static void write_position(FILE *out, const input *in, qtr_cell cell) {
  const input_position centre = frame_centre(in, cell, in->frame.metric && in->frame.yaw == 0.0);
  if (!centre.metres) {
    fprintf(out, "column: %.0f, row: %.0f", centre.x, centre.y);
    return;
  }
  char x[32], y[32];
  for (int decimals = 0; decimals <= 9; decimals++) {
    snprintf(x, sizeof x, "%.*f", decimals, centre.x);
    snprintf(y, sizeof y, "%.*f", decimals, centre.y);
    if (frame_cell(in, (input_position){true, strtod(x, NULL), strtod(y, NULL)}) == cell) break;
  }
  fprintf(out, "x: %s, y: %s", x, y);
}

static void write_name(FILE *out, const char *name) {
  if (name[0] != '\0') fprintf(out, ", name: %s", name);
}

static void write_sites(FILE *out, const mission_text *text, const key_record *r) {
  const input *in = text->in;
  const bool robots = strcmp(r->name, "robots") == 0;
  if (robots ? text->own_robots : text->own_places)
    comment(out, 0, "These are those that the map marks.");
  else
    comment(out, 0, "These are proposed, on free ground: put yours here.");
  fprintf(out, "%s:\n", r->name);
  for (int i = 0; robots && i < in->mission.seekers; i++) {
    fputs("  - {", out);
    write_position(out, in, in->mission.start[i]);
    write_name(out, in->names.seeker[i]);
    fputs("}\n", out);
  }
  for (int i = 0; !robots && i < in->mission.places; i++) {
    fputs("  - {", out);
    write_position(out, in, in->mission.place[i]);
    fprintf(out, ", weight: %.9g", in->mission.weight[i]);
    write_name(out, in->names.place[i]);
    fputs("}\n", out);
  }
}

/* ---- the whole ---- */

static void write_head(FILE *out, const mission_text *text) {
  char span[256];
  const input *in = text->in;
  frame_span(span, sizeof span, in, in->frame.metric);
  comment(out, 0, "A mission on %s, %s.", text->map, span);
  fprintf(out,
          "#\n"
          "#   quarter check %s                       every fault at once\n"
          "#   quarter draw %s --grid -o map.svg      the map, with lines to read positions from\n"
          "#   quarter learn %s -o plan.qtr           who searches what when, with its certificate\n"
          "#\n",
          text->name, text->name, text->name);
  comment(out, 0,
          "Below is every key that a mission may have. One behind a # may be left out: take the # away and put your "
          "value in "
          "the place of the example.");
}

void mission_text_write(FILE *out, const mission_text *text) {
  write_head(out, text);
  for (const key_record *r = mission_keys.records; r->name != NULL; r++)
    if (is_of_use(text, r)) write_key(out, text, r);
}
