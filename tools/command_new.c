#define _XOPEN_SOURCE 700 /* realpath() */

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "commands.h"
#include "draw_file.h"
#include "host/base/count.h"
#include "host/base/file.h"
#include "host/base/json.h"
#include "host/base/memory.h"
#include "host/base/outfile.h"
#include "host/base/stop.h"
#include "host/input/frame.h"
#include "host/input/mapfile.h"
#include "mission_text.h"
#include "options.h"
#include "print.h"
#include "products.h"
#include "propose.h"

static const char intro[] =
    "quarter new map.yaml                               a mission.yaml for a ROS map, a mission.svg beside it\n"
    "quarter new floor.png --resolution 0.05            for a bare image, 0.05 m a pixel: floor.yaml becomes its map\n"
    "quarter new arena.map -o patrol.yaml --robots 3    for a Moving AI map or a drawing, under another name\n"
    "quarter new --open 120x80 -o field.yaml            for open ground, 120 m by 80 m: field.txt is its map\n"
    "\n"
    "The mission has every key, those that may be left out as comments with unit and default. Robots and places are "
    "proposed\n"
    "on free ground, so that it learns as it stands: put your own in their place. The picture shows the map with a "
    "grid "
    "in\n"
    "its own frame, in metres, or in columns and rows.\n"
    "\n";

static const option_line lines[] = {
    {"output", "the mission (default mission.yaml); '-' is standard output, without a picture", 0},
    OPTION_LINE("picture"),
    OPTION_LINE("open"),
    OPTION_LINE("resolution"),
    {"cell-size", "metres a cell (default: the map's resolution, or whichever leaves a map that is soon planned)", 0},
    {"robots", "K robots (default 2), where the map does not mark more", 0},
    OPTION_LINE("force"),
    {"json", "what was written, in figures", 0},
    {"quiet", "say nothing", 0},
    {NULL, NULL, 0},
};

static const char outro[] =
    "\n"
    "Nothing that is there is written over without --force, and a map never.\n"
    "Exit status: 0 done; 2 bad input, nothing written; " STATUS_OF_SIGNAL("nothing half-written");

static const option_set set = {"new", intro, outro, option_records, lines};

enum { ROBOTS = 2, PLACES = 5 };

typedef struct {
  input in;
  mapfile map;
  mission_text text;
  char picture[OUTFILE_PATH_SIZE]; /* empty: none */
  char named[INPUT_PATH_SIZE];     /* the map, as seen from the mission */
  enum draw_form form;
  const options *o;
} mission_begun;

/* ---- names ---- */

static bool is_stdout(const char *path) {
  return strcmp(path, "-") == 0;
}

static size_t folder_of(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash != NULL ? (size_t)(slash - path) + 1 : 0;
}

/* The path with another ending, into out[size]. */
static int with_ending(char *out, size_t size, const char *path, const char *ending, fault *why) {
  const char *name = path + folder_of(path), *dot = strrchr(name, '.');
  const size_t stem = dot != NULL && dot != name ? (size_t)(dot - path) : strlen(path);
  const int length = snprintf(out, size, "%.*s%s", (int)stem, path, ending);
  return length >= 0 && (size_t)length < size ? 0 : fault_set(why, "%s: the name is too long for a file", path);
}

/* The map as seen from the mission's folder: beside it, below where the mission is, or by its whole path. */
static int name_map(mission_begun *m, fault *why) {
  const char *mission = is_stdout(m->o->output) ? "" : m->o->output, *map = m->in.map;
  while (strncmp(mission, "./", 2) == 0) mission += 2;
  while (strncmp(map, "./", 2) == 0) map += 2;
  const size_t folder = folder_of(mission);
  if (map[0] == '/' || strncmp(map, mission, folder) == 0) {
    strcpy(m->named, map[0] == '/' ? map : map + folder);
    return 0;
  }
  char whole[INPUT_PATH_SIZE], *of_folder = realpath(".", NULL);
  const int length = snprintf(whole, sizeof whole, "%s/%s", of_folder != NULL ? of_folder : ".", map);
  free(of_folder);
  if (length < 0 || (size_t)length >= sizeof whole) return fault_set(why, "%s: the name is too long for a file", map);
  strcpy(m->named, whole);
  return 0;
}

