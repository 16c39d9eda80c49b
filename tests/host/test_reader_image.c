/* PNG and BMP images beside PGM: the samples that map_server would see, and bytes that are not what they claim. The
 * images in tests/data/images were written by another program, byte by byte. */
#include "host/input/decode.h"

#include <stdlib.h>
#include <string.h>

#include "unity.h"

static fault why;
static image it;
static file_bytes bytes;

void setUp(void) {
  why.text[0] = '\0';
  memset(&it, 0, sizeof it);
}

void tearDown(void) {
  file_free(&bytes);
  image_free(&it);
}

static void load(const char *name) {
  char path[1024];
  snprintf(path, sizeof path, QUARTER_SOURCE_DIR "/tests/data/images/%s", name);
  file_free(&bytes);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, file_read(&bytes, path, FILE_MAP_LIMIT, NULL, &why), why.text);
}

/* Of memory of exactly that size, so that a sanitizer sees every byte read beyond it. */
static int decode_part(size_t size, enum image_alpha how) {
  file_bytes part = {malloc(size + 1), size};
  TEST_ASSERT_NOT_NULL(part.data);
  memcpy(part.data, bytes.data, size);
  part.data[size] = '\0';
  image_free(&it);
  const int result = decode_image(&it, "m", &part, how, &why);
  free(part.data);
  return result;
}

static bool is_here(const char *name) {
#ifndef QUARTER_HAVE_SPNG
  if (strstr(name, ".png") != NULL) return false;
#endif
#ifndef QUARTER_HAVE_STB
  if (strstr(name, ".bmp") != NULL) return false;
#endif
  return strchr(name, '.') != NULL;
}

static void expect(const char *name, enum image_alpha how, int maximum, const uint16_t samples[6]) {
  load(name);
  if (!is_here(name)) return;
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, decode_part(bytes.size, how), why.text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(3, it.width, name);
  TEST_ASSERT_EQUAL_INT_MESSAGE(2, it.height, name);
  TEST_ASSERT_EQUAL_INT_MESSAGE(maximum, it.maximum, name);
  TEST_ASSERT_EQUAL_UINT16_ARRAY_MESSAGE(samples, it.samples, 6, name);
}

#define GREYS ((const uint16_t[]){0, 615, 765, 762, 0, 300})
#define COLOURS ((const uint16_t[]){0, 615, 765, 255, 255, 61})

static void test_grey_and_colour_are_the_sum_of_three_channels(void) {
  static const char *const greys[] = {"grey8.png", "interlaced.png", "grey8.bmp", "grey4.bmp"};
  for (size_t i = 0; i < sizeof greys / sizeof *greys; i++)
    for (int how = IMAGE_ALPHA_AVERAGED; how <= IMAGE_ALPHA_IGNORED; how++)
      expect(greys[i], (enum image_alpha)how, 765, GREYS);
  static const char *const colours[] = {"rgb8.png", "rgb24.bmp", "topdown.bmp", "rgb32.bmp", "masks32.bmp"};
  for (size_t i = 0; i < sizeof colours / sizeof *colours; i++) expect(colours[i], IMAGE_ALPHA_AVERAGED, 765, COLOURS);
}

static void test_few_bits_are_spread_over_the_range(void) {
  expect("grey1.png", IMAGE_ALPHA_AVERAGED, 765, (const uint16_t[]){0, 765, 765, 765, 0, 0});
  expect("grey1.bmp", IMAGE_ALPHA_AVERAGED, 765, (const uint16_t[]){0, 765, 765, 765, 0, 0});
  expect("grey2.png", IMAGE_ALPHA_AVERAGED, 765, (const uint16_t[]){0, 255, 765, 510, 765, 0});
}

static void test_palettes(void) {
  expect("palette.png", IMAGE_ALPHA_AVERAGED, 765, (const uint16_t[]){0, 615, 765, 765, 615, 0});
  /* A palette with transparency has alpha: 255, 128, and 255 where it is not stated. */
  expect("palette4.png", IMAGE_ALPHA_AVERAGED, 1020, (const uint16_t[]){255, 743, 1020, 1020, 743, 255});
}

