/* How much is proven: the best game against the bound on every policy. */
#ifndef QUARTER_LEARN_CERTIFICATE_H
#define QUARTER_LEARN_CERTIFICATE_H

#include "learn/learner.h"

/* The best game's worth and a share of the gap asked for: what is bounded by it is as good as found. */
double qtr_certificate_within(const qtr_learner *learner, double share);

/* Whether a bound on what a game earned is one, but for what adding up in another order may change. */
bool qtr_certificate_bounds(double upper, double worth);

/* Whether no policy on the ground beats the best game by more than the gap asked for. */
bool qtr_certificate_closed(const qtr_learner *learner);

/* Where learning stands when nothing stopped it: on an aggregate it may be at its end with a gap that is the
 * aggregate's. */
enum qtr_learning qtr_certificate_verdict(const qtr_learner *learner);

#endif
