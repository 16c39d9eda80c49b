#include "host/table/certificate.h"

#include <string.h>

#include "quarter/claim.h"
#include "quarter/objective.h"

static double to_double(qtr_double_bits bits) {
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

table_certificate table_certificate_of(const qtr_policy *policy) {
  qtr_claim claim;
  qtr_claim_read(&claim, policy);
  table_certificate c = {.by_time = claim.objective == QTR_TIME,
                         .certified = claim.certified,
                         .gamma = to_double(claim.gamma),
                         .value = to_double(claim.value),
                         .expected_time = to_double(claim.expected_time),
                         .bound = to_double(claim.bound),
                         .gap = to_double(claim.gap),
                         .seed = claim.seed,
                         .version = {claim.version[0], claim.version[1], claim.version[2]}};
  c.figure = c.by_time ? c.expected_time : c.value;
  return c;
}
