/* What `--c` names the array: a name that compiles, whatever the file is called. */
#include "carray.h"
#include "cname.h"
#include "support/tool_run.h"

void setUp(void) {
}
void tearDown(void) {
}

static void expect_name(const char *wanted, const char *path) {
  char name[CNAME_SIZE];
  cname_of_path(name, path);
  TEST_ASSERT_EQUAL_STRING_MESSAGE(wanted, name, path);
}

static void test_a_plain_name_stays(void) {
  expect_name("patrol", "patrol.c");
  expect_name("mine_field", "out/mine field.c");
  expect_name("north2", "/a.b/north2.policy.c");
  expect_name("island", "island.c");
  expect_name("street", "street.c");
  expect_name("Int", "Int.c");
  expect_name("integer", "integer.c");
}

static void test_what_is_no_identifier_becomes_one(void) {
  expect_name("p2nd", "2nd.c");
  expect_name("p_x", "_x.c");
  expect_name("a_b", "a__b.c");
  expect_name("a_b", "a - b.c");
  expect_name("a", "a_.c");
  expect_name("p", ".c");
  expect_name("p", "");
  expect_name("p", "\xc3\xa9\xc3\xa9.c");
  expect_name("caf", "caf\xc3\xa9.c");
}

static void test_what_the_language_keeps_gets_a_tail(void) {
  expect_name("int_policy", "int.c");
  expect_name("main_policy", "out/main.c");
  expect_name("co_await_policy", "co_await.c");
  expect_name("xor_eq_policy", "xor eq.c");
  expect_name("uint8_t_policy", "uint8_t.c");
  expect_name("INT8_MAX_policy", "INT8_MAX.c");
  expect_name("sinf_policy", "sinf.c");
  expect_name("unix_policy", "unix.c");
}

static void test_a_long_name_is_cut_and_still_taken_for_what_it_is(void) {
  char path[400], name[CNAME_SIZE];
  memset(path, 'x', 300);
  strcpy(path + 300, ".c");
  cname_of_path(name, path);
  TEST_ASSERT_LESS_THAN_size_t(CNAME_SIZE, strlen(name));
  TEST_ASSERT_GREATER_THAN_size_t(100, strlen(name));
}

/* ---- compiled ---- */

/* From the standards' own tables, written out apart from the list under test. */
static const char *const words[] = {"alignas",
                                    "alignof",
                                    "auto",
                                    "bool",
                                    "break",
                                    "case",
                                    "char",
                                    "const",
                                    "constexpr",
                                    "continue",
                                    "default",
                                    "do",
                                    "double",
                                    "else",
                                    "enum",
                                    "extern",
                                    "false",
                                    "float",
                                    "for",
                                    "goto",
                                    "if",
                                    "inline",
                                    "int",
                                    "long",
                                    "nullptr",
                                    "register",
                                    "restrict",
                                    "return",
                                    "short",
                                    "signed",
                                    "sizeof",
                                    "static",
                                    "static_assert",
                                    "struct",
                                    "switch",
                                    "thread_local",
                                    "true",
                                    "typedef",
                                    "typeof",
                                    "typeof_unqual",
                                    "union",
                                    "unsigned",
                                    "void",
                                    "volatile",
                                    "while",
                                    "_Alignas",
                                    "_Alignof",
                                    "_Atomic",
                                    "_BitInt",
                                    "_Bool",
                                    "_Complex",
                                    "_Decimal128",
                                    "_Decimal32",
                                    "_Decimal64",
                                    "_Generic",
                                    "_Imaginary",
                                    "_Noreturn",
                                    "_Static_assert",
                                    "_Thread_local",
                                    "asm",
                                    "catch",
                                    "char16_t",
                                    "char32_t",
                                    "char8_t",
                                    "class",
                                    "co_await",
                                    "co_return",
                                    "co_yield",
                                    "concept",
                                    "const_cast",
                                    "consteval",
                                    "constinit",
                                    "contract_assert",
                                    "decltype",
                                    "delete",
                                    "dynamic_cast",
                                    "explicit",
                                    "export",
                                    "friend",
                                    "mutable",
                                    "namespace",
                                    "new",
                                    "noexcept",
                                    "operator",
                                    "private",
                                    "protected",
                                    "public",
                                    "reinterpret_cast",
                                    "requires",
                                    "static_cast",
                                    "template",
                                    "this",
                                    "throw",
                                    "try",
                                    "typeid",
                                    "typename",
                                    "using",
                                    "virtual",
                                    "wchar_t",
                                    "and",
                                    "and_eq",
                                    "bitand",
                                    "bitor",
                                    "compl",
                                    "not",
                                    "not_eq",
                                    "or",
                                    "or_eq",
                                    "xor",
                                    "xor_eq",
                                    "final",
                                    "override",
                                    "import",
                                    "module",
                                    "main",
                                    "errno",
                                    "NULL",
                                    "uint8_t",
                                    "uint32_t",
                                    "size_t",
                                    "INT8_MAX",
                                    "UINT8_C",
                                    "SIZE_MAX",
                                    "printf",
                                    "memcpy",
                                    "strlen",
                                    "exit",
                                    "time",
                                    "sin",
                                    "sinf",
                                    "sinl",
                                    "log",
                                    "gamma",
                                    "unix",
                                    "linux",
                                    "__x",
                                    "_X",
                                    "a__b",
                                    "stdin",
                                    "assert",
                                    "environ",
                                    "complex",
                                    "I",
                                    "std"};

