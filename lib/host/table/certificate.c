#include "host/table/certificate.h"

#include <string.h>

#include "quarter/claim.h"

static double to_double(qtr_double_bits bits) {
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

table_certificate table_certificate_of(const qtr_policy *policy) {
  qtr_claim claim;
  qtr_claim_read(&claim, policy);
  const table_certificate c = {.objective = claim.objective,
                               .certified = claim.certified,
                               .gamma = to_double(claim.gamma),
                               .value = to_double(claim.value),
                               .expected_time = to_double(claim.expected_time),
                               .figure = to_double(claim.figure),
                               .bound = to_double(claim.bound),
                               .gap = to_double(claim.gap),
                               .seed = claim.seed,
                               .version = {claim.version[0], claim.version[1], claim.version[2]}};
  return c;
}
