/* Robots without a plan, to see what dividing the territory is worth: each goes to the nearest place not yet scanned;
 * where looks may miss, round all of them again, for as often as the plan looks there. Blind ones know of their own
 * scans alone; informed ones know at every moment of everybody's scans and targets, by a communication that real robots
 * of this demo do not have. */
#ifndef QUARTER_DEMO_BASELINES_H
#define QUARTER_DEMO_BASELINES_H

#include "robot.h"

typedef struct baseline {
  const qtr_policy *policy;
  int self;
  qtr_places scanned;
  qtr_places blocked; /* it did not get there */
  unsigned node;      /* where it last was: a place, or its start */
  uint16_t target;
  bool found;
  struct baseline *crew; /* informed: all robots' baselines; NULL: blind */
  int robots;
} baseline;

/* `crew` NULL: blind; else all of the crew must be initialised before any of it is asked for a target. */
void baseline_init(baseline *b, const qtr_policy *policy, int self, baseline *crew);
robot_pilot baseline_pilot(baseline *b);

#endif
