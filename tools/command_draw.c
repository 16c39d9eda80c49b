#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "draw_file.h"
#include "figures.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/memory.h"
#include "host/base/stop.h"
#include "host/plan/problem.h"
#include "host/plan/terms.h"
#include "host/table/certificate.h"
#include "host/table/table.h"
#include "host/table/way.h"
#include "prepare.h"
#include "print.h"
#include "products.h"
#include "quarter/regions.h"
#include "quarter/spots.h"
#include "quarter/status.h"

static const char intro[] =
    "quarter draw mission.qtr -o mission.svg            the map, the places, each seeker's territory and route\n"
    "quarter draw mission.qtr -o mission.png            the same as PNG; or .pdf\n"
    "quarter draw mission.yaml -o map.svg               the map, places and starts alone, before learning\n"
    "quarter draw map.txt --regions -o regions.svg      the regions that the map divides into\n"
    "quarter draw map.txt --spots -o spots.svg          the hiding spots that its places form\n"
    "\n"
    "Places are sized by likelihood and bear their numbers; beside them stands which of its seeker's visits each is "
    "(1st,\n"
    "2nd, ...), where there is room, and a browser shows it on pointing at the place. '-o -' is standard output.\n"
    "\n";

static const option_line lines[] = {
    {"output", "the picture (required)", 0},
    {"format", "svg, png or pdf; else as FILE ends, or svg", 0},
    {"robots, cell-size, skip-unreachable, snap,\nclear, without, add", "as in 'quarter learn', for inputs", 71},
    OPTION_LINE("dark"),
    OPTION_LINE("grid"),
    OPTION_LINE("regions"),
    {"region-size region-diameter", "cells of a region, and steps between any two (default %s, %s)", 46},
    {"region-likelihood", "as in 'quarter learn'", 46},
    OPTION_LINE("spots"),
    {"spot-size spot-diameter spot-likelihood", "as in 'quarter learn'", 62},
    {"json", "what was drawn, in figures", 0},
    {"quiet", "say nothing", 0},
    {NULL, NULL, 0},
};

static const char outro[] =
    "\n"
    "Exit status: 0 done; 2 bad input, nothing written; " STATUS_OF_SIGNAL("nothing half-written");

static const option_set set = {"draw", intro, outro, option_records, lines};

#define LINES_MOST 12
#define LINE_SIZE 96

/* All that a drawing points to. */
typedef struct {
  drawing d;
  uint8_t *cost;
  uint16_t *region;
  qtr_cell place[QTR_MAX_PLACES];
  double likelihood[QTR_MAX_PLACES];
  drawing_seeker seeker[QTR_MAX_SEEKERS];
  table_route route[QTR_MAX_SEEKERS];
  uint16_t number[QTR_MAX_PLACES]; /* of a table's places, in the input */
  qtr_names names;                 /* that a table holds */
  qtr_cell *trail[QTR_MAX_SEEKERS];
  char text[LINES_MOST][LINE_SIZE];
  const char *line[LINES_MOST];
  uint32_t free_cells;  /* where regions are drawn */
  double mean_distance; /* steps of a free cell from its region's representative */
} sheet;

/* What drawing needs beside the sheet. */
typedef struct {
  problem drawn;
  qtr_regions divided;
  memory_block dividing;
  qtr_spots grouped, grouping;
} work;

static sheet picture;
static work *desk;

static void __attribute__((format(printf, 2, 3))) add_line(sheet *s, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(s->text[s->d.lines], LINE_SIZE, format, arguments);
  va_end(arguments);
  s->line[s->d.lines] = s->text[s->d.lines];
  s->d.lines++;
}

static void set_arrays(sheet *s) {
  s->d.place = s->place;
  s->d.likelihood = s->likelihood;
  s->d.seeker = s->seeker;
  s->d.line = s->line;
}

static void free_sheet(sheet *s) {
  free(s->cost);
  free(s->region);
  for (int i = 0; i < QTR_MAX_SEEKERS; i++) free(s->trail[i]);
}

/* ---- an input ---- */

