/* Functions that a robot's build does not put into their callers. What they keep on the stack is there only while they
 * run, and not below all else that the caller calls: the deepest way of calls is the shorter for it. */
#ifndef QUARTER_APART_H
#define QUARTER_APART_H

#include "quarter/config.h"

#if defined(__GNUC__) && defined(QTR_PROFILE_MCU)
#define QTR_APART __attribute__((noinline))
#else
#define QTR_APART
#endif

#endif
