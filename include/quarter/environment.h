/* The environment as the Q-learning unit sees it: the game behind its state aggregation unit (paper, Fig. 5.1).
 *
 * Without aggregation it is the game itself: targets are places, travel times exact, states lossless. With spots a
 * target is a spot, toured without a break; times stay exact. With regions the seekers' cells are seen as regions
 * alone, and travel times are taken from a region's representative, whatever the cell (section 5.2.3), so that they are
 * the same for all of a region. What a policy learnt here is worth is found on the ground, never here.
 *
 * Idle seekers choose by the joint game's rules, over targets instead of places.
 */
#ifndef QUARTER_ENVIRONMENT_H
#define QUARTER_ENVIRONMENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/game.h"
#include "quarter/regions.h"
#include "quarter/spots.h"

QTR_C_BEGIN

/* The aggregation unit's settings. */
typedef struct {
  uint32_t made; /* by qtr_aggregation_default() */
  uint8_t rule;  /* enum qtr_rule, by which targets are chosen */
  bool by_spots;
  qtr_spots_config spots;
  uint8_t spot_order;         /* enum qtr_spot_order */
  const qtr_regions *regions; /* NULL: cells are exact. Must outlive the environment */
  uint8_t region_times;       /* enum qtr_region_times */
} qtr_aggregation;

/* Nothing aggregated, free rule; spots, were they asked for, by their default and in their best order. */
void qtr_aggregation_default(qtr_aggregation *how);

/* QTR_OK; QTR_ERR_ARGUMENT for settings out of their ranges or not from their default; what qtr_spots_check() says of
 * the spots that are asked for. */
int qtr_aggregation_check(const qtr_aggregation *how);

/* Stands in a block of the caller's, and lives as long as that. */
typedef struct qtr_environment qtr_environment;

/* Bytes of the block that an environment over a game takes; with regions, which are divided already, that is most of
 * it. `how` NULL: no aggregation. */
size_t qtr_environment_bytes(const qtr_game *game, const qtr_aggregation *how);

/* At most, for blocks in static storage (QTR_STATIC_PLACES): without aggregation, with spots, and with regions
 * besides. */
#define QTR_STATIC_NODES (QTR_STATIC_PLACES + QTR_MAX_SEEKERS)
#define QTR_ENVIRONMENT_GROUND_BYTES                                                                                   \
  (sizeof(qtr_board) + 2 * sizeof(qtr_spots) + sizeof(qtr_spot_scratch) +                                              \
   (size_t)QTR_MAX_PLACES * (8 * QTR_MAX_SPOT_SIZE + 2 * QTR_MAX_NODES + 16) + 256)
#define QTR_ENVIRONMENT_BYTES (QTR_ENVIRONMENT_GROUND_BYTES + (size_t)QTR_STATIC_PLACES * 4 * QTR_STATIC_NODES)
#define QTR_ENVIRONMENT_REGIONS_BYTES                                                                                  \
  (QTR_ENVIRONMENT_BYTES +                                                                                             \
   (size_t)QTR_STATIC_PLACES * (sizeof(qtr_steps) * QTR_STATIC_REGIONS + (QTR_STATIC_CELLS + 3) / 4))

/* Set an environment up over a game, in a block of so many bytes, aligned as for a uint64_t. `how` NULL: no
 * aggregation, and the rule is the mission's. `travel` is scratch. Game, regions and block must outlive it. QTR_OK, and
 * then alone `*environment` is set; QTR_ERR_SPACE for a block of fewer bytes than qtr_environment_bytes(),
 * QTR_ERR_ARGUMENT for one that is not aligned; an error of qtr_aggregation_check() or qtr_spots_build();
 * QTR_ERR_UNREACHABLE if a tour has no way; QTR_ERR_CONFIG if the caller was built under other sizes; QTR_ERR_STOPPED
 * by the mission's watch, never without aggregation. */
#define qtr_environment_init(environment, block, bytes, game, how, travel)                                             \
  qtr_environment_init_built(environment, block, bytes, game, how, travel, QTR_CONFIG_ID)
int qtr_environment_init_built(qtr_environment **environment, void *block, size_t bytes, const qtr_game *game,
                               const qtr_aggregation *how, qtr_travel *travel, uint32_t config_id);

/* How many targets there are to choose from: places, or spots. */
unsigned qtr_environment_targets(const qtr_environment *environment);

QTR_C_END

#endif
