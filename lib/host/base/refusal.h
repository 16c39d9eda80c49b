/* What is said of words on a command line that getopt_long does not take. */
#ifndef QUARTER_HOST_REFUSAL_H
#define QUARTER_HOST_REFUSAL_H

#include <getopt.h>

#include "host/base/fault.h"

/* After getopt_long returned '?' or ':' as `code` for argv[optind - 1]: names the option and, where there is one near
 * it, the one that may have been meant. `command` is shown before it ("learn: "; NULL: nothing). Always -1. */
int refuse_option(const char *command, int code, const char *word, const struct option *longs, fault *why);

#endif
