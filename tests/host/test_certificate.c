/* How near to the optimum a plan is said to be. */
#include "host/table/certificate.h"

#include <string.h>

#include "unity.h"

void setUp(void) {
}
void tearDown(void) {
}

static const char *told(bool certified, double gap, int negligible) {
  static char text[128];
  FILE *file = tmpfile();
  TEST_ASSERT_NOT_NULL(file);
  certificate_tell(file, certified, gap, negligible);
  rewind(file);
  text[fread(text, 1, sizeof text - 1, file)] = '\0';
  fclose(file);
  return text;
}

static void test_what_is_within_the_default_gap_is_optimal(void) {
  TEST_ASSERT_EQUAL_STRING("certified optimal", told(true, 0.0, 0));
  TEST_ASSERT_EQUAL_STRING("certified optimal to 2.8e-05%", told(true, 2.8e-7, 0));
  TEST_ASSERT_EQUAL_STRING("certified optimal to 0.001%", told(true, 1e-5, 0));
  TEST_ASSERT_EQUAL_STRING("certified: within 0.5% of the optimum", told(true, 0.005, 0));
}

static void test_nothing_is_optimal_that_has_places_of_no_certified_order(void) {
  TEST_ASSERT_EQUAL_STRING("certified: within 1e-07% of the optimum", told(true, 0.0, 2));
}

static void test_what_is_not_certified_is_not_said_to_be_optimal(void) {
  TEST_ASSERT_EQUAL_STRING("not certified: at most 1e-07% from the optimum", told(false, 1e-9, 0));
  TEST_ASSERT_EQUAL_STRING("not certified: at most 3.21% from the optimum", told(false, 0.03211, 0));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_what_is_within_the_default_gap_is_optimal);
  RUN_TEST(test_nothing_is_optimal_that_has_places_of_no_certified_order);
  RUN_TEST(test_what_is_not_certified_is_not_said_to_be_optimal);
  return UNITY_END();
}
