/* What ./run bench is asked for. */
#ifndef QUARTER_BENCH_ASKED_H
#define QUARTER_BENCH_ASKED_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "host/base/fault.h"

typedef struct {
  bool help, json, clone, takeover;
  const char *instances; /* a folder of TSPLIB files, or one of them; NULL: none */
  uint32_t robots;
  bool comes_home;
  int objective; /* enum qtr_objective_kind */
  double gamma;
  double time_limit; /* seconds of the processor for each */
} bench_asked;

/* 0, or -1 with *why set. */
int bench_ask(bench_asked *asked, int argc, char **argv, fault *why);

/* The exit status. */
int bench_help(FILE *out);

/* Print the fault. The exit status that it means. */
int bench_fail(const fault *why);

#endif
