#include "host/base/memory.h"

#include <stdlib.h>

/* From the system, pages that are zero already: those that are never touched are never taken from anybody. */
void *memory_take(size_t bytes, fault *why) {
  void *taken = calloc(1, bytes);
  if (taken == NULL)
    fault_set(why,
              "no memory: %zu MB more are needed, of which a small mission uses little; raise the limit on the process "
              "(ulimit -v), or build with smaller arrays (quarter/config.h)",
              (bytes + 999999) / 1000000);
  return taken;
}
