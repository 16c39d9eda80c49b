/* What comes before a game: its outputs are looked at, its mission is read, its plan is made. */
#ifndef QUARTER_DEMO_PREPARE_H
#define QUARTER_DEMO_PREPARE_H

#include "plan.h"
#include "settings.h"

/* The exit status, with *why set and nothing to free or written if it is not 0. From now on signals are caught by
 * stop.h: one that comes before there is a plan ends this at once, with the status that it stands for. */
int prepare(plan *p, const settings *s, fault *why);

#endif
