/* A turn of the joint game whose rules its caller keeps to: quarter/joint.h has the functions that look. */
#ifndef QUARTER_ROBOT_JOINT_H
#define QUARTER_ROBOT_JOINT_H

#include "quarter/joint.h"

/* qtr_joint_start() from starts and with places cleared that there are, none of them NULL. */
void qtr_joint_begin(qtr_joint *joint, const qtr_board *board, const uint16_t *start_of, const qtr_places *cleared);

/* Whether a seeker is one, and idle. For numbers from outside, too. */
bool qtr_joint_can_choose(const qtr_joint *joint, const qtr_board *board, int seeker);

/* The places that the one whose turn it is may choose, added to `choices` (may be NULL: then only the answer counts),
 * and whether there are any. */
bool qtr_joint_options(const qtr_joint *joint, const qtr_board *board, unsigned seeker, qtr_places *choices);

/* Whether it may stand down instead. */
bool qtr_joint_may_leave(const qtr_joint *joint, const qtr_board *board, unsigned seeker, const qtr_places *choices);

/* qtr_joint_choose() for one of the choices that qtr_joint_options() gives. */
bool qtr_joint_go(qtr_joint *joint, const qtr_board *board, unsigned seeker, unsigned choice);

/* qtr_joint_advance() for who does not ask which places are visited now. */
qtr_steps qtr_joint_pass(qtr_joint *joint, const qtr_board *board);

#endif
