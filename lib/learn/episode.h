/* What both settings do in an episode: list the choices with their Q, make one, note it for the backup, and find out
 * what the whole game earns on the ground. */
#ifndef QUARTER_LEARN_EPISODE_H
#define QUARTER_LEARN_EPISODE_H

#include "learn/learner.h"

/* Q of all that a seeker may choose into learner->candidates, the targets in their order, standing down last. */
void qtr_episode_list(qtr_learner *learner, const qtr_situation *state, int seeker);

/* The candidate with the largest Q, the first among equals. */
unsigned qtr_episode_greedy(const qtr_candidates *candidates);

/* Note the candidate picked, for the backup; then make that choice and let time pass. */
void qtr_episode_note(qtr_learner *learner, unsigned picked);
void qtr_episode_act(qtr_learner *learner, qtr_situation *state, int seeker, uint16_t choice);

/* Eq. 4.7, for the entry of a choice: `value` is the largest Q of the state that it led to. */
double qtr_episode_backup(const qtr_trace *trace, double value);

/* On an aggregate: the targets chosen, played as routes of places. */
void qtr_episode_play_on_ground(qtr_learner *learner);

/* Score the game just played, which has come to its end, by what it earns on the ground. */
void qtr_episode_keep_if_best(qtr_learner *learner);

#endif
