#include <float.h>
#include <string.h>

#include "aggregate/growing.h"
#include "aggregate/settling.h"
#include "core/block.h"
#include "model/rounding.h"

#define ROUNDS 2 /* of exchanging and dissolving; a third takes a tenth longer for one region less in 500 */

/* Number the regions that are left by their lowest cells: the same division has the same numbers, however it came
 * about. */
static void number(const qtr_division *d) {
  qtr_regions *regions = d->regions;
  qtr_cell *fresh = d->scratch->waiting;         /* the new number, by the old */
  qtr_cell *representative = d->nearby->reached; /* by the old number */
  for (uint32_t region = 0; region < regions->count; region++) fresh[region] = QTR_NO_CELL;
  memcpy(representative, regions->representative, regions->count * sizeof *representative);
  regions->count = 0;
  for (uint32_t cell = 0; cell < d->cells; cell++) {
    const qtr_region old = regions->of[cell];
    /* Every free cell is in a region, and no other. */
    QTR_ASSERT((old == QTR_NO_REGION) == (qtr_grid_cost(d->nearby->grid, (qtr_cell)cell) == 0));
    if (old == QTR_NO_REGION) continue;
    if (fresh[old] == QTR_NO_CELL) {
      fresh[old] = (qtr_cell)regions->count++;
      regions->representative[fresh[old]] = representative[old];
      regions->size[fresh[old]] = 0;
    }
    regions->of[cell] = (qtr_region)fresh[old];
    regions->size[fresh[old]]++;
    /* However cells were moved, no region has more than it may. */
    QTR_ASSERT(regions->size[fresh[old]] <= d->config->max_size);
  }
}

/* The grid and the places; the config itself has been checked. */
static int check_ground(const qtr_grid *grid, const qtr_regions_config *config) {
  const uint32_t cells = qtr_grid_cells(grid);
  if (cells == 0) return QTR_ERR_ARGUMENT;
  if (cells > QTR_MAX_CELLS) return QTR_ERR_LIMIT;
  for (unsigned p = 0; config->likelihood > 0.0 && p < config->places; p++) {
    if (config->place[p] >= cells) return QTR_ERR_PLACE;
    if (!(config->weight[p] > 0.0 && config->weight[p] <= DBL_MAX)) return QTR_ERR_WEIGHT;
  }
  return QTR_OK;
}

/* The public header's size holds what stands in the scratch. */
typedef char scratch_fits[sizeof(qtr_regions_scratch) + QTR_MAX_CELLS * (sizeof(qtr_steps) + 3 * sizeof(qtr_cell) + 6) +
                                      8 * sizeof(uint64_t) <=
                                  QTR_REGIONS_SCRATCH_BYTES
                              ? 1
                              : -1];

/* By the cells there are and not by those there may be: a small map takes little. */
size_t qtr_regions_scratch_bytes(uint32_t cells) {
  return block_piece(sizeof(qtr_regions_scratch)) + qtr_nearby_bytes(cells) + block_piece(cells * sizeof(qtr_cell)) +
         block_piece(cells * sizeof(uint16_t)) + block_piece(cells);
}

const uint16_t *qtr_regions_errors(const void *scratch) {
  return ((const qtr_regions_scratch *)scratch)->error;
}

/* In the order in which the bytes were counted. */
static qtr_regions_scratch *lay_out(void *block, const qtr_grid *grid) {
  const uint32_t cells = qtr_grid_cells(grid);
  uint8_t *left = block;
  qtr_regions_scratch *scratch = block_cut(&left, sizeof *scratch);
  scratch->waiting = block_cut(&left, cells * sizeof *scratch->waiting);
  scratch->error = block_cut(&left, cells * sizeof *scratch->error);
  scratch->changed = block_cut(&left, cells);
  qtr_nearby_init(&scratch->nearby, left, grid);
  return scratch;
}

/* No cell is in a region yet. */
static void begin(const qtr_division *d) {
  d->regions->count = 0;
  d->regions->cells = d->cells;
  for (uint32_t cell = 0; cell < d->cells; cell++) d->regions->of[cell] = QTR_NO_REGION;
  memset(d->scratch->error, 0, d->cells * sizeof *d->scratch->error);
}

/* Grown greedily regions leave crumbs and crooked borders, for what is grown first takes what suits it. Exchanging
 * makes room where dissolving needs it, and the other way round. True medians come last, when nothing moves any
 * more. */
int qtr_regions_build_built(qtr_regions *regions, const qtr_grid *grid, const qtr_regions_config *config, void *block,
                            size_t bytes, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) return QTR_ERR_CONFIG;
  int status = qtr_regions_check(config);
  if (status == QTR_OK) status = check_ground(grid, config);
  if (status == QTR_OK) status = block_check(block, bytes, qtr_regions_scratch_bytes(qtr_grid_cells(grid)));
  if (status != QTR_OK) return status;
  qtr_regions_scratch *scratch = lay_out(block, grid);
  const qtr_division d = {regions, config, scratch, &scratch->nearby, qtr_grid_cells(grid)};
  begin(&d);
  status = qtr_division_grow(&d);
  if (status != QTR_OK) return status;
  qtr_division_follow_medians(&d);
  for (int round = 0; round < ROUNDS; round++) {
    qtr_division_exchange(&d);
    qtr_division_dissolve(&d);
  }
  qtr_division_exchange(&d);
  number(&d);
  for (uint32_t region = 0; region < regions->count && division_may_go_on(&d); region++)
    qtr_division_find_median(&d, (qtr_region)region);
  return division_may_go_on(&d) ? QTR_OK : QTR_ERR_STOPPED;
}
