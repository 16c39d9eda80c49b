/* The files that a command line asks to be written. */
#ifndef QUARTER_TOOLS_PRODUCTS_H
#define QUARTER_TOOLS_PRODUCTS_H

#include <stdbool.h>

#include "host/base/fault.h"
#include "options.h"

/* Once the input is read, and before any work: that each can be written, is none of the files that were read, under
 * whatever name, and that no two are the same. 0, or -1 with *why set. */
int products_check(const options *o, fault *why);

/* Whether some output but the report takes standard output: there is no room for text then. */
bool products_take_stdout(const options *o);

#endif
