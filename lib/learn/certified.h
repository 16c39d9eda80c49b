/* The certified setting: greedy on an upper bound, backed up from the end of an episode to its start, with local search
 * on the games played. */
#ifndef QUARTER_LEARN_CERTIFIED_H
#define QUARTER_LEARN_CERTIFIED_H

#include "learn/learner.h"

/* One episode, and search on from what it found. */
enum qtr_learning qtr_certified_step(qtr_learner *learner);

/* Local search on the best game, with `rounds` of shaking. */
void qtr_certified_refine(qtr_learner *learner, unsigned rounds);

#endif
