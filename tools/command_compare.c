#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "figures.h"
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
  double seconds;      /* a step; 0: the table does not say */
  double a_step, unit; /* seconds to count a step by, 1 where none are said, and figures: so that two plans can be */
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
  s->seconds = table_step_seconds(&s->t);
  s->a_step = s->seconds > 0.0 ? s->seconds : 1.0;
  s->unit = figures_unit(s->certificate.objective, s->seconds);
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

/* What times are told by rounds them. */
static bool is_as_long(double seconds, double other) {
  return seconds == other || fabs(seconds - other) <= 1e-5 * fmax(seconds, other);
}

/* Of plain ground, in metres (cells, on a map without), by whichever class has the shortest way. */
static double way_of(const side *s, int from, int to) {
  const qtr_policy *policy = &s->t.policy;
  const double side_m = qtr_policy_frame(policy).cell_size_um / 1e6;
  double shortest = HUGE_VAL;
  for (unsigned of = 0; of == 0 || of < policy->board.classes; of++) {
    const qtr_steps steps = qtr_board_class_steps(&policy->board, of, (unsigned)from, (unsigned)to);
    const qtr_steps scan = qtr_board_class_steps(&policy->board, of, (unsigned)to, (unsigned)to);
    if (steps == QTR_NEVER || scan == QTR_NEVER) continue;
    shortest = fmin(shortest, (double)(steps - scan) / qtr_claim_cell_steps(policy, of));
  }
  return shortest * (side_m > 0.0 ? side_m : 1.0);
}

static double when(const side *s, int place) {
  return s->a_step * s->step[place];
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
      if (!is_as_long(way_of(a, place, to), way_of(b, c->other[place], c->other[to]))) return false;
  }
  return true;
}

/* A second's, or a step's where none are said. */
static double gamma_of(const side *s) {
  return s->a_step == 1.0 ? s->certificate.gamma : pow(s->certificate.gamma, 1.0 / s->a_step);
}

static double deadline_of(const side *s) {
  return s->a_step * s->certificate.deadline;
}

