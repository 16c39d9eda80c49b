#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/stop.h"
#include "host/base/utf8.h"
#include "host/table/certificate.h"
#include "host/table/table.h"
#include "print.h"
#include "products.h"
#include "quarter/objective.h"
#include "report.h"

static const char intro[] =
    "quarter compare before.qtr after.qtr               two plans: value, bound, and who visits what when\n"
    "quarter compare two.qtr three.qtr --json\n"
    "\n"
    "The plans may be of one mission (other robots, other settings, more time to learn) or of two: places are the same "
    "where\n"
    "they have one name, or where neither has one and they have one number.\n"
    "\n";

static const option_line lines[] = {
    {"json", "print it as JSON, or write it to FILE", 0},
    {"quiet", "say nothing: the exit status tells whether the two can be compared", 0},
    {NULL, NULL, 0},
};

static const char outro[] = "\n"
                            "Exit status: 0 compared; 2 bad input, or plans for other objectives, whose figures are of "
                            "two kinds;\n" STATUS_OF_SIGNAL("nothing half-written");

static const option_set set = {"compare", intro, outro, option_records, lines};

enum { SIDES = 2, NOBODY = -1 };

/* A table and who visits what. */
typedef struct {
  const char *path;
  table t;
  naming names;
  table_certificate certificate;
  table_route route[QTR_MAX_SEEKERS];
  int visitor[QTR_MAX_PLACES]; /* NOBODY */
  qtr_steps step[QTR_MAX_PLACES];
} side;

typedef struct {
  const options *o;
  side side[SIDES];
  int other[QTR_MAX_PLACES];    /* the second's place that the first's is; NOBODY */
  bool common[QTR_MAX_PLACES];  /* of the second's, whether the first has it too */
  bool one_mission;             /* the same places with the same likelihoods, as far from one another */
  int name_column, side_column; /* of the text, in characters */
} comparison;

/* ---- the two ---- */

static int read_side(side *s, fault *why) {
  if (table_read(&s->t, s->path, why) != 0) return -1;
  s->names = table_naming(&s->t);
  s->certificate = table_certificate_of(&s->t.policy);
  table_routes(&s->t, s->route);
  for (int place = 0; place < s->names.places; place++) s->visitor[place] = NOBODY;
  for (int seeker = 0; seeker < s->names.seekers; seeker++) {
    const table_route *route = &s->route[seeker];
    for (int visit = 0; visit < route->places; visit++) {
      s->visitor[route->place[visit]] = seeker;
      s->step[route->place[visit]] = route->step[visit];
    }
  }
  return 0;
}

static void match_places(comparison *c) {
  const naming *a = &c->side[0].names, *b = &c->side[1].names;
  for (int place = 0; place < a->places; place++) {
    c->other[place] = naming_same_place(a, place, b);
    if (c->other[place] != NOBODY) c->common[c->other[place]] = true;
  }
}

static qtr_steps way_of(const side *s, int from, int to) {
  return qtr_board_class_steps(&s->t.policy.board, 0, (unsigned)from, (unsigned)to);
}

static bool is_alike(const side *a, int place, const side *b, int other) {
  const qtr_cell here = qtr_policy_cell(&a->t.policy, (unsigned)place);
  const qtr_cell there = qtr_policy_cell(&b->t.policy, (unsigned)other);
  return table_column(&a->t, here) == table_column(&b->t, there) && table_row(&a->t, here) == table_row(&b->t, there) &&
         qtr_policy_weight(&a->t.policy, (unsigned)place) == qtr_policy_weight(&b->t.policy, (unsigned)other);
}

/* Robots and their starts may be others: what is searched is the same. */
static bool is_one_mission(const comparison *c) {
  const side *a = &c->side[0], *b = &c->side[1];
  if (a->names.places != b->names.places) return false;
  for (int place = 0; place < a->names.places; place++) {
    if (c->other[place] == NOBODY || !is_alike(a, place, b, c->other[place])) return false;
    for (int to = 0; to < place; to++)
      if (way_of(a, place, to) != way_of(b, c->other[place], c->other[to])) return false;
  }
  return true;
}

