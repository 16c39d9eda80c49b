#include "robot/layout.h"

#include "quarter/board.h"
#include "quarter/grid.h"
#include "quarter/status.h"
#include "robot/bits.h"

/* A policy has room for as many offsets as there are sections, or this does not compile. */
typedef char sections_are_as_many[(SECTION_NUMBERS + 1 == QTR_POLICY_SECTIONS) ? 1 : -1];

/* A header may claim any number of things, and what they take must not wrap around into a size that fits. The upper
 * half of their count tells: 0xF000 * 2^16 and what the lower half adds to it, of things below 4 kB each, are less than
 * 2^32. */
static uint32_t size_of_all(uint32_t count, uint32_t bytes) {
  return (((count >> 16) * bytes) < 0xF000u) ? (count * bytes) : UINT32_MAX;
}

/* After the classes each seeker's, then ready times, ends with ways home, and looks, as far as there are such. */
static uint32_t size_of_terms(const qtr_policy *policy) {
  const qtr_board *board = &policy->board;
  uint32_t a_seeker = 1;
  if ((policy->terms & (unsigned)QTR_TERM_READY) != 0u) {
    a_seeker += 4u;
  }
  if ((policy->terms & (unsigned)QTR_TERM_END) != 0u) {
    a_seeker += 4u + ((uint32_t)board->step_bytes * board->places);
  }
  uint32_t size = QTR_TERMS_CLASS + (QTR_TERMS_CLASS_BYTES * (uint32_t)qtr_board_classes(board));
  size += a_seeker * board->seekers;
  if ((policy->terms & (unsigned)QTR_TERM_LOOKS) != 0u) {
    size += 2u * (uint32_t)board->places;
  }
  return size;
}

/* A section that a table makes no use of takes no byte. All but the records are so few that their bytes are counted in
 * 32 bits. */
static void find_sizes(uint32_t *size, const qtr_policy *policy) {
  const qtr_board *board = &policy->board;
  const uint32_t cells = qtr_grid_cells(&policy->grid);
  const uint32_t nodes = qtr_board_nodes(board);
  const uint32_t seats = is_format_1(policy->format) ? ((board->seekers + 1u) / 2u * 2u) : board->seekers;
  size[SECTION_SEATS] = 2u * seats;
  size[SECTION_CELLS] = cell_bytes_of(policy->format, cells) * nodes;
  size[SECTION_WEIGHTS] = 4u * board->places;
  size[SECTION_TRAVEL] = size_of_all(board->step_bytes * nodes * board->places, qtr_board_classes(board));
  size[SECTION_RECORDS] = size_of_all(policy->records, policy->records_shape.bytes);
  size[SECTION_GRID] = qtr_grid_size(cells, policy->grid.encoding);
  size[SECTION_REGIONS] = policy->any_start ? (2u * cells) : 0u;
  size[SECTION_CLEARED] = ((policy->features & QTR_FEATURE_CLEARED) != 0) ? bits_size(board->places) : 0u;
  size[SECTION_NUMBERS] = ((policy->features & QTR_FEATURE_NUMBERS) != 0) ? (2u * board->places) : 0u;
  size[SECTION_TERMS] = (QTR_TERMS && ((policy->features & QTR_FEATURE_TERMS) != 0)) ? size_of_terms(policy) : 0u;
}

/* One after another without gaps: bytes are read one by one, so nothing has to be aligned. */
uint32_t qtr_layout_find(qtr_policy *policy) {
  QTR_ASSERT((policy->board.places <= QTR_MAX_PLACES) && (policy->board.starts <= QTR_MAX_STARTS));
  QTR_ASSERT(qtr_grid_cells(&policy->grid) <= QTR_MAX_CELLS);
  find_sizes(policy->at, policy);
  uint32_t end = is_format_1(policy->format) ? QTR_POLICY_HEADER_1 : QTR_POLICY_HEADER_BYTES;
  for (unsigned section = 0; section < QTR_POLICY_SECTIONS; section++) {
    const uint32_t size = policy->at[section];
    policy->at[section] = end;
    end = (size < (UINT32_MAX - end)) ? (end + size) : UINT32_MAX;
  }
  return end;
}
