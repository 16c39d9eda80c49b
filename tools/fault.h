/* What went wrong, as the one line that the user gets: file, place in it, what is wrong, how to mend it. */
#ifndef QUARTER_TOOLS_FAULT_H
#define QUARTER_TOOLS_FAULT_H

/* Exit statuses of `quarter`. */
enum { EXIT_BAD_INPUT = 2 };

typedef struct {
  char text[1024];
} fault;

/* Write the line (printf style, no newline at the end). Always returns -1, so that a reader can `return fault_set(...)`. */
int fault_set(fault *why, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Print the line to standard error. Returns EXIT_BAD_INPUT, for a command to return. */
int fault_exit(const fault *why);

#endif
