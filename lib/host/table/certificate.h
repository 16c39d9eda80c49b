/* What the learner said of a table's policy, as numbers of a program with floating point. */
#ifndef QUARTER_HOST_CERTIFICATE_H
#define QUARTER_HOST_CERTIFICATE_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/policy.h"

typedef struct {
  bool by_time; /* the objective is the expected time */
  bool certified;
  double gamma, value, expected_time, bound, gap;
  double figure; /* value or expected time, whichever the objective is */
  uint64_t seed;
  unsigned version[3]; /* of the library that wrote it */
} table_certificate;

table_certificate table_certificate_of(const qtr_policy *policy);

#endif