static int check_objectives(const comparison *c, fault *why) {
  const side *a = &c->side[0], *b = &c->side[1];
  const qtr_objective_words *first = qtr_objective_in_words(a->certificate.objective);
  if (a->certificate.objective != b->certificate.objective)
    return fault_set(why,
                     "%s has the %s and %s the %s: their figures are of two kinds; learn both with one --objective",
                     a->path, first->goal, b->path, qtr_objective_in_words(b->certificate.objective)->goal);
  if (first->fades && a->certificate.gamma != b->certificate.gamma)
    return fault_set(why,
                     "%s has a gamma of %g and %s of %g: their values are in two units; learn both with one --gamma",
                     a->path, a->certificate.gamma, b->path, b->certificate.gamma);
  return 0;
}

/* ---- what there is to say ---- */

/* How many places go to another robot, and are visited sooner or later. */
typedef struct {
  int common, moved, sooner, later, gone, fresh;
} changes;

static bool is_one_robot(const side *a, int seeker, const side *b, int other) {
  if (seeker == NOBODY || other == NOBODY) return seeker == other;
  return strcmp(naming_seeker(&a->names, (unsigned)seeker).text, naming_seeker(&b->names, (unsigned)other).text) == 0;
}

static changes count_changes(const comparison *c) {
  const side *a = &c->side[0], *b = &c->side[1];
  changes n = {0};
  for (int place = 0; place < a->names.places; place++) {
    const int other = c->other[place];
    if (other == NOBODY) {
      n.gone++;
      continue;
    }
    n.common++;
    n.moved += !is_one_robot(a, a->visitor[place], b, b->visitor[other]);
    n.sooner += b->step[other] < a->step[place];
    n.later += b->step[other] > a->step[place];
  }
  n.fresh = b->names.places - n.common;
  return n;
}

/* ---- as text ---- */

/* Columns that a text takes, one a character. */
static int width_of(const char *text) {
  int width = 0;
  for (; *text != '\0'; width++) {
    const int length = utf8_length(text);
    text += length > 0 ? length : 1;
  }
  return width;
}

static void put_padded(FILE *out, const char *text, int width) {
  fprintf(out, "%s%*s", text, width > width_of(text) ? width - width_of(text) : 0, "");
}

static int wider(int width, const char *text) {
  return width > width_of(text) ? width : width_of(text);
}

static void put_row(FILE *out, const comparison *c, const char *name, const char *first, const char *second) {
  fputs("  ", out);
  put_padded(out, name, c->name_column);
  fputs("  ", out);
  put_padded(out, first, c->side_column);
  fprintf(out, "  %s\n", second);
}

static count_text told_figure(uint8_t objective, double figure) {
  const char *unit = qtr_objective_in_words(objective)->unit;
  count_text told;
  if (unit != NULL) return measured(figure, unit);
  snprintf(told.text, sizeof told.text, "%.6g", figure);
  return told;
}

static count_text told_certificate(const table_certificate *c) {
  count_text told;
  const double gap = 100.0 * c->gap;
  const char *word = c->certified ? "certified" : "not certified";
  if (c->gap < 1e-5)
    snprintf(told.text, sizeof told.text, "%s, gap %s", word, c->gap < 1e-9 ? "0" : "below 0.001 %");
  else
    snprintf(told.text, sizeof told.text, "%s, gap %.2g %%", word, gap);
  return told;
}

static count_text told_size(const side *s) {
  count_text told;
  snprintf(told.text, sizeof told.text, "%.24s, %.24s", counted((uint64_t)s->names.seekers, "robot").text,
           counted((uint64_t)s->names.places, "place").text);
  return told;
}

