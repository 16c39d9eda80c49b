/* Robots whose plan knows nothing of looks that miss: they walk it as any robot walks its plan, and when all of it is
 * done and nothing was found, once more, as often as the mission looks at each place. To see what it is worth that a
 * plan knows. */
#ifndef QUARTER_DEMO_SWEEPER_H
#define QUARTER_DEMO_SWEEPER_H

#include "robot.h"

typedef struct {
  const qtr_policy *plain, *whole; /* the plan; and the one of the same mission that knows how many looks it is worth */
  int self;
  int sweep, sweeps; /* from 1 */
  uint32_t run;
  qtr_seeker seeker; /* of this sweep */
  qtr_seeker first;  /* what the first sweep knew: only then are territories announced */
} sweeper;

void sweeper_init(sweeper *s, const qtr_policy *plain, const qtr_policy *whole, int self, uint32_t run);
robot_pilot sweeper_pilot(sweeper *s);

#endif
