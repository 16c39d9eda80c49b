#include "field/compete.h"

#include <stdlib.h>
#include <string.h>

#include "exact.h"
#include "field/families.h"
#include "field/learn.h"
#include "field/problem.h"
#include "field/referee.h"
#include "host/base/json.h"
#include "host/base/memory.h"
#include "host/base/text.h"

#define GAP 1e-5 /* the learner's own default */
#define LINE_MOST 65536

/* ---- the problem ---- */

static void print_numbers(json *j, const char *key, const uint32_t *number, size_t count) {
  json_flat_array(j, key);
  for (size_t i = 0; i < count; i++)
    if (number[i] == PROBLEM_NO_WAY)
      json_null(j, NULL);
    else
      json_natural(j, NULL, number[i]);
  json_end_array(j);
}

static void print_doubles(json *j, const char *key, const double *number, size_t count) {
  json_flat_array(j, key);
  for (size_t i = 0; i < count; i++) json_number(j, NULL, number[i]);
  json_end_array(j);
}

/* A matrix for each class: rows of nodes, columns of looks. */
static void print_steps(json *j, const plain_problem *p) {
  json_array(j, "steps");
  for (unsigned of_class = 0; of_class < p->classes; of_class++) {
    json_array(j, NULL);
    for (unsigned node = 0; node < p->looks + p->starts; node++)
      print_numbers(j, NULL, p->steps + ((size_t)of_class * (p->looks + p->starts) + node) * p->looks, p->looks);
    json_end_array(j);
  }
  json_end_array(j);
}

static void print_problem(json *j, const problem_case *made) {
  const plain_problem *p = &made->plain;
  json_object(j, NULL);
  json_string(j, "name", made->name);
  json_string(j, "objective", p->by_time ? "time" : "discounted");
  json_number(j, "gamma", p->gamma);
  json_natural(j, "looks", p->looks);
  json_natural(j, "places", p->places);
  json_natural(j, "starts", p->starts);
  json_natural(j, "robots", p->robots);
  json_natural(j, "cells", qtr_mission_cells(&made->s->p.in.mission));
  print_numbers(j, "place_of", p->place_of, p->looks);
  print_doubles(j, "weight", p->weight, p->places);
  print_doubles(j, "detection", p->detection, p->places);
  print_numbers(j, "class_of", p->class_of, p->robots);
  print_numbers(j, "start_of", p->start_of, p->robots);
  print_steps(j, p);
  json_end_object(j);
}

/* ---- plans ---- */

static void print_routes(json *j, unsigned robots, const plan_routes *routes) {
  const unsigned *look = routes->look;
  json_flat_array(j, "routes");
  for (unsigned robot = 0; robot < robots; robot++) {
    print_numbers(j, NULL, look, routes->length[robot]);
    look += routes->length[robot];
  }
  json_end_array(j);
}

static void print_point(json *j, const learn_point *point) {
  json_flat_object(j, NULL);
  json_number(j, "seconds", point->seconds);
  json_number(j, "objective", point->certificate.objective);
  json_number(j, "bound", point->certificate.bound);
  json_end_object(j);
}

static int learn(json *j, problem_case *made, const bench_asked *asked, fault *why) {
  const int setting = asked->task == BENCH_PAPER ? QTR_SETTING_PAPER : QTR_SETTING_CERTIFIED;
  learnt l = {0};
  const int status = learn_for(&l, made, setting, GAP, asked->time_limit, why);
  if (status == 0) {
    json_object(j, NULL);
    print_routes(j, made->plain.robots, &l.best);
    json_bool(j, "proved", learnt_end(&l)->certificate.certified);
    json_number(j, "bound", learnt_end(&l)->certificate.bound);
    json_number(j, "seconds", learnt_end(&l)->seconds);
    json_natural(j, "entries", qtr_learner_entries(made->s->learner));
    json_array(j, "points");
    for (unsigned i = 0; i < l.points; i++) print_point(j, &l.point[i]);
    json_end_array(j);
    json_end_object(j);
  }
  learnt_drop(&l);
  return status;
}

/* ---- the exact solver ---- */

