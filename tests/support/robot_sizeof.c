#include "support/robot_sizeof.h"

#include <stddef.h>

#include "quarter/robot.h"

struct aligned {
  char before;
  int64_t number;
};

/* ROBOT_SIZEOF is what this build's is called. */
extern const robot_sizeof ROBOT_SIZEOF;
const robot_sizeof ROBOT_SIZEOF = {.cells = QTR_MAX_CELLS,
                                   .places = QTR_MAX_PLACES,
                                   .seekers = QTR_MAX_SEEKERS,
                                   .policy = sizeof(qtr_policy),
                                   .seeker = sizeof(qtr_seeker),
                                   .field = sizeof(qtr_field),
                                   .pointer = sizeof(void *),
                                   .alignment = offsetof(struct aligned, number)};
