/* Upper bounds on what a game can still bring, from prices.
 *
 * Every target (a place, or a spot) gets a price. A seeker alone, at place j at step t, can then collect net of prices
 * at most
 *
 *   C(t, j) = max(0, max over p of worth(p, t + d(j,p)) - price(p) + C(t + d(j,p), p)),
 *
 * with spots for p the target's tour, whose worth is that of its visits, and in the last term its end and exit; targets
 * allowed to repeat, but for those that the walk remembers (search/near.h). Each kind of seekers has a C of its own:
 * its times, the places that it can still be home from in time, and in place of 0 the cost of going home, -v (t + d(j,
 * home)). For all prices, the sum of prices plus the seekers' C from their starts is at least the optimum: in any play
 * each place is visited first by one seeker, who pays its price. Under expected time every place must be visited, so
 * that prices of either sign will do, and worth(p, t) = -P t needs no horizon; else prices are at least 0, because a
 * place might be left out (qtr_objective_needs_all()).
 *
 * The prices are tuned by bundles of what the bound was under others: a place that the seekers' best walks visit more
 * than once in all becomes dearer, one that they leave out becomes cheaper.
 */
#ifndef QUARTER_SEARCH_BOUND_H
#define QUARTER_SEARCH_BOUND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "aggregate/environment.h"
#include "quarter/config.h"
#include "search/bundle.h"
#include "search/gains.h"

typedef struct {
  const qtr_environment *environment;
  const qtr_game *game; /* the environment's */
  bool shares;          /* two seekers may visit one target between them, each some places: no prices bound it */
  double upper;         /* the bound on the whole game under `price` */
  double price[QTR_MAX_PLACES]; /* the best so far, in force */
  double trial[QTR_MAX_PLACES]; /* being tried */
  double floor;                 /* below which no prices bring the bound, as far as is known */
  double upper_before;          /* before walks remembered as much as they do */
  uint32_t rounds;              /* in which they were given neighbours */
  qtr_bundle bundle;
  uint32_t iterations, steps_without_gain;
  uint32_t filling; /* the gains' number of fillings when C was last that of the prices in force; 0: it never was */
  qtr_gains gains;
} qtr_bound;

/* Start from a known play: the visits of each target's places set its price, the last visit sets the horizon. The
 * environment must be without regions and outlive the bound, as must the block, qtr_gains_bytes() aligned for a
 * double. Stopped by the mission's watch, `upper` is what the nearest seekers could collect all at once: valid, and
 * not tight. */
void qtr_bound_init(qtr_bound *bound, void *block, const qtr_environment *environment, const qtr_steps *visit);

/* The bound without prices: what the nearest seekers could collect all at once. Of large games the prices take minutes
 * to come below it. */
double qtr_bound_at_once(const qtr_bound *bound);

/* One step of the prices towards `goal`, the worth of the best play known. False when more steps are of no use; the
 * best prices are then in force. After a stop neither bound nor prices have changed, and the step can be taken
 * again. */
bool qtr_bound_improve(qtr_bound *bound, double goal);

/* Put the best prices in force, whatever was being tried. False: stopped, and no states can be bounded before it is
 * called again. */
bool qtr_bound_settle(qtr_bound *bound);

/* The most that can come after a choice, counted from now: `after` is the situation just after it, before time passes.
 * Never less than the truth. */
double qtr_bound_state(const qtr_bound *bound, const qtr_situation *after);

#endif
