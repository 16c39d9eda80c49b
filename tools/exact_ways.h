/* How long each seeker takes from where to where, when robots differ: what it may enter, its speed, its scans. Found
 * anew on the grid; none of the game's travel times are used. */
#ifndef QUARTER_TOOLS_EXACT_WAYS_H
#define QUARTER_TOOLS_EXACT_WAYS_H

#include "host/base/fault.h"
#include "quarter/mission.h"
#include "quarter/travel.h"

/* Seekers and places, and looks in all, that the search under the field's terms takes. */
enum { EXACT_TERMS_SEEKERS = 4, EXACT_TERMS_LOOKS = 10 };

/* Nodes: the places, then the seeker's own start. QTR_NEVER: no way, or a place that it may not visit. */
typedef struct {
  qtr_steps leg[EXACT_TERMS_SEEKERS][EXACT_TERMS_LOOKS + 1][EXACT_TERMS_LOOKS]; /* to a place, its scan included */
  qtr_steps home[EXACT_TERMS_SEEKERS][EXACT_TERMS_LOOKS + 1];                   /* to the seeker's start */
} exact_ways;

/* Measure the ways of a mission within these limits; `travel` is scratch. 0, or -1 with *why set: no memory, or a way
 * too long to add up. */
int exact_measure_ways(exact_ways *ways, const qtr_mission *mission, qtr_travel *travel, fault *why);

#endif
