/* Output files that appear whole or not at all: written beside their name, then renamed. */
#ifndef QUARTER_HOST_OUTFILE_H
#define QUARTER_HOST_OUTFILE_H

#include <stdbool.h>
#include <stdio.h>

#include "host/base/fault.h"

#define OUTFILE_PATH_SIZE 4096

typedef struct outfile outfile;
struct outfile {
  FILE *file;                        /* to write to */
  const char *path;                  /* as the user named it; "-" is standard output */
  char target[OUTFILE_PATH_SIZE];    /* what a link leads to: the link stays, the file behind it is replaced */
  char temporary[OUTFILE_PATH_SIZE]; /* empty: written directly, as a device, a pipe or standard output is */
  outfile *next;                     /* another one begun that has a temporary file */
};

/* Whether a file could be written there, found out before the work that fills it: what is there stays as it is. 0, or
 * -1 with *why set. */
int outfile_try(const char *path, fault *why);

/* Begin a file. `path` must last until the end. A file that the process has read is refused; one that is replaced keeps
 * its permissions. 0, or -1 with *why set and nothing left behind. */
int outfile_open(outfile *out, const char *path, fault *why);

/* Finish it: all written, on the disk, under its name. 0, or -1 with *why set and nothing left behind. */
int outfile_commit(outfile *out, fault *why);

/* Give it up: nothing is left behind. */
void outfile_abort(outfile *out);

/* Give up all that are begun and not finished. For a signal handler that ends the program: it makes system calls
 * alone. */
void outfile_abort_all(void);

/* Whether two names lead to one file, there already or not. */
bool outfile_is_same(const char *a, const char *b);

#endif
