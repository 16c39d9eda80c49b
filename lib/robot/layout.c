#include "robot/layout.h"

#include "quarter/board.h"
#include "quarter/grid.h"
#include "quarter/status.h"

static uint64_t size_of(const table_dimensions *d, enum section section) {
  const uint32_t nodes = (uint32_t)d->places + d->starts;
  switch (section) {
  case SECTION_SEATS: return (d->seekers + 1u) / 2u * 4u;
  case SECTION_CELLS: return 4u * nodes;
  case SECTION_WEIGHTS: return 4u * (uint32_t)d->places;
  case SECTION_TRAVEL: return 4u * nodes * d->places;
  case SECTION_RECORDS: return (uint64_t)d->records * record_size(d->key_words);
  case SECTION_GRID: return qtr_grid_size(d->cells, d->grid_encoding);
  case SECTION_REGIONS: return d->any_start ? 2u * d->cells : 0;
  default: return 0;
  }
}

void qtr_layout_find(table_layout *layout, const table_dimensions *dimensions) {
  /* So few that each section but the records is less than 2^32 bytes. */
  QTR_ASSERT(dimensions->places <= QTR_MAX_PLACES && dimensions->starts <= QTR_MAX_STARTS);
  QTR_ASSERT(dimensions->cells <= QTR_MAX_CELLS);
  layout->end = QTR_POLICY_HEADER_BYTES;
  for (unsigned section = 0; section < SECTIONS; section++) {
    layout->at[section] = (uint32_t)(layout->end & 0xFFFFFFFFu);
    layout->end += size_of(dimensions, (enum section)section);
  }
}
