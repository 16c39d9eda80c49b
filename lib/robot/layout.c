#include "robot/layout.h"

#include "quarter/board.h"
#include "quarter/grid.h"
#include "quarter/status.h"
#include "robot/bits.h"

/* A section that a table makes no use of takes no byte. */
static bool has(const table_dimensions *d, uint32_t feature) {
  return (d->features & feature) != 0u;
}

/* Of what there is one for each seeker or place. */
static uint32_t size_by_places(const table_dimensions *d, enum section section) {
  switch (section) {
  case SECTION_SEATS: return (d->format == 1u) ? ((d->seekers + 1u) / 2u * 4u) : (2u * d->seekers);
  case SECTION_WEIGHTS: return 4u * (uint32_t)d->places;
  case SECTION_CLEARED: return has(d, QTR_FEATURE_CLEARED) ? bits_size(d->places) : 0u;
  case SECTION_NUMBERS: return has(d, QTR_FEATURE_NUMBERS) ? (2u * d->places) : 0u;
  default: return 0;
  }
}

/* In 64 bits: a header may claim any number of records, and what they take must not wrap around into a size that fits. */
static uint64_t size_of(const table_dimensions *d, enum section section) {
  const uint32_t nodes = (uint32_t)d->places + d->starts;
  switch (section) {
  case SECTION_CELLS: return (uint32_t)cell_bytes_of(d->format, d->cells) * nodes;
  case SECTION_TRAVEL: return (uint32_t)d->step_bytes * nodes * d->places;
  case SECTION_RECORDS: return (uint64_t)d->records * d->record_bytes;
  case SECTION_GRID: return qtr_grid_size(d->cells, d->grid_encoding);
  case SECTION_REGIONS: return d->any_start ? (2u * d->cells) : 0u;
  default: return size_by_places(d, section);
  }
}

/* One after another without gaps: bytes are read one by one, so nothing has to be aligned. */
void qtr_layout_find(table_layout *layout, const table_dimensions *dimensions) {
  /* So few that each section but the records is less than 2^32 bytes. */
  QTR_ASSERT((dimensions->places <= QTR_MAX_PLACES) && (dimensions->starts <= QTR_MAX_STARTS));
  QTR_ASSERT(dimensions->cells <= QTR_MAX_CELLS);
  layout->end = (dimensions->format == 1u) ? QTR_POLICY_HEADER_1 : QTR_POLICY_HEADER_BYTES;
  for (unsigned section = 0; section < SECTIONS; section++) {
    layout->at[section] = (uint32_t)(layout->end & 0xFFFFFFFFu);
    layout->end += size_of(dimensions, (enum section)section);
  }
}
