#include "prepare.h"

#include "products.h"

int prepare_load(problem *p, const options *o, fault *why) {
  return problem_load(p, o->input, &o->plan, why) == 0 ? products_check(o, why) : -1;
}

int prepare_problem(problem *p, const options *o, fault *why) {
  return prepare_load(p, o, why) == 0 ? problem_measure(p, &o->plan, why) : -1;
}
