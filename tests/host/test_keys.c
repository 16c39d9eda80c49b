#include <math.h>
#include <string.h>

#include "host/input/keys.h"
#include "host/input/mission_keys.h"
#include "unity.h"

/* Settings of every kind, and their keys. */
typedef struct {
  char text[6], file[32];
  double number;
  uint8_t byte;
  int16_t half;
  int32_t word;
  uint64_t all;
  bool flag, given;
} settings;

static const char *const also[] = {"figure", "amount", NULL};
static const char *const colours[] = {"red", "green", NULL};
static const key_record item_records[] = {{.name = "deep", .kind = KEY_NUMBER, .help = "deep", .example = "1"},
                                          {.name = NULL}};
static const key_set items = {"An item", item_records, NULL, NULL};

#define INTEGER(field) .kind = KEY_INTEGER, .help = "whole", .example = "7", KEY_FIELD(settings, field)

static const key_record records[] = {
    {.name = "text", .kind = KEY_TEXT, .help = "words", .example = "abc", KEY_FIELD(settings, text)},
    {.name = "file", .kind = KEY_FILE, .help = "a file", .example = "a.txt", KEY_FIELD(settings, file)},
    {.name = "number",
     .also = also,
     .kind = KEY_NUMBER,
     .help = "how much",
     .example = "2",
     .unit = "m",
     .noun = "a length",
     .least = 1.0,
     .most = 5.0,
     .most_out = true,
     KEY_FIELD(settings, number),
     KEY_GIVEN(settings, given)},
    {.name = "byte", INTEGER(byte), .most = 200.0},
    {.name = "half", INTEGER(half), .least = -300.0, .most = 300.0},
    {.name = "word", INTEGER(word)},
    {.name = "all", INTEGER(all)},
    {.name = "flag", .kind = KEY_WORD, .help = "x", .example = "red", .words = colours, KEY_FIELD(settings, flag)},
    {.name = "list", .kind = KEY_LIST, .help = "things, an item each", .example = "[{deep: 1}]", .items = &items},
    {.name = "needed", .kind = KEY_MAPPING, .help = "x", .example = "{deep: 1}", .needed = true, .items = &items},
    {.name = NULL}};
static const key_set set = {"All", records, NULL, NULL};

static settings got;
static fault why;

static int read(const char *text) {
  tree yaml;
  file_bytes bytes = {(unsigned char *)text, strlen(text)};
  got = (settings){.number = 3.0};
  why.text[0] = '\0';
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, tree_read(&yaml, "folder/k.yaml", &bytes, &why), why.text);
  const int result = keys_read(&got, &set, &yaml, tree_root(&yaml), "the thing", NULL);
  tree_free(&yaml);
  return result;
}

static void refuse(const char *text, const char *wanted) {
  TEST_ASSERT_EQUAL_INT(-1, read(text));
  TEST_ASSERT_EQUAL_STRING(wanted, why.text);
}

#define NEEDED "needed: {deep: 1}\n"

void setUp(void) {
}

void tearDown(void) {
}

static void test_each_kind_goes_to_its_field(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(
      0,
      read(NEEDED
           "text: abcde\nfile: a.txt\nnumber: 1\nbyte: 200\nhalf: -300\nword: -70000\nall: 999999999\nflag: GREEN\n"
           "list: []\n"),
      why.text);
  TEST_ASSERT_EQUAL_STRING("abcde", got.text);
  TEST_ASSERT_EQUAL_STRING("folder/a.txt", got.file);
  TEST_ASSERT_EQUAL_DOUBLE(1.0, got.number);
  TEST_ASSERT_EQUAL_UINT(200, got.byte);
  TEST_ASSERT_EQUAL_INT(-300, got.half);
  TEST_ASSERT_EQUAL_INT(-70000, got.word);
  TEST_ASSERT_EQUAL_UINT64(999999999, got.all);
  TEST_ASSERT_TRUE(got.flag);
  TEST_ASSERT_TRUE(got.given);
}

static void test_what_is_not_there_keeps_its_default(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, read(NEEDED), why.text);
  TEST_ASSERT_EQUAL_DOUBLE(3.0, got.number);
  TEST_ASSERT_FALSE(got.given);
}

