#include <stdlib.h>

#include "carray.h"
#include "commands.h"
#include "curve.h"
#include "fit.h"
#include "host/base/outfile.h"
#include "host/base/stop.h"
#include "host/plan/progress.h"
#include "host/plan/study.h"
#include "host/plan/terms.h"
#include "prepare.h"
#include "quarter/export.h"
#include "quarter/status.h"
#include "report.h"

static const char intro[] =
    "quarter learn minefield.txt --robots 2             learn who visits what, print the certificate\n"
    "quarter learn mission.yaml -o mission.qtr          and write the policy table for the robots\n"
    "quarter learn mission.yaml --c mission_policy.c    the same as a C array for firmware\n"
    "quarter learn big.yaml --time-limit 60 --json      the best in a minute, with the gap that is left\n"
    "quarter learn mission.yaml --clear 'Bay 3,7' --without Alpha -o mission.qtr\n"
    "                                                   the rest anew, and what that changes\n"
    "\n"
    "INPUT is a drawing (.txt), a mission (.yaml), or a map that has places. Ctrl-C ends the search and still writes "
    "the\n"
    "best policy found.\n"
    "\n";

static const option_line lines[] = {
    OPTION_LINE("output"),
    OPTION_LINE("c"),
    OPTION_LINE("profile"),
    OPTION_LINES_OF_PROBLEM,
    OPTION_LINE("gap"),
    OPTION_LINE("time-limit"),
    OPTION_LINE("episodes"),
    OPTION_LINE("seed"),
    OPTION_LINE("learner"),
    OPTION_LINE("explore"),
    OPTION_LINE("alpha"),
    OPTION_LINE("aggregate"),
    {"spot-size spot-diameter", "places of a spot, and steps between any two of them (default %s, %s)", 42},
    OPTION_LINE("spot-order"),
    OPTION_LINE("spot-likelihood"),
    {"region-size region-diameter", "cells of a region, and steps between any two of them (default %s, %s)", 44},
    {"region-likelihood", NULL, 44},
    OPTION_LINE("region-times"),
    OPTION_LINE("starts"),
    OPTION_LINE("start-regions"),
    OPTION_LINE("cleared"),
    OPTION_LINE("table-limit"),
    OPTION_LINE("against"),
    OPTION_LINE("curve"),
    OPTION_LINES_OF_REPORT,
};

static const char outro[] =
    "\n"
    "Exit status: 0 done, certified or not; 2 bad input, nothing written; " STATUS_OF_EARLY_END(
        "there\nwas a first ", "best policy written") STATUS_OF_UNFIT("nothing learnt, nothing written");

static const option_set set = {"learn", intro, outro, option_records, lines};

/* Of the time limit, where other starts than the mission's take the rest of it. */
#define SEARCH_SHARE 0.5

static study *learnt;

/* What ends the search after a step, or NULL if it goes on. */
static const char *find_end(enum qtr_learning learning, const options *o, uint64_t episodes) {
  if (learning == QTR_CERTIFIED) return "certified";
  if (learning == QTR_CONVERGED) return "converged";
  if (stop_asked()) return stop_reason();
  return o->episodes > 0 && episodes >= o->episodes ? "episodes" : NULL;
}

static int search(report *r, const options *o, fault *why) {
  progress shown;
  curve course;
  const problem *p = &learnt->p;
  const double seconds = p->pace.stated ? p->pace.seconds_per_step : 0.0;
  if (curve_begin(&course, o->curve, p->in.mission.aim.kind, seconds, why) != 0) return -1;
  progress_begin(&shown, o->quiet, o->time_limit, o->plan.learner.gap);
  while (r->ended == NULL) {
    const enum qtr_learning learning = study_step(learnt);
    qtr_learner_certificate(learnt->learner, &r->certificate);
    progress_show(&shown, &r->certificate, stop_seconds());
    curve_note(&course, learnt->learner, &r->certificate);
    r->ended = find_end(learning, o, r->certificate.episodes);
  }
  progress_end(&shown);
  return curve_end(&course, learnt->learner, &r->certificate, why);
}

static int write_bytes(const char *path, const table *t, bool as_c, fault *why) {
  outfile out;
  if (outfile_open(&out, path, why) != 0) return -1;
  if (as_c)
    carray_write(out.file, path, &t->policy);
  else
    fwrite(t->bytes.data, 1, t->bytes.size, out.file);
  return outfile_commit(&out, why);
}

