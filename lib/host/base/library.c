#include "host/base/library.h"

#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

int library_load(const char *name, const library_function *functions, const char *need, fault *why) {
  void *library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) return fault_set(why, "%s, and %s is not on this machine", need, name);
  for (const library_function *f = functions; f->name != NULL; f++) {
    /* POSIX has functions and objects share a representation, ISO C does not: hence the bytes. */
    void *found = dlsym(library, f->name);
    if (found == NULL) return fault_set(why, "%s, and %s has no %s", need, name, f->name);
    memcpy(f->pointer, &found, sizeof found);
  }
  return 0;
}
