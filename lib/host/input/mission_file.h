/* Mission files: a YAML that names a map, the robots and the places. */
#ifndef QUARTER_HOST_MISSION_FILE_H
#define QUARTER_HOST_MISSION_FILE_H

#include "host/input/input.h"
#include "host/input/tree.h"

/* Fill all of the input but the robots' shared start; in->path is the mission's path and `tree` its contents. 0, or
 * -1 with the tree's fault set. */
int mission_file_read(input *in, tree *yaml, const input_options *options);

#endif