/* The node of a place's look, the how many-th from 1. */
static unsigned look_node(const plain_problem *p, unsigned place, unsigned number) {
  for (unsigned look = 0; look < p->looks; look++)
    if (p->place_of[look] == place && --number == 0) return look;
  return p->looks;
}

static int solve(json *j, problem_case *made, fault *why) {
  exact_solution *solution = memory_take(sizeof *solution, why);
  const double begin = learn_clock();
  study *s = made->s;
  int status = solution != NULL ? exact_check(&s->p.in.mission, why) : -1;
  if (status == 0) status = exact_solve(solution, &s->p.in.mission, s->p.travel, why);
  if (status == 0) {
    json_object(j, NULL);
    json_flat_array(j, "routes");
    for (unsigned robot = 0; robot < made->plain.robots; robot++) {
      json_flat_array(j, NULL);
      for (int i = 0; i < solution->length[robot]; i++)
        json_natural(j, NULL, look_node(&made->plain, solution->route[robot][i], solution->look[robot][i]));
      json_end_array(j);
    }
    json_end_array(j);
    json_bool(j, "proved", true);
    json_number(j, "bound", solution->objective);
    json_number(j, "seconds", learn_clock() - begin);
    json_end_object(j);
  }
  free(solution);
  return status;
}

/* ---- the referee ---- */

static void print_verdict(json *j, const verdict *v) {
  json_flat_object(j, NULL);
  json_bool(j, "legal", v->legal);
  if (!v->legal) json_string(j, "fault", v->fault);
  json_bool(j, "complete", v->complete);
  json_natural(j, "arrivals", v->arrivals);
  json_number(j, "expected_time", v->expected_time);
  json_number(j, "value", v->value);
  json_end_object(j);
}

/* A line's looks. What is no number is a look that there is not. */
static unsigned take_line(char *line, unsigned *look, unsigned most) {
  unsigned length = 0;
  for (char *word = strtok(line, " \n"); word != NULL && length < most; word = strtok(NULL, " \n")) {
    long number;
    look[length++] = text_integer(&number, word, strlen(word)) && number >= 0 ? (unsigned)number : UINT32_MAX;
  }
  return length;
}

/* One look more than there are is told as one made twice. */
static bool read_plan(FILE *in, char *line, plan_routes *routes, const plain_problem *p) {
  unsigned all = 0;
  for (unsigned robot = 0; robot < p->robots; robot++) {
    if (fgets(line, LINE_MOST, in) == NULL) return false;
    routes->length[robot] = take_line(line, routes->look + all, p->looks + 1 - all);
    all += routes->length[robot];
  }
  return true;
}

static int judge_all(json *j, FILE *in, const problem_case *made, fault *why) {
  const plain_problem *p = &made->plain;
  char *line = memory_take(LINE_MOST, why);
  plan_routes routes = {memory_take(p->robots * sizeof(unsigned), why),
                        memory_take((p->looks + 1) * sizeof(unsigned), why)};
  const bool ready = line != NULL && routes.length != NULL && routes.look != NULL;
  verdict v;
  if (ready) {
    json_array(j, NULL);
    while (read_plan(in, line, &routes, p)) {
      referee_judge(&v, p, &routes);
      print_verdict(j, &v);
    }
    json_end_array(j);
  }
  free(routes.look);
  free(routes.length);
  free(line);
  return ready ? 0 : -1;
}

static int do_task(json *j, FILE *in, problem_case *made, const bench_asked *asked, fault *why) {
  switch (asked->task) {
  case BENCH_CERTIFIED:
  case BENCH_PAPER: return learn(j, made, asked, why);
  case BENCH_EXACT: return solve(j, made, why);
  case BENCH_JUDGE: return judge_all(j, in, made, why);
  default: print_problem(j, made); return 0;
  }
}

int bench_compete(FILE *in, FILE *out, const bench_asked *asked) {
  static fault why;
  problem_case made;
  json j;
  json_begin(&j, out);
  int status = problem_of_family(&made, &asked->family, &why);
  if (status == 0) status = do_task(&j, in, &made, asked, &why);
  problem_drop(&made);
  return status == 0 ? 0 : bench_fail(&why);
}
