#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "exact.h"
#include "host/base/clock.h"
#include "host/base/memory.h"
#include "host/base/outfile.h"
#include "host/base/stop.h"
#include "prepare.h"
#include "report.h"

static const char intro[] =
    "quarter exact minefield.txt --robots 2             the exact optimum, to check a certificate against\n"
    "quarter exact mission.yaml --objective time --json\n"
    "\n"
    "Dynamic programming with transitions of its own: it shares nothing with the learner but the grid and the search\n"
    "for shortest ways. Up to 22 places for one or two robots, 18 for more. With classes, scan times, looks, ready\n"
    "times, endurance, a deadline or coming home: up to 10 looks in all, by up to 4 robots.\n"
    "\n";

static const option_line lines[] = {
    OPTION_LINES_OF_PROBLEM,
    OPTION_LINES_OF_ANSWER,
};

static const char outro[] =
    "\n"
    "Exit status: 0 done; 2 bad input, or more places than this takes; " STATUS_OF_SIGNAL("nothing written");

static const option_set set = {"exact", intro, outro, option_records, lines};

static problem *solved;

static void fill_report(report *r, const exact_solution *solution, const qtr_mission *mission) {
  qtr_certificate *c = &r->certificate;
  c->value = solution->value;
  c->expected_time = solution->expected_time;
  c->found = solution->found_probability;
  c->objective = c->bound = solution->objective;
  c->certified = true;
  c->negligible_places = (uint16_t)solution->negligible;
  for (int seeker = 0; seeker < mission->seekers; seeker++) {
    table_route *route = &r->route[seeker];
    route->places = solution->length[seeker];
    memcpy(route->place, solution->route[seeker], sizeof route->place);
    memcpy(route->step, solution->step[seeker], sizeof route->step);
  }
}

static int solve(const options *o, report *r, fault *why) {
  static exact_solution solution;
  solved = memory_take(sizeof *solved, why);
  if (solved == NULL || prepare_load(solved, o, why) != 0) return -1;
  /* At once, but where places that nobody can reach are yet to be left out. */
  if (!o->plan.reading.skip && exact_check(&solved->in.mission, why) != 0) return -1;
  if (problem_measure(solved, &o->plan, why) != 0) return -1;
  const double begin = clock_seconds();
  *r = (report){.command = "exact", .ended = "certified", .o = o, .p = solved};
  if (exact_solve(&solution, &solved->in.mission, solved->travel, why) != 0) return -1;
  fill_report(r, &solution, &solved->in.mission);
  r->seconds = clock_seconds() - begin;
  routes_measure(&r->units, r->route, solved);
  return report_write(r, why);
}

int command_exact(int argc, char **argv) {
  static options o;
  static report r;
  fault why;
  if (options_parse(&o, &set, argc, argv, &why) != 0) return fault_exit(&why);
  if (o.help) return option_help(stdout, &set);
  stop_at_once();
  return solve(&o, &r, &why) == 0 ? EXIT_SUCCESS : fault_exit(&why);
}
