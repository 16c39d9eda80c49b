/* A picture of a policy as SVG: the map, the places, each seeker's territory and trajectory, a legend. */
#ifndef QUARTER_TOOLS_DRAW_SVG_H
#define QUARTER_TOOLS_DRAW_SVG_H

#include <stdio.h>

#include "draw_input.h"

/* Write the picture: the same drawing gives the same bytes. Text may hold anything. 0, or -1 if there is no memory or
 * the drawing has a place, a start or a step of a trail off its map; errors of `out` are left to its owner. */
int draw_svg(FILE *out, const drawing *d);

#endif
