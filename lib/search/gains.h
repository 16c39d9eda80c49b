/* What one seeker alone can still collect, net of prices (C of search/bound.h): worked out for every moment, place and
 * kind of seekers, from the end of time backwards.
 *
 * Time is cut into slots. Worth falls with time, so C at a slot's first step is good for the whole slot; past the last
 * slot everything left counts as collected at once. Both keep the bound valid and make it less tight.
 */
#ifndef QUARTER_SEARCH_GAINS_H
#define QUARTER_SEARCH_GAINS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "aggregate/environment.h"
#include "quarter/config.h"

/* What a walk that comes to a place, the first of a target's tour, can collect, the tour included; and the target that
 * it goes on to. */
typedef struct {
  double best;    /* the best way on */
  double second;  /* the best way on to any other target */
  uint16_t to;    /* where the best goes on to; QTR_STAND_DOWN: it ends here */
  uint16_t other; /* where the second goes on to */
} qtr_gain;

typedef struct {
  const qtr_environment *environment;
  const qtr_game *game; /* the environment's */
  uint32_t slots;       /* in use */
  qtr_steps slot_steps; /* steps a slot */
  uint8_t kinds;
  uint8_t kind_of[QTR_MAX_SEEKERS];  /* 0..kinds-1 */
  uint8_t first_of[QTR_MAX_SEEKERS]; /* of each kind: its first seeker */
  /* In the caller's block, one after another for each kind. */
  qtr_gain *gain;        /* a row of places a slot */
  double *late;          /* of each place: gains past the last slot */
  qtr_steps *travel;     /* a row of places a node: as in the game, unpacked */
  uint32_t *slots_apart; /* a row of targets a place: from a tour's first place to the next target's, in slots */
} qtr_gains;

/* Bytes of the block that the gains and times of a game take. */
size_t qtr_gains_bytes(const qtr_game *game);

/* At most, for games of so many kinds of seekers. */
#define QTR_GAINS_BYTES(kinds)                                                                                         \
  ((kinds) * (size_t)QTR_MAX_PLACES *                                                                                  \
   (QTR_BOUND_SLOTS * sizeof(qtr_gain) + sizeof(double) + sizeof(qtr_steps) * QTR_MAX_NODES +                          \
    sizeof(uint32_t) * QTR_MAX_PLACES))

/* Get ready in a block of the caller's, qtr_gains_bytes() aligned for a qtr_gain. The environment must be without
 * regions; it and the block must outlive the gains. Nothing is known before they are filled. */
void qtr_gains_init(qtr_gains *gains, void *block, const qtr_environment *environment);

/* Cut time into slots, by the last visit of a play that is known. */
void qtr_gains_cut(qtr_gains *gains, qtr_steps last_visit);

/* Work C out under the prices of the targets. False: stopped by the mission's watch, and the gains are those of no
 * prices. */
bool qtr_gains_fill(qtr_gains *gains, const double *price);

/* What a seeker's best walk from its start collects; adds up in `visits` how often it comes to each target. */
double qtr_gains_walk(const qtr_gains *gains, unsigned seeker, int *visits);

/* What going home from a node (QTR_STAND_DOWN: from wherever it is least) costs a seeker of a kind at step `when`: 0 or
 * less. */
double qtr_gains_go_home(const qtr_gains *gains, unsigned kind, unsigned node, qtr_steps when);

/* Of games with an end: whether a seeker of a kind is home by its own that ends a tour at `exit` at step `when`. */
bool qtr_gains_before_end(const qtr_gains *gains, unsigned kind, unsigned exit, qtr_steps when);

/* ---- the innermost of the learner's loops ---- */

/* Whether a seeker of a kind is home in time that ends a tour at `exit` at step `when`. */
static inline bool qtr_gains_in_time(const qtr_gains *gains, unsigned kind, unsigned exit, qtr_steps when) {
  return gains->game->board.terms.end == NULL || qtr_gains_before_end(gains, kind, exit, when);
}

/* The gains of one kind, found once for many questions. */
typedef struct {
  const qtr_gain *gain; /* a row of places a slot */
  const double *late;   /* of each place */
  size_t places;
  uint32_t slots;
  qtr_steps slot_steps;
} qtr_gains_view;

static inline qtr_gains_view qtr_gains_of(const qtr_gains *gains, unsigned kind) {
  const size_t places = gains->game->board.places;
  const qtr_gains_view view = {gains->gain + (size_t)kind * gains->slots * places, gains->late + kind * places, places,
                               gains->slots, gains->slot_steps};
  return view;
}

/* What a walk from target `from` (QTR_STAND_DOWN: none) collects that begins the tour at `place` in `slot`: it may not
 * go straight back. Walks may repeat targets, which real ones cannot, and the worst of that is to and fro between two:
 * with the best way on and the best one to another target kept, C is known for every `from` at no more work than for
 * none. */
static inline double qtr_gains_in_slot(const qtr_gains_view *view, unsigned from, unsigned place, uint32_t slot) {
  if (slot >= view->slots) return view->late[place];
  const qtr_gain *gain = &view->gain[(size_t)slot * view->places + place];
  return gain->to == from ? gain->second : gain->best;
}

/* The same at step `when`. A slot is known by its first step, when its walks can collect most: worth never rises with
 * time. */
static inline double qtr_gains_at(const qtr_gains_view *view, unsigned from, unsigned place, qtr_steps when) {
  return qtr_gains_in_slot(view, from, place, view->slot_steps == 1 ? when : when / view->slot_steps);
}

/* Steps from a node to each place, for a kind. */
static inline qtr_steps *qtr_gains_travel(const qtr_gains *gains, unsigned kind, unsigned node) {
  const size_t places = gains->game->board.places;
  return gains->travel + (kind * (places + gains->game->board.starts) + node) * places;
}

#endif
