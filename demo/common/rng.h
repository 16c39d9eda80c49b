/* Random numbers that are the same everywhere for the same seed: SplitMix64 (Steele, Lea, Flood 2014). */
#ifndef QUARTER_DEMO_RNG_H
#define QUARTER_DEMO_RNG_H

#include <stdint.h>

typedef struct {
  uint64_t state;
} rng;

static inline void rng_seed(rng *r, uint64_t seed) {
  r->state = seed;
}

static inline uint64_t rng_next(rng *r) {
  uint64_t z = (r->state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/* From 0 to just below 1. */
static inline double rng_unit(rng *r) {
  return (double)(rng_next(r) >> 11) * 0x1p-53;
}

/* Mean 0, standard deviation 1, never beyond 6: the sum of twelve units (a normal variate, nearly). */
static inline double rng_normal(rng *r) {
  double sum = -6.0;
  for (int i = 0; i < 12; i++) sum += rng_unit(r);
  return sum;
}

#endif
