/* The viewer for a game that is played elsewhere: it hears what passes on the bus, and says nothing. */
#ifndef QUARTER_DEMO_FOLLOW_H
#define QUARTER_DEMO_FOLLOW_H

#include "plan.h"
#include "settings.h"

/* Serve it until interrupted. 0, or -1 with *why set. */
int follow(const settings *s, const plan *p, const volatile int *interrupted, fault *why);

#endif
