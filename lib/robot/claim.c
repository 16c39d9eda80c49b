#include "quarter/claim.h"

#include "robot/layout.h"

void qtr_claim_read(qtr_claim *claim, const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const uint32_t producer = load32_le(bytes + QTR_POLICY_PRODUCER);
  claim->objective = bytes[QTR_POLICY_OBJECTIVE];
  claim->certified = bytes[QTR_POLICY_CERTIFIED] != 0;
  for (unsigned i = 0; i < 3; i++) claim->version[i] = (uint8_t)(producer >> (16 - 8 * i) & 0xFFu);
  claim->seed = load64_le(bytes + QTR_POLICY_SEED);
  claim->gamma = load64_le(bytes + QTR_POLICY_GAMMA);
  claim->value = load64_le(bytes + QTR_POLICY_VALUE);
  claim->expected_time = load64_le(bytes + QTR_POLICY_TIME);
  claim->bound = load64_le(bytes + QTR_POLICY_BOUND);
  claim->gap = load64_le(bytes + QTR_POLICY_GAP);
}