/* ---- what is there already ---- */

static int check_new(const char *path, const char *option, bool force, fault *why) {
  if (force || path[0] == '\0' || is_stdout(path) || access(path, F_OK) != 0) return 0;
  return fault_set(why, "%s: is there already; --force writes over it, %s FILE elsewhere", path, option);
}

/* A map is a map: it may be another's, and what was made before is as good. */
static int check_map(const mission_begun *m, fault *why) {
  file_bytes there;
  if (m->map.made == NULL) return 0;
  if (outfile_is_same(m->in.map, m->o->output))
    return fault_set(why, "-o %s: is where the map goes; name the mission otherwise", m->o->output);
  if (access(m->in.map, F_OK) != 0) return outfile_try(m->in.map, why);
  if (file_read(&there, m->in.map, FILE_MAP_LIMIT, NULL, why) != 0) return -1;
  const bool same = there.size == m->map.length && memcmp(there.data, m->map.made, there.size) == 0;
  file_free(&there);
  return same ? 0
              : fault_set(why, "%s: is there already, and says otherwise; name it as the map, or remove it", m->in.map);
}

static int check_outputs(const mission_begun *m, fault *why) {
  options o = *m->o;
  o.picture = m->picture[0] != '\0' ? m->picture : NULL;
  if (products_check(&o, why) != 0 || check_map(m, why) != 0) return -1;
  if (check_new(m->o->output, "-o", m->o->force, why) != 0) return -1;
  return check_new(m->picture, "--picture", m->o->force, why);
}

/* ---- reading ---- */

static bool is_side(double metres) {
  return metres > 0.0 && metres <= 1e6;
}

static int read_open(mission_begun *m, fault *why) {
  double width, height;
  int taken = 0;
  char path[INPUT_PATH_SIZE];
  const char *value = m->o->open;
  if (m->o->input != NULL) return fault_set(why, "new: --open takes no map, and '%s' is one", m->o->input);
  if (m->o->resolution > 0.0) return fault_set(why, "new: --resolution is for images; --cell-size goes with --open");
  const int fields = sscanf(value, "%lfx%lf%n", &width, &height, &taken);
  if (fields != 2 || value[taken] != '\0' || !is_side(width) || !is_side(height))
    return fault_set(why, "--open %s: say metres as WIDTHxHEIGHT, as 120x80, each above 0 and up to 1e6", value);
  const char *beside = is_stdout(m->o->output) ? "mission.yaml" : m->o->output;
  if (with_ending(path, sizeof path, beside, ".txt", why) != 0) return -1;
  return mapfile_open(&m->in, &m->map, path, width, height, why);
}

static int read_map(mission_begun *m, fault *why) {
  mapfile_begin(&m->in, m->o->plan.reading.cell_size);
  if (m->o->open != NULL) return read_open(m, why);
  if (m->o->input == NULL) return fault_set(why, "new: name a map; 'quarter new --help' shows how");
  return mapfile_read(&m->in, &m->map, m->o->input, m->o->resolution, why);
}

static int check_robots(const mission_begun *m, fault *why) {
  const int asked = m->o->plan.reading.robots, marked = m->in.mission.seekers;
  if (asked == 0 || marked <= 1 || marked == asked) return 0;
  return fault_set(why, "--robots %d: %s marks %d starts; leave the option out", asked, m->in.map, marked);
}

/* A drawing's one start is one robot's, where nothing is said. */
static int propose(mission_begun *m, fault *why) {
  const int asked = m->o->plan.reading.robots;
  m->text.own_robots = m->in.mission.seekers > 0;
  m->text.own_places = m->in.mission.places > 0;
  const int robots = asked > 0 ? asked : m->text.own_robots ? 1 : ROBOTS;
  return propose_sites(&m->in, robots, PLACES, why);
}

static int begin(mission_begun *m, fault *why) {
  if (read_map(m, why) != 0 || check_robots(m, why) != 0 || propose(m, why) != 0 || name_map(m, why) != 0) return -1;
  m->text.in = &m->in;
  m->text.map = m->named;
  m->text.ros = m->map.kind == KIND_YAML;
  m->text.name = is_stdout(m->o->output) ? "mission.yaml" : m->o->output + folder_of(m->o->output);
  return 0;
}

