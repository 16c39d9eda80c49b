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
    "Dynamic programming over the subsets of the places, with transitions of its own: it shares nothing with the "
    "learner\n"
    "but the grid and the travel times. Up to 22 places for one or two robots, 18 for more.\n"
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

/* Travel times from each seeker's start and each place to each place, found anew: none of the game's are used. */
static qtr_steps *measure(problem *p) {
  const qtr_mission *mission = &p->in.mission;
  const qtr_grid grid = qtr_mission_grid(mission);
  const unsigned places = mission->places;
  const unsigned seekers = mission->seekers;
  qtr_steps *steps = malloc(sizeof *steps * (seekers + places) * places);
  for (unsigned to = 0; steps != NULL && to < places; to++) {
    qtr_travel_fill(&p->travel, &grid, mission->place[to]);
    for (unsigned i = 0; i < seekers; i++) steps[i * places + to] = p->travel.to_go[mission->start[i]];
    for (unsigned from = 0; from < places; from++)
      steps[(seekers + from) * places + to] = p->travel.to_go[mission->place[from]];
  }
  return steps;
}

static void fill_report(report *r, const exact_solution *solution, const qtr_mission *mission) {
  qtr_certificate *c = &r->certificate;
  const uint8_t kind = mission->aim.kind;
  const qtr_score score = {.value = solution->value, .expected_time = solution->expected_time};
  c->value = score.value;
  c->expected_time = score.expected_time;
  c->objective = c->bound = qtr_objective_figure(kind, qtr_objective_of_score(kind, &score));
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
  qtr_steps *steps = measure(solved);
  const int status = steps != NULL ? exact_solve(&solution, &solved->in.mission, steps, why)
                                   : fault_set(why, "%s: no memory for the travel times", o->input);
  free(steps);
  if (status != 0) return -1;
  fill_report(r, &solution, &solved->in.mission);
  r->seconds = clock_seconds() - begin;
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
