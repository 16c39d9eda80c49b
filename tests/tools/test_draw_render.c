/* PNG and PDF: what they hold, the same bytes every time, and libraries that nothing else loads. */
#include "draw_render.h"

#include <stdbool.h>

#include "support/tool_run.h"

static tool_result result;
static char first[1 << 20], second[1 << 20];

void setUp(void) {
  write_file("area.txt", "S..1\n.#~.\n2..3\n");
  run_tool(&result, "learn area.txt -q -o t.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
}

void tearDown(void) {
}

static size_t read_all(const char *path, char *bytes) {
  FILE *file = fopen(path, "rb");
  TEST_ASSERT_NOT_NULL_MESSAGE(file, path);
  const size_t length = fread(bytes, 1, sizeof first, file);
  fclose(file);
  return length;
}

static bool holds(const char *bytes, size_t length, const char *what) {
  const size_t size = strlen(what);
  for (size_t at = 0; at + size <= length; at++)
    if (memcmp(bytes + at, what, size) == 0) return true;
  return false;
}

/* Draws in a form, or is told what to install. */
static void draw(const char *words) {
  run_tool(&result, "%s", words);
#ifdef QUARTER_RSVG
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
#else
  TEST_ASSERT_EQUAL_INT(2, result.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "librsvg2-dev"), result.err);
  TEST_IGNORE_MESSAGE("librsvg was not there when Quarter was built (librsvg2-dev)");
#endif
}

static void test_a_png_is_drawn_at_twice_the_pixels(void) {
  unsigned width = 0, wide = 0;
  draw("draw t.qtr -q -o t.png");
  const size_t length = read_all("t.png", first);
  TEST_ASSERT_TRUE(length > 1000 && memcmp(first, "\x89PNG\r\n\x1a\n", 8) == 0);
  for (int i = 16; i < 20; i++) wide = wide << 8 | (unsigned char)first[i];
  run_tool(&result, "draw t.qtr -q -o t.svg");
  read_text("t.svg", second, sizeof second);
  TEST_ASSERT_EQUAL_INT(1, sscanf(strstr(second, " width=\""), " width=\"%u", &width));
  TEST_ASSERT_EQUAL_UINT(2 * width, wide);
  TEST_ASSERT_FALSE(holds(first, length, "tIME"));
}

static void test_a_pdf_tells_no_date(void) {
  draw("draw t.qtr -q -o t.pdf");
  const size_t length = read_all("t.pdf", first);
  TEST_ASSERT_TRUE(length > 1000 && memcmp(first, "%PDF-", 5) == 0);
  TEST_ASSERT_FALSE(holds(first, length, "Date"));
}

static void test_the_same_table_gives_the_same_bytes(void) {
  static const char *const forms[] = {"png", "pdf"};
  for (int i = 0; i < 2; i++) {
    char words[80];
    snprintf(words, sizeof words, "draw t.qtr -q --format %s -o first", forms[i]);
    draw(words);
    snprintf(words, sizeof words, "draw t.qtr -q --format %s -o second", forms[i]);
    draw(words);
    const size_t length = read_all("first", first);
    TEST_ASSERT_EQUAL_size_t(length, read_all("second", second));
    TEST_ASSERT_EQUAL_MEMORY(first, second, length);
  }
}

static void test_the_form_is_asked_for_or_told_by_the_name(void) {
  run_tool(&result, "draw t.qtr -q --format svg -o picture.png");
  TEST_ASSERT_EQUAL_INT(0, result.status);
  read_text("picture.png", first, sizeof first);
  TEST_ASSERT_EQUAL_STRING_LEN("<svg ", first, 5);
  run_tool(&result, "draw t.qtr -q -o t.jpg");
  TEST_ASSERT_EQUAL_INT(2, result.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "t.png"), result.err);
  run_tool(&result, "draw t.qtr -q --format gif -o t");
  TEST_ASSERT_EQUAL_INT(2, result.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, "svg, png or pdf"), result.err);
}

static void test_dark_pages_have_pictures_of_their_own(void) {
  run_tool(&result, "draw t.qtr -q -o light.svg");
  run_tool(&result, "draw t.qtr -q --dark -o dark.svg");
  TEST_ASSERT_EQUAL_INT(0, result.status);
  read_text("light.svg", first, sizeof first);
  read_text("dark.svg", second, sizeof second);
  TEST_ASSERT_NOT_NULL(strstr(first, "fill=\"#fbfaf7\""));
  TEST_ASSERT_NULL(strstr(second, "fill=\"#fbfaf7\""));
  TEST_ASSERT_NULL(strstr(second, "#ffffff"));
}

static void test_what_is_linked_is_light(void) {
  static const char *const heavy[] = {"librsvg", "libcairo", "libproj", "libglib"};
  if (system("ldd '" QUARTER_TOOL "' >linked.txt 2>linked.err") != 0) TEST_IGNORE_MESSAGE("there is no ldd");
  read_text("linked.txt", first, sizeof first);
  for (size_t i = 0; i < sizeof heavy / sizeof heavy[0]; i++)
    TEST_ASSERT_NULL_MESSAGE(strstr(first, heavy[i]), heavy[i]);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_png_is_drawn_at_twice_the_pixels);
  RUN_TEST(test_a_pdf_tells_no_date);
  RUN_TEST(test_the_same_table_gives_the_same_bytes);
  RUN_TEST(test_the_form_is_asked_for_or_told_by_the_name);
  RUN_TEST(test_dark_pages_have_pictures_of_their_own);
  RUN_TEST(test_what_is_linked_is_light);
  return UNITY_END();
}
