/* The tables in tests/golden, which Quarter 0.1 wrote: every later version opens them, and plays them without leaving
 * the table. */
#include <stdio.h>
#include <string.h>

#include "host/table/table.h"
#include "quarter/nominal.h"
#include "unity.h"

void setUp(void) {
}

void tearDown(void) {
}

static void test_tables_of_the_first_version_open_and_are_played(void) {
  static const char *const names[] = {"any-start", "most",      "places-31", "places-32",
                                      "places-33", "places-63", "places-64", "places-65"};
  for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++) {
    static table t;
    char path[1000];
    fault why;
    qtr_joint joint;
    qtr_move move;
    unsigned off = 0;
    snprintf(path, sizeof path, QUARTER_SOURCE_DIR "/tests/golden/%s.qtr", names[i]);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, table_read(&t, path, &why), why.text);
    TEST_ASSERT_EQUAL_UINT8_MESSAGE(1, t.policy.format, names[i]);
    qtr_joint_start(&joint, &t.policy.board, NULL, NULL);
    while (qtr_policy_move(&t.policy, &joint, &move)) off += move.off_table;
    TEST_ASSERT_EQUAL_UINT_MESSAGE(0, off, names[i]);
    TEST_ASSERT_EQUAL_UINT16_MESSAGE(0, joint.unvisited, names[i]);
    table_free(&t);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_tables_of_the_first_version_open_and_are_played);
  return UNITY_END();
}
