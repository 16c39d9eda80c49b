/* What is wrong with a mission that the core does not take, and who of its robots is of no use, in words and in the
 * planner's units. */
#ifndef QUARTER_HOST_UNFIT_H
#define QUARTER_HOST_UNFIT_H

#include "host/base/fault.h"
#include "host/input/input.h"
#include "host/plan/pace.h"
#include "quarter/game.h"

/* Steps from a seeker's start until it has searched a place, if it goes there first and at once. */
qtr_steps unfit_way(const qtr_game *game, unsigned seeker, unsigned place);

/* The fault of what qtr_mission_check() or qtr_game_init() returned with that culprit. -1. */
int unfit_fault(const input *in, const qtr_game *game, const pace *p, int status, int culprit, fault *why);

/* Note the robots that can search no place in the time that they have, or none at all. */
void unfit_note(input *in, const qtr_game *game, const pace *p);

#endif