static void test_sixteen_bits_are_averaged(void) {
  expect("grey16.png", IMAGE_ALPHA_AVERAGED, 65535, (const uint16_t[]){0, 52685, 65535, 65278, 0, 25700});
  expect("rgb16.png", IMAGE_ALPHA_AVERAGED, 65535, (const uint16_t[]){0, 52685, 65535, 21845, 2, 7});
}

static void test_alpha_is_a_fourth_channel_where_it_is_averaged(void) {
  static const uint16_t wanted[] = {255, 870, 1020, 762, 0, 743};
  expect("greyalpha8.png", IMAGE_ALPHA_AVERAGED, 1020, wanted);
  expect("rgba8.png", IMAGE_ALPHA_AVERAGED, 1020, (const uint16_t[]){255, 870, 1020, 765, 0, 743});
  expect("rgba32.bmp", IMAGE_ALPHA_AVERAGED, 1020, (const uint16_t[]){255, 870, 1020, 765, 0, 743});
  expect("greyalpha16.png", IMAGE_ALPHA_AVERAGED, 65535, (const uint16_t[]){16384, 55898, 65535, 48959, 0, 47738});
  expect("trns.png", IMAGE_ALPHA_AVERAGED, 1020, (const uint16_t[]){255, 615, 1020, 1017, 255, 555});
}

static void test_alpha_marks_or_does_not_count(void) {
  static const char *const names[] = {"rgba8.png", "rgba32.bmp"};
  static const uint8_t transparent[] = {0, 0, 0, 1, 1, 1};
  static const uint16_t samples[] = {0, 615, 765, 765, 0, 615};
  for (size_t i = 0; i < 2; i++) {
    if (!is_here(names[i])) continue;
    expect(names[i], IMAGE_ALPHA_IGNORED, 765, samples);
    TEST_ASSERT_NULL(it.transparent);
    expect(names[i], IMAGE_ALPHA_MARKED, 765, samples);
    TEST_ASSERT_NOT_NULL(it.transparent);
    TEST_ASSERT_EQUAL_UINT8_ARRAY(transparent, it.transparent, 6);
  }
}

static void test_an_opaque_grey_has_the_sample_that_is_told(void) {
  static const char *const names[] = {"grey8.png",      "grey16.png",      "rgb8.png",  "rgb16.png", "rgba8.png",
                                      "greyalpha8.png", "greyalpha16.png", "grey8.bmp", "rgba32.bmp"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    load(names[i]);
    if (!is_here(names[i])) continue;
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, decode_part(bytes.size, IMAGE_ALPHA_AVERAGED), why.text);
    TEST_ASSERT_EQUAL_INT_MESSAGE(it.samples[1], image_grey(&it, 205), names[i]); /* the second pixel of each is 205 */
  }
}

/* ---- what is no image ---- */

static void refuse(const char *name, const char *what, const char *mend) {
  load(name);
  if (!is_here(name)) return;
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, decode_part(bytes.size, IMAGE_ALPHA_AVERAGED), name);
  TEST_ASSERT_NULL(it.samples);
  TEST_ASSERT_NULL_MESSAGE(strchr(why.text, '\n'), why.text);
  if (strncmp(why.text, "m: ", 3) != 0 || strstr(why.text, what) == NULL || strstr(why.text, mend) == NULL)
    TEST_FAIL_MESSAGE(why.text);
}

static void test_bombs_are_refused_before_they_go_off(void) {
  refuse("promise.png", "is cut off: its header says 8000 x 8000 pixels", "copy the file anew");
  refuse("large.png", "60000 x 60000 pixels are more than 67108864", "scale the map down");
  load("textbomb.png");
  if (is_here("textbomb.png")) decode_part(bytes.size, IMAGE_ALPHA_AVERAGED); /* either way without 50 MB of text */
}

static void test_kinds_of_bmp_that_are_not_read(void) {
  refuse("rle8.bmp", "run-length compression", "save it with 24 bits a pixel");
  refuse("rgb16.bmp", "16 bits a pixel", "save it with 24 bits a pixel");
  refuse("badindex.bmp", "is not a whole BMP", "copy the file anew");
}

