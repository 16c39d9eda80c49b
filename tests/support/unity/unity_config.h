/* What Unity is told before it defines anything: QUARTER_TEST_ONLY=NAME in the environment runs the test functions
 * alone that have NAME in theirs. */
#ifndef QUARTER_TESTS_UNITY_CONFIG_H
#define QUARTER_TESTS_UNITY_CONFIG_H

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static inline bool is_to_run(const char *function) {
  const char *only = getenv("QUARTER_TEST_ONLY");
  return only == NULL || strstr(function, only) != NULL;
}

/* Unity declares its own runner only where RUN_TEST is Unity's too. */
void UnityDefaultTestRun(void (*test)(void), const char *name, const int line);

#define RUN_TEST(function) (is_to_run(#function) ? UnityDefaultTestRun(function, #function, __LINE__) : (void)0)

#endif
