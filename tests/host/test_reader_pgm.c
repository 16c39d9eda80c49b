#include <stdlib.h>
#include <string.h>

#include "host/input/pgm.h"
#include "unity.h"

static fault why;
static image it;

void setUp(void) {
  why.text[0] = '\0';
}

void tearDown(void) {
}

/* Decode from memory of exactly that size (and the NUL that a file's bytes have), so that a sanitizer sees every byte
 * read beyond it. */
static int decode(const void *data, size_t size) {
  file_bytes bytes = {malloc(size + 1), size};
  TEST_ASSERT_NOT_NULL(bytes.data);
  memcpy(bytes.data, data, size);
  bytes.data[size] = '\0';
  int result = pgm_read(&it, "m.pgm", &bytes, &why);
  free(bytes.data);
  return result;
}

static void expect(const void *data, size_t size, int width, int height, int maximum, const uint16_t *samples) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, decode(data, size), why.text);
  TEST_ASSERT_EQUAL_INT(width, it.width);
  TEST_ASSERT_EQUAL_INT(height, it.height);
  TEST_ASSERT_EQUAL_INT(maximum, it.maximum);
  TEST_ASSERT_EQUAL_UINT16_ARRAY(samples, it.samples, width * height);
  image_free(&it);
}

static void refuse(const void *data, size_t size, const char *what) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, decode(data, size), what);
  TEST_ASSERT_EQUAL_STRING_LEN("m.pgm:", why.text, 6);
  if (strstr(why.text, what) == NULL) TEST_FAIL_MESSAGE(why.text);
  TEST_ASSERT_NULL(it.samples);
}

#define EXPECT(text, width, height, maximum, samples) expect(text, sizeof(text) - 1, width, height, maximum, samples)
#define REFUSE(text, what) refuse(text, sizeof(text) - 1, what)

static void test_binary_bytes(void) {
  const uint16_t samples[] = {0, 10, 32, 255, 35, 205};
  EXPECT("P5\n3 2\n255\n\0\n \xff#\xcd", 3, 2, 255, samples);
}

static void test_binary_words_have_the_high_byte_first(void) {
  const uint16_t samples[] = {1, 256, 65535, 0};
  EXPECT("P5 4 1 65535\n\0\1\1\0\xff\xff\0\0", 4, 1, 65535, samples);
  const uint16_t small[] = {256, 255};
  EXPECT("P5 2 1 256\n\1\0\0\xff", 2, 1, 256, small);
}

static void test_plain_with_comments_anywhere(void) {
  const uint16_t samples[] = {0, 7, 15, 3};
  EXPECT("P2# one\n# two\n2#three\n 2 # four\n15\n0 7 # five\n15\n\t3\n", 2, 2, 15, samples);
  EXPECT("P2\r\n2 2\r\n15\r\n0 7\r\n15 3", 2, 2, 15, samples);
}

static void test_binary_header_with_comments(void) {
  const uint16_t samples[] = {35, 9};
  EXPECT("P5#a\n#b 9 9\n2 #c\n#d\n1\n#e\n255\n#\t", 2, 1, 255, samples);
  EXPECT("P5 2 1 255# right behind\n#\t", 2, 1, 255, samples);
}

static void test_carriage_return_before_samples(void) {
  const uint16_t samples[] = {10, 9};
  EXPECT("P5\r\n2 1\r\n255\r\n\n\t", 2, 1, 255, samples);
  EXPECT("P5\n2 1\n255\r\n\t", 2, 1, 255, samples); /* the sample itself is 10 */
}

static void test_blanks_after_the_samples(void) {
  const uint16_t samples[] = {1, 2};
  EXPECT("P5 2 1 255\n\1\2\n", 2, 1, 255, samples);
  EXPECT("P2 2 1 255\n1 2\n# done\n", 2, 1, 255, samples);
  REFUSE("P5 2 1 255\n\1\2\3", "goes on for 1 byte after");
  REFUSE("P2 2 1 255\n1 2 3", "goes on for 1 byte after");
}

static void test_wrong_magic(void) {
  REFUSE("", "not a PGM");
  REFUSE("P", "not a PGM");
  REFUSE("P6 1 1 255\n\1\1\1", "not a PGM");
  REFUSE("P52 1 255\n\1\1", "not a PGM");
  REFUSE("\x89PNG\r\n", "not a PGM");
}

static void test_truncated(void) {
  REFUSE("P5", "ends before the width");
  REFUSE("P5 3 # 4", "ends before the height");
  REFUSE("P5 3 4", "ends before the maximum grey");
  REFUSE("P5 3 4 255", "is cut off: its header says 3 x 4 pixels, which take 12 bytes, but it holds 0");
  REFUSE("P5 3 4 255\n12345678901", "but it holds 11");
  REFUSE("P5 3 4 256\n123456789012", "which take 24 bytes, but it holds 12");
  REFUSE("P2 2 2 255\n100 100 100", "is cut off: its header says 2 x 2 pixels, which take 4 samples, but it holds 3");
  REFUSE("P2 9 9 255\n1 1", "is cut off");
}

static void test_absurd_headers(void) {
  REFUSE("P5 0 4 255\n", "the width is 0");
  REFUSE("P5 4 0 255\n", "the height is 0");
  REFUSE("P5 4 4 0\n", "the maximum grey is 0");
  REFUSE("P5 4 4 65536\n", "the maximum grey is above 65535");
  REFUSE("P5 65536 1 255\n", "the width is above 65535");
  REFUSE("P5 65535 65535 255\n", "more than 67108864");
  REFUSE("P5 8192 8192 255\n", "is cut off");
  REFUSE("P5 99999999999999999999999 1 255\n", "the width is above 65535");
  REFUSE("P5 -3 4 255\n", "the width is not a whole number");
  REFUSE("P5 3.5 4 255\n", "the height is not a whole number");
  REFUSE("P5\n3 4\nwhite\n", "the maximum grey is not a whole number");
  REFUSE("P5 1 1 255x\1", "not followed by a blank");
}

static void test_samples_above_the_maximum(void) {
  REFUSE("P5 2 2 100\n\1\2\3\x65", "column 1, row 1 is 101, above the maximum grey 100");
  REFUSE("P2 2 1 100\n1 101\n", "column 1, row 0 is 101");
  REFUSE("P2 2 1 100\n1 99999999999999999999\n", "the sample is above 99999");
  REFUSE("P2 2 1 100\n1 -1\n", "the sample is not a whole number");
}

static void test_faults_name_the_line_of_the_header(void) {
  REFUSE("P5\n# x\n3\nfour 255\n", "m.pgm:4: the height");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_binary_bytes);
  RUN_TEST(test_binary_words_have_the_high_byte_first);
  RUN_TEST(test_plain_with_comments_anywhere);
  RUN_TEST(test_binary_header_with_comments);
  RUN_TEST(test_carriage_return_before_samples);
  RUN_TEST(test_blanks_after_the_samples);
  RUN_TEST(test_wrong_magic);
  RUN_TEST(test_truncated);
  RUN_TEST(test_absurd_headers);
  RUN_TEST(test_samples_above_the_maximum);
  RUN_TEST(test_faults_name_the_line_of_the_header);
  return UNITY_END();
}
