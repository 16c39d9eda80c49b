#include "quarter/digest.h"

#include <stddef.h>

#include "core/apart.h"
#include "core/bytes.h"
#include "core/crc.h"
#include "quarter/deployment.h"
#include "quarter/nominal.h"
#include "robot/joint.h"
#include "robot/layout.h"

/* A choice, and the step at which it is made. */
static uint32_t add(uint32_t digest, int seeker, uint16_t choice, qtr_steps now) {
  return qtr_crc32_add_number(qtr_crc32_add_number(digest, (uint32_t)seeker | ((uint32_t)choice << 16), 4), now, 4);
}

QTR_APART static void start(qtr_joint *joint, const qtr_policy *policy) {
  qtr_deployment home;
  qtr_deployment_home(&home, policy);
  qtr_joint_begin(joint, &policy->board, home.start_of, &home.cleared);
}

/* One pass over the game, choice by choice. */
static uint32_t digest_of_game(const qtr_policy *policy) {
  qtr_joint joint;
  qtr_move move;
  uint32_t digest = 0;
  start(&joint, policy);
  while (qtr_policy_move(policy, &joint, &move)) {
    digest = add(digest, move.seeker, move.choice, joint.now);
  }
  return digest;
}

#if QTR_READ_FORMAT_1
/* Play on until the seeker chooses, or is known to have nothing left: then, and not at a later choice of another's, is
 * its end. */
static uint16_t play_route(const qtr_policy *policy, qtr_joint *joint, int seeker, qtr_steps *now) {
  while (joint->node[seeker] != QTR_STAND_DOWN) {
    const int chooser = qtr_joint_chooser(joint, &policy->board);
    if (chooser == QTR_NOBODY) {
      const qtr_steps passed = qtr_joint_advance(joint, &policy->board, NULL);
      if (passed == 0u) {
        break;
      }
      *now += passed;
      continue;
    }
    const uint16_t choice = qtr_policy_choose(policy, joint, chooser, NULL);
    (void)qtr_joint_choose(joint, &policy->board, chooser, choice);
    if (chooser == seeker) {
      return choice;
    }
  }
  return QTR_STAND_DOWN;
}

/* As format 1 has it: seeker by seeker, and at the end of each the step at which it is known to be the end. */
static uint32_t digest_of_routes(const qtr_policy *policy) {
  uint32_t digest = 0;
  for (int seeker = 0; seeker < policy->board.seekers; seeker++) {
    qtr_joint joint;
    qtr_steps now = 0;
    uint16_t choice = 0;
    qtr_joint_start(&joint, &policy->board, NULL, NULL);
    while (choice != QTR_STAND_DOWN) {
      choice = play_route(policy, &joint, seeker, &now);
      digest = add(digest, seeker, choice, now);
    }
  }
  return digest;
}
#endif

/* From the mission's own start: what is played from there goes through every part that could differ, keys and records,
 * turns, travel times and the rule off the table. */
uint32_t qtr_policy_digest(const qtr_policy *policy) {
#if QTR_READ_FORMAT_1
  if (is_format_1(policy->format)) {
    return digest_of_routes(policy);
  }
#endif
  return digest_of_game(policy);
}
