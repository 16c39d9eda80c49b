/* profiles: host mcu */
/* The checksum is the world's CRC-32, not one of our own. */
#include "core/crc.h"

#include <string.h>

#include "unity.h"

void setUp(void) {
}

void tearDown(void) {
}

static uint32_t crc_of(const char *text) {
  return qtr_crc32_add(0, (const uint8_t *)text, (uint32_t)strlen(text));
}

static void test_check_value_of_the_standard(void) {
  TEST_ASSERT_EQUAL_HEX32(0xCBF43926u, crc_of("123456789"));
}

/* As zlib's crc32() has them. */
static void test_values_of_others(void) {
  TEST_ASSERT_EQUAL_HEX32(0x00000000u, crc_of(""));
  TEST_ASSERT_EQUAL_HEX32(0xE8B7BE43u, crc_of("a"));
  TEST_ASSERT_EQUAL_HEX32(0x414FA339u, crc_of("The quick brown fox jumps over the lazy dog"));
  TEST_ASSERT_EQUAL_HEX32(0xD202EF8Du, qtr_crc32_add(0, (const uint8_t[]){0}, 1));
  TEST_ASSERT_EQUAL_HEX32(0xFF000000u, qtr_crc32_add(0, (const uint8_t[]){0xFF}, 1));
}

static void test_sum_of_parts_is_that_of_the_whole(void) {
  const uint8_t *digits = (const uint8_t *)"123456789";
  for (uint32_t cut = 0; cut <= 9; cut++)
    TEST_ASSERT_EQUAL_HEX32(0xCBF43926u, qtr_crc32_add(qtr_crc32_add(0, digits, cut), digits + cut, 9 - cut));
}

/* Bit by bit, by the polynomial. */
static void test_every_byte_by_the_polynomial(void) {
  for (unsigned byte = 0; byte < 256; byte++) {
    uint32_t slow = ~(uint32_t)0 ^ byte;
    for (int bit = 0; bit < 8; bit++) slow = slow >> 1 ^ ((slow & 1u) != 0 ? 0xEDB88320u : 0);
    const uint8_t one = (uint8_t)byte;
    TEST_ASSERT_EQUAL_HEX32(~slow, qtr_crc32_add(0, &one, 1));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_check_value_of_the_standard);
  RUN_TEST(test_values_of_others);
  RUN_TEST(test_sum_of_parts_is_that_of_the_whole);
  RUN_TEST(test_every_byte_by_the_polynomial);
  return UNITY_END();
}
