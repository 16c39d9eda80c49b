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
#include "quarter/spots.h"

/* Where the travel times of a seeker seen in a region are taken from. */
enum qtr_region_times {
  QTR_TIMES_STANDING = 0, /* the region's representative: alike for all of the region (section 5.2.3) */
  QTR_TIMES_TRUE =
      1 /* the seeker's own cell: the section's first solution, whose Q may go to and fro. To show just that */
};

typedef struct {
  uint8_t rule; /* enum qtr_rule, by which targets are chosen */
  bool by_spots;
  qtr_spots_config spots;
  uint8_t spot_order;         /* enum qtr_spot_order */
  const qtr_regions *regions; /* NULL: cells are exact. Must outlive the environment */
  uint8_t region_times;       /* enum qtr_region_times */
} qtr_aggregation;

/* What a seeker does that has come to a place: the rest of the target's tour, which depends on nothing else. */
typedef struct {
  uint16_t target;
  uint8_t places;                    /* this one included */
  uint16_t place[QTR_MAX_SPOT_SIZE]; /* in the order of the visits; the last one is the exit */
  qtr_steps step[QTR_MAX_SPOT_SIZE]; /* of each visit, from the first on */
} qtr_tour;

/* Large: keep it in static storage. */
typedef struct {
  const qtr_game *game;
  const qtr_regions *regions;
  bool estimating;    /* times are the representatives' */
  qtr_board board;    /* the joint game over the targets */
  qtr_key_shape keys; /* of what is seen of it */
  uint16_t targets;
  qtr_tour tour[QTR_MAX_PLACES];                  /* by the first place visited */
  uint16_t first[QTR_MAX_NODES * QTR_MAX_PLACES]; /* of the target's places, from a node: a row of targets a node */
  qtr_spots spots;
  uint8_t reach[4 * QTR_MAX_NODES * QTR_MAX_PLACES];    /* the board's travel times: the longest between targets */
  qtr_steps estimate[QTR_MAX_REGIONS * QTR_MAX_PLACES]; /* from a region's representative to each place */
  uint8_t way[(size_t)QTR_MAX_PLACES * ((QTR_MAX_CELLS + 3) / 4)]; /* to each place, the direction from each cell */
  qtr_spots spots_scratch;
  qtr_spot_scratch tour_scratch;
} qtr_environment;

/* A moment. */
typedef struct {
  qtr_joint joint;                    /* over the targets */
  qtr_steps now;                      /* since the start */
  double unvisited;                   /* probability of the places left */
  uint16_t at[QTR_MAX_SEEKERS];       /* idle: the node where it is; on its way: the first place of its tour */
  uint8_t stage[QTR_MAX_SEEKERS];     /* with regions: how many places of its tour it has passed */
  qtr_cell cell[QTR_MAX_SEEKERS];     /* with regions: where it truly is */
  qtr_steps carried[QTR_MAX_SEEKERS]; /* with regions: steps spent on entering the next cell */
} qtr_situation;

/* Set an environment up over a game. `how` NULL: no aggregation, and the rule is the mission's. `field` is scratch. Game
 * and regions must outlive it. QTR_OK, or an error of qtr_spots_build(); QTR_ERR_UNREACHABLE if a tour has no way;
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
