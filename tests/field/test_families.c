/* The families of problems, and what is done with them: written, learnt, solved, judged. */
#include <stdio.h>
#include <string.h>

#include "field/compete.h"
#include "field/families.h"
#include "field/learn.h"
#include "quarter/objective.h"
#include "unity.h"

static problem_case made;
static fault why;
static char printed[1 << 16];

void setUp(void) {
  made = (problem_case){0};
}

void tearDown(void) {
  problem_drop(&made);
}

static family_wish wish_of(int family, unsigned seed) {
  return (family_wish){.family = family,
                       .seed = seed,
                       .side = 30,
                       .places = 12,
                       .robots = 3,
                       .looks = 1,
                       .classes = 1,
                       .stretch = 1,
                       .objective = QTR_TIME,
                       .gamma = 0.99};
}

static void make(const family_wish *wish) {
  problem_drop(&made);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, problem_of_family(&made, wish, &why), why.text);
}

static void test_every_place_is_in_reach_of_every_robot(void) {
  for (int family = 0; family < FAMILIES; family++) {
    for (unsigned seed = 0; seed < 10; seed++) {
      const family_wish wish = wish_of(family, seed);
      make(&wish);
      TEST_ASSERT_EQUAL_UINT(12, made.plain.places);
      for (unsigned i = 0; i < 3; i++)
        for (unsigned look = 0; look < 12; look++)
          TEST_ASSERT_NOT_EQUAL(PROBLEM_NO_WAY, plain_steps(&made.plain, 0, 12 + made.plain.start_of[i], look));
    }
  }
}

static uint64_t sum_of_steps(const plain_problem *p) {
  uint64_t sum = 0;
  for (unsigned node = 0; node < p->looks + p->starts; node++)
    for (unsigned look = 0; look < p->looks; look++) sum = 31 * sum + plain_steps(p, 0, node, look);
  return sum;
}

static void test_problem_is_its_seeds_alone(void) {
  for (int family = 0; family < FAMILIES; family++) {
    family_wish wish = wish_of(family, 5);
    make(&wish);
    const uint64_t sum = sum_of_steps(&made.plain);
    make(&wish);
    TEST_ASSERT_EQUAL_UINT64(sum, sum_of_steps(&made.plain));
    wish.seed = 6;
    make(&wish);
    TEST_ASSERT_NOT_EQUAL(sum, sum_of_steps(&made.plain));
  }
}

static void test_stretched_ways_take_so_many_times_as_long(void) {
  family_wish wish = wish_of(FAMILY_ROOMS, 1);
  make(&wish);
  const uint32_t once = plain_steps(&made.plain, 0, 0, 1);
  wish.stretch = 30;
  make(&wish);
  TEST_ASSERT_EQUAL_UINT(30 * once, plain_steps(&made.plain, 0, 0, 1));
}

static void test_looks_and_classes_are_told(void) {
  family_wish wish = wish_of(FAMILY_SCATTER, 1);
  wish.looks = wish.classes = 2;
  make(&wish);
  TEST_ASSERT_EQUAL_UINT(24, made.plain.looks);
  TEST_ASSERT_EQUAL_UINT(3, made.plain.place_of[15]);
  TEST_ASSERT_EQUAL_UINT(2, plain_steps(&made.plain, 0, 3, 15)); /* to scan once more */
  TEST_ASSERT_EQUAL_UINT(1, made.plain.class_of[1]);
  const uint32_t way = plain_steps(&made.plain, 0, 0, 1) - 2;
  TEST_ASSERT_EQUAL_UINT(2 * way + 2, plain_steps(&made.plain, 1, 0, 1));
}

static void test_more_than_the_build_holds_is_refused(void) {
  family_wish wish = wish_of(FAMILY_SCATTER, 1);
  wish.places = QTR_MAX_PLACES;
  wish.looks = 2;
  TEST_ASSERT_EQUAL_INT(-1, problem_of_family(&made, &wish, &why));
  TEST_ASSERT_NOT_NULL(strstr(why.text, "looks are more than this build holds"));
  wish = wish_of(FAMILY_SCATTER, 1);
  wish.places = 4096;
  TEST_ASSERT_EQUAL_INT(-1, problem_of_family(&made, &wish, &why));
  TEST_ASSERT_NOT_NULL(strstr(why.text, "more than this build holds"));
  wish = wish_of(FAMILY_SCATTER, 1);
  wish.side = 3;
  TEST_ASSERT_EQUAL_INT(-1, problem_of_family(&made, &wish, &why));
  TEST_ASSERT_EQUAL_STRING("no room for 12 places on ground of that size", why.text);
}

