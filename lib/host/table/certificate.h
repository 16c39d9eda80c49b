/* What the learner said of a table's policy, as numbers of a program with floating point. */
#ifndef QUARTER_HOST_CERTIFICATE_H
#define QUARTER_HOST_CERTIFICATE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "quarter/policy.h"

typedef struct {
  uint8_t objective; /* enum qtr_objective_kind */
  bool certified;
  double gamma, value, expected_time, bound, gap;
  double figure;                       /* value, expected time or found, whichever the objective asks for */
  double found, findable, home_weight; /* as quarter/claim.h has them */
  qtr_steps deadline;
  unsigned own_places;
  uint64_t seed;
  unsigned version[3]; /* of the library that wrote it */
} table_certificate;

table_certificate table_certificate_of(const qtr_policy *policy);

/* How near to the optimum a plan is known to be: "certified optimal to 0.001%". `negligible`: places that count for so
 * little that nothing is certified of their order. */
void certificate_tell(FILE *out, bool certified, double gap, int negligible);

#endif
