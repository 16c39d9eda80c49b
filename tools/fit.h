/* `--profile`: whether a table fits a robot's build, and what it takes there. */
#ifndef QUARTER_TOOLS_FIT_H
#define QUARTER_TOOLS_FIT_H

#include <stdio.h>

#include "host/base/fault.h"
#include "host/base/json.h"
#include "host/table/robot_memory.h"
#include "host/table/robot_sizes.h"
#include "quarter/policy.h"

typedef struct {
  const char *profile;       /* NULL: none was asked for, and nothing below does anything */
  robot_sizes built, needed; /* of the profile; of the table */
  uint32_t flash_bytes;      /* of the table; 0: not known yet */
} fit;

/* `profile` as the command line has it, NULL for none. 0, or -1 with *why set. */
int fit_begin(fit *f, const char *profile, fault *why);

/* What an open table needs. */
void fit_take(fit *f, const qtr_policy *policy);

/* 0, or -1 with *why set and EXIT_UNFIT in it where the profile's arrays are too small for what is needed: the table of
 * `input`. */
int fit_check(const fit *f, const char *input, fault *why);

/* What the table takes, where it fits; and in JSON whether it does. */
void fit_write(FILE *out, const fit *f);
void fit_json(json *j, const fit *f);

#endif
