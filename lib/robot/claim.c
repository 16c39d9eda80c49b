#include "quarter/claim.h"

#include <stddef.h>

#include "quarter/status.h"
#include "robot/layout.h"

/* All that a robot knows of objectives; the learner's side has the rest (quarter/objective.h). */
static const struct {
  uint8_t figure_at; /* in the header */
  bool less_is_better;
} objectives[] = {{QTR_POLICY_VALUE, false}, {QTR_POLICY_TIME, true}};

/* An objective of a later version is refused and not guessed at: nobody could say what its bound bounds. */
bool qtr_claim_knows(uint8_t objective) {
  return objective < (sizeof objectives / sizeof(objectives[0]));
}

/* Nothing here is used in play; it is read anew whenever somebody asks, and takes no room in an open policy. */
void qtr_claim_read(qtr_claim *claim, const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const uint32_t producer = load32_le(bytes + QTR_POLICY_PRODUCER);
  QTR_ASSERT(qtr_claim_knows(bytes[QTR_POLICY_OBJECTIVE])); /* as opening sees to */
  claim->objective = bytes[QTR_POLICY_OBJECTIVE];
  claim->less_is_better = objectives[claim->objective].less_is_better;
  claim->certified = bytes[QTR_POLICY_CERTIFIED] != 0u;
  for (unsigned i = 0; i < 3u; i++) {
    claim->version[i] = (uint8_t)((producer >> (16u - (8u * i))) & 0xFFu);
  }
  claim->seed = load64_le(bytes + QTR_POLICY_SEED);
  claim->gamma = load64_le(bytes + QTR_POLICY_GAMMA);
  claim->value = load64_le(bytes + QTR_POLICY_VALUE);
  claim->expected_time = load64_le(bytes + QTR_POLICY_TIME);
  claim->figure = load64_le(bytes + objectives[claim->objective].figure_at);
  claim->bound = load64_le(bytes + QTR_POLICY_BOUND);
  claim->gap = load64_le(bytes + QTR_POLICY_GAP);
  const bool is_whole = policy->format == 1u;
  claim->step_time_us = load32_le(bytes + QTR_POLICY_STEP_TIME);
  claim->map_columns = is_whole ? policy->grid.columns : (uint16_t)load16_le(bytes + QTR_POLICY_MAP_COLUMNS);
  claim->map_rows = is_whole ? policy->grid.rows : (uint16_t)load16_le(bytes + QTR_POLICY_MAP_ROWS);
  claim->left = is_whole ? 0 : (uint16_t)load16_le(bytes + QTR_POLICY_LEFT);
  claim->top = is_whole ? 0 : (uint16_t)load16_le(bytes + QTR_POLICY_TOP);
  const bool has_numbers = (load32_le(bytes + QTR_POLICY_FEATURES) & QTR_FEATURE_NUMBERS) != 0u;
  /* The last section. */
  claim->numbers = has_numbers ? (bytes + policy->size - (2u * policy->board.places)) : NULL;
}

/* Only people see these numbers: robots speak of a table's places by its own. */
unsigned qtr_claim_number(const qtr_claim *claim, const qtr_policy *policy, unsigned place) {
  if ((claim->numbers == NULL) || (place >= policy->board.places)) {
    return place;
  }
  return (unsigned)load16_le(claim->numbers + (2u * place));
}
