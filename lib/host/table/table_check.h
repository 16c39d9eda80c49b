/* What a robot leaves unchecked when it opens a table, because it takes a search of the map for every place or floating
 * point: whether the table is true of its own map. Every host program that opens a table asks. */
#ifndef QUARTER_HOST_TABLE_CHECK_H
#define QUARTER_HOST_TABLE_CHECK_H

#include "host/base/fault.h"
#include "quarter/policy.h"

/* Hold an open table's travel times and regions against its grid, and its certificate against its own play. `path` is
 * named in the fault. 0, or -1 with *why set. */
int table_check(const qtr_policy *policy, const char *path, fault *why);

#endif
