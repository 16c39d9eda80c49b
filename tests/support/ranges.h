/* Integers at the ends of their ranges and beyond, over tables of random missions. */
#ifndef QUARTER_TESTS_RANGES_H
#define QUARTER_TESTS_RANGES_H

#include <stdlib.h>
#include <string.h>

#include "quarter/robot.h"
#include "tables.h"

static qtr_policy policy;
static qtr_field table_field;
static uint8_t *exact; /* the table, in memory that ends where it ends */

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
  free(exact);
  exact = NULL;
}

static void open_random(const char *test, unsigned number, test_random *random) {
  *random = random_case(test, number);
  table_random(random, (mission_size){9, 7, 6, 4});
  free(exact);
  exact = malloc(table_size);
  TEST_ASSERT_NOT_NULL(exact);
  memcpy(exact, table_bytes, table_size);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, exact, table_size));
}

/* About the ends of the range 0..count-1, of a word and of half a word; or anywhere. */
static unsigned any_number(test_random *random, unsigned count) {
  const unsigned telling[] = {0,
                              1,
                              count - 1,
                              count,
                              count + 1,
                              0x7FFF,
                              0x8000,
                              0xFFFE,
                              0xFFFF,
                              0x10000,
                              0x7FFFFFFF,
                              0x80000000u,
                              0xFFFFFFFEu,
                              0xFFFFFFFFu,
                              32 * QTR_PLACE_WORDS,
                              QTR_MAX_PLACES,
                              QTR_MAX_SEEKERS};
  const unsigned kind = random_below(random, 4);
  if (kind == 0) return (unsigned)random_bits(random);
  if (kind == 1) return random_below(random, count + 3);
  return telling[random_below(random, sizeof telling / sizeof telling[0])];
}

#endif
