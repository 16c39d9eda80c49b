/* Large memory, taken when it is needed: what a command does not use costs it nothing. */
#ifndef QUARTER_HOST_MEMORY_H
#define QUARTER_HOST_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

#include "host/base/fault.h"

/* Zeroed memory, for free(). NULL with *why set if the machine, or a limit set on the process, has no more. */
void *memory_take(size_t bytes, fault *why);

/* A block for one purpose, which lasts for as long as it is large enough. {0} is none yet. */
typedef struct {
  void *at;
  size_t bytes;
} memory_block;

/* Make it hold so many bytes, whatever stood in it; or none, where there are no more: for what one can do without. */
void memory_want(memory_block *block, size_t bytes);

/* Make it hold so many bytes; what stood in it is lost. 0, or -1 with *why set and no block. */
int memory_need(memory_block *block, size_t bytes, fault *why);

/* Make it hold so many bytes; what stood in it stays, and may have moved. False: there is no more, and the block is as
 * it was. */
bool memory_grow(memory_block *block, size_t bytes);

void memory_drop(memory_block *block);

#endif
