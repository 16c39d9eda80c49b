/* What went wrong, as the line that the user gets: file, place in it, what is wrong, how to mend it. */
#ifndef QUARTER_HOST_FAULT_H
#define QUARTER_HOST_FAULT_H

#include <stdbool.h>
#include <stddef.h>

/* Exit statuses of `quarter`. */
enum {
  EXIT_BAD_INPUT = 2,
  EXIT_STOPPED = 3,   /* by a time limit or a signal, before there was anything to write */
  EXIT_UNVISITED = 4, /* simulated, and places were left although nothing was found */
  EXIT_UNFIT = 5      /* a table that a robot's build of the profile named does not hold */
};

#define FAULT_LINE 1024
#define FAULT_SIZE 32768

/* One line; several, with '\n' between, where an input has one fault in many places. */
typedef struct {
  int status; /* exit status that it means */
  char text[FAULT_SIZE];
} fault;

/* Write the line (printf style, no newline at the end). Always returns -1, so that a reader can `return
 * fault_set(...)`. The exit status is EXIT_BAD_INPUT. */
int fault_set(fault *why, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Add a line below what is there; "..." stands for those that no longer fit. Always returns -1. */
int fault_add(fault *why, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Add the lines of *why to those gathered in *all, which begins empty, so that what follows may be looked at too. False
 * where nothing is gathered (NULL): the first fault ends it. */
bool fault_keep(fault *all, fault *why);

/* Text in one line that does not steer a terminal: names and contents of files end up in messages. */
void fault_clean(char *text);

/* Print the lines to standard error. Returns the fault's exit status, for a command to return. */
int fault_exit(const fault *why);

#endif
