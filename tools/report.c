#include "report.h"

#include <inttypes.h>

#include "figures.h"
#include "host/base/count.h"
#include "host/base/json.h"
#include "host/base/stop.h"
#include "host/input/words.h"
#include "host/table/certificate.h"
#include "print.h"

static void write_units(json *j, const table_route *route, const route_units *units, int seeker) {
  if (units->seconds_per_step > 0.0) {
    json_array(j, "seconds");
    for (int i = 0; i < route->places; i++) json_number(j, NULL, route->step[i] * units->seconds_per_step);
    json_end_array(j);
  }
  if (units->metric) {
    json_array(j, "metres");
    for (int i = 0; i < route->places; i++) json_number(j, NULL, units->metres[seeker][i]);
    json_end_array(j);
  }
  if (units->deadline > 0) {
    int by = 0;
    while (by < route->places && !routes_is_late(units, route->step[by])) by++;
    json_integer(j, "by_deadline", by);
  }
  if (!units->looks) return;
  json_array(j, "looks");
  for (int i = 0; i < route->places; i++) json_integer(j, NULL, units->look[seeker][i]);
  json_end_array(j);
}

static void write_route(json *j, const table_route *route, const naming *n) {
  json_array(j, "places");
  for (int i = 0; i < route->places; i++) json_integer(j, NULL, n->number[route->place[i]]);
  json_end_array(j);
  if (naming_has_places(n)) {
    json_array(j, "names");
    for (int i = 0; i < route->places; i++) json_string(j, NULL, naming_place(n, route->place[i]).text);
    json_end_array(j);
  }
  json_array(j, "steps");
  for (int i = 0; i < route->places; i++) json_integer(j, NULL, route->step[i]);
  json_end_array(j);
}

void report_json_routes(json *j, const table_route *routes, const naming *n, const route_units *units) {
  json_array(j, "routes");
  for (int seeker = 0; seeker < n->seekers; seeker++) {
    json_flat_object(j, NULL);
    json_integer(j, "seeker", seeker);
    naming_json_seeker(n, j, (unsigned)seeker);
    write_route(j, &routes[seeker], n);
    write_units(j, &routes[seeker], units, seeker);
    json_end_object(j);
  }
  json_end_array(j);
}

/* Units of the objective's figure in a step: expected time is told in seconds, where steps have any. */
static double objective_unit(const report *r) {
  return figures_unit(r->p->in.mission.aim.kind, r->p->pace.seconds_per_step);
}

/* Of a step, where people are told of them; else 0. */
static double told_seconds(const report *r) {
  return r->p->pace.stated ? r->p->pace.seconds_per_step : 0.0;
}

static double time_by_deadline(const report *r) {
  return routes_time_by_deadline(&r->units, r->route, &r->p->in.mission);
}

static void write_certificate(json *j, const report *r) {
  const qtr_certificate *c = &r->certificate;
  json_number(j, "seconds_per_step", r->p->pace.seconds_per_step);
  json_number(j, "travel_rounding", r->p->pace.rounding);
  json_number(j, "value", c->value);
  json_number(j, "expected_time", c->expected_time);
  figures_json_seconds(j, "expected_time_seconds", c->expected_time, told_seconds(r));
  json_number(j, "found_probability", c->found);
  if (r->units.deadline > 0) {
    json_natural(j, "deadline_step", r->units.deadline);
    figures_json_seconds(j, "deadline_seconds", r->units.deadline, told_seconds(r));
    json_number(j, "expected_time_by_deadline", time_by_deadline(r));
    figures_json_seconds(j, "expected_time_by_deadline_seconds", time_by_deadline(r), told_seconds(r));
  }
  json_number(j, "objective_value", objective_unit(r) * c->objective);
  json_number(j, "objective_bound", objective_unit(r) * c->bound);
  json_number(j, "gap", c->gap);
  json_bool(j, "certified", c->certified);
  json_integer(j, "negligible_places", c->negligible_places);
}

/* By the input's numbers. */
static void write_cleared(json *j, const input *in) {
  json_flat_array(j, "cleared");
  for (unsigned place = 0; place < in->places_stated; place++)
    if (qtr_places_has(&in->cleared, place)) json_integer(j, NULL, place);
  json_end_array(j);
}

static void write_left_out(json *j, const report *r) {
  uint16_t places[QTR_MAX_PLACES];
  const int count = routes_left_out(places, r->route, &r->p->in.mission);
  json_flat_array(j, "left_out");
  for (int i = 0; i < count; i++) json_integer(j, NULL, r->p->in.place_number[places[i]]);
  json_end_array(j);
}