static int from_input(sheet *s, const options *o, fault *why) {
  const qtr_mission *mission = &desk->drawn.in.mission;
  if (prepare_problem(&desk->drawn, o, why) != 0) return -1;
  draw_of_input(&s->d, &desk->drawn.in, s->seeker);
  s->d.step_seconds = desk->drawn.pace.stated ? desk->drawn.pace.seconds_per_step : 0.0;
  add_line(s, "places\t%d", mission->places);
  add_line(s, "free cells\t%" PRIu32, problem_free_cells(&desk->drawn));
  return 0;
}

/* ---- a table ---- */

/* A picture shows the map that the table was learnt on, of which it holds a part. */
static qtr_cell on_map(const table *t, qtr_cell cell) {
  return (qtr_cell)(table_row(t, cell) * t->claim.map_columns + table_column(t, cell));
}

/* The cells that a seeker walks, its route's last place the last. */
static int walk(sheet *s, const table *t, int seeker, fault *why) {
  way walked;
  if (way_walk(&walked, t, seeker, &s->route[seeker], why) != 0) return -1;
  s->trail[seeker] = malloc(walked.count * sizeof(qtr_cell));
  size_t cells = 0;
  for (size_t i = 0; s->trail[seeker] != NULL && i < walked.count; i++)
    if (i == 0 || walked.at[i].cell != walked.at[i - 1].cell) s->trail[seeker][cells++] = on_map(t, walked.at[i].cell);
  s->seeker[seeker].trail = s->trail[seeker];
  s->seeker[seeker].trail_length = cells;
  way_free(&walked);
  return s->trail[seeker] != NULL ? 0 : fault_set(why, "no memory for seeker %d's route", seeker);
}

static int add_seeker(sheet *s, const table *t, int seeker, fault *why) {
  const qtr_board *board = &t->policy.board;
  s->seeker[seeker] = (drawing_seeker){
      .start = on_map(t, qtr_policy_cell(&t->policy, (unsigned)board->places + board->start_of[seeker])),
      .places = s->route[seeker].places,
      .place = s->route[seeker].place,
      .step = s->route[seeker].step};
  return walk(s, t, seeker, why);
}

static void add_found(sheet *s, const table_certificate *c, double step_seconds) {
  if (c->deadline > 0)
    add_line(s, "found by %s\t%.5g", figures_time(c->deadline, step_seconds).text, c->found);
  else if (c->found < 1.0 - 1e-9)
    add_line(s, "found at all\t%.5g", c->found);
}

static void add_certificate(sheet *s, const table *t) {
  const table_certificate c = table_certificate_of(&t->policy);
  const qtr_objective_words *words = qtr_objective_in_words(c.objective);
  if (c.certified && c.gap < 1e-9)
    add_line(s, "certified\toptimal");
  else
    add_line(s, "%s\tgap %s%.2g%%", c.certified ? "certified" : "not certified", c.gap < 1e-5 ? "below " : "",
             100.0 * fmax(c.gap, 1e-5));
  const double seconds = table_step_seconds(t);
  add_line(s, "expected time\t%s", figures_time(c.expected_time, seconds).text);
  add_found(s, &c, seconds);
  add_line(s, "discounted value\t%.5g", c.value);
  if (words->unit != NULL && seconds > 0.0)
    add_line(s, "%s\t%.5g s", words->limit, c.bound * seconds);
  else
    add_line(s, words->unit != NULL ? "%s\t%.5g %ss" : "%s\t%.5g", words->limit, c.bound, words->unit);
  if (seconds > 0.0) add_line(s, "a step\t%.6g s", seconds);
}

/* A later look is one at the same place: the picture shows it once, and what all looks find. */
static void gather_looks(sheet *s, const table *t) {
  const qtr_board *board = &t->policy.board;
  s->d.places = 0;
  for (unsigned place = 0; place < board->places; place++) {
    const unsigned of = qtr_policy_place(&t->policy, place);
    s->likelihood[place] = 0.0;
    s->likelihood[of] += table_probability(t, place);
    s->d.places += of == place;
  }
  for (int seeker = 0; seeker < board->seekers; seeker++)
    for (int i = 0; i < s->route[seeker].places; i++)
      s->route[seeker].place[i] = (uint16_t)qtr_policy_place(&t->policy, s->route[seeker].place[i]);
}

