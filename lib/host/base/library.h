/* Shared libraries that only some commands need, loaded by these when they run: the others start without. */
#ifndef QUARTER_HOST_LIBRARY_H
#define QUARTER_HOST_LIBRARY_H

#include "host/base/fault.h"

typedef struct {
  const char *name; /* of a function; NULL ends a list */
  void *pointer;    /* to the pointer to it, of the function's own type */
} library_function;

/* Load the library of the name that its users link by, and find its functions; it stays until the program ends. 0, or
 * -1 with *why set: `need` says what it was for and what to install. */
int library_load(const char *name, const library_function *functions, const char *need, fault *why);

#endif