static void write_figures(FILE *out, const comparison *c) {
  const table_certificate *a = &c->side[0].certificate, *b = &c->side[1].certificate;
  const qtr_objective_words *words = qtr_objective_in_words(a->objective);
  put_row(out, c, words->figure, told_figure(a->objective, a->figure).text, told_figure(b->objective, b->figure).text);
  put_row(out, c, words->limit, told_figure(a->objective, a->bound).text, told_figure(b->objective, b->bound).text);
  put_row(out, c, "", told_certificate(a).text, told_certificate(b).text);
  put_row(out, c, "", told_size(&c->side[0]).text, told_size(&c->side[1]).text);
}

/* "seeker Alpha, step 12" */
static void tell_visit(char *text, size_t size, const side *s, int place) {
  if (place == NOBODY)
    snprintf(text, size, "-");
  else if (s->visitor[place] == NOBODY)
    snprintf(text, size, "nobody");
  else
    snprintf(text, size, "%s, step %" PRIu32, table_robot_name(&s->t, s->visitor[place]).text, s->step[place]);
}

static void write_visit(FILE *out, const comparison *c, int place, int other) {
  const side *a = &c->side[0], *b = &c->side[1];
  char first[SIDES * QTR_SITE_NAME_BYTES], second[SIDES * QTR_SITE_NAME_BYTES];
  const table_name name =
      place != NOBODY ? table_place_name(&a->t, (unsigned)place) : table_place_name(&b->t, (unsigned)other);
  tell_visit(first, sizeof first, a, place);
  tell_visit(second, sizeof second, b, other);
  put_row(out, c, name.text, first, second);
}

static void write_better(FILE *out, const comparison *c) {
  const side *a = &c->side[0], *b = &c->side[1];
  const uint8_t kind = a->certificate.objective;
  const bool first = qtr_objective_is_better(kind, a->certificate.figure, b->certificate.figure);
  const side *better = first ? a : b, *worse = first ? b : a;
  const double figure = better->certificate.figure, against = worse->certificate.figure;
  if (figure == against)
    fputs("both are worth the same\n", out);
  else
    fprintf(out, "%s is better by %.3g %%: %s against %s\n", better->path,
            100.0 * fabs(figure - against) / fabs(against), told_figure(kind, figure).text,
            told_figure(kind, against).text);
}

static void write_verdict(FILE *out, const comparison *c) {
  const changes n = count_changes(c);
  if (c->one_mission)
    write_better(out, c);
  else
    fputs("two missions: places, likelihoods or ways differ, so the figures do not tell which plan is better\n", out);
  fprintf(out, "of %s in both, in the second %d by another robot, %d sooner, %d later",
          counted((uint64_t)n.common, "place").text, n.moved, n.sooner, n.later);
  if (n.gone > 0) fprintf(out, "; %d in the first alone", n.gone);
  if (n.fresh > 0) fprintf(out, "; %d in the second alone", n.fresh);
  fputc('\n', out);
}

/* As wide as what stands there. */
static void lay_out(comparison *c) {
  const side *a = &c->side[0], *b = &c->side[1];
  char visit[SIDES * QTR_SITE_NAME_BYTES];
  c->name_column = wider(0, qtr_objective_in_words(a->certificate.objective)->limit);
  c->side_column = wider(wider(0, a->path), told_certificate(&a->certificate).text);
  c->side_column = wider(c->side_column, told_size(a).text);
  for (int place = 0; place < a->names.places; place++) {
    tell_visit(visit, sizeof visit, a, place);
    c->name_column = wider(c->name_column, table_place_name(&a->t, (unsigned)place).text);
    c->side_column = wider(c->side_column, visit);
  }
  for (int place = 0; place < b->names.places; place++)
    c->name_column = wider(c->name_column, table_place_name(&b->t, (unsigned)place).text);
}