static void write_json(FILE *out, const void *what) {
  const report *r = what;
  const qtr_mission *mission = &r->p->in.mission;
  const qtr_certificate *c = &r->certificate;
  const naming n = input_naming(&r->p->in);
  json j;
  json_begin(&j, out);
  json_object(&j, NULL);
  json_string(&j, "command", r->command);
  json_string(&j, "input", r->o->input);
  json_string(&j, "version", QTR_VERSION_STRING);
  json_integer(&j, "columns", mission->columns);
  json_integer(&j, "rows", mission->rows);
  json_integer(&j, "cells", problem_free_cells(r->p));
  json_integer(&j, "places", mission->places);
  json_integer(&j, "robots", mission->seekers);
  json_string(&j, "objective", qtr_objective_names[mission->aim.kind]);
  json_number(&j, "gamma", r->p->pace.gamma);
  json_string(&j, "rule", words_rule[mission->rule]);
  write_certificate(&j, r);
  json_string(&j, "ended", r->ended);
  json_natural(&j, "episodes", c->episodes);
  json_natural(&j, "updates", c->updates);
  json_number(&j, "max_q", c->max_q);
  json_natural(&j, "regions", r->regions);
  json_natural(&j, "spots", r->spots);
  json_natural(&j, "price_steps", c->price_steps);
  json_natural(&j, "q_entries", r->q_entries);
  json_natural(&j, "q_bytes", r->q_bytes);
  json_number(&j, "seconds", r->seconds);
  json_natural(&j, "seed", r->o->plan.learner.seed);
  json_natural(&j, "table_bytes", r->table_bytes);
  json_natural(&j, "table_records", r->table_records);
  report_json_routes(&j, r->route, &n, &r->units);
  write_left_out(&j, r);
  json_flat_array(&j, "place_numbers");
  for (int place = 0; place < mission->places; place++) json_integer(&j, NULL, r->p->in.place_number[place]);
  json_end_array(&j);
  write_cleared(&j, &r->p->in);
  replan_json(&j, &r->before, &n, r->route);
  fit_json(&j, &r->fit);
  notes_json(&r->p->in.note, &j);
  if (r->anywhere) {
    json_flat_object(&j, "anywhere");
    json_natural(&j, "games", r->any.games);
    json_bool(&j, "complete", r->any.complete);
    json_natural(&j, "regions", r->any.regions);
    json_natural(&j, "regions_meant", r->any.regions_meant);
    json_integer(&j, "trials", r->any.trials);
    json_number(&j, "median_loss", r->any.median_loss);
    json_number(&j, "ninety_loss", r->any.ninety_loss);
    json_number(&j, "worst_loss", r->any.worst_loss);
    json_end_object(&j);
  }
  json_end_object(&j);
}

void report_routes(FILE *out, const table_route *route, const naming *n, const route_units *units) {
  for (int seeker = 0; seeker < n->seekers; seeker++) {
    fprintf(out, "  seeker %s:", naming_seeker(n, (unsigned)seeker).text);
    if (route[seeker].places == 0) fprintf(out, " stays at its start");
    for (int i = 0; i < route[seeker].places; i++) {
      fprintf(out, "%s %s (%s%s)", i > 0 ? " ->" : "", naming_place(n, route[seeker].place[i]).text,
              figures_moment(route[seeker].step[i], units->seconds ? units->seconds_per_step : 0.0).text,
              figures_late(routes_is_late(units, route[seeker].step[i])));
    }
    if (units->seconds && units->metric && route[seeker].places > 0)
      fprintf(out, "; %.6g m", units->metres[seeker][route[seeker].places - 1]);
    fputc('\n', out);
  }
}

/* "expected time 12.5 steps" */
static void write_figure(FILE *out, uint8_t objective, double figure, double step_seconds) {
  fprintf(out, "%s %s", qtr_objective_in_words(objective)->figure, figures_told(objective, figure, step_seconds).text);
}

/* The objective's figure and its bound, and another one beside it. */
static void write_figures(FILE *out, uint8_t objective, const report *r) {
  const qtr_certificate *c = &r->certificate;
  const uint8_t beside = qtr_objective_in_words(objective)->beside;
  const qtr_score score = {.value = c->value, .expected_time = c->expected_time, .found = c->found};
  write_figure(out, objective, c->objective, told_seconds(r));
  fprintf(out, ", bound %.6g (", objective_unit(r) * c->bound);
  if (objective == QTR_DEADLINE) {
    fprintf(out, "by then found after %s)\n", figures_time(time_by_deadline(r), told_seconds(r)).text);
    return;
  }
  write_figure(out, beside, qtr_objective_figure(beside, qtr_objective_of_score(beside, &score)), told_seconds(r));
  fputs(")\n", out);
}

