/* How the learning went, as a CSV file: episode,max_q,value,expected_time,bound,updates,q_entries, and behind them
 * expected_time_seconds and bound_seconds, where a step has seconds and the bound is a time. A row stands for the state
 * after that many episodes. There is one for every episode that changed MaxQ or the best policy, and enough others that
 * rows are never more than a twentieth apart; so the last episode that changed a column can be read off exactly. */
#ifndef QUARTER_TOOLS_CURVE_H
#define QUARTER_TOOLS_CURVE_H

#include "host/base/fault.h"
#include "host/base/outfile.h"
#include "quarter/learner.h"

typedef struct {
  outfile out;
  bool wanted;
  uint8_t objective;
  double step_seconds; /* 0: nobody says */
  uint64_t episodes;   /* of the last row */
  double max_q, value;
} curve;

/* Begin a curve in the file `path`; NULL: none is wanted, and the other calls do nothing. A step takes `step_seconds`;
 * 0: nobody says. 0, or -1 with *why set. */
int curve_begin(curve *c, const char *path, uint8_t objective, double step_seconds, fault *why);

/* After a step of the learner. */
void curve_note(curve *c, const qtr_learner *learner, const qtr_certificate *certificate);

/* Finish the file, with a last row. 0, or -1 with *why set and nothing left behind. */
int curve_end(curve *c, const qtr_learner *learner, const qtr_certificate *certificate, fault *why);

#endif
