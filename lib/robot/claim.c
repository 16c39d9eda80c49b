#include "quarter/claim.h"

#include <stddef.h>

#include "quarter/status.h"
#include "robot/layout.h"

/* All that a robot knows of objectives; the learner's side has the rest (quarter/objective.h). */
static const struct {
  uint8_t figure_at; /* in the header */
  bool less_is_better;
} objectives[] = {{QTR_POLICY_VALUE, false}, {QTR_POLICY_TIME, true}, {QTR_POLICY_FOUND, false}};

/* An objective of a later version is refused and not guessed at: nobody could say what its bound bounds. */
bool qtr_claim_knows(uint8_t objective) {
  return objective < (sizeof objectives / sizeof(objectives[0]));
}

#define DOUBLE_OF_1 0x3FF0000000000000u

/* Without terms all is found, at once and by the last visit. */
static void read_terms(qtr_claim *claim, const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const bool has_terms = (policy->features & (unsigned)QTR_FEATURE_TERMS) != 0u;
  const uint8_t *terms = section_of(policy, SECTION_TERMS);
  claim->found = has_terms ? qtr_load64(bytes + QTR_POLICY_FOUND) : DOUBLE_OF_1;
  claim->findable = has_terms ? qtr_load64(terms + QTR_TERMS_FINDABLE) : DOUBLE_OF_1;
  claim->home_weight = has_terms ? qtr_load64(terms + QTR_TERMS_HOME_WEIGHT) : 0u;
  claim->deadline = has_terms ? qtr_load32(bytes + QTR_POLICY_DEADLINE) : 0u;
  claim->own_places = has_terms ? (uint16_t)qtr_load16(bytes + QTR_POLICY_OWN_PLACES) : policy->board.places;
}

uint32_t qtr_claim_cell_steps(const qtr_policy *policy, unsigned of_class) {
  if (of_class >= qtr_board_classes(&policy->board)) {
    return 0;
  }
  if ((policy->features & (unsigned)QTR_FEATURE_TERMS) == 0u) {
    return 1;
  }
  return qtr_load16(section_of(policy, SECTION_TERMS) + QTR_TERMS_CLASS + (QTR_TERMS_CLASS_BYTES * of_class));
}

/* Nothing here is used in play; it is read anew whenever somebody asks, and takes no room in an open policy. */
void qtr_claim_read(qtr_claim *claim, const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const uint32_t producer = qtr_load32(bytes + QTR_POLICY_PRODUCER);
  /* Of an objective that is none, which only a table has that was not checked, the first is as good as any. */
  claim->objective = qtr_claim_knows(bytes[QTR_POLICY_OBJECTIVE]) ? bytes[QTR_POLICY_OBJECTIVE] : 0;
  claim->less_is_better = objectives[claim->objective].less_is_better;
  claim->certified = bytes[QTR_POLICY_CERTIFIED] != 0u;
  for (unsigned i = 0; i < 3u; i++) {
    claim->version[i] = (uint8_t)((producer >> (16u - (8u * i))) & 0xFFu);
  }
  claim->seed = qtr_load64(bytes + QTR_POLICY_SEED);
  claim->gamma = qtr_load64(bytes + QTR_POLICY_GAMMA);
  claim->value = qtr_load64(bytes + QTR_POLICY_VALUE);
  claim->expected_time = qtr_load64(bytes + QTR_POLICY_TIME);
  read_terms(claim, policy);
  claim->figure = qtr_load64(bytes + objectives[claim->objective].figure_at);
  claim->bound = qtr_load64(bytes + QTR_POLICY_BOUND);
  claim->gap = qtr_load64(bytes + QTR_POLICY_GAP);
  const bool is_whole = is_format_1(policy->format);
  claim->step_time_us = qtr_load32(bytes + QTR_POLICY_STEP_TIME);
  claim->map_columns = is_whole ? policy->grid.columns : (uint16_t)qtr_load16(bytes + QTR_POLICY_MAP_COLUMNS);
  claim->map_rows = is_whole ? policy->grid.rows : (uint16_t)qtr_load16(bytes + QTR_POLICY_MAP_ROWS);
  claim->left = is_whole ? 0 : (uint16_t)qtr_load16(bytes + QTR_POLICY_LEFT);
  claim->top = is_whole ? 0 : (uint16_t)qtr_load16(bytes + QTR_POLICY_TOP);
  const bool has_numbers = (policy->features & QTR_FEATURE_NUMBERS) != 0;
  claim->numbers = has_numbers ? section_of(policy, SECTION_NUMBERS) : NULL;
}

/* Only people see these numbers: robots speak of a table's places by its own. */
unsigned qtr_claim_number(const qtr_claim *claim, const qtr_policy *policy, unsigned place) {
  if ((claim->numbers == NULL) || (place >= policy->board.places)) {
    return place;
  }
  return (unsigned)qtr_load16(claim->numbers + (2u * place));
}
