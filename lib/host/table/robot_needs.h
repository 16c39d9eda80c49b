/* What a table needs of the build that opens it. */
#ifndef QUARTER_HOST_ROBOT_NEEDS_H
#define QUARTER_HOST_ROBOT_NEEDS_H

#include "host/table/robot_sizes.h"
#include "quarter/policy.h"

/* The least sizes that open `policy`. A key's length and the number of starts are none of their own: a build of these
 * three has room for both. */
robot_sizes robot_needs(const qtr_policy *policy);

#endif
