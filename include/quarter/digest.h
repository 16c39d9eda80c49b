/* A digest of the nominal game from the mission's own starts: who chooses what, when. It is stored in the table and
 * compared on opening, so that a robot whose build plays otherwise than the learner's fails loudly instead of searching
 * wrongly. */
#ifndef QUARTER_DIGEST_H
#define QUARTER_DIGEST_H

#include <stdint.h>

#include "quarter/policy.h"

QTR_C_BEGIN

uint32_t qtr_policy_digest(const qtr_policy *policy);

QTR_C_END

#endif
