/* A table that also answers for starts in any region and for any set of places cleared beforehand, so that one table
 * serves redeployment and a mission resumed. */
#ifndef QUARTER_HOST_ANYWHERE_H
#define QUARTER_HOST_ANYWHERE_H

#include <stdbool.h>

#include "host/base/fault.h"
#include "host/plan/study.h"

/* What the ground says of the table's policies from random starts, against policies learnt for those starts alone. */
typedef struct {
  uint64_t games;         /* learnt for the table */
  bool complete;          /* all that were meant: no stop came between */
  uint32_t regions;       /* of the table; 0: the mission's starts alone */
  uint32_t regions_meant; /* after a stop there may be fewer, or in some of them robots go by their rule */
  int trials;             /* drawn by the learner's seed */
  double median_loss, ninety_loss, worst_loss; /* of the objective, relative; 0.01 is one per cent; nine tenths of the
                                                  trials lose no more than the second */
} anywhere_report;

/* Learn the table that the settings ask for and write it to newly allocated `*bytes`, which the caller frees. The study
 * has been read and learnt for the mission's own starts. Where the settings do not say how many regions, there are as
 * many as the limit of bytes, that of time if there is one, and some minutes' work allow. Regions come to be learnt by
 * stages, half as many, then all; a stop leaves the last stage that was whole. If there was none, robots go by their
 * rule where no game was learnt. Returns the table's size, or 0 with *why set: it would not fit, or it was not begun
 * before a stop. */
uint32_t anywhere_learn(study *s, const plan_config *config, uint8_t **bytes, anywhere_report *report, fault *why);

#endif