/* ---- writing ---- */

static int write_map(const mission_begun *m, fault *why) {
  outfile out;
  if (m->map.made == NULL || access(m->in.map, F_OK) == 0) return 0;
  if (outfile_open(&out, m->in.map, why) != 0) return -1;
  fwrite(m->map.made, 1, m->map.length, out.file);
  return outfile_commit(&out, why);
}

static int write_mission(const mission_begun *m, fault *why) {
  outfile out;
  if (outfile_open(&out, m->o->output, why) != 0) return -1;
  mission_text_write(out.file, &m->text);
  return outfile_commit(&out, why);
}

static int write_picture(const mission_begun *m, fault *why) {
  static drawing_seeker seekers[QTR_MAX_SEEKERS];
  drawing d = {.title = m->text.map, .grid = true};
  if (m->picture[0] == '\0') return 0;
  draw_of_input(&d, &m->in, seekers);
  d.number = NULL;
  return draw_file_write(&d, m->in.map, m->picture, m->form, why);
}

/* ---- the report ---- */

static void write_json(FILE *out, const void *what) {
  const mission_begun *m = what;
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "new");
  json_string(&j, "mission", m->o->output);
  if (m->picture[0] != '\0') json_string(&j, "picture", m->picture);
  json_string(&j, "map", m->in.map);
  json_bool(&j, "map_made", m->map.made != NULL);
  json_integer(&j, "columns", m->in.mission.columns);
  json_integer(&j, "rows", m->in.mission.rows);
  if (m->in.frame.metric) json_number(&j, "cell_size", m->in.frame.cell_size);
  json_integer(&j, "robots", m->in.mission.seekers);
  json_integer(&j, "places", m->in.mission.places);
  notes_json(&m->in.note, &j);
  json_end_object(&j);
}

static void write_text(FILE *out, const void *what) {
  const mission_begun *m = what;
  const qtr_mission *mission = &m->in.mission;
  fprintf(out, "%s: %u x %u cells", m->in.map, (unsigned)mission->columns, (unsigned)mission->rows);
  if (m->in.frame.metric) fprintf(out, " of %.6g m", m->in.frame.cell_size);
  fprintf(out, "; %s %s, %s %s\n", counted(mission->seekers, "robot").text, m->text.own_robots ? "marked" : "proposed",
          counted(mission->places, "place").text, m->text.own_places ? "marked" : "proposed");
  if (m->map.made != NULL) fprintf(out, "wrote %s\n", m->in.map);
  fprintf(out, "wrote %s\n", m->o->output);
  if (m->picture[0] != '\0') fprintf(out, "wrote %s\n", m->picture);
}

static int name_picture(mission_begun *m, fault *why) {
  m->form = DRAW_SVG;
  if (m->o->picture == NULL)
    return is_stdout(m->o->output) ? 0 : with_ending(m->picture, sizeof m->picture, m->o->output, ".svg", why);
  if (strlen(m->o->picture) >= sizeof m->picture) return fault_set(why, "--picture: the name is too long for a file");
  strcpy(m->picture, m->o->picture);
  return draw_file_form(&m->form, "--picture", m->picture, NULL, why);
}

static int make(mission_begun *m, fault *why) {
  if (name_picture(m, why) != 0 || begin(m, why) != 0) return -1;
  int status = check_outputs(m, why);
  /* The picture first: what it needs may be missing. */
  if (status == 0) status = write_picture(m, why);
  if (status == 0) status = write_map(m, why);
  if (status == 0) status = write_mission(m, why);
  if (status == 0) status = print_report(m->o, write_json, write_text, m, why);
  free(m->map.made);
  return status;
}

int command_new(int argc, char **argv) {
  static options o;
  fault why;
  if (options_parse_any(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  mission_begun *m = memory_take(sizeof *m, &why);
  if (m == NULL) return fault_exit(&why);
  if (o.output == NULL) o.output = "mission.yaml";
  m->o = &o;
  return make(m, &why) == 0 ? EXIT_SUCCESS : fault_exit(&why);
}