/* The bytes of the table that the options ask for, newly allocated. Their number, or 0 with *why set. */
static uint32_t make_table(report *r, const options *o, uint8_t **bytes, fault *why) {
  r->anywhere = o->plan.any_starts || o->plan.any_cleared;
  stop_after(o->time_limit);
  if (r->anywhere) return anywhere_learn(learnt, &o->plan, bytes, &r->any, why);
  const uint32_t size = qtr_export_size(learnt->learner);
  *bytes = malloc(size);
  const int32_t written = *bytes != NULL ? qtr_export(learnt->learner, *bytes, size) : QTR_ERR_SPACE;
  if (written > 0) return (uint32_t)written;
  free(*bytes);
  fault_set(why, "no policy table can be made: %s", qtr_strerror(written));
  return 0;
}

/* The table, opened once as a robot will, gives the routes of the report: what is told is what was written. */
static int write_table(report *r, const options *o, fault *why) {
  table t = {.bytes = {NULL, 0}};
  const uint32_t size = make_table(r, o, &t.bytes.data, why);
  if (size == 0) return -1;
  t.bytes.size = size;
  if (table_add_names(&t.bytes, &learnt->p.in.names, &learnt->p.in.geo, why) != 0) {
    table_free(&t);
    return -1;
  }
  const uint32_t whole = (uint32_t)t.bytes.size;
  int status = table_open_bytes(&t);
  if (status != QTR_OK) {
    status = fault_set(why, "the policy table does not open: %s; this is a fault of Quarter's", qtr_strerror(status));
  } else {
    fit_take(&r->fit, &t.policy);
    r->table_bytes = whole;
    r->table_records = t.policy.records;
    table_routes(&t, r->route);
    if (o->output != NULL) status = write_bytes(o->output, &t, false, why);
    if (status == 0 && o->c_output != NULL) status = write_bytes(o->c_output, &t, true, why);
  }
  table_free(&t);
  return status;
}

/* Of what was learnt on, and how large it became. */
static void count(report *r, const options *o) {
  r->regions = aggregate_by_regions(o->plan.aggregate.way) && learnt->aggregated ? learnt->regions->count : 0;
  r->spots =
      aggregate_by_spots(o->plan.aggregate.way) && learnt->aggregated ? qtr_environment_targets(learnt->aggregate) : 0;
  r->q_entries = qtr_learner_entries(learnt->learner);
  r->q_bytes = (uint64_t)r->q_entries * qtr_learner_entry_bytes(learnt->learner);
}

static void note_cramped(void) {
  input *in = &learnt->p.in;
  const int before = in->note.count;
  if (!learnt->cramped) return;
  notes_add(&in->note,
            "%s: there was no memory for more Q entries; what is proven holds, but more memory (ulimit -v) would close "
            "the gap sooner",
            in->path);
  notes_print(&in->note, before);
}

/* What can be known of the table before there is one: robots are told of all of the map where they may start
 * anywhere. */
static int foresee_fit(fit *f, const options *o, fault *why) {
  const qtr_game *game = learnt->p.game;
  const qtr_mission *mission = game->mission;
  const bool anywhere = o->plan.any_starts || o->plan.any_cleared;
  const qtr_box box = anywhere ? (qtr_box){0, 0, mission->columns, mission->rows} : game->used;
  f->needed.of[ROBOT_CELLS] = (uint32_t)(box.right - box.left) * (uint32_t)(box.bottom - box.top);
  f->needed.of[ROBOT_PLACES] = game->board.places;
  f->needed.of[ROBOT_SEEKERS] = game->board.seekers;
  return fit_check(f, o->input, why);
}

/* All that is read and refused before anything is learnt. */
static int prepare(const options *o, report *r, fault *why) {
  if (fit_begin(&r->fit, o->profile, why) != 0 || replan_begin(&r->before, o->against, o->output, why) != 0) return -1;
  if (prepare_problem(&learnt->p, o, why) != 0) return -1;
  return foresee_fit(&r->fit, o, why);
}

static int learn(const options *o, report *r, fault *why) {
  stop_after(o->time_limit);
  learnt = study_take(why);
  *r = (report){.command = "learn", .o = o};
  if (learnt == NULL || prepare(o, r, why) != 0) return -1;
  stop_after(o->time_limit * (o->plan.any_starts || o->plan.any_cleared ? SEARCH_SHARE : 1.0));
  const double begin = stop_seconds();
  if (study_begin(learnt, &o->plan, why) != 0) return -1;
  r->p = &learnt->p;
  if (search(r, o, why) != 0) return -1;
  note_cramped();
  r->seconds = stop_seconds() - begin + learnt->p.travel_seconds;
  count(r, o);
  if (write_table(r, o, why) != 0) return -1;
  routes_to_mission(r->route, learnt->p.game);
  routes_measure(&r->units, r->route, &learnt->p);
  return report_write(r, why);
}

int command_learn(int argc, char **argv) {
  static options o;
  static report r;
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_begin();
  if (learn(&o, &r, &why) != 0) return fault_exit(&why);
  return stop_signal() != 0 ? 128 + stop_signal() : EXIT_SUCCESS;
}
