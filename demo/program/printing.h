/* Help and version, on standard output, which may be a disk that is full. */
#ifndef QUARTER_DEMO_PRINTING_H
#define QUARTER_DEMO_PRINTING_H

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* Print the text. The exit status: 0, or 2 with one line on standard error if it cannot be printed whole. */
static inline int print_whole(const char *program, const char *text) {
  if (fputs(text, stdout) >= 0 && fflush(stdout) == 0) return 0;
  fprintf(stderr, "%s: standard output cannot be written: %s\n", program, strerror(errno));
  return 2;
}

#endif
