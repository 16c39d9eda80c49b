/* Random numbers that are the same everywhere for the same seed: a run repeats bit for bit. Two generators, whose
 * streams never change; a robot has no use for either. */
#ifndef QUARTER_RANDOM_H
#define QUARTER_RANDOM_H

#include <stdint.h>

#include "quarter/status.h"

QTR_C_BEGIN

/* Knuth's linear congruential generator (MMIX), for draws of a few: 0..below-1, from the better half of its bits. */
static inline uint32_t qtr_lcg_below(uint64_t *state, uint32_t below) {
  QTR_ASSERT(below > 0); /* there is a number to draw */
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)((*state >> 33) % below);
}

/* SplitMix64 (Steele, Lea, Flood 2014): all 64 bits are good. */
static inline uint64_t qtr_splitmix_next(uint64_t *state) {
  uint64_t z = *state += 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

/* The same as a number from 0 to just below 1. */
static inline double qtr_splitmix_unit(uint64_t *state) {
  return (double)(qtr_splitmix_next(state) >> 11) * (1.0 / 9007199254740992.0);
}

QTR_C_END

#endif
