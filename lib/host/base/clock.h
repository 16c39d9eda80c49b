/* The time that passes. */
#ifndef QUARTER_HOST_CLOCK_H
#define QUARTER_HOST_CLOCK_H

/* Seconds on a clock that only goes forward. */
double clock_seconds(void);

#endif
