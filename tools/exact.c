#include "exact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exact_free.h"
#include "exact_paper.h"
#include "exact_terms.h"

static void name_starts(exact_problem *problem, const qtr_mission *mission) {
  problem->starts = 0;
  for (int i = 0; i < problem->seekers; i++) {
    int same = 0;
    while (mission->start[same] != mission->start[i]) same++;
    problem->start_of[i] = same < i ? problem->start_of[same] : problem->starts++;
  }
}

static void normalise(exact_problem *problem, const qtr_mission *mission) {
  double largest = 0, sum = 0;
  for (int p = 0; p < problem->places; p++) largest = fmax(largest, mission->weight[p]);
  for (int p = 0; p < problem->places; p++) sum += mission->weight[p] / largest;
  for (int p = 0; p < problem->places; p++) problem->share[p] = mission->weight[p] / largest / sum;
}

static bool reached_from(const exact_problem *problem, int place, const bool *reached) {
  for (int s = 0; s < problem->starts; s++)
    if (exact_steps(problem, problem->places + s, place) != QTR_NEVER) return true;
  for (int p = 0; p < problem->places; p++)
    if (reached[p] && exact_steps(problem, p, place) != QTR_NEVER) return true;
  return false;
}

static int check_places(const exact_problem *problem, fault *why) {
  bool reached[QTR_MAX_PLACES] = {false};
  for (bool more = true; more;) {
    more = false;
    for (int p = 0; p < problem->places; p++)
      if (!reached[p] && reached_from(problem, p, reached)) reached[p] = more = true;
  }
  for (int p = 0; p < problem->places; p++)
    if (!reached[p])
      return fault_set(why, "exact: no seeker can reach place %d; move it, remove it, or give --skip-unreachable", p);
  return 0;
}

static int check_steps(const exact_problem *problem, fault *why) {
  const size_t entries = (size_t)(problem->places + problem->seekers) * (size_t)problem->places;
  const qtr_steps most = (QTR_NEVER - 1) / (qtr_steps)(problem->places + 1);
  for (size_t e = 0; e < entries; e++)
    if (problem->steps[e] != QTR_NEVER && problem->steps[e] > most)
      return fault_set(why, "exact: a way of %lu steps is too long to add up; use a coarser map",
                       (unsigned long)problem->steps[e]);
  return 0;
}

/* From the routes alone, so that both figures are exact whatever was optimised. */
static void evaluate(exact_solution *solution, const exact_problem *problem) {
  solution->value = 0;
  solution->expected_time = 0;
  for (int i = 0; i < problem->seekers; i++) {
    for (int v = 0; v < solution->length[i]; v++) {
      const int place = solution->route[i][v];
      solution->value += exact_reward(problem, place, solution->step[i][v]);
      solution->expected_time += problem->share[place] * (double)solution->step[i][v];
      solution->look[i][v] = 1;
    }
  }
  solution->found_probability = 1; /* every place is visited */
  solution->objective = problem->discounted ? solution->value : solution->expected_time;
}

static void count_negligible(exact_solution *solution, const exact_problem *problem) {
  for (int i = 0; i < problem->seekers; i++) {
    for (int v = 0; v < solution->length[i]; v++) {
      const int place = solution->route[i][v];
      const double steps = fmax(1, solution->step[i][v]);
      const double part =
          problem->discounted ? exact_reward(problem, place, solution->step[i][v]) : problem->share[place] * steps;
      solution->negligible += part < QTR_NEGLIGIBLE * solution->objective;
    }
  }
}

/* One seeker has nobody to give way to: both rules are the same game. */
static bool by_paper_rule(const qtr_mission *mission) {
  return mission->rule == QTR_RULE_PAPER && mission->seekers > 1;
}

static int check_plain(const qtr_mission *mission, fault *why) {
  const int most = mission->seekers <= 2 ? EXACT_PAIR_PLACES : EXACT_GROUP_PLACES;
  if (by_paper_rule(mission) && mission->places > EXACT_PAPER_PLACES)
    return fault_set(why,
                     "exact: %d places are too many under the paper's rule: it takes %d; use `quarter learn`, or "
                     "--rule free",
                     mission->places, EXACT_PAPER_PLACES);
  if (by_paper_rule(mission) || mission->places <= most) return 0;
  return fault_set(why,
                   "exact: %d places for %d seekers are too many: it takes %d places for 1 or 2 seekers, %d for more; "
                   "use `quarter learn`, which certifies its result too",
                   mission->places, mission->seekers, EXACT_PAIR_PLACES, EXACT_GROUP_PLACES);
}

static bool knows_objective(const qtr_mission *mission) {
  const uint8_t kind = mission->aim.kind;
  return kind == QTR_DISCOUNTED || kind == QTR_TIME || kind == QTR_DEADLINE;
}

int exact_check(const qtr_mission *mission, fault *why) {
  if (!knows_objective(mission)) return fault_set(why, "exact: there is no objective %d", mission->aim.kind);
  return exact_has_terms(mission) ? exact_check_terms(mission, why) : check_plain(mission, why);
}

int exact_solve_plain(exact_solution *solution, const qtr_mission *mission, const qtr_steps *steps, fault *why) {
  exact_problem problem = {.places = mission->places,
                           .seekers = mission->seekers,
                           .discounted = mission->aim.kind == QTR_DISCOUNTED,
                           .gamma = mission->aim.gamma,
                           .steps = steps};
  memset(solution, 0, sizeof *solution);
  if (exact_check(mission, why) != 0) return -1;
  if (exact_has_terms(mission)) return fault_set(why, "exact: the mission has terms that travel times do not tell");
  name_starts(&problem, mission);
  normalise(&problem, mission);
  if (check_places(&problem, why) != 0 || check_steps(&problem, why) != 0) return -1;
  const int status =
      by_paper_rule(mission) ? exact_solve_paper(solution, &problem, why) : exact_solve_free(solution, &problem, why);
  if (status != 0) return status;
  evaluate(solution, &problem);
  count_negligible(solution, &problem);
  return 0;
}

/* Found anew: none of the game's are used. */
static qtr_steps *measure(const qtr_mission *mission, qtr_travel *travel) {
  const qtr_grid grid = qtr_mission_grid(mission);
  const unsigned places = mission->places;
  const unsigned seekers = mission->seekers;
  qtr_steps *steps = malloc(sizeof *steps * (seekers + places) * places);
  for (unsigned to = 0; steps != NULL && to < places; to++) {
    qtr_travel_fill(travel, &grid, mission->place[to]);
    for (unsigned i = 0; i < seekers; i++) steps[i * places + to] = travel->to_go[mission->start[i]];
    for (unsigned from = 0; from < places; from++)
      steps[(seekers + from) * places + to] = travel->to_go[mission->place[from]];
  }
  return steps;
}

int exact_solve(exact_solution *solution, const qtr_mission *mission, qtr_travel *travel, fault *why) {
  memset(solution, 0, sizeof *solution);
  if (exact_check(mission, why) != 0) return -1;
  if (exact_has_terms(mission)) return exact_solve_terms(solution, mission, travel, why);
  qtr_steps *steps = measure(mission, travel);
  const int status = steps != NULL ? exact_solve_plain(solution, mission, steps, why)
                                   : fault_set(why, "exact: no memory for the travel times");
  free(steps);
  return status;
}
