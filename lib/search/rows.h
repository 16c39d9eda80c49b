/* How C (search/gains.h) stands in the caller's block: for each kind and slot a row, in it the most that is collected
 * from that slot on, wherever, and then the gains of each place, one for each memory. */
#ifndef QUARTER_SEARCH_ROWS_H
#define QUARTER_SEARCH_ROWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "aggregate/environment.h"
#include "quarter/config.h"
#include "search/looks.h"
#include "search/near.h"

/* The way from a tour's first place to the next target's. */
typedef struct {
  uint32_t
      entry;   /* where in a slot the gains stand of a walk that remembers nothing but where it comes from: of several
                      looks the best one's */
  float share; /* and how far the rest of the way reaches on the line to the next slot */
  uint16_t slots;  /* whole ones, up to all that are in use; QTR_NO_WAY */
  uint16_t target; /* of several looks at a place the first one */
} qtr_gains_way;

#define QTR_NO_WAY UINT16_MAX

typedef char qtr_slots_fit_ways[QTR_BOUND_SLOTS < QTR_NO_WAY ? 1 : -1];

typedef struct {
  const qtr_environment *environment;
  const qtr_game *game; /* the environment's */
  uint32_t slots;       /* in use */
  qtr_steps slot_steps; /* steps a slot */
  const double *charge; /* of each move from target to target, a row of targets each; NULL: none */
  uint32_t fillings;    /* begun, and other times that C was lost: while it is the same, so is C */
  bool clocked;         /* what can be collected depends on the clock: nothing between slots is known */
  double slot_fall;     /* discounted: 1 - gamma^slot_steps */
  uint32_t row;         /* gains a slot of a kind */
  uint8_t kinds;
  uint8_t kind_of[QTR_MAX_SEEKERS];  /* 0..kinds-1 */
  uint8_t first_of[QTR_MAX_SEEKERS]; /* of each kind: its first seeker */
  uint32_t entry[QTR_MAX_PLACES];    /* of each place, where its gains stand in a slot: one for each memory */
  qtr_looks looks;
  qtr_near near;
  /* In the caller's block, one after another for each kind. */
  double *gain; /* a row a slot, and one for what is past the last slot */
  qtr_gains_way
      *way;          /* a row of targets a place: ways to other places, the nearest first, then that to the next look */
  qtr_steps *travel; /* a row of places a node: as in the game, unpacked */
  qtr_steps
      *soonest; /* the same by way of other places, where that is sooner; on a map it never is, and these are one */
} qtr_gains;

static inline unsigned gains_places(const qtr_gains *gains) {
  return gains->game->board.places;
}

static inline unsigned gains_targets(const qtr_gains *gains) {
  return gains->environment->targets.count;
}

static inline qtr_gains_way *gains_ways_from(const qtr_gains *gains, unsigned kind, unsigned place) {
  return gains->way + ((size_t)kind * gains_places(gains) + place) * gains_targets(gains);
}

/* The way to the next look at the same place, behind those to the first looks: where there are several, they are
 * fewer. */
static inline qtr_gains_way *gains_way_to_next(const qtr_gains *gains, unsigned kind, unsigned place) {
  return gains_ways_from(gains, kind, place) + gains->looks.firsts;
}

static inline double *gains_row(const qtr_gains *gains, unsigned kind, uint32_t slot) {
  return gains->gain + ((size_t)kind * (gains->slots + 1) + slot) * gains->row;
}

/* The first place of a target's tour from a node; QTR_STAND_DOWN if there is no way. */
static inline uint16_t gains_first_of(const qtr_gains *gains, unsigned node, unsigned target) {
  return qtr_targets_first(&gains->environment->targets, node, target);
}

static inline unsigned gains_target_of(const qtr_gains *gains, unsigned place) {
  return qtr_targets_of(&gains->environment->targets, place);
}

static inline const qtr_tour *gains_tour_at(const qtr_gains *gains, unsigned place) {
  return qtr_targets_tour(&gains->environment->targets, place);
}

/* Ahead of the first of several looks stands the best of all of them, for each memory. */
static inline uint32_t gains_best_ahead(const qtr_gains *gains, unsigned target) {
  return qtr_looks_are_several(&gains->looks, target) ? qtr_near_memories(&gains->near, target) : 0;
}

/* Steps from a node to each place, for a kind. */
static inline qtr_steps *qtr_gains_travel(const qtr_gains *gains, unsigned kind, unsigned node) {
  const size_t places = gains->game->board.places;
  return gains->travel + (kind * (places + gains->game->board.starts) + node) * places;
}

/* Steps after which it can be at each place at the soonest, whatever it visits on the way. */
static inline const qtr_steps *qtr_gains_soonest(const qtr_gains *gains, unsigned kind, unsigned node) {
  const size_t places = gains->game->board.places;
  return gains->soonest + (kind * (places + gains->game->board.starts) + node) * places;
}

#endif