static void test_every_truncation_is_refused(void) {
  static const char *const names[] = {"grey8.png", "rgba8.png", "palette4.png", "interlaced.png",
                                      "grey8.bmp", "rgb24.bmp", "rgba32.bmp",   "masks32.bmp"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    load(names[i]);
    if (!is_here(names[i])) continue;
    const size_t idle = strstr(names[i], ".png") != NULL ? 4 : 0; /* the checksum of the mark at a PNG's end */
    for (size_t size = 0; size + idle < bytes.size; size++) {
      TEST_ASSERT_EQUAL_INT_MESSAGE(-1, decode_part(size, IMAGE_ALPHA_AVERAGED), names[i]);
      TEST_ASSERT_NULL(it.samples);
    }
  }
}

/* Whatever a byte is turned into, there is an image within the limits or a fault. */
static void test_every_changed_byte_is_read_or_refused(void) {
  static const char *const names[] = {"grey8.png", "rgba8.png", "palette4.png", "interlaced.png", "trns.png",
                                      "grey8.bmp", "grey4.bmp", "rgb24.bmp",    "rgba32.bmp",     "masks32.bmp"};
  static const unsigned char changes[] = {0x01, 0x80, 0xff, 0x7f, 0x10};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    load(names[i]);
    for (size_t at = 0; is_here(names[i]) && at < bytes.size; at++)
      for (size_t c = 0; c < sizeof changes; c++) {
        bytes.data[at] ^= changes[c];
        const int result = decode_part(bytes.size, IMAGE_ALPHA_MARKED);
        TEST_ASSERT_TRUE(result == 0 ? it.samples != NULL && it.width >= 1 && it.height >= 1 : it.samples == NULL);
        bytes.data[at] ^= changes[c];
      }
  }
}

static void test_a_build_without_a_decoder_names_the_package(void) {
#ifndef QUARTER_HAVE_SPNG
  load("grey8.png");
  TEST_ASSERT_EQUAL_INT(-1, decode_part(bytes.size, IMAGE_ALPHA_AVERAGED));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "install libspng-dev and build again"), why.text);
#endif
#ifndef QUARTER_HAVE_STB
  load("grey8.bmp");
  TEST_ASSERT_EQUAL_INT(-1, decode_part(bytes.size, IMAGE_ALPHA_AVERAGED));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "install libstb-dev and build again"), why.text);
#endif
#if defined QUARTER_HAVE_SPNG && defined QUARTER_HAVE_STB
  TEST_IGNORE_MESSAGE("this build has both decoders");
#endif
}

static void test_what_looks_like_an_image(void) {
  static const char *const images[] = {"\x89PNG\r\n\x1a\n", "GIF89a", "\xff\xd8\xff\xe0", "P5 1 1 255 x",
                                       "II*\1xxxxxxx"};
  static const char *const others[] = {"BMW is a car, not an image", "map: a.txt", "#####", "PNG", "P9 1 1"};
  for (size_t i = 0; i < sizeof images / sizeof *images; i++) {
    const file_bytes one = {(unsigned char *)images[i], strlen(images[i])};
    TEST_ASSERT_TRUE_MESSAGE(decode_is_image(&one), images[i]);
  }
  for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
    const file_bytes one = {(unsigned char *)others[i], strlen(others[i])};
    TEST_ASSERT_FALSE_MESSAGE(decode_is_image(&one), others[i]);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_grey_and_colour_are_the_sum_of_three_channels);
  RUN_TEST(test_few_bits_are_spread_over_the_range);
  RUN_TEST(test_palettes);
  RUN_TEST(test_sixteen_bits_are_averaged);
  RUN_TEST(test_alpha_is_a_fourth_channel_where_it_is_averaged);
  RUN_TEST(test_alpha_marks_or_does_not_count);
  RUN_TEST(test_an_opaque_grey_has_the_sample_that_is_told);
  RUN_TEST(test_bombs_are_refused_before_they_go_off);
  RUN_TEST(test_kinds_of_bmp_that_are_not_read);
  RUN_TEST(test_every_truncation_is_refused);
  RUN_TEST(test_every_changed_byte_is_read_or_refused);
  RUN_TEST(test_a_build_without_a_decoder_names_the_package);
  RUN_TEST(test_what_looks_like_an_image);
  return UNITY_END();
}
