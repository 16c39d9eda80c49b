/* The best game bettered by ruin and recreate, beside what is learnt: a few rounds with each of the learner's steps,
 * for as long as the gap is open. */
#ifndef QUARTER_LEARN_PLANNING_H
#define QUARTER_LEARN_PLANNING_H

#include "learn/learner.h"

/* No run is under way. */
void qtr_planning_init(qtr_learner *learner);

/* Some rounds beside the prices, or beside an episode; none where the setting's own best policy is sought. */
void qtr_planning_step(qtr_learner *learner);

#endif
