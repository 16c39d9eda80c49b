#include "host/base/naming.h"

#include <string.h>

#include "unity.h"

static qtr_names names;
static const uint16_t number[] = {0, 2, 3, 7};
static const naming called = {&names, number, 4, 2, NULL};
static char wrong[FAULT_LINE];

void setUp(void) {
  memset(&names, 0, sizeof names);
  strcpy(names.place[0], "Bay 3");
  strcpy(names.place[3], "3");
  strcpy(names.seeker[1], "Alpha");
}

void tearDown(void) {
}

static void test_a_label_is_the_name_or_the_number(void) {
  TEST_ASSERT_EQUAL_STRING("Bay 3", naming_place(&called, 0).text);
  TEST_ASSERT_EQUAL_STRING("2", naming_place(&called, 1).text);
  TEST_ASSERT_EQUAL_STRING("0", naming_seeker(&called, 0).text);
  TEST_ASSERT_EQUAL_STRING("Alpha", naming_seeker(&called, 1).text);
  TEST_ASSERT_TRUE(naming_has_places(&called));
}

static void test_a_word_is_a_name_before_it_is_a_number(void) {
  TEST_ASSERT_EQUAL_INT(0, naming_find_place(&called, "Bay 3", wrong));
  TEST_ASSERT_EQUAL_INT(1, naming_find_place(&called, "2", wrong));
  TEST_ASSERT_EQUAL_INT(3, naming_find_place(&called, "3", wrong)); /* not number 3, which is place 2 */
  TEST_ASSERT_EQUAL_INT(3, naming_find_place(&called, "7", wrong));
  TEST_ASSERT_EQUAL_INT(1, naming_find_seeker(&called, "Alpha", wrong));
  TEST_ASSERT_EQUAL_INT(1, naming_find_seeker(&called, "1", wrong));
}

static void refuse_place(const char *word, const char *wanted) {
  TEST_ASSERT_EQUAL_INT(-1, naming_find_place(&called, word, wrong));
  TEST_ASSERT_EQUAL_STRING(wanted, wrong);
}

static void test_what_is_not_there_is_refused_with_what_was_meant(void) {
  refuse_place("Bya 3", "there is no place Bya 3; did you mean 'Bay 3'?");
  refuse_place("1", "there is no place 1; there are places 0 to 7 but those that were left out, or give a name");
  refuse_place("", "there is no place ; there are places 0 to 7 but those that were left out, or give a name");
  refuse_place("-2", "there is no place -2; there are places 0 to 7 but those that were left out, or give a name");
  TEST_ASSERT_EQUAL_INT(-1, naming_find_seeker(&called, "2", wrong));
  TEST_ASSERT_EQUAL_STRING("there is no robot 2; there are robots 0 to 1", wrong);
  strcpy(names.seeker[0], "Mole");
  TEST_ASSERT_EQUAL_INT(-1, naming_find_seeker(&called, "2", wrong));
  TEST_ASSERT_EQUAL_STRING("there is no robot 2; there are robots Mole and Alpha", wrong);
}

static void test_long_names_are_compared_with_care(void) {
  char word[200];
  memset(names.place[1], 'a', QTR_SITE_NAME_BYTES - 1);
  memset(word, 'a', sizeof word - 1);
  word[sizeof word - 1] = '\0';
  TEST_ASSERT_EQUAL_INT(-1, naming_find_place(&called, word, wrong));
  TEST_ASSERT_EQUAL_INT(-1, naming_find_place(&called, "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", wrong));
  TEST_ASSERT_EQUAL_INT(1, naming_find_place(&called, names.place[1], wrong));
}

static void test_lists_have_commas_between(void) {
  qtr_places places;
  qtr_places_clear(&places);
  TEST_ASSERT_EQUAL_INT(0, naming_list_places(&places, &called, "Bay 3, 2", wrong));
  TEST_ASSERT_TRUE(qtr_places_has(&places, 0) && qtr_places_has(&places, 1) && !qtr_places_has(&places, 2));
  TEST_ASSERT_EQUAL_INT(-1, naming_list_places(&places, &called, "2,,3", wrong));
  strcpy(names.place[2], "left, right");
  TEST_ASSERT_EQUAL_INT(0, naming_list_places(&places, &called, "left, right", wrong));
  TEST_ASSERT_TRUE(qtr_places_has(&places, 2));
}

static void test_what_may_be_a_name(void) {
  TEST_ASSERT_NULL(naming_wrong("B\xc3\xa4hnle 7, left"));
  TEST_ASSERT_EQUAL_STRING("is empty", naming_wrong(""));
  TEST_ASSERT_EQUAL_STRING("is empty", naming_wrong(" \t"));
  TEST_ASSERT_EQUAL_STRING("begins or ends with a blank", naming_wrong("a "));
  TEST_ASSERT_EQUAL_STRING("is not UTF-8", naming_wrong("a\xff"));
  TEST_ASSERT_EQUAL_STRING("has a control character", naming_wrong("a\nb"));
  char text[QTR_SITE_NAME_BYTES + 1] = "";
  memset(text, 'x', QTR_SITE_NAME_BYTES - 1);
  TEST_ASSERT_NULL(naming_wrong(text));
  text[QTR_SITE_NAME_BYTES - 1] = 'x';
  TEST_ASSERT_EQUAL_STRING("is too long", naming_wrong(text));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_label_is_the_name_or_the_number);
  RUN_TEST(test_a_word_is_a_name_before_it_is_a_number);
  RUN_TEST(test_what_is_not_there_is_refused_with_what_was_meant);
  RUN_TEST(test_long_names_are_compared_with_care);
  RUN_TEST(test_lists_have_commas_between);
  RUN_TEST(test_what_may_be_a_name);
  return UNITY_END();
}
