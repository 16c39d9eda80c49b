#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "commands.h"
#include "export_parts.h"
#include "figures.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/outfile.h"
#include "host/base/stop.h"
#include "print.h"
#include "products.h"

static const char intro[] =
    "quarter export mission.qtr -o ways.csv             all robots' ways: waypoints in cells and metres, with times\n"
    "quarter export mission.qtr --format nav2 --places -o way-%.yaml\n"
    "                                                   a file a robot, way-0.yaml ...: poses for Nav2's waypoint "
    "follower\n"
    "quarter export mission.qtr --altitude 20 -o way-%.plan\n"
    "                                                   the same for QGroundControl, flown at 20 m, with stops to "
    "scan\n"
    "quarter export mission.qtr --format moos --robot 1 -o way.bhv\n"
    "                                                   points of a MOOS-IvP waypoint behaviour, of one robot\n"
    "\n"
    "A way begins at the start; its waypoints are the places that the robot visits, in order, and the corners between "
    "them,\n"
    "so that from one to the next it goes straight over ground that is free. Times are the plan's; at a place, that at "
    "which\n"
    "its scan ends.\n"
    "\n";

static const option_line lines[] = {
    {"output", "the file; a % in its name stands for a robot's name or number, and makes a file for each", 0},
    {"format",
     "csv, geojson, gpx, qgc-plan, qgc-wpl, nav2 or moos; else as FILE ends: .csv, .geojson, .gpx, .plan,\n"
     ".waypoints, .yaml",
     0},
    OPTION_LINE("robot"),
    OPTION_LINE("places"),
    OPTION_LINE("altitude"),
    OPTION_LINE("hold"),
    {"json", "what was written, in figures", 0},
    {"quiet", "say nothing", 0},
    {NULL, NULL, 0},
};

static const char outro[] =
    "\n"
    "geojson, gpx, qgc-plan and qgc-wpl are in degrees (WGS84) and need the mission's 'geo'; nav2 and moos are in "
    "metres and\n"
    "need its 'cell_size'. moos counts x to the east and y to the north, where there is a 'geo'. A file of qgc-plan, "
    "qgc-wpl,\n"
    "nav2 and moos holds one robot's way. gpx counts time from 1970-01-01T00:00:00Z, where the table knows seconds.\n"
    "\n"
    "Exit status: 0 done; 2 bad input, nothing written; " STATUS_OF_SIGNAL("nothing half-written");

static const option_set set = {"export", intro, outro, option_records, lines};

typedef struct {
  const options *o;
  const export_format *format;
  int robot; /* -1: all */
  table t;
  export_plan plan;
  int files;
  char path[QTR_MAX_SEEKERS][OUTFILE_PATH_SIZE];
  outfile out[QTR_MAX_SEEKERS];
} work;

/* ---- the format ---- */

static int format_by_name(const export_format **format, const char *name, fault *why) {
  const char *names[16] = {NULL};
  int index;
  for (int i = 0; export_formats[i].name != NULL; i++) names[i] = export_formats[i].name;
  if (option_word(&index, "format", name, strlen(name), names, why) != 0) return -1;
  *format = &export_formats[index];
  return 0;
}

static int find_format(const export_format **format, const options *o, fault *why) {
  if (o->output == NULL) return fault_set(why, "export: say where to with -o FILE");
  if (o->format != NULL) return format_by_name(format, o->format, why);
  const char *dot = strrchr(o->output, '.');
  for (*format = export_formats; (*format)->name != NULL; (*format)++)
    if (dot != NULL && (*format)->ending != NULL && strcasecmp(dot, (*format)->ending) == 0) return 0;
  return fault_set(why, "-o %s: does not say which format; add one, as --format csv", o->output);
}

/* What the format needs of the mission, by the key that states it. */
static int check_unit(const work *w, fault *why) {
  const bool metric = qtr_policy_frame(&w->t.policy).cell_size_um > 0;
  if (w->format->unit == EXPORT_CELLS || (w->format->unit == EXPORT_METRES && metric)) return 0;
  if (w->format->unit == EXPORT_METRES || !metric)
    return fault_set(why,
                     "%s: %s takes metres, and the map has none: state 'cell_size' in the mission and learn it again",
                     w->o->input, w->format->name);
  if (w->t.geo.given) return 0;
  return fault_set(why,
                   "%s: %s takes degrees: state where the map lies in the mission, as 'geo: {latitude: 52.5163, "
                   "longitude: 13.3777}', and learn it again",
                   w->o->input, w->format->name);
}

/* ---- the files ---- */

/* Where a robot's name goes: the folders' names are left alone. NULL: all go into one file. */
static const char *find_mark(const char *path) {
  const char *slash = strrchr(path, '/');
  return strchr(slash != NULL ? slash : path, '%');
}

static int find_robot(work *w, fault *why) {
  char wrong[FAULT_LINE];
  const naming n = table_naming(&w->t);
  w->robot = -1;
  if (w->o->robot == NULL) return 0;
  w->robot = naming_find_seeker(&n, w->o->robot, wrong);
  return w->robot >= 0 ? 0 : fault_set(why, "--robot: %s", wrong);
}

static int check_files(const work *w, fault *why) {
  const options *o = w->o;
  const int seekers = w->t.policy.board.seekers;
  if (!w->format->one_robot || w->robot >= 0 || seekers == 1 || find_mark(o->output) != NULL) return 0;
  return fault_set(why,
                   "-o %s: a %s file holds one robot's way, and there are %d: put a %% where the robot's name goes, as "
                   "way-%%%s, or name one, as --robot 0",
                   o->output, w->format->name, seekers, w->format->ending != NULL ? w->format->ending : ".txt");
}

