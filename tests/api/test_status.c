/* profiles: host mcu */
/* Status codes: each has a text of its own, and no number is without one. */
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "quarter/status.h"
#include "unity.h"

static const int codes[] = {
    QTR_OK,           QTR_ERR_CONFIG,      QTR_ERR_ARGUMENT, QTR_ERR_LIMIT,   QTR_ERR_SPACE,       QTR_ERR_TRUNCATED,
    QTR_ERR_MAGIC,    QTR_ERR_FORMAT,      QTR_ERR_CHECKSUM, QTR_ERR_CORRUPT, QTR_ERR_SELFTEST,    QTR_ERR_NO_START,
    QTR_ERR_NO_PLACE, QTR_ERR_START,       QTR_ERR_PLACE,    QTR_ERR_WEIGHT,  QTR_ERR_UNREACHABLE, QTR_ERR_DISCOUNT,
    QTR_ERR_TRAVEL,   QTR_ERR_CERTIFICATE, QTR_ERR_STOPPED};
enum { CODES = sizeof codes / sizeof codes[0] };

void setUp(void) {
}

void tearDown(void) {
}

static void test_success_is_zero_and_errors_are_negative(void) {
  TEST_ASSERT_EQUAL_INT(0, QTR_OK);
  for (int i = 1; i < CODES; i++) TEST_ASSERT_LESS_THAN(0, codes[i]);
}

static void test_every_code_has_a_line_of_its_own(void) {
  for (int i = 0; i < CODES; i++) {
    const char *text = qtr_strerror(codes[i]);
    TEST_ASSERT_NOT_NULL(text);
    TEST_ASSERT_GREATER_THAN(3, strlen(text));
    TEST_ASSERT_NULL(strchr(text, '\n'));
    TEST_ASSERT_TRUE(strcmp(text, "unknown status") != 0);
    for (int j = 0; j < i; j++) TEST_ASSERT_TRUE(strcmp(text, qtr_strerror(codes[j])) != 0);
  }
}

static void test_texts_say_what_their_codes_mean(void) {
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_OK), "success"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_CHECKSUM), "checksum"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_WEIGHT), "weight"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_UNREACHABLE), "reached"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_DISCOUNT), "discount"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_SAVE), "save"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_CLASS), "class"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_LOOKS), "looks"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_HORIZON), "time"));
  TEST_ASSERT_NOT_NULL(strstr(qtr_strerror(QTR_ERR_NO_START), "no seeker"));
}

static void test_numbers_that_are_no_codes_are_unknown(void) {
  static const int strangers[] = {1, 2, INT_MAX, INT_MIN, INT_MIN + 1, QTR_ERR_HORIZON - 1, -1000};
  for (unsigned i = 0; i < sizeof strangers / sizeof strangers[0]; i++)
    TEST_ASSERT_EQUAL_STRING("unknown status", qtr_strerror(strangers[i]));
}

static void test_version_string_is_the_version_numbers(void) {
  char text[32];
  snprintf(text, sizeof text, "%d.%d.%d", QTR_VERSION_MAJOR, QTR_VERSION_MINOR, QTR_VERSION_PATCH);
  TEST_ASSERT_EQUAL_STRING(text, QTR_VERSION_STRING);
}

static void test_version_as_a_number_is_that_of_the_linked_library(void) {
  TEST_ASSERT_EQUAL_UINT32(QTR_VERSION, qtr_version());
  TEST_ASSERT_EQUAL_UINT32(QTR_VERSION_MAJOR, qtr_version() >> 16);
  TEST_ASSERT_EQUAL_UINT32(QTR_VERSION_MINOR, qtr_version() >> 8 & 0xFFu);
  TEST_ASSERT_EQUAL_UINT32(QTR_VERSION_PATCH, qtr_version() & 0xFFu);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_success_is_zero_and_errors_are_negative);
  RUN_TEST(test_every_code_has_a_line_of_its_own);
  RUN_TEST(test_texts_say_what_their_codes_mean);
  RUN_TEST(test_numbers_that_are_no_codes_are_unknown);
  RUN_TEST(test_version_string_is_the_version_numbers);
  RUN_TEST(test_version_as_a_number_is_that_of_the_linked_library);
  return UNITY_END();
}