static void write_verdict(FILE *out, const report *r) {
  const qtr_certificate *c = &r->certificate;
  const uint8_t objective = r->p->in.mission.aim.kind;
  certificate_tell(out, c->certified, c->gap, c->negligible_places);
  if (!c->certified) fprintf(out, " when it ended (%s)", r->ended);
  fputs("; ", out);
  write_figures(out, objective, r);
}

/* What the certificate does not cover, for it is lost in the sum. */
static void write_negligible(FILE *out, const report *r) {
  const int places = r->certificate.negligible_places;
  const qtr_objective_words *words = qtr_objective_in_words(r->p->in.mission.aim.kind);
  if (places == 0) return;
  fprintf(out, "%d of %d places %s up less than %g of it each, and nothing is certified of their order: ", places,
          r->p->in.mission.places, places == 1 ? "makes" : "make", QTR_NEGLIGIBLE);
  fprintf(out, words->fades ? "--objective time, or a gamma nearer 1, covers them\n"
                            : "their weights are too small beside the others'\n");
}

static void write_left_places(FILE *out, const report *r) {
  const naming n = input_naming(&r->p->in);
  uint16_t places[QTR_MAX_PLACES];
  const int count = routes_left_out(places, r->route, &r->p->in.mission);
  const char *nobody = r->units.deadline > 0 ? "nobody searches by the deadline:" : "nobody searches";
  for (int i = 0; i < count; i++)
    fprintf(out, "%s %s%s", i == 0 ? nobody : ",", naming_place(&n, places[i]).text, i + 1 < count ? "" : "\n");
}

/* What the field's terms bring: looks that all miss, steps of so many seconds, places that nobody gets to. */
static void write_terms(FILE *out, const report *r) {
  const pace *p = &r->p->pace;
  if (r->certificate.found < 1.0 - 1e-9 && r->p->in.mission.aim.kind != QTR_DEADLINE)
    fprintf(out, "finds the target with probability %.6g\n", r->certificate.found);
  if (p->stated) fprintf(out, "a step is %.6g s", p->seconds_per_step);
  if (p->stated && p->rounding > 0.0) fprintf(out, ", which rounds travel times by up to %.2g %%", 100.0 * p->rounding);
  if (p->stated) fputc('\n', out);
  write_left_places(out, r);
}

/* What a table for any start or progress loses, and what a stop left out of it. */
static void write_anywhere(FILE *out, const anywhere_report *any, uint64_t seed) {
  if (any->trials > 0)
    fprintf(out,
            "for any start in %s; from %s (seed %" PRIu64 ") it loses %.2g%% (median), %.2g%% (nine tenths), %.2g%% "
            "(worst) against policies learnt for them alone\n",
            counted(any->regions, "region").text, counted((uint64_t)any->trials, "random start").text, seed,
            100.0 * any->median_loss, 100.0 * any->ninety_loss, 100.0 * any->worst_loss);
  if (any->regions < any->regions_meant)
    fprintf(out, "ended (%s) before a table for %s was learnt\n", stop_reason(),
            counted(any->regions_meant, "region").text);
  else if (!any->complete)
    fprintf(out, "ended (%s) with %s learnt for the table; in all others robots go by their rule\n", stop_reason(),
            counted(any->games, "game").text);
}

static void write_text(FILE *out, const void *what) {
  const report *r = what;
  const qtr_mission *mission = &r->p->in.mission;
  const naming n = input_naming(&r->p->in);
  fprintf(out, "%s: %s, %s, %s\n", r->o->input, counted(problem_free_cells(r->p), "free cell").text,
          counted(mission->places, "place").text, counted(mission->seekers, "robot").text);
  write_verdict(out, r);
  write_negligible(out, r);
  if (r->q_bytes > 0 || r->certificate.episodes > 0)
    fprintf(out, "%s, %s, %s (%s), %.3g s\n", counted(r->certificate.episodes, "episode").text,
            counted(r->certificate.updates, "update").text, counted(r->q_entries, "Q entry").text,
            counted(r->q_bytes, "byte").text, r->seconds);
  else
    fprintf(out, "%.3g s\n", r->seconds);
  report_routes(out, r->route, &n, &r->units);
  write_terms(out, r);
  replan_write(out, &r->before, &n, r->route, &r->certificate, r->p);
  if (r->o->output != NULL)
    fprintf(out, "wrote %s: %s, %s\n", r->o->output, counted(r->table_bytes, "byte").text,
            counted(r->table_records, "state").text);
  if (r->anywhere) write_anywhere(out, &r->any, r->o->plan.learner.seed);
  if (r->o->c_output != NULL) fprintf(out, "wrote %s\n", r->o->c_output);
  fit_write(out, &r->fit);
}

int report_write(const report *r, fault *why) {
  return print_report(r->o, write_json, write_text, r, why);
}
