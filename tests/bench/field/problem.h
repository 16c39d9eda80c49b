/* A problem that solvers are compared on: the game that Quarter learns, and the same in plain numbers, for those that
 * share nothing with it. */
#ifndef QUARTER_BENCH_PROBLEM_H
#define QUARTER_BENCH_PROBLEM_H

#include <stdbool.h>
#include <stdint.h>

#include "field/tsplib.h"
#include "host/base/fault.h"
#include "host/plan/study.h"

#define PROBLEM_NAME 128
#define PROBLEM_NO_WAY UINT32_MAX

/* Nodes are the looks (each place's first ones, in the mission's order, then the second ones) and, behind them, the
 * starts. {0} is none. */
typedef struct {
  unsigned looks, starts, robots, classes;
  unsigned *place_of; /* of each look: the place that it is a look at */
  double *weight;     /* of each place, in any unit */
  double *detection;  /* of each place: probability that a look finds what is there */
  unsigned places;    /* that there are */
  unsigned *class_of; /* of each robot */
  unsigned *start_of; /* of each robot: number of its start */
  uint32_t *steps;    /* a matrix for each class: a row of looks for each node, scans included */
  uint32_t *home;     /* a row of looks for each robot: the way home; NULL: nobody comes home */
  bool by_time;       /* the objective: expected time; else discounted value */
  double gamma, home_weight;
} plain_problem;

typedef struct {
  char name[PROBLEM_NAME];
  study *s; /* its mission, and its game */
  plain_problem plain;
} problem_case;

/* What is asked of an instance. */
typedef struct {
  unsigned robots;
  bool comes_home;
  int objective; /* QTR_TIME or QTR_DISCOUNTED */
  double gamma;
} problem_wish;

/* Robots start at the first town, the others are places of weight 1; who comes home counts as a place does. 0, or -1
 * with *why set, by the file `path`. Drop it in any case. */
int problem_of_instance(problem_case *made, const tsplib *instance, const char *path, const problem_wish *wish,
                        fault *why);

/* The plain numbers of the game that stands in made->s. 0, or -1 with *why set. */
int problem_tell(problem_case *made, fault *why);

void problem_drop(problem_case *made);

/* Steps from a node to a look, for robots of a class. */
static inline uint32_t plain_steps(const plain_problem *p, unsigned of_class, unsigned node, unsigned look) {
  return p->steps[((size_t)of_class * (p->looks + p->starts) + node) * p->looks + look];
}

#endif
