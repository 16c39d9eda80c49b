#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/base/json.h"
#include "unity.h"

static char *text;
static size_t size;
static FILE *out;
static json j;

void setUp(void) {
  out = open_memstream(&text, &size);
  TEST_ASSERT_NOT_NULL(out);
  json_begin(&j, out);
}

void tearDown(void) {
  free(text);
  text = NULL;
}

static const char *written(void) {
  fclose(out);
  return text;
}

static void test_members_stand_in_the_order_of_the_calls(void) {
  json_object(&j, NULL);
  json_integer(&j, "zebra", -3);
  json_array(&j, "list");
  json_bool(&j, NULL, true);
  json_null(&j, NULL);
  json_end_array(&j);
  json_string(&j, "ant", "x");
  json_end_object(&j);
  TEST_ASSERT_EQUAL_STRING("{\n  \"zebra\": -3,\n  \"list\": [\n    true,\n    null\n  ],\n  \"ant\": \"x\"\n}\n",
                           written());
}

static void test_empty_object_and_array_take_no_line(void) {
  json_object(&j, NULL);
  json_object(&j, "object");
  json_end_object(&j);
  json_array(&j, "array");
  json_end_array(&j);
  json_end_object(&j);
  TEST_ASSERT_EQUAL_STRING("{\n  \"object\": {},\n  \"array\": []\n}\n", written());
}

static void test_flat_members_stand_on_one_line_with_all_they_hold(void) {
  json_array(&j, NULL);
  json_flat_object(&j, NULL);
  json_array(&j, "places");
  json_natural(&j, NULL, 1);
  json_natural(&j, NULL, 2);
  json_end_array(&j);
  json_integer(&j, "seeker", 0);
  json_end_object(&j);
  json_flat_array(&j, NULL);
  json_end_array(&j);
  json_end_array(&j);
  TEST_ASSERT_EQUAL_STRING("[\n  {\"places\": [1, 2], \"seeker\": 0},\n  []\n]\n", written());
}

static void test_integers_keep_all_64_bits(void) {
  json_flat_array(&j, NULL);
  json_integer(&j, NULL, INT64_MIN);
  json_natural(&j, NULL, UINT64_MAX);
  json_end_array(&j);
  TEST_ASSERT_EQUAL_STRING("[-9223372036854775808, 18446744073709551615]\n", written());
}

static void test_numbers_are_short_where_short_is_exact(void) {
  json_flat_array(&j, NULL);
  json_number(&j, NULL, 0.1);
  json_number(&j, NULL, 1e-5);
  json_number(&j, NULL, 3);
  json_number(&j, NULL, 0.1 + 0.2);
  json_number(&j, NULL, 1.0 / 3);
  json_end_array(&j);
  TEST_ASSERT_EQUAL_STRING("[0.1, 1e-05, 3, 0.30000000000000004, 0.3333333333333333]\n", written());
}

static void test_numbers_that_json_lacks_are_null(void) {
  json_flat_array(&j, NULL);
  json_number(&j, NULL, NAN);
  json_number(&j, NULL, INFINITY);
  json_number(&j, NULL, -INFINITY);
  json_end_array(&j);
  TEST_ASSERT_EQUAL_STRING("[null, null, null]\n", written());
}

static void test_numbers_read_back_as_the_same_double(void) {
  enum { NUMBERS = 2000 };
  static double numbers[NUMBERS] = {DBL_MAX, DBL_MIN, DBL_TRUE_MIN, DBL_EPSILON, -0.0, 1e22, 0x1.b69b4ba630f34p56};
  uint64_t bits = 88172645463325252u;
  for (int n = 7; n < NUMBERS; n++) {
    do {
      bits ^= bits << 13;
      bits ^= bits >> 7;
      bits ^= bits << 17;
      memcpy(&numbers[n], &bits, sizeof bits);
    } while (!isfinite(numbers[n]));
  }
  json_flat_array(&j, NULL);
  for (int n = 0; n < NUMBERS; n++) json_number(&j, NULL, numbers[n]);
  json_end_array(&j);
  const char *at = written();
  for (int n = 0; n < NUMBERS; n++) {
    char *end;
    const double read = strtod(at + 1, &end);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&numbers[n], &read, sizeof read, at + 1);
    at = end;
  }
}

static void test_strings_are_escaped(void) {
  json_string(&j, NULL, "a\"b\\c\n\t\x01\x7f/");
  TEST_ASSERT_EQUAL_STRING("\"a\\\"b\\\\c\\u000a\\u0009\\u0001\\u007f/\"", written());
}

static void test_keys_are_escaped(void) {
  json_object(&j, NULL);
  json_null(&j, "\"\n");
  json_end_object(&j);
  TEST_ASSERT_EQUAL_STRING("{\n  \"\\\"\\u000a\": null\n}\n", written());
}

static void test_utf8_passes_and_what_is_none_is_replaced(void) {
#define REPLACED "\xEF\xBF\xBD"
  static const char *const cases[][2] = {
      {"\xC3\xA9 \xE2\x82\xAC \xF0\x9F\xA4\x96", "\xC3\xA9 \xE2\x82\xAC \xF0\x9F\xA4\x96"},
      {"a\xFF"
       "b",
       "a" REPLACED "b"},
      {"\xC3", REPLACED},                                        /* cut short by the end */
      {"\xE2\x82z", REPLACED REPLACED "z"},                      /* cut short by another */
      {"\xC0\xAF", REPLACED REPLACED},                           /* longer than need be */
      {"\xE0\x80\xAF", REPLACED REPLACED REPLACED},              /* the same in three bytes */
      {"\xED\xA0\x80", REPLACED REPLACED REPLACED},              /* half of a pair */
      {"\xF4\x90\x80\x80", REPLACED REPLACED REPLACED REPLACED}, /* beyond the last character */
  };
  json_array(&j, NULL);
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) json_string(&j, NULL, cases[c][0]);
  json_end_array(&j);
  const char *at = written();
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
    char expected[64];
    snprintf(expected, sizeof expected, "  \"%s\"", cases[c][1]);
    at = strchr(at, '\n') + 1;
    TEST_ASSERT_EQUAL_STRING_LEN(expected, at, strlen(expected));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_members_stand_in_the_order_of_the_calls);
  RUN_TEST(test_empty_object_and_array_take_no_line);
  RUN_TEST(test_flat_members_stand_on_one_line_with_all_they_hold);
  RUN_TEST(test_integers_keep_all_64_bits);
  RUN_TEST(test_numbers_are_short_where_short_is_exact);
  RUN_TEST(test_numbers_that_json_lacks_are_null);
  RUN_TEST(test_numbers_read_back_as_the_same_double);
  RUN_TEST(test_strings_are_escaped);
  RUN_TEST(test_keys_are_escaped);
  RUN_TEST(test_utf8_passes_and_what_is_none_is_replaced);
  return UNITY_END();
}
