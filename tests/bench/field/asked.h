/* What ./run bench is asked for. */
#ifndef QUARTER_BENCH_ASKED_H
#define QUARTER_BENCH_ASKED_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "field/families.h"
#include "host/base/fault.h"

/* What is done with a family's problem: written as JSON, learnt in either setting, solved by `quarter exact`'s dynamic
 * programming, or plans of it judged. */
enum bench_task { BENCH_WRITE, BENCH_CERTIFIED, BENCH_PAPER, BENCH_EXACT, BENCH_JUDGE, BENCH_NO_TASK };

/* What of the benchmarks can be measured alone. */
enum bench_row { BENCH_MEMORY, BENCH_TERMS, BENCH_HORIZON, BENCH_PAPER_SPEED, BENCH_PLANS, BENCH_NO_ROW };

typedef struct {
  bool help, json, clone, takeover;
  int row;               /* enum bench_row */
  uint32_t certificates; /* held against the exact optimum; 0: none */
  const char *instances; /* a folder of TSPLIB files, or one of them; NULL: none */
  bool comes_home;
  double time_limit;  /* seconds of the processor for each */
  int task;           /* enum bench_task */
  family_wish family; /* its robots, objective and gamma are the instances', too */
} bench_asked;

/* 0, or -1 with *why set. */
int bench_ask(bench_asked *asked, int argc, char **argv, fault *why);

/* The exit status. */
int bench_help(FILE *out);

/* Print the fault. The exit status that it means. */
int bench_fail(const fault *why);

#endif
