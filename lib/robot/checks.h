/* What a policy is checked for: QTR_OK, or the error that is named. The nodes on opening, the rest by qtr_policy_check(). */
#ifndef QUARTER_CHECKS_H
#define QUARTER_CHECKS_H

#include "quarter/policy.h"

/* Every node lies on the grid: QTR_ERR_CORRUPT. In entries.c. */
int qtr_check_nodes(const qtr_policy *policy);

/* Every number lies in its range, and bytes that mean nothing are 0: QTR_ERR_CORRUPT. */
int qtr_check_sections(const qtr_policy *policy);

/* What the travel times say of one another, and of reach: QTR_ERR_TRAVEL. */
int qtr_check_travel(const qtr_policy *policy);

/* Value, bound and gap could be those of some policy: QTR_ERR_CERTIFICATE. */
int qtr_check_certificate(const qtr_policy *policy);

#endif
