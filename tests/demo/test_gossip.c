/* Gossip: what is known is said at once and then again and again, and nothing else is. */
#include <limits.h>
#include <string.h>

#include "gossip.h"
#include "quarter/seeker.h"
#include "support/random.h"
#include "unity.h"

enum { SAID_MOST = 64, TICK = 50000 };

static struct {
  int signal, territory;
} said[SAID_MOST]; /* since the last listen() */
static int count;
static gossip g;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  memset(&g, 0, sizeof g);
  count = 0;
}

void tearDown(void) {
}

static void say(void *user, int signal, int territory) {
  TEST_ASSERT_EQUAL_PTR(&g, user);
  TEST_ASSERT_LESS_THAN(SAID_MOST, count);
  said[count].signal = signal;
  said[count++].territory = territory;
}

/* How many signals are said at a moment. */
static int listen(int64_t utime) {
  count = 0;
  gossip_repeat(&g, utime, say, &g);
  return count;
}

static void test_who_knows_nothing_says_nothing(void) {
  for (int tick = 0; tick < 10000; tick++) TEST_ASSERT_EQUAL_INT(0, listen((int64_t)tick * TICK));
}

static void test_news_is_said_at_once(void) {
  listen(0);
  TEST_ASSERT_TRUE(gossip_learn(&g, QTR_SIGNAL_FOUND, 0));
  TEST_ASSERT_EQUAL_INT(1, listen(1));
  TEST_ASSERT_EQUAL_INT(QTR_SIGNAL_FOUND, said[0].signal);
  TEST_ASSERT_EQUAL_INT(0, listen(2));
}

static void test_a_signal_is_said_once_a_period_for_ever(void) {
  gossip_learn(&g, QTR_SIGNAL_TERRITORY_DONE, 3);
  for (int tick = 0; tick < 100000; tick++) { /* 5,000 seconds; every second tick is due */
    TEST_ASSERT_EQUAL_INT(tick % 2 == 0, listen((int64_t)tick * TICK));
    if (count == 0) continue;
    TEST_ASSERT_EQUAL_INT(QTR_SIGNAL_TERRITORY_DONE, said[0].signal);
    TEST_ASSERT_EQUAL_INT(3, said[0].territory);
  }
}

static void test_with_news_all_that_is_known_is_said_and_the_period_begins_anew(void) {
  gossip_learn(&g, QTR_SIGNAL_TERRITORY_DONE, 0);
  TEST_ASSERT_EQUAL_INT(1, listen(0));
  gossip_learn(&g, QTR_SIGNAL_FOUND, 0);
  TEST_ASSERT_EQUAL_INT(2, listen(30000));
  TEST_ASSERT_EQUAL_INT(0, listen(129999));
  TEST_ASSERT_EQUAL_INT(2, listen(130000));
}

static void test_only_the_first_time_is_a_signal_new(void) {
  TEST_ASSERT_TRUE(gossip_learn(&g, QTR_SIGNAL_FOUND, 0));
  TEST_ASSERT_FALSE(gossip_learn(&g, QTR_SIGNAL_FOUND, 0));
  TEST_ASSERT_TRUE(gossip_learn(&g, QTR_SIGNAL_TERRITORY_DONE, 0));
  TEST_ASSERT_TRUE(gossip_learn(&g, QTR_SIGNAL_TERRITORY_DONE, DEMO_MOST_ROBOTS - 1));
  TEST_ASSERT_FALSE(gossip_learn(&g, QTR_SIGNAL_TERRITORY_DONE, 0));
  listen(0);
  gossip_learn(&g, QTR_SIGNAL_TERRITORY_DONE, 0);
  TEST_ASSERT_EQUAL_INT(0, listen(1));
}

static void test_what_is_no_signal_and_no_territory_is_ignored(void) {
  static const int signals[] = {INT_MIN, -1, 0, 3, 4, 256, 257, INT_MAX};
  static const int territories[] = {INT_MIN, -1, DEMO_MOST_ROBOTS, DEMO_MOST_ROBOTS + 1, 256, INT_MAX};
  for (unsigned i = 0; i < sizeof signals / sizeof signals[0]; i++) TEST_ASSERT_FALSE(gossip_learn(&g, signals[i], 0));
  for (unsigned i = 0; i < sizeof territories / sizeof territories[0]; i++)
    TEST_ASSERT_FALSE(gossip_learn(&g, QTR_SIGNAL_TERRITORY_DONE, territories[i]));
  TEST_ASSERT_EQUAL_INT(0, listen(0));
}

static void test_any_set_of_signals_is_said_whole_and_each_once(void) {
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("set of signals", number);
    bool known[DEMO_MOST_ROBOTS] = {false};
    memset(&g, 0, sizeof g);
    for (unsigned left = random_below(&random, 30); left > 0; left--) {
      const int territory = (int)random_below(&random, DEMO_MOST_ROBOTS);
      TEST_ASSERT_EQUAL_INT_MESSAGE(!known[territory], gossip_learn(&g, QTR_SIGNAL_TERRITORY_DONE, territory),
                                    case_note);
      known[territory] = true;
    }
    listen((int64_t)(random_bits(&random) >> 8));
    for (int i = 0; i < count; i++) {
      TEST_ASSERT_TRUE_MESSAGE(known[said[i].territory], case_note);
      known[said[i].territory] = false;
    }
    for (int territory = 0; territory < DEMO_MOST_ROBOTS; territory++)
      TEST_ASSERT_FALSE_MESSAGE(known[territory], case_note);
  }
}

/* The moments come from outside: a world begun anew, or bytes that say the year 294,000, must not silence a robot. */
static void test_a_clock_that_jumps_silences_nobody(void) {
  static const int64_t moments[] = {0, INT64_MAX, 5, INT64_MIN, 1000000, 0};
  gossip_learn(&g, QTR_SIGNAL_FOUND, 0);
  for (unsigned i = 0; i < sizeof moments / sizeof moments[0]; i++) TEST_ASSERT_EQUAL_INT(1, listen(moments[i]));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_who_knows_nothing_says_nothing);
  RUN_TEST(test_news_is_said_at_once);
  RUN_TEST(test_a_signal_is_said_once_a_period_for_ever);
  RUN_TEST(test_with_news_all_that_is_known_is_said_and_the_period_begins_anew);
  RUN_TEST(test_only_the_first_time_is_a_signal_new);
  RUN_TEST(test_what_is_no_signal_and_no_territory_is_ignored);
  RUN_TEST(test_any_set_of_signals_is_said_whole_and_each_once);
  RUN_TEST(test_a_clock_that_jumps_silences_nobody);
  return UNITY_END();
}
