/* A table that also answers for starts in any region and for any set of places cleared beforehand, so that one table
 * serves redeployment and a mission resumed. */
#ifndef QUARTER_HOST_ANYWHERE_H
#define QUARTER_HOST_ANYWHERE_H

#include <stdbool.h>

#include "host/base/fault.h"
#include "host/plan/study.h"

/* What the ground says of the table's policies from random starts, against policies learnt for those starts alone. */
typedef struct {
  uint64_t games;   /* learnt for the table */
  bool complete;    /* all of them: no stop came between */
  uint32_t regions; /* 0: the mission's starts alone */
  int trials;
  double median_loss, worst_loss; /* of the objective, relative; 0.01 is one per cent */
} anywhere_report;

/* Learn the table that the settings ask for and write it to newly allocated `*bytes`, which the caller frees. The study
 * has been read and learnt for the mission's own starts. A stop leaves out the games that were not learnt yet: there
 * robots go by their rule. Returns the table's size, or 0 with *why set: it would not fit, or it was not begun before a
 * stop. */
uint32_t anywhere_learn(study *s, const plan_config *config, uint8_t **bytes, anywhere_report *report, fault *why);

#endif
