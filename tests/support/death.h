/* For what must end at an assertion: it is tried in a process of its own. The host's tests alone; the file that
 * includes it asks for POSIX. */
#ifndef QUARTER_TESTS_DEATH_H
#define QUARTER_TESTS_DEATH_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "unity.h"

/* Whether `act` ends at the compiler's trap, and not otherwise or in silence. */
static inline bool is_death(void (*act)(void)) {
  int status = 0;
  fflush(stdout);
  const pid_t process = fork();
  if (process == 0) {
    const struct rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    act();
    _exit(0);
  }
  if (process < 0 || waitpid(process, &status, 0) != process) return false;
  return WIFSIGNALED(status) && (WTERMSIG(status) == SIGILL || WTERMSIG(status) == SIGTRAP);
}

static inline void expect_death(const char *what, void (*act)(void)) {
  TEST_ASSERT_TRUE_MESSAGE(is_death(act), what);
}

#endif
