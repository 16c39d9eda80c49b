#include "host/base/memory.h"

#include <stdlib.h>

/* From the system, pages that are zero already: those that are never touched are never taken from anybody. */
void *memory_take(size_t bytes, fault *why) {
  void *taken = calloc(1, bytes);
  if (taken == NULL)
    fault_set(why,
              "no memory: %zu MB more are needed; raise the limit on the process (ulimit -v), or build with smaller "
              "arrays (quarter/config.h)",
              (bytes + 999999) / 1000000);
  return taken;
}

int memory_need(memory_block *block, size_t bytes, fault *why) {
  if (block->bytes >= bytes) return 0;
  memory_drop(block);
  block->at = memory_take(bytes, why);
  if (block->at == NULL) return -1;
  block->bytes = bytes;
  return 0;
}

void memory_want(memory_block *block, size_t bytes) {
  if (block->bytes >= bytes) return;
  memory_drop(block);
  block->at = calloc(1, bytes);
  if (block->at != NULL) block->bytes = bytes;
}

bool memory_grow(memory_block *block, size_t bytes) {
  if (block->bytes >= bytes) return true;
  void *larger = realloc(block->at, bytes);
  if (larger == NULL) return false;
  *block = (memory_block){larger, bytes};
  return true;
}

void memory_drop(memory_block *block) {
  free(block->at);
  *block = (memory_block){0};
}
