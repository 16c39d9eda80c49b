/* Instances of the literature: TSPLIB 95 files, their distances worked out and rounded as TSPLIB has it. */
#ifndef QUARTER_BENCH_TSPLIB_H
#define QUARTER_BENCH_TSPLIB_H

#include <stdint.h>

#include "host/base/fault.h"

#define TSPLIB_NAME 64

enum tsplib_kind { TSPLIB_EUC_2D, TSPLIB_CEIL_2D, TSPLIB_ATT, TSPLIB_GEO, TSPLIB_EXPLICIT, TSPLIB_KINDS };

/* {0} is none. */
typedef struct {
  char name[TSPLIB_NAME];
  unsigned towns;
  long line;          /* of the section that the distances come from */
  uint32_t *distance; /* a row of towns for each town, from it to the others */
} tsplib;

/* Read a file of type TSP or ATSP. 0, or -1 with *why set, by file and line, and nothing to free. */
int tsplib_read(tsplib *instance, const char *path, fault *why);

void tsplib_free(tsplib *instance);

/* The distance of two towns by their coordinates; not of EXPLICIT. */
uint32_t tsplib_distance(enum tsplib_kind kind, const double *from, const double *to);

#endif
