/* A command's report, as JSON or as text for people, where the options want it. */
#ifndef QUARTER_TOOLS_PRINT_H
#define QUARTER_TOOLS_PRINT_H

#include <stdio.h>

#include "host/base/fault.h"
#include "options.h"

/* Writes `what` to a file. */
typedef void (*print_writer)(FILE *out, const void *what);

/* Print JSON, or write it to the file that --json names, or else print text; quiet leaves the text out, and so does
 * another output that takes standard output. 0, or -1 with *why
 * set. */
int print_report(const options *o, print_writer json, print_writer text, const void *what, fault *why);

#endif
