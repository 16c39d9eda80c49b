/* A turn of the joint game whose rules its caller keeps to: quarter/joint.h has the functions that look. */
#ifndef QUARTER_ROBOT_JOINT_H
#define QUARTER_ROBOT_JOINT_H

#include "quarter/joint.h"

/* Whether a seeker is one, and idle. For numbers from outside, too. */
bool qtr_joint_can_choose(const qtr_joint *joint, const qtr_board *board, int seeker);

/* qtr_joint_choices() for whoever's turn it is. */
bool qtr_joint_options(const qtr_joint *joint, const qtr_board *board, unsigned seeker, qtr_places *choices);

/* qtr_joint_choose() for one of the choices that qtr_joint_options() gives. */
bool qtr_joint_go(qtr_joint *joint, const qtr_board *board, unsigned seeker, unsigned choice);

/* qtr_joint_advance() for who does not ask which places are visited now. */
qtr_steps qtr_joint_pass(qtr_joint *joint, const qtr_board *board);

#endif
