/* Mission files: a YAML that names a map, the robots and the places. */
#ifndef QUARTER_READER_MISSION_FILE_H
#define QUARTER_READER_MISSION_FILE_H

#include "input.h"
#include "tree.h"

/* Fill all of the input but the robots' shared start; in->path is the mission's path and `tree` its contents. 0, or
 * -1 with the tree's fault set. */
int mission_file_read(input *in, tree *yaml, const input_options *options);

#endif