/* A robot's name, or its number, in a file's: it leads to no other folder. */
static naming_label part_of_name(const work *w, int robot) {
  const naming n = table_naming(&w->t);
  naming_label label = naming_seeker(&n, (unsigned)robot);
  for (char *c = label.text; *c != '\0'; c++)
    if (*c == '/') *c = '_';
  return label;
}

static int begin_file(work *w, int robot, fault *why) {
  const char *pattern = w->o->output, *mark = find_mark(pattern);
  const naming_label label = part_of_name(w, robot);
  char *path = w->path[w->files];
  const size_t size = sizeof w->path[0];
  const int before = (int)(mark != NULL ? mark - pattern : 0);
  const int length = mark == NULL ? snprintf(path, size, "%s", pattern)
                                  : snprintf(path, size, "%.*s%s%s", before, pattern, label.text, mark + 1);
  if (length < 0 || (size_t)length >= size) return fault_set(why, "-o: the name is too long; shorten it");
  for (int i = 0; i < w->files; i++)
    if (strcmp(w->path[i], path) == 0)
      return fault_set(why, "-o %s: two robots' ways would go there; export them one by one, with --robot", path);
  if (outfile_open(&w->out[w->files], path, why) != 0) return -1;
  w->files++;
  return 0;
}

/* All are begun and written before the first one takes its place. */
static int write_files(work *w, fault *why) {
  const bool apart = find_mark(w->o->output) != NULL;
  const int files = apart ? w->plan.ways : 1;
  int status = 0, finished = 0;
  for (int i = 0; i < files && status == 0; i++) {
    status = begin_file(w, w->plan.way[i].robot, why);
    if (status != 0) break;
    export_plan part = w->plan;
    if (apart) {
      part.ways = 1;
      part.way[0] = w->plan.way[i];
    }
    w->format->write(w->out[i].file, &part);
  }
  while (status == 0 && finished < w->files) status = outfile_commit(&w->out[finished++], why);
  while (status != 0 && finished < w->files) outfile_abort(&w->out[finished++]);
  return status;
}

/* ---- what was done ---- */

static const export_point *last_of(const export_way *w) {
  return &w->point[w->count - 1];
}

static void write_json(FILE *out, const void *what) {
  const work *w = what;
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "export");
  json_string(&j, "input", w->o->input);
  json_string(&j, "format", w->format->name);
  json_array(&j, "ways");
  for (int i = 0; i < w->plan.ways; i++) {
    const export_way *way = &w->plan.way[i];
    json_flat_object(&j, NULL);
    json_integer(&j, "robot", way->robot);
    json_string(&j, "file", w->path[w->files > 1 ? i : 0]);
    json_natural(&j, "waypoints", way->count);
    json_integer(&j, "places", way->places);
    json_natural(&j, "steps", last_of(way)->step);
    figures_json_seconds(&j, "seconds", last_of(way)->step, table_step_seconds(&w->t));
    json_end_object(&j);
  }
  json_end_array(&j);
  json_end_object(&j);
}

static int count_late(const export_way *way) {
  int count = 0;
  for (size_t i = 0; i < way->count; i++) count += way->point[i].place != WAY_NO_PLACE && way->point[i].late;
  return count;
}

static void write_text(FILE *out, const void *what) {
  const work *w = what;
  for (int i = 0; i < w->plan.ways; i++) {
    const export_way *way = &w->plan.way[i];
    fprintf(out, "  %s: %s, %s, %s", table_robot_name(&w->t, way->robot).text, counted(way->count, "waypoint").text,
            counted((uint64_t)way->places, "place").text, counted(last_of(way)->step, "step").text);
    if (table_step_seconds(&w->t) > 0.0) fprintf(out, ", %.6g s", last_of(way)->seconds);
    if (count_late(way) > 0) fprintf(out, "; %s after the deadline", counted((uint64_t)count_late(way), "place").text);
    fputc('\n', out);
  }
  for (int i = 0; i < w->files; i++) fprintf(out, "wrote %s\n", w->path[i]);
}

/* ---- the command ---- */

/* The table is open. */
static int export(work *w, fault *why) {
  const options *o = w->o;
  if (products_check(o, why) != 0 || check_unit(w, why) != 0) return -1;
  if (find_robot(w, why) != 0 || check_files(w, why) != 0) return -1;
  w->plan = (export_plan){.source = o->input, .altitude = o->altitude, .hold = o->hold};
  if (export_plan_make(&w->plan, &w->t, w->robot, o->places, why) != 0) return -1;
  int status = w->format->unit == EXPORT_DEGREES ? export_plan_locate(&w->plan, why) : 0;
  if (status == 0) status = write_files(w, why);
  if (status == 0) status = print_report(o, write_json, write_text, w, why);
  export_plan_free(&w->plan);
  return status;
}

int command_export(int argc, char **argv) {
  static options o;
  static work w = {.o = &o};
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  if (find_format(&w.format, &o, &why) != 0 || table_read(&w.t, o.input, &why) != 0) return fault_exit(&why);
  const int status = export(&w, &why);
  table_free(&w.t);
  return status == 0 ? EXIT_SUCCESS : fault_exit(&why);
}
