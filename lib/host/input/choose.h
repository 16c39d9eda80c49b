/* Which of an input's places and robots take part: what is cleared, left out, or added by the caller. */
#ifndef QUARTER_HOST_CHOOSE_H
#define QUARTER_HOST_CHOOSE_H

#include "host/input/input.h"
#include "host/input/tree.h"

/* Mark the places that the mission's `cleared` lists, once all are read. 0, or -1 with the fault set. */
int choose_cleared(input *in, tree *yaml, tree_node *root);

/* Add the places of options->add, "x,y,weight,name" each, behind the input's own. 0, or -1 with *why set. */
int choose_added(input *in, const input_options *options, fault *why);

/* Drop what is cleared, by the mission or the options, and what the options leave out, and note it. Those that stay
 * keep their numbers and names. 0, or -1 with *why set: a word for nobody, or nothing is left. */
int choose_rest(input *in, const input_options *options, fault *why);

#endif