/* Paper setting and certified one: what is learnt is a plan, and worth what the learner says. */
static void test_learnt_plans_are_worth_what_they_are_said_to_be(void) {
  for (int setting = QTR_SETTING_CERTIFIED; setting <= QTR_SETTING_PAPER; setting++) {
    const family_wish wish = wish_of(FAMILY_CORRIDORS, 2);
    learnt l;
    verdict v;
    make(&wish);
    TEST_ASSERT_EQUAL_INT(0, learn_for(&l, &made, setting, 1e-5, 0.2, &why));
    referee_judge(&v, &made.plain, &l.best);
    TEST_ASSERT_TRUE_MESSAGE(v.legal && v.complete, v.fault);
    const double said = learnt_end(&l)->certificate.objective;
    TEST_ASSERT_DOUBLE_WITHIN(1e-9 * said, said, v.expected_time);
    learnt_drop(&l);
  }
}

/* ---- from outside ---- */

static int compete(int task, const family_wish *wish, const char *plans) {
  const bench_asked asked = {.task = task, .family = *wish, .time_limit = 60.0};
  FILE *in = tmpfile();
  FILE *out = tmpfile();
  fputs(plans, in);
  rewind(in);
  const int status = bench_compete(in, out, &asked);
  rewind(out);
  printed[fread(printed, 1, sizeof printed - 1, out)] = '\0';
  fclose(in);
  fclose(out);
  return status;
}

static void expect_printed(const char *text) {
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(printed, text), printed);
}

static void test_problem_is_written_with_all_that_others_need(void) {
  family_wish wish = wish_of(FAMILY_ROOMS, 1);
  wish.places = 2;
  TEST_ASSERT_EQUAL_INT(0, compete(BENCH_WRITE, &wish, ""));
  expect_printed("\"name\": \"rooms 1\",\n  \"objective\": \"time\",\n  \"gamma\": 0.99,\n  \"looks\": 2,");
  expect_printed("\"place_of\": [0, 1],");
  expect_printed("\"class_of\": [0, 0, 0],\n  \"start_of\": [0, 0, 0],\n  \"steps\": [\n    [\n      [0, ");
}

static void test_plans_are_judged_one_after_another(void) {
  family_wish wish = wish_of(FAMILY_ROOMS, 1);
  wish.places = 2;
  TEST_ASSERT_EQUAL_INT(0, compete(BENCH_JUDGE, &wish, "0 1\n\n\n0\n1\n\n0\n0\n\n0 1\nx\n\n1\n\n\n"));
  expect_printed("[\n  {\"legal\": true, \"complete\": true, \"arrivals\": ");
  expect_printed("{\"legal\": false, \"fault\": \"robot 1 makes a look once more, number 0\"");
  expect_printed("{\"legal\": false, \"fault\": \"robot 1 makes a look that there is not, 4294967295\"");
  expect_printed("{\"legal\": true, \"complete\": false, ");
}

/* The learner and the exact solver, on their own ways, to one figure. */
static double figure_after(const char *key) {
  double figure = -1.0;
  const char *last = NULL;
  for (const char *at = strstr(printed, key); at != NULL; at = strstr(at + 1, key)) last = at;
  TEST_ASSERT_NOT_NULL_MESSAGE(last, printed);
  TEST_ASSERT_EQUAL_INT(1, sscanf(last + strlen(key), "%lf", &figure));
  return figure;
}

static void test_exact_solver_and_learner_agree(void) {
  for (int objective = QTR_DISCOUNTED; objective <= QTR_TIME; objective++) {
    family_wish wish = wish_of(FAMILY_FLOOR, 3);
    wish.objective = objective;
    TEST_ASSERT_EQUAL_INT(0, compete(BENCH_EXACT, &wish, ""));
    const double optimum = figure_after("\"bound\": ");
    TEST_ASSERT_EQUAL_INT(0, compete(BENCH_CERTIFIED, &wish, ""));
    expect_printed("\"proved\": true");
    TEST_ASSERT_DOUBLE_WITHIN(1e-5 * optimum, optimum, figure_after("\"objective\": "));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_place_is_in_reach_of_every_robot);
  RUN_TEST(test_problem_is_its_seeds_alone);
  RUN_TEST(test_stretched_ways_take_so_many_times_as_long);
  RUN_TEST(test_looks_and_classes_are_told);
  RUN_TEST(test_more_than_the_build_holds_is_refused);
  RUN_TEST(test_learnt_plans_are_worth_what_they_are_said_to_be);
  RUN_TEST(test_problem_is_written_with_all_that_others_need);
  RUN_TEST(test_plans_are_judged_one_after_another);
  RUN_TEST(test_exact_solver_and_learner_agree);
  return UNITY_END();
}
