/* Large memory, taken when it is needed: what a command does not use costs it nothing. */
#ifndef QUARTER_HOST_MEMORY_H
#define QUARTER_HOST_MEMORY_H

#include <stddef.h>

#include "host/base/fault.h"

/* Zeroed memory, for free(). NULL with *why set if the machine, or a limit set on the process, has no more. */
void *memory_take(size_t bytes, fault *why);

#endif
