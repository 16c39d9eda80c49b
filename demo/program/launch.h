/* A game in processes of their own: one for the world, one for each robot, started, watched and ended together. */
#ifndef QUARTER_DEMO_LAUNCH_H
#define QUARTER_DEMO_LAUNCH_H

#include "faults.h"
#include "plan.h"
#include "settings.h"

/* Play it, all processes on the settings' bus. The world writes replay, log and outcome. When it ends, however it ends,
 * the robots are ended; when interrupted, the world is asked to finish first. A robot that has no power (`faults`) has
 * no process for that time. The exit status: 0, or another with *why set. */
int launch(const settings *s, const plan *p, const fault_script *faults, const volatile int *interrupted, fault *why);

#endif
