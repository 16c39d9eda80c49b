/* The nominal game: the joint game as it goes when all robots are on time and choose by the table. Every robot plays
 * the whole of it by itself, so all know who goes where without a word. */
#ifndef QUARTER_NOMINAL_H
#define QUARTER_NOMINAL_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"
#include "quarter/joint.h"
#include "quarter/policy.h"

QTR_C_BEGIN

/* Look a state up. False if the table has no record of it. */
bool qtr_policy_lookup(const qtr_policy *policy, const qtr_joint *joint, uint16_t *choice);

/* What `seeker`, whose turn it is, chooses: by the table, and off the table the place with the most weight for a step
 * of travel (the lowest of equal ones). `*off_table` (may be NULL) says which. QTR_STAND_DOWN for a seeker that is
 * none, or whose turn it is not. */
uint16_t qtr_policy_choose(const qtr_policy *policy, const qtr_joint *joint, int seeker, bool *off_table);

typedef struct {
  int seeker;
  uint16_t choice; /* a place, or QTR_STAND_DOWN */
  bool off_table;
} qtr_move;

/* Play the next choice of the joint game, in nominal time. False: the game is over; `seeker` is
 * QTR_NOBODY, and the rest is not written. */
bool qtr_policy_move(const qtr_policy *policy, qtr_joint *joint, qtr_move *move);

/* Play the joint game on in nominal time until `seeker` makes its next choice. Returns that choice, or QTR_STAND_DOWN
 * when it has none left or is none. `*now` (may be NULL) is moved on by the time that passes; `*off_table` (may be
 * NULL) counts the choices made off the table. */
uint16_t qtr_policy_play(const qtr_policy *policy, qtr_joint *joint, int seeker, qtr_steps *now, uint32_t *off_table);

QTR_C_END

#endif
