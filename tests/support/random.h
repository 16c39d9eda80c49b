/* Random cases for the tests: every case has a seed of its own, and a failure names it. QUARTER_TEST_SEED=N in the
 * environment moves all seeds by N, for a run on other cases. */
#ifndef QUARTER_TESTS_RANDOM_H
#define QUARTER_TESTS_RANDOM_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "quarter/random.h"

typedef struct {
  uint64_t state;
} test_random;

static char case_note[200]; /* for the assertions' _MESSAGE */

static inline uint64_t random_bits(test_random *random) {
  return qtr_splitmix_next(&random->state);
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
  return qtr_splitmix_unit(&random->state);
}

/* Of so many cases those that are tried: all on a host, the first ones on a board, whose emulator takes a hundred times
 * as long. */
#ifndef QUARTER_TEST_SHARE
#define QUARTER_TEST_SHARE 1
#endif
static inline unsigned random_cases(unsigned all) {
  return (all + QUARTER_TEST_SHARE - 1) / QUARTER_TEST_SHARE;
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
