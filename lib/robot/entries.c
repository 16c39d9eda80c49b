#include "quarter/policy.h"

#include <stddef.h>

#include "core/bytes.h"
#include "quarter/status.h"
#include "robot/layout.h"

/* Read when it is asked for: a robot that is told its cell has no use for it. A map of format 1 was never turned: those
 * bytes were no part of its header. */
qtr_frame qtr_policy_frame(const qtr_policy *policy) {
  const uint8_t *bytes = policy->bytes;
  const bool can_turn = !is_format_1(policy->format);
  return (qtr_frame){.cell_size_um = qtr_load32(bytes + QTR_POLICY_CELL_SIZE),
                     .origin_x_um = (int64_t)qtr_load64(bytes + QTR_POLICY_ORIGIN_X),
                     .origin_y_um = (int64_t)qtr_load64(bytes + QTR_POLICY_ORIGIN_Y),
                     .cosine = can_turn ? (int32_t)qtr_load32(bytes + QTR_POLICY_COSINE) : 0,
                     .sine = can_turn ? (int32_t)qtr_load32(bytes + QTR_POLICY_SINE) : 0};
}

/* All three answer for any number: they are asked with what comes from poses and radios. */
qtr_cell qtr_policy_cell(const qtr_policy *policy, unsigned node) {
  if (node >= qtr_board_nodes(&policy->board)) {
    return QTR_NO_CELL;
  }
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  const uint8_t bytes = cell_bytes_of(policy->format, cells);
  const uint8_t *at = section_of(policy, SECTION_CELLS) + (bytes * (uint32_t)node);
  const uint32_t cell = (bytes == 2u) ? qtr_load16(at) : qtr_load32(at);
  return (cell < cells) ? (qtr_cell)cell : QTR_NO_CELL;
}

unsigned qtr_policy_place(const qtr_policy *policy, unsigned place) {
  const qtr_board *board = &policy->board;
  if (!QTR_TERMS || (board->terms.look_of == NULL) || (place >= board->places)) {
    return place;
  }
  return (unsigned)qtr_load16(board->terms.look_of + (2u * place));
}

/* A word of a seeker's class tells whether it keeps off rough ground. */
static bool keeps_off_rough(const qtr_policy *policy, unsigned seeker) {
  if (!QTR_TERMS || ((policy->features & QTR_FEATURE_TERMS) == 0) || (seeker >= policy->board.seekers)) {
    return false;
  }
  const uint8_t *classes = section_of(policy, SECTION_TERMS) + QTR_TERMS_CLASS;
  return classes[(QTR_TERMS_CLASS_BYTES * (uint32_t)policy->board.class_of[seeker]) + 2u] != 0u;
}

qtr_grid qtr_policy_ground(const qtr_policy *policy, unsigned seeker) {
  qtr_grid grid = policy->grid;
  if ((grid.encoding == QTR_GRID_BYTES) && keeps_off_rough(policy, seeker)) {
    grid.encoding = QTR_GRID_SMOOTH;
  }
  return grid;
}

/* Likelihoods in units of 2^-32: a robot only compares them. */
uint32_t qtr_policy_weight(const qtr_policy *policy, unsigned place) {
  return (place < policy->board.places) ? qtr_load32(section_of(policy, SECTION_WEIGHTS) + (4u * place)) : 0u;
}

unsigned qtr_policy_region(const qtr_policy *policy, qtr_cell cell) {
  if (!policy->any_start || (cell >= qtr_grid_cells(&policy->grid))) {
    return QTR_POLICY_NO_REGION;
  }
  return (unsigned)qtr_load16(section_of(policy, SECTION_REGIONS) + (2u * (uint32_t)cell));
}
