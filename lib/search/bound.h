/* Upper bounds on what a game can still bring, from prices.
 *
 * Every target (a place, or a spot) gets a price. A seeker alone, at place j at step t, can then collect net of prices
 * at most
 *
 *   C(t, j) = max(0, max over p of worth(p, t + d(j,p)) - price(p) + C(t + d(j,p), p)),
 *
 * with spots for p the target's tour, whose worth is that of its visits, and in the last term its end and exit; targets
 * allowed to repeat, but not to go straight back. For all prices, the sum of prices plus the seekers' C from their
 * starts is at least the optimum: in any play each place is visited first by one seeker, who pays its price. Under
 * expected time every place must be visited, so that prices of either sign will do, and worth(p, t) = -P t needs no
 * horizon; under discounting prices are at least 0, because a place might be left out (qtr_objective_needs_all()).
 *
 * The prices are tuned by subgradient steps: a place that the seekers' best walks visit more than once in all becomes
 * dearer, one that they leave out becomes cheaper.
 *
 * Time is cut into slots. Worth falls with time, so C at a slot's first step is good for the whole slot; past the last
 * slot everything left counts as collected at once. Both keep the bound valid and make it less tight.
 */
#ifndef QUARTER_SEARCH_BOUND_H
#define QUARTER_SEARCH_BOUND_H

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
  const qtr_game *game;         /* the environment's */
  double upper;                 /* the bound on the whole game under `price` */
  double price[QTR_MAX_PLACES]; /* the best so far, in force */
  double trial[QTR_MAX_PLACES]; /* being tried */
  double scale;                 /* of the subgradient steps */
  uint32_t steps_without_gain;
  uint32_t iterations;
  uint32_t slots;                                        /* in use */
  qtr_steps slot_steps;                                  /* steps a slot */
  qtr_steps travel[QTR_MAX_NODES * QTR_MAX_PLACES];      /* to places, as in the game, unpacked */
  uint32_t slots_apart[QTR_MAX_PLACES * QTR_MAX_PLACES]; /* from a tour's first place to the next target's: in slots */
  double late[QTR_MAX_PLACES];                           /* gains past the last slot */
  qtr_gain *gain;                                        /* a row of places a slot */
} qtr_bound;

/* Bytes of the block that the gains of a game take. */
size_t qtr_bound_bytes(const qtr_game *game);

/* Start from a known play: the visits of each target's places set its price, the last visit sets the horizon. The
 * environment must be without regions and outlive the bound, as must the block, qtr_bound_bytes() aligned for a
 * qtr_gain. Stopped by the mission's watch, `upper` is what the nearest seekers could collect all at once: valid, and
 * not tight. */
void qtr_bound_init(qtr_bound *bound, qtr_gain *gain, const qtr_environment *environment, const qtr_steps *visit);

/* One subgradient step towards `goal`, the worth of the best play known. False when more steps are of no use; the best
 * prices are then in force. A stop changes nothing, and the step can be taken again. */
bool qtr_bound_improve(qtr_bound *bound, double goal);

/* Put the best prices in force, whatever was being tried. False: stopped, and no states can be bounded before it is
 * called again. */
bool qtr_bound_settle(qtr_bound *bound);

/* The most that can come after a choice, counted from now: `after` is the situation just after it, before time passes.
 * Never less than the truth. */
double qtr_bound_state(const qtr_bound *bound, const qtr_situation *after);

#endif
