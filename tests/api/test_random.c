/* profiles: host mcu */
/* The two generators' streams, which never change: tables, reports and the demo's figures rest on them. */
#include "quarter/random.h"
#include "unity.h"

void setUp(void) {
}

void tearDown(void) {
}

/* The first numbers that the authors' own code gives for this seed. */
static void test_splitmix_gives_the_published_stream(void) {
  static const uint64_t published[] = {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                       4593380528125082431u, 16408922859458223821u};
  uint64_t state = 1234567;
  for (unsigned i = 0; i < 5; i++) TEST_ASSERT_EQUAL_UINT64(published[i], qtr_splitmix_next(&state));
}

static void test_unit_is_the_upper_53_bits(void) {
  uint64_t state = 1234567;
  TEST_ASSERT_TRUE(qtr_splitmix_unit(&state) == (double)(6457827717110365317u >> 11) / 9007199254740992.0);
}

/* 1 * a + c and what follows it, worked out in integers of any size. */
static void test_lcg_gives_the_upper_31_bits_of_its_state(void) {
  uint64_t state = 1;
  TEST_ASSERT_EQUAL_UINT32(908834774, qtr_lcg_below(&state, 1u << 31));
  TEST_ASSERT_EQUAL_UINT64(7806831264735756412u, state);
  TEST_ASSERT_EQUAL_UINT32(1093944153u % 10, qtr_lcg_below(&state, 10));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_splitmix_gives_the_published_stream);
  RUN_TEST(test_unit_is_the_upper_53_bits);
  RUN_TEST(test_lcg_gives_the_upper_31_bits_of_its_state);
  return UNITY_END();
}
