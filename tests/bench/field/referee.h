/* The referee: what routes are worth, from the plain numbers of a problem and the routes alone, whoever found them. It
 * shares no code with any solver. */
#ifndef QUARTER_BENCH_REFEREE_H
#define QUARTER_BENCH_REFEREE_H

#include "field/problem.h"

#define REFEREE_FAULT 128

/* A route for each robot, one after another: looks in the order in which they are made. */
typedef struct {
  unsigned *length; /* of each robot's */
  unsigned *look;
} plan_routes;

typedef struct {
  bool legal; /* else `fault` says why not, and nothing below counts */
  char fault[REFEREE_FAULT];
  bool complete;        /* every look is made */
  uint64_t arrivals;    /* steps: of all looks, and of all robots that come home */
  double expected_time; /* steps: places' weights, and the ways home, in shares of the places' sum */
  double value;         /* discounted: the sum of 10 P gamma^max(t - 1, 0) */
} verdict;

/* What routes earn in which no look is made twice. What nobody looks at counts as found never: value alone is told
 * then. */
void referee_judge(verdict *v, const plain_problem *p, const plan_routes *routes);

#endif