static void write_words(const char *path, const char *headers) {
  static const uint8_t bytes[] = {1, 2, 3};
  const qtr_policy policy = {.bytes = bytes, .size = sizeof bytes, .grid = {4, 2, QTR_GRID_BITS, bytes}};
  FILE *out = fopen(path, "w");
  TEST_ASSERT_NOT_NULL(out);
  fputs(headers, out);
  for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
    char name[64];
    snprintf(name, sizeof name, "%s.c", words[i]);
    carray_write(out, name, &policy);
  }
  TEST_ASSERT_EQUAL_INT(0, fclose(out));
}

static int compile(const char *compiler, const char *language, const char *standard, const char *file) {
  char command[1024];
  snprintf(command, sizeof command, "%s -x %s -std=%s -Wall -Wextra -Werror -fsyntax-only %s >words.log 2>&1", compiler,
           language, standard, file);
  return system(command);
}

static int compile_all(const char *compiler, const char *language, const char *const standards[]) {
  int compiled = 0;
  char log[2000];
  write_file("empty.c", "typedef int nothing;\n");
  for (int i = 0; standards[i] != NULL; i++) {
    if (compile(compiler, language, standards[i], "empty.c") != 0) continue; /* a standard that it does not know yet */
    for (int headers = 0; headers < 2; headers++) {
      const int status = compile(compiler, language, standards[i], headers == 0 ? "words.c" : "words_headers.c");
      read_text("words.log", log, sizeof log);
      TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, log);
      compiled++;
    }
  }
  return compiled;
}

static void test_every_keyword_compiles_as_c_and_as_cpp(void) {
  static const char *const c[] = {"c99", "c11", "gnu17", "c2x", "gnu2x", "c23", NULL};
  static const char *const cpp[] = {"c++11", "gnu++17", "c++20", "gnu++23", "c++26", NULL};
  write_words("words.c", "");
  write_words("words_headers.c", "#include <assert.h>\n#include <ctype.h>\n#include <errno.h>\n#include <iso646.h>\n"
                                 "#include <limits.h>\n#include <math.h>\n#include <stdbool.h>\n#include <stddef.h>\n"
                                 "#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n"
                                 "#include <time.h>\n");
  TEST_ASSERT_GREATER_THAN_INT(3, compile_all(QUARTER_CC, "c", c));
  if (compile_all("c++", "c++", cpp) == 0) TEST_IGNORE_MESSAGE("no C++ compiler here: compiled as C alone");
}

static void test_learn_writes_the_name_that_compiles(void) {
  tool_result r;
  char text[3000];
  write_file("map.txt", "S..5\n");
  run_tool(&r, "learn map.txt -q --c int.c");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  read_text("int.c", text, sizeof text);
  TEST_ASSERT_NOT_NULL(strstr(text, "const uint8_t int_policy["));
  TEST_ASSERT_EQUAL_INT(0, compile(QUARTER_CC, "c", "c99", "int.c"));
}

/* A build whose arrays are too small does not compile, and is told which to raise. */
static void test_what_does_not_fit_the_build_does_not_compile(void) {
  tool_result r;
  char text[3000];
  const char *const include = "-I" QUARTER_SOURCE_DIR "/include";
  char compiler[600];
  write_file("map.txt", "S..5..1..1..1..1..1..1..1..1..1..1..1..1..1..1..1..1..1\n");
  run_tool(&r, "learn map.txt -q --c sweep.c");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  read_text("sweep.c", text, sizeof text);
  TEST_ASSERT_NOT_NULL_MESSAGE(
      strstr(text, "#define SWEEP_CELLS 55\n#define SWEEP_PLACES 18\n#define SWEEP_SEEKERS 1\n"), text);
  snprintf(compiler, sizeof compiler, "%s %s", QUARTER_CC, include);
  TEST_ASSERT_EQUAL_INT(0, compile(compiler, "c", "c99", "sweep.c"));
  snprintf(compiler, sizeof compiler, "%s %s -DQTR_PROFILE_MCU", QUARTER_CC, include);
  TEST_ASSERT_NOT_EQUAL_INT(0, compile(compiler, "c", "c99", "sweep.c"));
  read_text("words.log", text, sizeof text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "sweep needs QTR_MAX_PLACES to be 18 or more"), text);
  TEST_ASSERT_NULL_MESSAGE(strstr(text, "QTR_MAX_CELLS"), text);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_plain_name_stays);
  RUN_TEST(test_what_is_no_identifier_becomes_one);
  RUN_TEST(test_what_the_language_keeps_gets_a_tail);
  RUN_TEST(test_a_long_name_is_cut_and_still_taken_for_what_it_is);
  RUN_TEST(test_every_keyword_compiles_as_c_and_as_cpp);
  RUN_TEST(test_learn_writes_the_name_that_compiles);
  RUN_TEST(test_what_does_not_fit_the_build_does_not_compile);
  return UNITY_END();
}
