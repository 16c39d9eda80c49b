#include "quarter/policy.h"

#include <stddef.h>

#include "core/bytes.h"
#include "quarter/status.h"

/* All three answer for any number: they are asked with what comes from poses and radios. */
qtr_cell qtr_policy_cell(const qtr_policy *policy, unsigned node) {
  if (node >= qtr_board_nodes(&policy->board)) {
    return QTR_NO_CELL;
  }
  const uint8_t *at = policy->cells + (policy->cell_bytes * (uint32_t)node);
  const uint32_t cell = (policy->cell_bytes == 2u) ? load16_le(at) : load32_le(at);
  QTR_ASSERT(cell < qtr_grid_cells(&policy->grid)); /* as it was when the table was opened */
  return (qtr_cell)cell;
}

/* Likelihoods in units of 2^-32: a robot only compares them. */
uint32_t qtr_policy_weight(const qtr_policy *policy, unsigned place) {
  return (place < policy->board.places) ? load32_le(policy->weights + (4u * place)) : 0u;
}

unsigned qtr_policy_region(const qtr_policy *policy, qtr_cell cell) {
  if ((policy->regions == NULL) || (cell >= qtr_grid_cells(&policy->grid))) {
    return QTR_POLICY_NO_REGION;
  }
  return (unsigned)load16_le(policy->regions + (2u * (uint32_t)cell));
}
