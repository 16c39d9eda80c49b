#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/memory.h"
#include "host/base/stop.h"
#include "host/plan/problem.h"
#include "options.h"
#include "print.h"
#include "products.h"

static const char intro[] =
    "quarter check mission.yaml                          every fault and note of a mission at once, without learning\n"
    "quarter check mission.yaml --json                   the same for editors and scripts\n"
    "\n"
    "The mission, its map and its files are read as for 'quarter learn', which ends at the first fault; this goes on: "
    "key by\n"
    "key, place by place, line by line. What hangs on something faulty is left for the next time.\n"
    "\n";

static const option_line lines[] = {
    OPTION_LINES_OF_PROBLEM,
    OPTION_LINES_OF_ANSWER,
};

static const char outro[] =
    "\n"
    "Exit status: 0 no faults, though there may be notes; 2 faults; " STATUS_OF_SIGNAL("nothing half-written");

static const option_set set = {"check", intro, outro, option_records, lines};

/* What was found. */
typedef struct {
  const options *o;
  const problem *p;
  fault all;
} finding;

static const char *next_line(const char *line) {
  const char *end = strchr(line, '\n');
  return end != NULL ? end + 1 : line + strlen(line);
}

/* A line that sums up those below it is no fault of its own. */
static int count_faults(const char *text) {
  int count = 0;
  for (const char *line = text; *line != '\0'; line = next_line(line)) {
    const char *below = strstr(line, ", see below;");
    count += below == NULL || below >= next_line(line);
  }
  return count;
}

/* The number behind the last colon of where[0..*length), which is cut off; 0: there is none. */
static long cut_number(const char *where, size_t *length) {
  size_t digits = 0;
  while (digits < *length && where[*length - digits - 1] >= '0' && where[*length - digits - 1] <= '9') digits++;
  if (digits == 0 || digits > 9 || digits >= *length || where[*length - digits - 1] != ':') return 0;
  *length -= digits + 1;
  return strtol(where + *length + 1, NULL, 10);
}

/* "file:line:column: text" in its parts. */
static void write_fault(json *j, const char *line, size_t length) {
  char text[FAULT_LINE + 1], file[FAULT_LINE + 1];
  snprintf(text, sizeof text, "%.*s", (int)(length < FAULT_LINE ? length : FAULT_LINE), line);
  const char *colon = strstr(text, ": ");
  size_t end = colon != NULL ? (size_t)(colon - text) : 0;
  const long last = cut_number(text, &end), before = last > 0 ? cut_number(text, &end) : 0;
  snprintf(file, sizeof file, "%.*s", (int)end, text);
  json_flat_object(j, NULL);
  if (end > 0) json_string(j, "file", file);
  if (last > 0) json_integer(j, "line", before > 0 ? before : last);
  if (before > 0) json_integer(j, "column", last);
  json_string(j, "text", colon != NULL ? colon + 2 : text);
  json_end_object(j);
}

static void write_json(FILE *out, const void *what) {
  const finding *f = what;
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "check");
  json_string(&j, "input", f->o->input);
  json_bool(&j, "sound", f->all.text[0] == '\0');
  json_array(&j, "faults");
  for (const char *line = f->all.text; *line != '\0'; line = next_line(line))
    write_fault(&j, line, strcspn(line, "\n"));
  json_end_array(&j);
  notes_json(&f->p->in.note, &j);
  json_end_object(&j);
}

static void write_text(FILE *out, const void *what) {
  const finding *f = what;
  const qtr_mission *mission = &f->p->in.mission;
  const int faults = count_faults(f->all.text);
  if (faults > 0)
    fprintf(out, "%s: %s\n", f->o->input, counted((uint64_t)faults, "fault").text);
  else
    fprintf(out, "%s: no faults: %s, %s, %s\n", f->o->input, counted(problem_free_cells(f->p), "free cell").text,
            counted(mission->places, "place").text, counted(mission->seekers, "robot").text);
}

/* All faults of the files; and, where they have none, of the game that they make. */
static void look(problem *p, const options *o, fault *all) {
  plan_config config = o->plan;
  fault why;
  config.reading.all = all;
  why.text[0] = '\0';
  if (problem_load(p, o->input, &config, &why) == 0 && problem_measure(p, &config, &why) == 0) return;
  fault_keep(all, &why);
}

int command_check(int argc, char **argv) {
  static options o;
  static finding f = {.o = &o};
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  problem *p = memory_take(sizeof *p, &why);
  if (p == NULL) return fault_exit(&why);
  f.p = p;
  f.all.status = EXIT_SUCCESS;
  look(p, &o, &f.all);
  if (products_check(&o, &why) != 0 || print_report(&o, write_json, write_text, &f, &why) != 0) return fault_exit(&why);
  if (f.all.text[0] == '\0') return EXIT_SUCCESS;
  if (!o.json) fault_exit(&f.all);
  return EXIT_BAD_INPUT;
}
