/* Robots and places for a map that says nothing of them. */
#ifndef QUARTER_TOOLS_PROPOSE_H
#define QUARTER_TOOLS_PROPOSE_H

#include "host/base/fault.h"
#include "host/input/input.h"

/* Put robots and places, where there are none, on the largest piece of the map's free ground: the robots beside one
 * another at an end of it, the places as far from them and from one another as can be, each with a name and equally
 * likely. Fewer places, where there are fewer cells. All robots start at the one start that the map has, where it has
 * one. 0, or -1 with *why set. */
int propose_sites(input *in, int robots, int places, fault *why);

#endif
