/* Random numbers of the demo: the same everywhere for the same seed (quarter/random.h). */
#ifndef QUARTER_DEMO_RNG_H
#define QUARTER_DEMO_RNG_H

#include <stdint.h>

#include "quarter/random.h"

typedef struct {
  uint64_t state;
} rng;

static inline void rng_seed(rng *r, uint64_t seed) {
  r->state = seed;
}

static inline uint64_t rng_next(rng *r) {
  return qtr_splitmix_next(&r->state);
}

/* From 0 to just below 1. */
static inline double rng_unit(rng *r) {
  return qtr_splitmix_unit(&r->state);
}

/* Mean 0, standard deviation 1, never beyond 6: the sum of twelve units (a normal variate, nearly). */
static inline double rng_normal(rng *r) {
  double sum = -6.0;
  for (int i = 0; i < 12; i++) sum += rng_unit(r);
  return sum;
}

#endif
