/* Families of problems to compare solvers on, each by its seed: random ground, rooms, corridors, and a map as a robot
 * made it. */
#ifndef QUARTER_BENCH_FAMILIES_H
#define QUARTER_BENCH_FAMILIES_H

#include <stdint.h>

#include "field/problem.h"
#include "host/base/fault.h"

enum family { FAMILY_SCATTER, FAMILY_ROOMS, FAMILY_CORRIDORS, FAMILY_FLOOR, FAMILIES };

extern const char *const family_names[FAMILIES + 1]; /* ended by NULL */

typedef struct {
  int family; /* enum family */
  uint32_t seed;
  uint32_t side; /* cells of the ground; the floor has its own */
  uint32_t places, robots;
  uint32_t looks;   /* at each place; with more than one, a look misses one time in five and takes 2 steps */
  uint32_t classes; /* 1; 2: every second robot is half as fast */
  uint32_t stretch; /* steps a cell: all ways so many times as long */
  int objective;    /* enum qtr_objective_kind */
  double gamma;
} family_wish;

/* Robots set out together, in a corner of the scattered ground, anywhere in rooms and on the floor; in corridors each
 * for itself. One place in three has three times the weight. 0, or -1 with *why set. Drop it in any case. */
int problem_of_family(problem_case *made, const family_wish *wish, fault *why);

#endif
