/* The best game bettered by ruin and recreate, beside what is learnt: a few rounds with each of the learner's steps,
 * for as long as the gap is open. */
#ifndef QUARTER_LEARN_PLANNING_H
#define QUARTER_LEARN_PLANNING_H

#include "learn/learner.h"

#define QTR_PRICE_STEPS 16u /* of the bound in one step of the learner, but in large games */

/* No run is under way. */
void qtr_planning_init(qtr_learner *learner);

/* Of a large game, ahead of its prices: the first run, whole. */
void qtr_planning_first(qtr_learner *learner);

/* Whether the first game is bettered beside the prices: games of few places are over before they need it. */
bool qtr_planning_follows(const qtr_learner *learner);

/* How many of `most` steps of the prices one of the learner takes. */
uint32_t qtr_planning_price_steps(const qtr_learner *learner, uint32_t most);

/* Some rounds beside the prices, or beside an episode; none where the setting's own best policy is sought. */
void qtr_planning_step(qtr_learner *learner);

/* Beside so many routes begun that are listed: about half as long as that takes. */
void qtr_planning_beside(qtr_learner *learner, uint32_t labels);

#endif