static int from_table(sheet *s, const table *t, fault *why) {
  const qtr_policy *policy = &t->policy;
  s->cost = calloc(t->claim.map_columns, t->claim.map_rows);
  if (s->cost == NULL) return fault_set(why, "no memory for the picture");
  s->d.cost = s->cost;
  for (uint32_t cell = 0; cell < qtr_grid_cells(&policy->grid); cell++)
    s->cost[on_map(t, (qtr_cell)cell)] = (uint8_t)qtr_grid_cost(&policy->grid, (qtr_cell)cell);
  s->d.columns = t->claim.map_columns;
  s->d.rows = t->claim.map_rows;
  const qtr_frame frame = qtr_policy_frame(policy);
  s->d.cell_size = frame.cell_size_um / 1e6;
  s->d.step_seconds = table_step_seconds(t);
  s->d.deadline = t->claim.deadline;
  s->d.turned = frame.sine != 0 || frame.cosine < 0;
  table_map_origin(t, &s->d.x, &s->d.y);
  s->d.reached_alone = true;
  for (unsigned place = 0; place < policy->board.places; place++)
    s->place[place] = on_map(t, qtr_policy_cell(policy, place));
  s->d.seekers = policy->board.seekers;
  for (unsigned place = 0; place < policy->board.places; place++) s->number[place] = t->number[place];
  s->d.number = s->number;
  s->names = t->names;
  s->d.names = &s->names;
  table_routes(t, s->route);
  gather_looks(s, t);
  add_certificate(s, t);
  for (int seeker = 0; seeker < s->d.seekers; seeker++)
    if (add_seeker(s, t, seeker, why) != 0) return -1;
  return 0;
}

/* ---- regions and spots ---- */

static void add_mean_distance(sheet *s) {
  add_line(s, "to representative\t%.3g step%s", s->mean_distance, s->mean_distance == 1.0 ? "" : "s");
  if (s->d.step_seconds > 0.0) add_line(s, "\t%.3g s", s->mean_distance * s->d.step_seconds);
}

static int add_regions(sheet *s, const options *o, fault *why) {
  qtr_regions_config config = o->plan.aggregate.regions;
  config.places = (uint16_t)s->d.places;
  config.place = s->d.place;
  config.weight = s->d.likelihood;
  const qtr_grid grid = {(uint16_t)s->d.columns, (uint16_t)s->d.rows, QTR_GRID_BYTES, s->d.cost};
  const size_t cells = drawing_cells(&s->d);
  memory_block *scratch = &desk->dividing;
  if (memory_need(scratch, qtr_regions_scratch_bytes((uint32_t)cells), why) != 0) return -1;
  const int status = qtr_regions_build(&desk->divided, &grid, &config, scratch->at, scratch->bytes);
  if (status != QTR_OK) return fault_set(why, "%s: its regions: %s", o->input, qtr_strerror(status));
  s->region = malloc(cells * sizeof *s->region);
  if (s->region == NULL || desk->divided.count > UINT16_MAX)
    return fault_set(why, "%s: too many regions for a picture: %" PRIu32 "; allow larger ones", o->input,
                     desk->divided.count);
  for (size_t cell = 0; cell < cells; cell++) s->region[cell] = (uint16_t)desk->divided.of[cell];
  s->d.region = s->region;
  s->d.regions = desk->divided.count;
  s->d.representative = desk->divided.representative;
  const uint16_t *error = qtr_regions_errors(scratch->at);
  for (size_t cell = 0; cell < cells; cell++) {
    if (desk->divided.of[cell] == QTR_NO_REGION) continue;
    s->free_cells++;
    s->mean_distance += error[cell];
  }
  if (s->free_cells > 0) s->mean_distance /= s->free_cells;
  add_line(s, "regions\t%" PRIu32, desk->divided.count);
  add_mean_distance(s);
  return 0;
}

