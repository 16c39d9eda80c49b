#include "core/bytes.h"
#include "quarter/status.h"
#include "robot/checks.h"

int qtr_check_nodes(const qtr_policy *policy) {
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  const uint8_t *at = policy->cells;
  for (uint32_t node = 0; node < qtr_board_nodes(&policy->board); node++, at += policy->cell_bytes) {
    if (((policy->cell_bytes == 2u) ? load16_le(at) : load32_le(at)) >= cells) {
      return QTR_ERR_CORRUPT;
    }
  }
  return QTR_OK;
}
