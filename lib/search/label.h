/* A route that is grown place by place (search/pool.h). */
#ifndef QUARTER_SEARCH_LABEL_H
#define QUARTER_SEARCH_LABEL_H

#include <stdbool.h>
#include <stdint.h>

#include "quarter/config.h"

#define QTR_NO_LABEL UINT32_MAX

/* A route up to its last place. */
typedef struct {
  double net;      /* worth of its visits, less what prices take of it */
  qtr_steps when;  /* of the last one */
  uint32_t before; /* the label that it was grown from: one further ahead */
  uint32_t next;   /* with the same hash */
  uint16_t node;   /* where it ends */
  uint8_t squad;
  uint8_t state;
  uint32_t set[]; /* the places on it, bit p % 32 of word p / 32 for place p */
} qtr_label;

static inline bool qtr_label_has(const qtr_label *label, unsigned place) {
  return (label->set[place / 32] >> (place % 32) & 1u) != 0;
}

#endif
