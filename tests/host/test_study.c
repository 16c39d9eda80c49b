/* A study's Q-table grows as it is learnt, and where there is no memory left, learning goes on without. */
#include <stdio.h>
#include <sys/resource.h>
#include <unistd.h>

#include "host/plan/study.h"
#include "unity.h"

static study *s;
static plan_config config;
static fault why;

/* Open ground with a start and 8 places, learnt by robots that go anywhere: entries without end. */
void setUp(void) {
  FILE *file = fopen("open.txt", "w");
  TEST_ASSERT_NOT_NULL(file);
  for (int cell = 0; cell < 900; cell++)
    fprintf(file, "%c%s", cell == 0 ? 'S' : cell % 112 == 15 ? '1' : '.', cell % 30 == 29 ? "\n" : "");
  fclose(file);
  plan_config_default(&config);
  config.reading.robots = 3;
  config.learner.setting = QTR_SETTING_PAPER;
  config.learner.gap = 0.0;
  config.learner.exploration.kind = QTR_EXPLORE_UNIFORM;
  s = study_take(&why);
  TEST_ASSERT_NOT_NULL(s);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, problem_load(&s->p, "open.txt", &config, &why), why.text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, problem_measure(&s->p, &config, &why), why.text);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, study_begin(s, &config, &why), why.text);
}

void tearDown(void) {
  study_drop(s);
}

/* Steps until the table has grown to so many bytes, or could not. */
static void learn_until(size_t bytes) {
  while (s->table.bytes < bytes && !s->cramped) study_step(s);
}

static void test_table_grows_as_it_is_learnt(void) {
  const size_t first = s->table.bytes;
  learn_until(first + 1);
  TEST_ASSERT_FALSE(s->cramped);
  TEST_ASSERT_GREATER_THAN(first, s->table.bytes);
}

static void leave_address_space(rlim_t more) {
  unsigned long pages = 0;
  FILE *file = fopen("/proc/self/statm", "r");
  TEST_ASSERT_NOT_NULL(file);
  TEST_ASSERT_EQUAL_INT(1, fscanf(file, "%lu", &pages));
  fclose(file);
  struct rlimit limit = {pages * (rlim_t)sysconf(_SC_PAGESIZE) + more, RLIM_INFINITY};
  TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_AS, &limit));
}

static void test_learning_goes_on_where_no_memory_is_left(void) {
#ifdef __SANITIZE_ADDRESS__
  TEST_IGNORE_MESSAGE("a sanitizer takes more address space than any limit");
#endif
  const struct rlimit unlimited = {RLIM_INFINITY, RLIM_INFINITY};
  qtr_certificate before, after;
  leave_address_space(1 << 20);
  learn_until((size_t)1 << 24);
  TEST_ASSERT_TRUE(s->cramped);
  qtr_learner_certificate(s->learner, &before);
  for (int step = 0; step < 100; step++) study_step(s);
  qtr_learner_certificate(s->learner, &after);
  TEST_ASSERT_EQUAL_UINT64(before.episodes + 100, after.episodes);
  TEST_ASSERT_TRUE(after.objective >= before.objective && after.bound <= before.bound);
  TEST_ASSERT_EQUAL_INT(0, setrlimit(RLIMIT_AS, &unlimited));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_table_grows_as_it_is_learnt);
  RUN_TEST(test_learning_goes_on_where_no_memory_is_left);
  return UNITY_END();
}
