/* The paper's setting: seekers that explore, each step backed up as it comes, and the greedy policy played after each
 * episode. */
#ifndef QUARTER_LEARN_EXPLORING_H
#define QUARTER_LEARN_EXPLORING_H

#include "learn/learner.h"

/* One episode, and the greedy policy played after it. */
enum qtr_learning qtr_exploring_step(qtr_learner *learner);

#endif
