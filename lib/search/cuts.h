/* What prices say of the bound under others (search/bound.h): for all lambda' and any walks of the seekers
 *
 *   L(lambda') >= sum of lambda' + what the walks collect net of lambda',
 *
 * for C is the most that any walk collects. The best walks under lambda give the cut that touches L there. Seekers of
 * one kind that start together all have the same best walk, which says little of where the others are to go: so there
 * is a cut for each of them, the j-th of which goes where those before it did not. They cost next to nothing beside
 * filling C, which is then filled less often.
 */
#ifndef QUARTER_SEARCH_CUTS_H
#define QUARTER_SEARCH_CUTS_H

#include "search/bundle.h"
#include "search/gains.h"

/* Add the cuts of prices under which the gains have been filled, L is `upper`, and the best walks come to each target
 * `visits` times. The prices are `step` from the bundle's center. */
void qtr_cuts_add(qtr_bundle *bundle, const qtr_gains *gains, const double *price, const double *step, double upper,
                  const int *visits);

#endif
