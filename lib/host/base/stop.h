/* What ends a run early: a time limit, Ctrl-C, SIGTERM. Whoever works long and has something to show asks from time to
 * time; whoever has nothing before the end is ended at once. */
#ifndef QUARTER_HOST_STOP_H
#define QUARTER_HOST_STOP_H

#include <stdbool.h>

#include "host/base/fault.h"
#include "quarter/watch.h"

/* From now on Ctrl-C and SIGTERM end the program at once, with exit status 130 or 143, and no file is left
 * half-written. */
void stop_at_once(void);

/* From now on Ctrl-C and SIGTERM do not end the program but are noted, also if they came before; a third one ends it at
 * once. The clock of the time limit starts. */
void stop_begin(void);

/* The time limit, in seconds since stop_begin(); 0: none. May be set anew, also after it has passed. */
void stop_after(double seconds);

/* Whether to stop. Costs nothing. */
bool stop_asked(void);

/* stop_asked() for the core. */
qtr_watch stop_watch(void);

/* Seconds since stop_begin(). */
double stop_seconds(void);

/* Seconds until the time limit; HUGE_VAL if there is none. */
double stop_left(void);

/* The number of the signal that came; 0: none. */
int stop_signal(void);

/* "interrupted" or "time limit". */
const char *stop_reason(void);

/* The line for a run that was stopped before it had anything to write, with the seconds that it takes to get there.
 * Returns -1; the exit status is EXIT_STOPPED. */
int stop_fault(fault *why, const char *input, const char *what, double needed);

#endif
