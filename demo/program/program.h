/* What the programs that play a game begin and end with. */
#ifndef QUARTER_DEMO_PROGRAM_H
#define QUARTER_DEMO_PROGRAM_H

#include <stdio.h>

#include "settings.h"

typedef struct {
  const char *name;
  int (*help)(FILE *out);
  int (*run)(const settings *s, fault *why);
  const volatile int *interrupted; /* the exit status of a game that was ended by a signal; 0: it was not */
} program;

/* Parse the words, and print help or version, or run. The exit status, for main() to return. */
int program_main(const program *p, int argc, char **argv);

#endif
