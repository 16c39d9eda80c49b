/* The progress line of a long search: on a terminal alone, a few times a second. */
#ifndef QUARTER_HOST_PROGRESS_H
#define QUARTER_HOST_PROGRESS_H

#include <stdbool.h>

#include "quarter/learner.h"

typedef struct {
  bool shown;            /* standard error is a terminal and nobody asked for quiet */
  double time_limit;     /* seconds; 0: none */
  double gap;            /* at which the search ends */
  double last;           /* seconds at which the line was last drawn */
  double mark, mark_gap; /* an earlier moment and its gap, from which the time left is reckoned */
  uint64_t mark_episodes;
} progress;

/* Whether to show any: standard error is a terminal. */
bool progress_wanted(bool quiet);

void progress_begin(progress *p, bool quiet, double time_limit, double gap);

/* Draw the line anew if it is time to. `seconds` since the search began. */
void progress_show(progress *p, const qtr_certificate *certificate, double seconds);

/* The same for work that is counted: "what: done of all", and the seconds left at the rate since it began. */
void progress_count(progress *p, const char *what, double done, double all, double seconds);

/* Wipe the line. */
void progress_end(progress *p);

#endif
