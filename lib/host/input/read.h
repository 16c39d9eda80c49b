/* A mission read from a file: a drawing, or a mission YAML and the map that it names (a drawing, a Moving AI map, or a
 * ROS map_server YAML with its image).
 *
 * Where the sources leave a choice open:
 * - What a file is, its contents say; its name's extension decides only where they do not.
 * - In a mission whose map is a drawing, the mission's `robots` replace the drawing's S, and its `places` or
 *   `places_csv` the drawing's digits; those marks are plain free cells then.
 * - One start is shared by all robots of input_options.robots; several starts are one seeker each.
 * - A map without metres has cells of 1 m with the origin at its lower-left corner, so that {x, y} works there too.
 * - A point on the line between two cells belongs to the right or upper one.
 * - Places keep the numbers that they have in the input, whichever are left out.
 */
#ifndef QUARTER_HOST_READ_H
#define QUARTER_HOST_READ_H

#include "host/input/input.h"

/* Read `path` and everything it names. 0, or -1 with *fault set. `input` is large: keep it in static storage. Whether
 * the starts reach the places is not looked at. */
int input_read(input *in, const char *path, const input_options *options, fault *why);

#endif
