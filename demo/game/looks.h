/* What looks of a sensor that misses bring. Whether the n-th look at the mine finds it follows from the game's seed and
 * from n alone, whoever looks: so games of one seed can be compared, whatever their robots do. */
#ifndef QUARTER_DEMO_LOOKS_H
#define QUARTER_DEMO_LOOKS_H

#include <stdbool.h>
#include <stdint.h>

/* Whether look n, from 1, finds what is there with probability `detection`. */
bool looks_find(uint64_t seed, int n, double detection);

/* The first look that does; LOOKS_NEVER if it takes that many. */
#define LOOKS_NEVER 1000
int looks_needed(uint64_t seed, double detection);

#endif
