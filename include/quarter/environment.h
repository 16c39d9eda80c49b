/* The environment as the Q-learning unit sees it: the game behind its state aggregation unit (paper, Fig. 5.1).
 *
 * Without aggregation it is the game itself: targets are places, travel times exact, states lossless. With spots a target
 * is a spot, toured without a break; times stay exact. With regions the seekers' cells are seen as regions alone, and
 * travel times are taken from a region's representative, whatever the cell (section 5.2.3), so that they are the same for
 * all of a region. What a policy learnt here is worth is found on the ground, never here.
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
#include "quarter/sight.h"
#include "quarter/target.h"

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

/* QTR_OK; QTR_ERR_ARGUMENT for settings out of their ranges or not from their default; what qtr_spots_check() says of the
 * spots that are asked for. */
int qtr_aggregation_check(const qtr_aggregation *how);

/* Large: keep it in static storage. */
typedef struct {
  const qtr_game *game;
  qtr_targets targets;
  qtr_sight sight;
  qtr_board board;                                   /* the joint game over the targets */
  qtr_key_shape keys;                                /* of what is seen of it */
  uint8_t reach[4 * QTR_MAX_NODES * QTR_MAX_PLACES]; /* the board's travel times: the longest between targets */
} qtr_environment;

/* A moment. */
typedef struct {
  qtr_joint joint;                /* over the targets */
  qtr_steps now;                  /* since the start */
  double unvisited;               /* probability of the places left */
  uint16_t at[QTR_MAX_SEEKERS];   /* idle: the node where it is; on its way: the first place of its tour */
  qtr_walk walk[QTR_MAX_SEEKERS]; /* with regions: where it truly is */
} qtr_situation;

/* Set an environment up over a game. `how` NULL: no aggregation, and the rule is the mission's. `field` is scratch. Game
 * and regions must outlive it. QTR_OK, or an error of qtr_aggregation_check() or qtr_spots_build(); QTR_ERR_UNREACHABLE if a tour has no way;
 * QTR_ERR_CONFIG if the caller was built under other sizes; QTR_ERR_STOPPED by the mission's watch, never without
 * aggregation: the environment is of no use then. */
#define qtr_environment_init(environment, game, how, field)                                                            \
  qtr_environment_init_built(environment, game, how, field, QTR_CONFIG_ID)
int qtr_environment_init_built(qtr_environment *environment, const qtr_game *game, const qtr_aggregation *how,
                               qtr_field *field, uint32_t config_id);

/* The first situation. */
void qtr_environment_start(const qtr_environment *environment, qtr_situation *situation);

/* `seeker`, whose turn it is, makes an allowed choice: a target, or to stand down. Returns the reward of a place at no
 * distance. Nothing happens, and 0, for a seeker or target that is none or has no way. */
double qtr_environment_choose(const qtr_environment *environment, qtr_situation *situation, int seeker,
                              uint16_t choice);

/* Let time pass until somebody is to choose or the game is over (Eq. 4.7). */
void qtr_environment_pass(const qtr_environment *environment, qtr_situation *situation, qtr_outcome *outcome);

/* The key of a situation in the Q-table. */
void qtr_environment_key(const qtr_environment *environment, const qtr_situation *situation, qtr_key *key);

/* Likelihood for a step of the way: a target's, from a node, by exact times; 0 if there is no way, node or target. */
double qtr_environment_rate(const qtr_environment *environment, unsigned node, unsigned target);

/* The place at which the seeker on its way, or idle, will next be free; a node. QTR_STAND_DOWN for a seeker that is none. */
unsigned qtr_environment_exit(const qtr_environment *environment, const qtr_situation *situation, unsigned seeker);

/* Step at which a seeker on its way visits place `i` of its tour, counted from now; 0: visited already, or there is no such
 * seeker or place. */
qtr_steps qtr_environment_visit(const qtr_environment *environment, const qtr_situation *situation, unsigned seeker,
                                unsigned i);

#endif
