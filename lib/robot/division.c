#include "quarter/division.h"

#include <stddef.h>

#include "quarter/nominal.h"

void qtr_division_begin(qtr_division *division, const qtr_policy *policy, const qtr_deployment *deployment) {
  division->moves = 0;
  division->off_table = 0;
  qtr_joint_start(&division->joint, &policy->board, deployment->start_of, &deployment->cleared);
}

/* Time passes only when nobody has to choose, and each time it passes somebody arrives: between two choices there are no
 * more advances than seekers, so that a call is short. */
bool qtr_division_play(qtr_division *division, const qtr_policy *policy) {
  qtr_joint *joint = &division->joint;
  int seeker = qtr_joint_chooser(joint, &policy->board);
  while (seeker == QTR_NOBODY) {
    if (qtr_joint_advance(joint, &policy->board, NULL) == 0u) {
      return false;
    }
    seeker = qtr_joint_chooser(joint, &policy->board);
  }
  bool off_table = false;
  const uint16_t choice = qtr_policy_choose(policy, joint, seeker, &off_table);
  division->off_table += off_table;
  (void)qtr_joint_choose(joint, &policy->board, seeker, choice);
  if (choice == QTR_STAND_DOWN) {
    return true;
  }
  if (division->moves == QTR_MAX_MOVES) {
    return false; /* only by travel times that no map gives */
  }
  division->place[division->moves] = choice;
  division->seeker[division->moves++] = (uint8_t)seeker;
  return true;
}
