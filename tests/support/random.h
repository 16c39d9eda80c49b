/* Random cases for the tests: every case has a seed of its own, and a failure names it. QUARTER_TEST_SEED=N in the
 * environment moves all seeds by N, for a run on other cases. */
#ifndef QUARTER_TESTS_RANDOM_H
#define QUARTER_TESTS_RANDOM_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
  uint64_t state;
} test_random;

static char case_note[200]; /* for the assertions' _MESSAGE */

static inline uint64_t random_bits(test_random *random) {
  uint64_t z = random->state += 0x9E3779B97F4A7C15u;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return z ^ z >> 31;
}

/* 0..below-1 */
static inline unsigned random_below(test_random *random, unsigned below) {
  return (unsigned)(random_bits(random) >> 32) % below;
}

static inline unsigned random_in(test_random *random, unsigned least, unsigned most) {
  return least + random_below(random, most - least + 1);
}

static inline bool random_chance(test_random *random, unsigned percent) {
  return random_below(random, 100) < percent;
}

/* 0 or more and less than 1 */
static inline double random_unit(test_random *random) {
  return (double)(random_bits(random) >> 11) / 9007199254740992.0;
}

/* Begin case `number` of a test: its random numbers, and the note that names its seed. */
static inline test_random random_case(const char *test, unsigned number) {
  const char *moved = getenv("QUARTER_TEST_SEED");
  const uint64_t seed = number + (moved != NULL ? strtoull(moved, NULL, 10) : 0);
  test_random random = {seed * 0xD1342543DE82EF95u + 1};
  snprintf(case_note, sizeof case_note, "%s: seed %llu", test, (unsigned long long)seed);
  return random;
}

#endif
