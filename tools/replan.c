#include "replan.h"

#include <math.h>
#include <string.h>

#include "figures.h"
#include "host/base/count.h"
#include "host/base/file.h"
#include "host/base/outfile.h"
#include "host/table/certificate.h"

enum { NOBODY = -1 };

int replan_begin(replan *c, const char *path, const char *output, fault *why) {
  fault unused;
  c->path = path;
  c->asked = path != NULL;
  /* What is to be replaced may be written over although it was read. */
  if (path != NULL) {
    if (table_read(&c->t, path, why) != 0) return -1;
    if (output != NULL && outfile_is_same(path, output)) file_forget(path);
  } else {
    if (output == NULL || !table_is_one(output)) return 0;
    const int status = table_read(&c->t, output, &unused);
    file_forget(output);
    if (status != 0) return 0;
    c->path = output;
  }
  table_routes(&c->t, c->route);
  c->expected_time = table_certificate_of(&c->t.policy).expected_time;
  c->expected_seconds = c->expected_time * (c->t.claim.step_time_us > 0 ? c->t.claim.step_time_us / 1e6 : 1.0);
  return 0;
}

/* A mission has no looks of its own: of a table's, the first of a place stands for it. */
static bool is_first_look(const naming *n, int place) {
  return naming_look(n, (unsigned)place) == 1;
}

static int count_places(const naming *n) {
  int count = 0;
  for (int place = 0; place < n->places; place++) count += is_first_look(n, place);
  return count;
}

/* ---- who goes where ---- */

static int visitor_of(const table_route *routes, int seekers, int place) {
  for (int seeker = 0; seeker < seekers; seeker++)
    for (int i = 0; i < routes[seeker].places; i++)
      if (routes[seeker].place[i] == place) return seeker;
  return NOBODY;
}

/* "nobody", or what the seeker is called. */
static naming_label who(const naming *n, int seeker) {
  return seeker != NOBODY ? naming_seeker(n, (unsigned)seeker) : (naming_label){"nobody"};
}

typedef struct {
  naming_label before, after;
} pair;

/* Whether another robot goes there now. */
static bool passes_on(pair *robots, const replan *c, const naming *n, const table_route *routes, int place) {
  const naming before = table_naming(&c->t);
  const int old = naming_same_place(n, place, &before);
  if (old == NOBODY) return false;
  robots->before = who(&before, visitor_of(c->route, before.seekers, old));
  robots->after = who(n, visitor_of(routes, n->seekers, place));
  return strcmp(robots->before.text, robots->after.text) != 0;
}

static bool is_same(const replan *c, const naming *n, const table_route *routes, double seconds) {
  const naming before = table_naming(&c->t);
  pair robots;
  bool same = fabs(seconds - c->expected_seconds) <= 1e-6 * c->expected_seconds && count_places(&before) == n->places;
  for (int place = 0; place < n->places && same; place++)
    same = naming_same_place(n, place, &before) != NOBODY && !passes_on(&robots, c, n, routes, place);
  return same;
}

/* ---- as text ---- */

static void write_absent(FILE *out, const char *what, const naming *n, const naming *in) {
  int count = 0;
  for (int place = 0; place < n->places; place++)
    if (is_first_look(n, place) && naming_same_place(n, place, in) == NOBODY)
      fprintf(out, "%s%s", count++ == 0 ? what : ", ", naming_place(n, (unsigned)place).text);
  if (count > 0) fputc('\n', out);
}

static void write_passed_on(FILE *out, const replan *c, const naming *n, const table_route *routes) {
  pair robots;
  int count = 0;
  for (int place = 0; place < n->places; place++)
    if (passes_on(&robots, c, n, routes, place))
      fprintf(out, "%s%s (%s -> %s)", count++ == 0 ? "  another robot: " : ", ", naming_place(n, (unsigned)place).text,
              robots.before.text, robots.after.text);
  if (count > 0) fputc('\n', out);
}

/* Expected times can be compared whatever a plan is for; but what is played for a deadline is not played for time. */
static void write_figures(FILE *out, const replan *c, const qtr_certificate *now, const problem *p) {
  const table_certificate before = table_certificate_of(&c->t.policy);
  const double seconds = now->expected_time * p->pace.seconds_per_step;
  if (p->in.mission.aim.kind == QTR_DEADLINE && before.objective == QTR_DEADLINE)
    fprintf(out, "%s %.6g, was %.6g\n", qtr_objective_in_words(QTR_DEADLINE)->figure, now->objective, before.figure);
  else if (p->pace.stated)
    fprintf(out, "expected time %.6g s, was %.6g\n", seconds, c->expected_seconds);
  else
    fprintf(out, "expected time %s, was %.6g\n", measured(seconds, "step").text, c->expected_seconds);
}

void replan_write(FILE *out, const replan *c, const naming *n, const table_route *routes,
                  const qtr_certificate *certificate, const problem *p) {
  const double seconds = certificate->expected_time * p->pace.seconds_per_step;
  const naming before = table_naming(&c->t);
  if (c->path == NULL || (!c->asked && is_same(c, n, routes, seconds))) return;
  fprintf(out, "against %s: ", c->path);
  write_figures(out, c, certificate, p);
  write_absent(out, "  gone: ", &before, n);
  write_absent(out, "  new: ", n, &before);
  write_passed_on(out, c, n, routes);
}

/* ---- as JSON ---- */

static void write_place(json *j, const naming *n, int place) {
  json_flat_object(j, NULL);
  json_integer(j, "place", n->number[place]);
  naming_json_place(n, j, (unsigned)place);
}

static void json_absent(json *j, const char *key, const naming *n, const naming *in) {
  json_array(j, key);
  for (int place = 0; place < n->places; place++) {
    if (!is_first_look(n, place) || naming_same_place(n, place, in) != NOBODY) continue;
    write_place(j, n, place);
    json_end_object(j);
  }
  json_end_array(j);
}

void replan_json(json *j, const replan *c, const naming *n, const table_route *routes) {
  const naming before = table_naming(&c->t);
  pair robots;
  if (c->path == NULL) return;
  json_object(j, "against");
  json_string(j, "file", c->path);
  json_number(j, "expected_time", c->expected_time);
  figures_json_seconds(j, "expected_time_seconds", c->expected_time, table_step_seconds(&c->t));
  json_absent(j, "gone", &before, n);
  json_absent(j, "new", n, &before);
  json_array(j, "another_robot");
  for (int place = 0; place < n->places; place++) {
    if (!passes_on(&robots, c, n, routes, place)) continue;
    write_place(j, n, place);
    json_string(j, "before", robots.before.text);
    json_string(j, "after", robots.after.text);
    json_end_object(j);
  }
  json_end_array(j);
  json_end_object(j);
}