static void write_text(FILE *out, const void *what) {
  const comparison *c = what;
  put_row(out, c, "", c->side[0].path, c->side[1].path);
  write_figures(out, c);
  for (int place = 0; place < c->side[0].names.places; place++) write_visit(out, c, place, c->other[place]);
  for (int other = 0; other < c->side[1].names.places; other++)
    if (!c->common[other]) write_visit(out, c, NOBODY, other);
  write_verdict(out, c);
}

/* ---- as JSON ---- */

static void write_table_json(json *j, const side *s) {
  const table_certificate *c = &s->certificate;
  json_object(j, NULL);
  json_string(j, "input", s->path);
  json_number(j, "objective_value", c->figure);
  json_number(j, "objective_bound", c->bound);
  json_number(j, "gap", c->gap);
  json_bool(j, "certified", c->certified);
  json_number(j, "value", c->value);
  json_number(j, "expected_time", c->expected_time);
  json_integer(j, "robots", s->names.seekers);
  json_integer(j, "places", s->names.places);
  json_end_object(j);
}

static void write_visit_json(json *j, const char *key, const side *s, int place) {
  if (place == NOBODY) {
    json_null(j, key);
    return;
  }
  json_object(j, key);
  json_integer(j, "place", s->names.number[place]);
  naming_json_place(&s->names, j, (unsigned)place);
  if (s->visitor[place] != NOBODY) {
    json_integer(j, "seeker", s->visitor[place]);
    json_natural(j, "step", s->step[place]);
  }
  json_end_object(j);
}

static void write_visits_json(json *j, const comparison *c, int place, int other) {
  json_flat_object(j, NULL);
  write_visit_json(j, "first", &c->side[0], place);
  write_visit_json(j, "second", &c->side[1], other);
  json_end_object(j);
}

static void write_json(FILE *out, const void *what) {
  const comparison *c = what;
  const changes n = count_changes(c);
  const table_certificate *a = &c->side[0].certificate, *b = &c->side[1].certificate;
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "compare");
  json_string(&j, "objective", qtr_objective_names[a->objective]);
  json_bool(&j, "one_mission", c->one_mission);
  json_array(&j, "tables");
  for (int i = 0; i < SIDES; i++) write_table_json(&j, &c->side[i]);
  json_end_array(&j);
  json_number(&j, "difference", b->figure - a->figure);
  if (c->one_mission)
    json_bool(&j, "second_is_better", qtr_objective_is_better(a->objective, b->figure, a->figure));
  else
    json_null(&j, "second_is_better");
  json_integer(&j, "moved", n.moved);
  json_integer(&j, "sooner", n.sooner);
  json_integer(&j, "later", n.later);
  json_array(&j, "visits");
  for (int place = 0; place < c->side[0].names.places; place++) write_visits_json(&j, c, place, c->other[place]);
  for (int other = 0; other < c->side[1].names.places; other++)
    if (!c->common[other]) write_visits_json(&j, c, NOBODY, other);
  json_end_array(&j);
  json_end_object(&j);
}

/* ---- the command ---- */

static int compare(comparison *c, fault *why) {
  if (products_check(c->o, why) != 0 || check_objectives(c, why) != 0) return -1;
  match_places(c);
  c->one_mission = is_one_mission(c);
  lay_out(c);
  return print_report(c->o, write_json, write_text, c, why);
}

int command_compare(int argc, char **argv) {
  static options o;
  static comparison c = {.o = &o};
  fault why;
  if (options_parse_two(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  c.side[0].path = o.input;
  c.side[1].path = o.second;
  if (read_side(&c.side[0], &why) != 0) return fault_exit(&why);
  int status = read_side(&c.side[1], &why);
  if (status == 0) {
    status = compare(&c, &why);
    table_free(&c.side[1].t);
  }
  table_free(&c.side[0].t);
  return status == 0 ? EXIT_SUCCESS : fault_exit(&why);
}