static int check_objectives(const comparison *c, fault *why) {
  const side *a = &c->side[0], *b = &c->side[1];
  const qtr_objective_words *first = qtr_objective_in_words(a->certificate.objective);
  if (a->certificate.objective != b->certificate.objective)
    return fault_set(why,
                     "%s has the %s and %s the %s: their figures are of two kinds; learn both with one --objective",
                     a->path, first->goal, b->path, qtr_objective_in_words(b->certificate.objective)->goal);
  if (first->fades && fabs(gamma_of(a) - gamma_of(b)) > 1e-6 * (1.0 - gamma_of(a)))
    return fault_set(why,
                     "%s has a gamma of %g and %s of %g: their values are in two units; learn both with one --gamma",
                     a->path, gamma_of(a), b->path, gamma_of(b));
  if (!is_as_long(deadline_of(a), deadline_of(b)))
    return fault_set(why,
                     "%s finds by %g s and %s by %g: their probabilities are of two deadlines; learn both with one "
                     "--deadline",
                     a->path, deadline_of(a), b->path, deadline_of(b));
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
    if (a->visitor[place] == NOBODY || b->visitor[other] == NOBODY || is_as_long(when(a, place), when(b, other)))
      continue;
    n.sooner += when(b, other) < when(a, place);
    n.later += when(b, other) > when(a, place);
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

static count_text told_figure(const side *s, double figure) {
  return figures_told(s->certificate.objective, figure, s->seconds);
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
  snprintf(told.text, sizeof told.text, "%.20s, %.40s", counted((uint64_t)s->names.seekers, "robot").text,
           figures_places(s->certificate.own_places, (unsigned)s->names.places).text);
  return told;
}

static void write_figures(FILE *out, const comparison *c) {
  const side *a = &c->side[0], *b = &c->side[1];
  const qtr_objective_words *words = qtr_objective_in_words(a->certificate.objective);
  put_row(out, c, words->figure, told_figure(a, a->certificate.figure).text,
          told_figure(b, b->certificate.figure).text);
  put_row(out, c, words->limit, told_figure(a, a->certificate.bound).text, told_figure(b, b->certificate.bound).text);
  put_row(out, c, "", told_certificate(&a->certificate).text, told_certificate(&b->certificate).text);
  put_row(out, c, "", told_size(a).text, told_size(b).text);
}

#define VISIT_BYTES (sizeof(table_name) + sizeof(count_text) + 32)

/* "seeker Alpha, step 12", "seeker Alpha, step 12, 6 s" */
static void tell_visit(char *text, size_t size, const side *s, int place) {
  if (place == NOBODY)
    snprintf(text, size, "-");
  else if (s->visitor[place] == NOBODY)
    snprintf(text, size, "nobody");
  else
    snprintf(text, size, "%s, %s%s", table_robot_name(&s->t, s->visitor[place]).text,
             figures_moment(s->step[place], s->seconds).text, figures_late(table_is_late(&s->t, s->step[place])));
}

static void write_visit(FILE *out, const comparison *c, int place, int other) {
  const side *a = &c->side[0], *b = &c->side[1];
  char first[VISIT_BYTES], second[VISIT_BYTES];
  const table_name name =
      place != NOBODY ? table_look_name(&a->t, (unsigned)place) : table_look_name(&b->t, (unsigned)other);
  tell_visit(first, sizeof first, a, place);
  tell_visit(second, sizeof second, b, other);
  put_row(out, c, name.text, first, second);
}

/* What a plan comes to, where both count alike. */
static double worth(const side *s) {
  return s->unit * s->certificate.figure;
}

static void write_better(FILE *out, const comparison *c) {
  const side *a = &c->side[0], *b = &c->side[1];
  const bool first = qtr_objective_is_better(a->certificate.objective, worth(a), worth(b));
  const side *better = first ? a : b, *worse = first ? b : a;
  if (worth(a) == worth(b))
    fputs("both are worth the same\n", out);
  else
    fprintf(out, "%s is better by %.3g %%: %s against %s\n", better->path,
            100.0 * fabs(worth(better) - worth(worse)) / fabs(worth(worse)),
            told_figure(better, better->certificate.figure).text, told_figure(worse, worse->certificate.figure).text);
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
  char visit[VISIT_BYTES];
  c->name_column = wider(0, qtr_objective_in_words(a->certificate.objective)->limit);
  c->side_column = wider(wider(0, a->path), told_certificate(&a->certificate).text);
  c->side_column = wider(c->side_column, told_size(a).text);
  c->name_column = wider(c->name_column, qtr_objective_in_words(a->certificate.objective)->figure);
  for (int place = 0; place < a->names.places; place++) {
    tell_visit(visit, sizeof visit, a, place);
    c->name_column = wider(c->name_column, table_look_name(&a->t, (unsigned)place).text);
    c->side_column = wider(c->side_column, visit);
  }
  for (int place = 0; place < b->names.places; place++)
    c->name_column = wider(c->name_column, table_look_name(&b->t, (unsigned)place).text);
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
  json_number(j, "objective_value", s->unit * c->figure);
  json_number(j, "objective_bound", s->unit * c->bound);
  json_number(j, "gap", c->gap);
  json_bool(j, "certified", c->certified);
  json_number(j, "value", c->value);
  json_number(j, "expected_time", c->expected_time);
  figures_json_seconds(j, "expected_time_seconds", c->expected_time, s->seconds);
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
    figures_json_seconds(j, "seconds", s->step[place], s->seconds);
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
  const side *a = &c->side[0], *b = &c->side[1];
  const uint8_t objective = a->certificate.objective;
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", "compare");
  json_string(&j, "objective", qtr_objective_names[objective]);
  json_bool(&j, "one_mission", c->one_mission);
  json_array(&j, "tables");
  for (int i = 0; i < SIDES; i++) write_table_json(&j, &c->side[i]);
  json_end_array(&j);
  json_number(&j, "difference", worth(b) - worth(a));
  if (c->one_mission)
    json_bool(&j, "second_is_better", qtr_objective_is_better(objective, worth(b), worth(a)));
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
