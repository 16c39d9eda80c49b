/* The order of seekers in the key of a state, and the key as format 1 had it. */
#ifndef QUARTER_ROBOT_JOINT_KEY_H
#define QUARTER_ROBOT_JOINT_KEY_H

#include "quarter/joint.h"
#include "quarter/key.h"

/* How many seekers stand behind this one in a key: those of a higher kind, then of a higher node, then with longer to
 * go. Each gets a number of its own. Seekers of a kind are interchangeable: in this order, who is who is gone from the
 * key. Kinds stay apart, in one order always. */
unsigned qtr_joint_behind(const qtr_joint *joint, const qtr_key_shape *shape, unsigned seeker);

/* The key in format 1, which knew no clock; all words of it are written. Returns how many it takes. */
unsigned qtr_joint_key_1(qtr_key *key, const qtr_joint *joint, const qtr_key_shape *shape);

/* Words of the greatest key in format 1: what each of its keys takes in a record. */
unsigned qtr_key_words_1(const qtr_key_shape *shape);

#endif
