/* What a user should know of an input that is read all the same. */
#ifndef QUARTER_HOST_NOTES_H
#define QUARTER_HOST_NOTES_H

#include "host/base/json.h"
#include "quarter/config.h"

#define NOTES_MOST (QTR_MAX_PLACES + QTR_MAX_SEEKERS + 8) /* one for each place and robot that was moved, and more */
#define NOTES_SIZE 640

typedef struct {
  int count;
  char text[NOTES_MOST][NOTES_SIZE];
} notes;

/* Add a line, printf style. More than NOTES_MOST are dropped. */
void notes_add(notes *n, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Print them to standard error from number `from` on, "quarter: note: ..." a line. */
void notes_print(const notes *n, int from);

/* The array "notes" of a report. */
void notes_json(const notes *n, json *j);

#endif
