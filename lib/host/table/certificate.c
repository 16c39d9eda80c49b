#include "host/table/certificate.h"

#include <math.h>
#include <string.h>

#include "quarter/claim.h"
#include "quarter/objective.h"

#define OPTIMAL 1e-5 /* the gap up to which a certified plan is told as optimal: --gap's default */

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
                               .found = to_double(claim.found),
                               .findable = to_double(claim.findable),
                               .home_weight = to_double(claim.home_weight),
                               .deadline = claim.deadline,
                               .own_places = claim.own_places,
                               .bound = to_double(claim.bound),
                               .gap = to_double(claim.gap),
                               .seed = claim.seed,
                               .version = {claim.version[0], claim.version[1], claim.version[2]}};
  return c;
}

void certificate_tell(FILE *out, bool certified, double gap, int negligible) {
  const bool optimal = certified && gap <= OPTIMAL && negligible == 0;
  if (optimal && gap < QTR_NEGLIGIBLE)
    fprintf(out, "certified optimal");
  else if (certified)
    fprintf(out, optimal ? "certified optimal to %.2g%%" : "certified: within %.2g%% of the optimum",
            100.0 * fmax(gap, QTR_NEGLIGIBLE));
  else
    fprintf(out, "not certified: at most %.3g%% from the optimum", 100.0 * gap);
}
