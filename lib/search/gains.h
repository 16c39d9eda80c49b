/* What one seeker alone can still collect, net of prices (C of search/bound.h): worked out for every moment, place,
 * memory (search/near.h) and kind of seekers, from the end of time backwards.
 *
 * Time is cut into slots of some steps, and C is known at the first step of each. In between, without a clock, it is no
 * more than the straight line between the two: every walk's worth is linear in t under expected time, and in gamma^t
 * discounted, so that their greatest is convex. With a clock it is no more than at the slot's first step: worth never
 * rises with time. Past the last slot everything left counts as collected at once. All of it keeps the bound valid and
 * makes it less tight.
 */
#ifndef QUARTER_SEARCH_GAINS_H
#define QUARTER_SEARCH_GAINS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "quarter/config.h"
#include "search/rows.h"
#include "search/ways.h"

/* Bytes of the block that the gains and times of a game take. A game by legs has two tables of times. */
size_t qtr_gains_bytes(const qtr_game *game);

/* At most, for games on a map of QTR_STATIC_PLACES and so many kinds of seekers. */
#define QTR_GAINS_PER_SLOT 3u /* and place, that the block has room for */
#define QTR_GAINS_BYTES(kinds)                                                                                         \
  ((kinds) * (size_t)QTR_STATIC_PLACES *                                                                               \
       (QTR_BOUND_SLOTS * QTR_GAINS_PER_SLOT * sizeof(double) + sizeof(qtr_steps) * QTR_STATIC_NODES +                 \
        sizeof(qtr_gains_way) * QTR_STATIC_PLACES) +                                                                   \
   (size_t)QTR_STATIC_PLACES * QTR_STATIC_PLACES * sizeof(qtr_memory))

/* Get ready in a block of the caller's, qtr_gains_bytes() aligned for a double. The environment must be without
 * regions; it and the block must outlive the gains. Nothing is known before they are filled. */
void qtr_gains_init(qtr_gains *gains, void *block, const qtr_environment *environment);

/* Cut time into slots, by the last visit of a play that is known. */
void qtr_gains_cut(qtr_gains *gains, qtr_steps last_visit);

/* Walks remember one more neighbour of each target, as far as there is room. False: of none. What C was is lost. */
bool qtr_gains_remember_more(qtr_gains *gains);

/* Charge walks for each move from one target to another (search/columns.h): a row of targets for each target, 0 or
 * more, which must outlive the gains. NULL: moves are free, as they are at first. What C was is lost. */
void qtr_gains_charge(qtr_gains *gains, const double *charge);

/* Work C out under the prices of the targets. False: stopped by the mission's watch, and the gains are those of no
 * prices. */
bool qtr_gains_fill(qtr_gains *gains, const double *price);

/* What a seeker's best walk from its start collects; adds up in `visits` how often it comes to each target. */
double qtr_gains_walk(const qtr_gains *gains, unsigned seeker, int *visits);

/* What a walk of a seeker's collects under these prices that goes where most can be collected but to targets in `but`;
 * adds up in `visits` as above. */
double qtr_gains_walk_but(const qtr_gains *gains, unsigned seeker, const qtr_places *but, const double *price,
                          int *visits);

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

/* Where a step lies: in a slot, at its first step (share 0), or so far on the line to the next one. */
typedef struct {
  uint32_t slot;
  double share; /* 0..1 */
} qtr_moment;

/* Slots past the last one are any numbers: qtr_gains_in() knows them for late. */
static inline qtr_moment qtr_gains_when(const qtr_gains *gains, qtr_steps when) {
  qtr_moment moment = {when, 0.0};
  if (gains->slot_steps == 1) return moment;
  moment.slot = when / gains->slot_steps;
  moment.share = qtr_ways_share(gains, moment.slot, when % gains->slot_steps);
  return moment;
}

/* The gains of a kind in a slot, an entry for each place and memory. */
static inline const double *qtr_gains_in(const qtr_gains *gains, unsigned kind, uint32_t slot) {
  return gains->gain + ((size_t)kind * (gains->slots + 1) + (slot < gains->slots ? slot : gains->slots)) * gains->row;
}

/* What a seeker of a kind collects that begins the tour at `place` at step `when`, and remembers so much. */
static inline double qtr_gains_at(const qtr_gains *gains, unsigned kind, unsigned place, qtr_memory memory,
                                  qtr_steps when) {
  const uint32_t entry = gains->entry[place] + memory;
  const qtr_moment moment = qtr_gains_when(gains, when);
  const double here = qtr_gains_in(gains, kind, moment.slot)[entry];
  if (moment.share == 0.0) return here;
  return here + moment.share * (qtr_gains_in(gains, kind, moment.slot + 1)[entry] - here);
}

/* What a move between two targets is charged. */
static inline double qtr_gains_charge_of(const qtr_gains *gains, unsigned from, unsigned to) {
  return gains->charge == NULL ? 0.0 : gains->charge[from * gains->environment->targets.count + to];
}

#endif
