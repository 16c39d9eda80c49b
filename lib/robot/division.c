#include "quarter/division.h"

#include "quarter/nominal.h"
#include "robot/joint.h"

void qtr_division_begin(qtr_division *division, const qtr_policy *policy, const qtr_deployment *deployment) {
  division->moves = 0;
  division->off_table = 0;
  qtr_joint_begin(&division->joint, &policy->board, deployment->start_of, &deployment->cleared);
}

bool qtr_division_play(qtr_division *division, const qtr_policy *policy) {
  qtr_move move;
  if (!qtr_policy_move(policy, &division->joint, &move)) {
    return false;
  }
  division->off_table += move.off_table;
  if (move.choice == QTR_STAND_DOWN) {
    return true;
  }
  if (division->moves == QTR_MAX_MOVES) {
    return false; /* only by travel times that no map gives */
  }
  division->place[division->moves] = (qtr_place_number)move.choice;
  division->seeker[division->moves++] = (uint8_t)move.seeker;
  return true;
}
