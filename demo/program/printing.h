/* Help and version, on standard output, which may be a disk that is full. */
#ifndef QUARTER_DEMO_PRINTING_H
#define QUARTER_DEMO_PRINTING_H

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* That all which was printed got through. The exit status: 0, or 2 with one line on standard error. */
static inline int print_end(const char *program) {
  if (fflush(stdout) == 0 && ferror(stdout) == 0) return 0;
  fprintf(stderr, "%s: standard output cannot be written: %s\n", program, strerror(errno));
  return 2;
}

#endif
