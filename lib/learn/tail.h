/* The rest of the gap: all routes of games that are better than the best one known, listed (search/pool.h), and the
 * best game chosen out of them (search/selection.h, or of few places search/deal.h). Where they are too many to list,
 * prices of routes bring the bound down until they are not (search/columns.h), and a part of them is chosen from, for a
 * better game. What cannot be closed so is left to episodes, the next try behind as many of them as it is worth. */
#ifndef QUARTER_LEARN_TAIL_H
#define QUARTER_LEARN_TAIL_H

#include <stdbool.h>
#include <stddef.h>

#include "learn/learner.h"

/* Take over the block, aligned as for a uint64_t; one that is too small, or none, is not used. */
void qtr_tail_init(qtr_learner *learner, void *block, size_t bytes);

/* Whether a game has so few routes that they are listed before the ground's prices are tuned at all. */
bool qtr_tail_comes_first(const qtr_learner *learner);

/* While the ground's prices are tuned, between two steps of theirs: where so few routes are within the gap already that
 * they take less time than that, they are listed, and the phase of episodes begins, if only to choose from them.
 * Returns whether it does. */
bool qtr_tail_try_early(qtr_learner *learner);

/* Go on for a bounded amount of work. False: there is nothing to do now, and an episode is next. */
bool qtr_tail_step(qtr_learner *learner);

#endif