static void test_another_word_for_a_key(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, read(NEEDED "amount: 4\n"), why.text);
  TEST_ASSERT_EQUAL_DOUBLE(4.0, got.number);
  refuse(NEEDED "amount: 4\nnumber: 4\n",
         "folder/k.yaml:2: the thing has both 'number' and 'amount', which are one; keep one");
}

static void test_ranges_and_their_ends(void) {
  char range[KEYS_RANGE_SIZE];
  keys_range(range, keys_find(&set, "number"));
  TEST_ASSERT_EQUAL_STRING("from 1 to below 5", range);
  refuse(NEEDED "number: 5\n", "folder/k.yaml:2: 'number' is 5 m; give a length from 1 to below 5, such as 2");
  refuse(NEEDED "number: 0.99\n", "folder/k.yaml:2: 'number' is 0.99 m; give a length from 1 to below 5, such as 2");
  refuse(NEEDED "byte: 201\n", "folder/k.yaml:2: 'byte' is 201; give a whole number from 0 to 200, such as 7");
  refuse(NEEDED "half: -301\n", "folder/k.yaml:2: 'half' is -301; give a whole number from -300 to 300, such as 7");
  static const key_record ends[] = {{.least = 0.5, .most = HUGE_VAL},
                                    {.least = 0.5, .least_out = true, .most = HUGE_VAL},
                                    {.least_out = true, .most = 1.0},
                                    {.least_out = true, .most = 1.0, .most_out = true},
                                    {.most = 0.0}};
  static const char *const words[] = {"of 0.5 or more", "above 0.5", "above 0 and up to 1", "above 0 and below 1", ""};
  for (int i = 0; i < 5; i++) {
    keys_range(range, &ends[i]);
    TEST_ASSERT_EQUAL_STRING(words[i], range);
  }
}

static void test_faults_name_the_key_and_the_mend(void) {
  refuse("text: a\n", "folder/k.yaml:1: the thing lacks the key 'needed'; add \"needed: {deep: 1}\"");
  refuse(NEEDED "text: abcdef\n", "folder/k.yaml:2: 'text' has 6 bytes; shorten it to 5");
  refuse(NEEDED "amuont: 1\n", "folder/k.yaml:2: unknown key 'amuont' of the thing; did you mean 'amount'?");
  refuse(NEEDED "list: 1\n",
         "folder/k.yaml:2: 'list' is not a list; write one, such as \"list: [{deep: 1}]\": things, an item each");
  refuse(NEEDED "flag: blue\n", "folder/k.yaml:2: 'flag' is \"blue\"; give one of red and green");
}

/* What the mission's own records say: all that people and programs are told, and a field of their kind's size. */
static void check_records(const key_set *of) {
  TEST_ASSERT_NOT_NULL(of->title);
  for (const key_record *r = of->records; r->name != NULL; r++) {
    TEST_ASSERT_NOT_NULL_MESSAGE(r->help, r->name);
    TEST_ASSERT_NOT_NULL_MESSAGE(r->example, r->name);
    TEST_ASSERT_NULL_MESSAGE(strchr(r->help, '|'), r->name);
    TEST_ASSERT_EQUAL_PTR_MESSAGE(r, keys_find(of, r->name), "a key is there twice");
    TEST_ASSERT_TRUE_MESSAGE((r->kind == KEY_WORD) == (r->words != NULL), r->name);
    if (r->kind == KEY_NUMBER) TEST_ASSERT_EQUAL_size_t_MESSAGE(sizeof(double), r->size, r->name);
    if (r->kind < KEY_LIST) TEST_ASSERT_GREATER_THAN_size_t_MESSAGE(0, r->size, r->name);
    if (r->items != NULL) check_records(r->items);
  }
}

static void test_the_missions_records_are_whole(void) {
  check_records(&mission_keys);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_each_kind_goes_to_its_field);
  RUN_TEST(test_what_is_not_there_keeps_its_default);
  RUN_TEST(test_another_word_for_a_key);
  RUN_TEST(test_ranges_and_their_ends);
  RUN_TEST(test_faults_name_the_key_and_the_mend);
  RUN_TEST(test_the_missions_records_are_whole);
  return UNITY_END();
}
