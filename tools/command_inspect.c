#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "commands.h"
#include "figures.h"
#include "fit.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/stop.h"
#include "host/input/words.h"
#include "host/table/certificate.h"
#include "host/table/table.h"
#include "print.h"
#include "products.h"
#include "report.h"

static const char intro[] =
    "quarter inspect mission.qtr                        what a policy table holds: map, certificate, routes\n"
    "quarter inspect mission.qtr --json\n"
    "\n"
    "The table is opened as a robot opens it, checksum and self-test included.\n"
    "\n";

static const option_line lines[] = {
    OPTION_LINE("profile"),
    {"json", "print it as JSON, or write it to FILE", 0},
    {"quiet", "say nothing: the exit status tells whether the table is sound", 0},
    {NULL, NULL, 0},
};

static const char outro[] = "\n"
                            "Exit status: 0 a sound table; 2 not one; " STATUS_OF_SIGNAL("nothing half-written")
                                STATUS_OF_UNFIT("though it is sound");

static const option_set set = {"inspect", intro, outro, option_records, lines};

/* The shortest decimal that a table's weights, of 32 bits, do not tell from the likelihood: 0.4, not 0.39999999981. */
static double told_probability(const table *t, unsigned place) {
  const double held = table_probability(t, place), unit = 1.0 / 4294967296.0;
  for (int digits = 1; digits < 17; digits++) {
    char text[32];
    snprintf(text, sizeof text, "%.*g", digits, held);
    const double shorter = strtod(text, NULL);
    if (fabs(shorter - held) <= unit) return shorter;
  }
  return held;
}

static void write_places(json *j, const table *t) {
  const naming n = table_naming(t);
  json_array(j, "place");
  for (unsigned place = 0; place < t->policy.board.places; place++) {
    json_flat_object(j, NULL);
    if (t->claim.numbers != NULL || qtr_policy_place(&t->policy, place) != place)
      json_integer(j, "number", t->number[place]);
    naming_json_place(&n, j, place);
    json_integer(j, "column", table_column(t, qtr_policy_cell(&t->policy, place)));
    json_integer(j, "row", table_row(t, qtr_policy_cell(&t->policy, place)));
    json_number(j, "probability", told_probability(t, place));
    json_end_object(j);
  }
  json_end_array(j);
  json_array(j, "start");
  for (unsigned seeker = 0; seeker < t->policy.board.seekers; seeker++) {
    const unsigned node = (unsigned)t->policy.board.places + t->policy.board.start_of[seeker];
    json_flat_object(j, NULL);
    naming_json_seeker(&n, j, seeker);
    json_integer(j, "column", table_column(t, qtr_policy_cell(&t->policy, node)));
    json_integer(j, "row", table_row(t, qtr_policy_cell(&t->policy, node)));
    json_end_object(j);
  }
  json_end_array(j);
}

/* The map, a text a row: '#' blocked or out of reach, '.' free, 2 to 9 the steps that slow ground takes (9 or more). */
static void write_map(json *j, const table *t) {
  char *text = malloc(t->claim.map_columns + 1u);
  json_array(j, "map");
  for (unsigned row = 0; text != NULL && row < t->claim.map_rows; row++)
    json_string(j, NULL, table_map_row(text, t, row));

  json_end_array(j);
  free(text);
}

/* A table and its routes. */
typedef struct {
  table t;
  const options *o;
  fit fit;
  table_route routes[QTR_MAX_SEEKERS];
  route_units units;
} inspection;

typedef struct {
  char text[9];
} identity;

/* Of the division from the mission's own starts. */
static identity identity_of(const table *t) {
  identity i;
  qtr_deployment home;
  qtr_deployment_init(&home, &t->policy, NULL, NULL);
  snprintf(i.text, sizeof i.text, "%08" PRIx32, qtr_deployment_identity(&home, &t->policy));
  return i;
}

/* Where the map lies: in metres, and on the globe. */
static void write_frame(json *j, const table *t) {
  const qtr_frame frame = qtr_policy_frame(&t->policy);
  double x, y;
  table_map_origin(t, &x, &y);
  if (frame.cell_size_um > 0) {
    json_number(j, "cell_size", frame.cell_size_um / 1e6);
    json_number(j, "origin_x", x);
    json_number(j, "origin_y", y);
    if (frame.sine != 0 || frame.cosine < 0) json_number(j, "yaw", round(1e8 * atan2(frame.sine, frame.cosine)) / 1e8);
  }
  if (!t->geo.given) return;
  json_flat_object(j, "geo");
  json_number(j, "latitude", (double)t->geo.latitude / (double)QTR_GEO_ONE);
  json_number(j, "longitude", (double)t->geo.longitude / (double)QTR_GEO_ONE);
  json_number(j, "yaw", (double)t->geo.yaw / (double)QTR_GEO_ONE);
  json_end_object(j);
}

