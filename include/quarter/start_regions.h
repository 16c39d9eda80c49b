/* Regions that starts are told apart by, for tables for any start: the cells of one are about as far from all places.
 *
 * What a search loses by setting out from another cell than it was learnt for is what its travel times to the places
 * differ by. So cells are points, the roots of their likelihood-weighted travel times the coordinates (a step more
 * counts for less where the way is long), and regions are clusters of them: representatives are first spread out, the
 * farthest cell next (Gonzalez 1985), then each moves to the member nearest to its cluster's mean, a few times (Lloyd
 * 1982). Parts of the map that reach other places than one another, for any class of robots, are told apart whatever
 * their number of cells. Cells that nobody gets to any place from are of one region more, the last.
 *
 * Unlike those of quarter/regions.h these are as few as is asked for, and need not be connected.
 */
#ifndef QUARTER_START_REGIONS_H
#define QUARTER_START_REGIONS_H

#include <stddef.h>
#include <stdint.h>

#include "quarter/game.h"
#include "quarter/regions.h"
#include "quarter/travel.h"

QTR_C_BEGIN

/* Bytes of scratch that a game's map takes. */
size_t qtr_start_regions_bytes(const qtr_game *game, uint32_t most);

/* Divide the free cells of a game's map into `most` regions at most, 1..QTR_MAX_REGIONS, by scratch that is aligned as
 * for a uint64_t. As few as it takes, where all cells of each are equally far from all places. The same input gives the
 * same regions. QTR_OK; QTR_ERR_ARGUMENT for no regions or scratch that is not aligned, QTR_ERR_SPACE for too little of
 * it, QTR_ERR_LIMIT where the map falls into more parts than `most`, or they are more than the build holds;
 * QTR_ERR_STOPPED by the mission's watch, QTR_ERR_CONFIG if the caller was built under other sizes. */
#define qtr_start_regions_build(regions, game, most, travel, scratch, bytes)                                           \
  qtr_start_regions_build_built(regions, game, most, travel, scratch, bytes, QTR_CONFIG_ID)
int qtr_start_regions_build_built(qtr_regions *regions, const qtr_game *game, uint32_t most, qtr_travel *travel,
                                  void *scratch, size_t bytes, uint32_t config_id);

QTR_C_END

#endif
