/* What qtr_policy_check() looks at: QTR_OK, or the error that is named. */
#ifndef QUARTER_CHECKS_H
#define QUARTER_CHECKS_H

#include "quarter/policy.h"

/* Every number lies in its range, every node on a free cell, and bytes that mean nothing are 0: QTR_ERR_CORRUPT. */
int qtr_check_sections(const qtr_policy *policy);

/* What the travel times say of one another, and of reach: QTR_ERR_TRAVEL. */
int qtr_check_travel(const qtr_policy *policy);

/* Value, bound and gap could be those of some policy: QTR_ERR_CERTIFICATE. */
int qtr_check_certificate(const qtr_policy *policy);

#endif