static int add_spots(sheet *s, const options *o, fault *why) {
  const qtr_game *game = desk->drawn.game;
  const qtr_spot_ground ground = {game->board.places, game->steps, game->probability, &game->objective};
  if (game->board.places == 0)
    return fault_set(why, "%s: --spots goes with a mission or a drawing, not with a policy table", o->input);
  if (terms_leave_no_spots(game->mission))
    return fault_set(why, "%s: --spots: there are none with classes, looks, ready times, endurance or home_weight",
                     o->input);
  const int status = qtr_spots_build(&desk->grouped, &ground, &o->plan.aggregate.units.spots, &desk->grouping);
  if (status != QTR_OK) return fault_set(why, "%s: its spots: %s", o->input, qtr_strerror(status));
  s->d.spot = desk->grouped.spot_of;
  add_line(s, "spots\t%d", desk->grouped.count);
  return 0;
}

/* ---- the command ---- */

static void write_json(FILE *out, const void *what) {
  const sheet *s = what;
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "draw");
  json_string(&j, "title", s->d.title);
  json_integer(&j, "columns", s->d.columns);
  json_integer(&j, "rows", s->d.rows);
  json_integer(&j, "places", s->d.places);
  json_integer(&j, "robots", s->d.seekers);
  if (s->d.spot != NULL) json_integer(&j, "spots", desk->grouped.count);
  if (s->d.regions > 0) {
    json_natural(&j, "cells", s->free_cells);
    json_natural(&j, "regions", s->d.regions);
    json_number(&j, "mean_distance", s->mean_distance);
    figures_json_seconds(&j, "mean_distance_seconds", s->mean_distance, s->d.step_seconds);
  }
  notes_json(&desk->drawn.in.note, &j);
  json_end_object(&j);
}

static void write_nothing(FILE *out, const void *what) {
  (void)out;
  (void)what;
}

/* The mission's name, or the file's, a table's without the suffix. */
static const char *title_of(const options *o) {
  static char title[256];
  const char *slash = strrchr(o->input, '/');
  if (desk->drawn.in.names.mission[0] != '\0') return desk->drawn.in.names.mission;
  if (picture.names.mission[0] != '\0') return picture.names.mission;
  snprintf(title, sizeof title, "%s", slash != NULL ? slash + 1 : o->input);
  char *suffix = strrchr(title, '.');
  if (suffix != NULL && suffix != title && strcmp(suffix, ".qtr") == 0) *suffix = '\0';
  return title;
}

static int fill_sheet(sheet *s, const options *o, fault *why) {
  table t;
  if (!table_is_one(o->input)) return from_input(s, o, why);
  if (table_read(&t, o->input, why) != 0) return -1;
  const int status = products_check(o, why) == 0 ? from_table(s, &t, why) : -1;
  table_free(&t);
  return status;
}

static int draw(const options *o, fault *why) {
  enum draw_form form;
  if (o->output == NULL) return fault_set(why, "draw: say where to with -o FILE.svg");
  if (draw_file_form(&form, "-o", o->output, o->format, why) != 0) return -1;
  desk = memory_take(sizeof *desk, why);
  if (desk == NULL) return -1;
  set_arrays(&picture);
  picture.d.dark = o->dark;
  picture.d.grid = o->grid;
  int status = fill_sheet(&picture, o, why);
  picture.d.title = title_of(o);
  if (status == 0 && o->regions) status = add_regions(&picture, o, why);
  if (status == 0 && o->spots) status = add_spots(&picture, o, why);
  if (status == 0) status = draw_file_write(&picture.d, o->input, o->output, form, why);
  return status == 0 ? print_report(o, write_json, write_nothing, &picture, why) : -1;
}

int command_draw(int argc, char **argv) {
  static options o;
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  const int status = draw(&o, &why);
  free_sheet(&picture);
  return status == 0 ? EXIT_SUCCESS : fault_exit(&why);
}
