/* Running the built `quarter` in a test's own folder, and reading what it says. */
#ifndef QUARTER_TESTS_TOOL_RUN_H
#define QUARTER_TESTS_TOOL_RUN_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "unity.h"

typedef struct {
  int status;        /* exit status */
  char out[1 << 16]; /* standard output */
  char err[1 << 13]; /* standard error */
} tool_result;

static inline void read_text(const char *path, char *text, size_t size) {
  FILE *file = fopen(path, "rb");
  const size_t length = file != NULL ? fread(text, 1, size - 1, file) : 0;
  text[length] = '\0';
  if (file != NULL) fclose(file);
}

/* A new file: some file systems wait for the disk when one is cut to nothing and written anew. */
static inline void write_file(const char *path, const char *text) {
  remove(path);
  FILE *file = fopen(path, "wb");
  TEST_ASSERT_NOT_NULL(file);
  fputs(text, file);
  fclose(file);
}

/* Run `quarter` with these words, as a shell splits them. */
static inline void __attribute__((format(printf, 2, 3))) run_tool(tool_result *result, const char *format, ...) {
  char words[4096], command[8192];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(words, sizeof words, format, arguments);
  va_end(arguments);
  snprintf(command, sizeof command, "'%s' %s >out.txt 2>err.txt </dev/null", QUARTER_TOOL, words);
  remove("out.txt");
  remove("err.txt");
  const int status = system(command);
  result->status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  read_text("out.txt", result->out, sizeof result->out);
  read_text("err.txt", result->err, sizeof result->err);
}

/* The text after `"key": ` in the JSON of a result. */
static inline const char *json_text(const char *text, const char *key) {
  char quoted[64];
  snprintf(quoted, sizeof quoted, "\"%s\": ", key);
  const char *at = strstr(text, quoted);
  TEST_ASSERT_NOT_NULL_MESSAGE(at, key);
  return at + strlen(quoted);
}

static inline double json_value(const char *text, const char *key) {
  return strtod(json_text(text, key), NULL);
}

static inline int json_is(const char *text, const char *key, const char *expected) {
  return strncmp(json_text(text, key), expected, strlen(expected)) == 0;
}

#endif