/* Where looks may miss or it is said how long a step is. */
static void write_terms(json *j, const table *t, const table_certificate *c) {
  const double seconds = table_step_seconds(t);
  figures_json_seconds(j, "expected_time_seconds", c->expected_time, seconds);
  if (seconds > 0.0) json_number(j, "seconds_per_step", seconds);
  if (seconds > 0.0 || c->found < 1.0) json_number(j, "found_probability", c->found);
  if (c->deadline > 0) json_natural(j, "deadline_step", c->deadline);
  if (c->deadline > 0) figures_json_seconds(j, "deadline_seconds", c->deadline, seconds);
}

static void write_json(FILE *out, const void *what) {
  const inspection *i = what;
  const table *t = &i->t;
  const table_certificate c = table_certificate_of(&t->policy);
  const naming n = table_naming(t);
  const double seconds = table_step_seconds(t);
  char version[40];
  json j;
  snprintf(version, sizeof version, "%u.%u.%u", c.version[0], c.version[1], c.version[2]);
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "inspect");
  json_string(&j, "input", i->o->input);
  json_integer(&j, "format", t->policy.format);
  json_string(&j, "version", version);
  json_natural(&j, "bytes", t->bytes.size);
  if (t->names.mission[0] != '\0') json_string(&j, "name", t->names.mission);
  json_string(&j, "identity", identity_of(t).text);
  json_integer(&j, "columns", t->claim.map_columns);
  json_integer(&j, "rows", t->claim.map_rows);
  write_frame(&j, t);
  json_integer(&j, "places", t->policy.board.places);
  json_integer(&j, "robots", t->policy.board.seekers);
  json_string(&j, "objective", qtr_objective_names[c.objective]);
  json_number(&j, "gamma", c.gamma);
  json_string(&j, "rule", words_rule[t->policy.board.rule]);
  json_number(&j, "value", c.value);
  json_number(&j, "expected_time", c.expected_time);
  write_terms(&j, t, &c);
  json_number(&j, "objective_value", figures_unit(c.objective, seconds) * c.figure);
  json_number(&j, "objective_bound", figures_unit(c.objective, seconds) * c.bound);
  json_number(&j, "gap", c.gap);
  json_bool(&j, "certified", c.certified);
  json_natural(&j, "seed", c.seed);
  json_natural(&j, "records", t->policy.records);
  json_integer(&j, "key_bytes", 4 * t->policy.board.keys.words);
  fit_json(&j, &i->fit);
  write_map(&j, t);
  write_places(&j, t);
  report_json_routes(&j, i->routes, &n, &i->units);
  json_end_object(&j);
}

static void write_text(FILE *out, const void *what) {
  const inspection *i = what;
  const table *t = &i->t;
  const table_certificate c = table_certificate_of(&t->policy);
  const naming n = table_naming(t);
  const double seconds = table_step_seconds(t);
  fprintf(out, "%s: a sound policy table, %s, written by Quarter %u.%u.%u with seed %" PRIu64 "\n", i->o->input,
          counted(t->bytes.size, "byte").text, c.version[0], c.version[1], c.version[2], c.seed);
  fprintf(out, "%d x %d cells, %s, %s; %s rule, %s\n", t->claim.map_columns, t->claim.map_rows,
          figures_places(c.own_places, t->policy.board.places).text, counted(t->policy.board.seekers, "robot").text,
          words_rule[t->policy.board.rule], qtr_objective_in_words(c.objective)->goal);
  fprintf(out, "%s: discounted value %.6g (gamma %.6g), expected time %s; bound %.6g, gap %.3g%%\n",
          c.certified ? "certified" : "not certified", c.value, c.gamma, figures_time(c.expected_time, seconds).text,
          figures_unit(c.objective, seconds) * c.bound, 100.0 * c.gap);
  if (seconds > 0.0) fprintf(out, "a step is %.6g s\n", seconds);
  if (c.deadline > 0)
    fprintf(out, "finds by the deadline (%s) with probability %.6g\n", figures_moment(c.deadline, seconds).text,
            c.found);
  else if (c.found < 1.0 - 1e-9)
    fprintf(out, "finds the target with probability %.6g\n", c.found);
  fprintf(out, "identity %s: robots of another one are not believed\n", identity_of(t).text);
  fprintf(out, "%s of %d-byte keys\n", counted(t->policy.records, "state").text, 4 * t->policy.board.keys.words);
  report_routes(out, i->routes, &n, &i->units);
  fit_write(out, &i->fit);
}

int command_inspect(int argc, char **argv) {
  static options o;
  static inspection i = {.o = &o};
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  if (fit_begin(&i.fit, o.profile, &why) != 0 || table_read(&i.t, o.input, &why) != 0) return fault_exit(&why);
  if (products_check(&o, &why) != 0) return fault_exit(&why);
  fit_take(&i.fit, &i.t.policy);
  table_routes(&i.t, i.routes);
  int status = routes_measure_table(&i.units, i.routes, &i.t, &why);
  if (status == 0) status = print_report(&o, write_json, write_text, &i, &why);
  if (status == 0) status = fit_check(&i.fit, o.input, &why);
  table_free(&i.t);
  return status == 0 ? EXIT_SUCCESS : fault_exit(&why);
}
