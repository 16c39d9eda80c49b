/* Fault scripts: what they say, in the order of its time, and one line for each mistake in one. */
#include <string.h>

#include "faults.h"
#include "play.h"

/* Four robots, four places; column 2 of row 1 is a wall, and there is no way to the room of column 5. */
#define GROUND "S.1S##/S.#2#./S..3##/4...##"

static fault_script script;
static fault why;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  memset(&script, 0xA5, sizeof script);
  memset(&why, 0, sizeof why);
}

void tearDown(void) {
}

static int read_script(const char *text) {
  FILE *file = fopen("faults.yaml", "wb");
  TEST_ASSERT_NOT_NULL(file);
  fputs(text, file);
  fclose(file);
  return faults_read(&script, "faults.yaml", &play_plan.t, &why);
}

static void assert_event(int i, double at, int kind, int robot, double share) {
  TEST_ASSERT_EQUAL_DOUBLE(at, script.event[i].at);
  TEST_ASSERT_EQUAL_INT(kind, script.event[i].kind);
  TEST_ASSERT_EQUAL_INT(robot, script.event[i].robot);
  TEST_ASSERT_EQUAL_DOUBLE(share, script.event[i].share);
}

static void assert_shut(int i, unsigned column, unsigned row) {
  TEST_ASSERT_EQUAL_UINT(column, table_column(&play_plan.t, script.event[i].cell));
  TEST_ASSERT_EQUAL_UINT(row, table_row(&play_plan.t, script.event[i].cell));
}

static void test_every_fault_is_read(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0,
                                read_script("faults:\n"
                                            "  - {at: 20, lost: 1}\n"
                                            "  - {at: 15, stuck: 0, for: 10}\n"
                                            "  - {at: 1, slip: 0.3, robot: 2}\n"
                                            "  - {at: 2.5, loss: 0.25}\n"
                                            "  - {at: 30, shut: 2}\n"
                                            "  - {at: 31, shut: {column: 1, row: 2}}\n"
                                            "  - {at: 40, reset: 2, for: 4}\n"),
                                why.text);
  TEST_ASSERT_EQUAL_INT(9, script.count);
  assert_event(0, 1.0, FAULT_SLIP, 2, 0.3);
  assert_event(1, 2.5, FAULT_LOSS, -1, 0.25);
  assert_event(2, 15.0, FAULT_STUCK, 0, 0.0);
  assert_event(3, 20.0, FAULT_LOST, 1, 0.0);
  assert_event(4, 25.0, FAULT_UNSTUCK, 0, 0.0);
  assert_event(5, 30.0, FAULT_SHUT, -1, 0.0);
  assert_shut(5, 3, 2);
  assert_event(6, 31.0, FAULT_SHUT, -1, 0.0);
  assert_shut(6, 1, 2);
  assert_event(7, 40.0, FAULT_RESET, 2, 0.0);
  assert_event(8, 44.0, FAULT_RESTART, 2, 0.0);
  TEST_ASSERT_EQUAL_INT(2, faults_count(&script, FAULT_SHUT));
}

static void test_what_is_left_out_has_the_documented_value(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, read_script("faults: [{stuck: 3}, {slip: 0.5}, {reset: 1}]"), why.text);
  TEST_ASSERT_EQUAL_INT(5, script.count);
  assert_event(0, 0.0, FAULT_STUCK, 3, 0.0);
  assert_event(1, 0.0, FAULT_SLIP, -1, 0.5);
  assert_event(2, 0.0, FAULT_RESET, 1, 0.0);
  assert_event(3, 3.0, FAULT_RESTART, 1, 0.0);
  assert_event(4, 10.0, FAULT_UNSTUCK, 3, 0.0);
}

static void test_a_script_may_be_empty(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, read_script("faults: []"), why.text);
  TEST_ASSERT_EQUAL_INT(0, script.count);
}

/* One line: file, the line in it, and what it should say. */
static void refuse(const char *text, int line, const char *named) {
  char place[40];
  memset(&why, 0, sizeof why);
  snprintf(place, sizeof place, "faults.yaml:%d", line);
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, read_script(text), text);
  TEST_ASSERT_NULL_MESSAGE(strchr(why.text, '\n'), why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, place), why.text);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, named), why.text);
}

static void test_robots_that_are_not_there_are_refused(void) {
  refuse("faults:\n  - {at: 1, lost: 4}\n", 2, "there is no robot 4; there are robots 0 to 3");
  refuse("faults:\n  - {at: 1, lost: 0}\n  - {at: 1, stuck: -1}\n", 3, "no robot -1");
  refuse("faults:\n  - {at: 1, slip: 0.1, robot: 99}\n", 2, "no robot 99");
  refuse("faults:\n  - {at: 1, lost: first}\n", 2, "there is no robot first");
  refuse("faults:\n  - {at: 1, lost: 1.5}\n", 2, "there is no robot 1.5");
  refuse("faults:\n  - {at: 1, lost: 99999999999999999999}\n", 2, "lost");
}

static void test_what_cannot_be_shut_is_refused(void) {
  refuse("faults:\n  - {at: 1, shut: 4}\n", 2, "there is no place 4; there are places 0 to 3");
  refuse("faults:\n  - {at: 1, shut: -1}\n", 2, "no place -1");
  refuse("faults:\n  - {at: 1, shut: door}\n", 2, "shut");
  refuse("faults:\n  - {at: 1, shut: {column: 6, row: 0}}\n", 2, "column 6, row 0");
  refuse("faults:\n  - {at: 1, shut: {column: -1, row: 0}}\n", 2, "column -1, row 0");
  refuse("faults:\n  - {at: 1, shut: {column: 99999999, row: 0}}\n", 2, "column 99999999");
  refuse("faults:\n  - {at: 1, shut: {column: 2, row: 1}}\n", 2, "name a free cell");
  refuse("faults:\n  - {at: 1, shut: {column: 5, row: 1}}\n", 2, "name a free cell");
  refuse("faults:\n  - {at: 1, shut: {column: 2}}\n", 2, "row");
  refuse("faults:\n  - {at: 1, shut: {column: 2, row: 0, door: 1}}\n", 2, "door");
  refuse("faults:\n  - {at: -2, shut: 1}\n", 2, "at: -2 is not from 0");
}

static void test_resets_that_cannot_be_are_refused(void) {
  refuse("faults:\n  - {at: 1, reset: 4}\n", 2, "there is no robot 4; there are robots 0 to 3");
  refuse("faults:\n  - {at: -0.5, reset: 1}\n", 2, "at: -0.5 is not from 0");
  refuse("faults:\n  - {at: 1, reset: 1, for: 0.5}\n", 2, "for: 0.5 is not from 1 to 1000000");
  refuse("faults:\n  - {at: 1, shut: 1, for: 5}\n", 2, "for goes with stuck and reset");
  refuse("faults:\n  - {at: 1, reset: 1, robot: 2}\n", 2, "robot goes with slip");
}

static void test_numbers_out_of_range_are_refused(void) {
  refuse("faults:\n  - {at: -1, lost: 0}\n", 2, "at: -1 is not from 0");
  refuse("faults:\n  - {at: 1e7, lost: 0}\n", 2, "at");
  refuse("faults:\n  - {at: soon, lost: 0}\n", 2, "soon");
  refuse("faults:\n  - {at: .nan, lost: 0}\n", 2, "at");
  refuse("faults:\n  - {at: 1, stuck: 0, for: -3}\n", 2, "for");
  refuse("faults:\n  - {at: 1, slip: 1.5}\n", 2, "slip: 1.5 is not from 0 to 0.95");
  refuse("faults:\n\n  - {at: 1, loss: -0.1}\n", 3, "loss");
  refuse("faults:\n  - {at: 1, loss: .inf}\n", 2, "loss");
}

static void test_what_is_no_fault_is_refused(void) {
  refuse("faults:\n  - {at: 1}\n", 2, "lost, stuck, slip, loss, shut or reset");
  refuse("faults:\n  - {at: 1, robot: 2}\n", 2, "lost, stuck, slip, loss, shut or reset");
  refuse("faults:\n  - {at: 1, explode: 2}\n", 2, "explode");
  refuse("faults:\n  - lost\n", 2, "a fault");
  refuse("faults:\n  - [1, 2]\n", 2, "a fault");
}

static void test_what_is_no_script_is_refused(void) {
  refuse("faults: 3\n", 1, "list");
  refuse("faults:\n  lost: 1\n", 2, "list");
  refuse("errors: []\n", 1, "errors");
  refuse("- {at: 1, lost: 0}\n", 1, "key: value");
}

static void test_bytes_that_are_no_yaml_are_refused(void) {
  TEST_ASSERT_EQUAL_INT(-1, read_script("faults: [{at: 1, lost: 0}"));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "faults.yaml"), why.text);
  TEST_ASSERT_EQUAL_INT(-1, read_script(""));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "faults.yaml"), why.text);
  TEST_ASSERT_EQUAL_INT(-1, faults_read(&script, "not_there.yaml", &play_plan.t, &why));
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, "not_there.yaml"), why.text);
}

static void test_too_many_faults_are_refused_where_they_become_too_many(void) {
  char text[FAULTS_MOST * 30 + 100] = "faults:\n";
  for (int i = 0; i < FAULTS_MOST; i++) strcat(text, "  - {at: 1, lost: 0}\n");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, read_script(text), why.text);
  TEST_ASSERT_EQUAL_INT(FAULTS_MOST, script.count);
  strcat(text, "  - {at: 1, lost: 0}\n");
  refuse(text, FAULTS_MOST + 2, "more than 64 faults");
}

static void test_events_come_in_the_order_of_their_times_and_equal_ones_as_they_were_given(void) {
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("order of faults", number);
    script.count = 0;
    for (int i = 0; i < FAULTS_MOST; i++)
      TEST_ASSERT_EQUAL_INT(0, faults_add(&script, (fault_event){random_below(&random, 8), FAULT_LOST, i, 0.0, 0}));
    TEST_ASSERT_EQUAL_INT(-1, faults_add(&script, (fault_event){0, FAULT_LOST, 0, 0.0, 0}));
    for (int i = 1; i < FAULTS_MOST; i++) {
      const fault_event *before = &script.event[i - 1], *after = &script.event[i];
      TEST_ASSERT_TRUE_MESSAGE(before->at < after->at || (before->at == after->at && before->robot < after->robot),
                               case_note);
    }
  }
}

int main(void) {
  UNITY_BEGIN();
  play_prepare_drawn(GROUND, 0);
  RUN_TEST(test_every_fault_is_read);
  RUN_TEST(test_what_is_left_out_has_the_documented_value);
  RUN_TEST(test_a_script_may_be_empty);
  RUN_TEST(test_robots_that_are_not_there_are_refused);
  RUN_TEST(test_what_cannot_be_shut_is_refused);
  RUN_TEST(test_resets_that_cannot_be_are_refused);
  RUN_TEST(test_numbers_out_of_range_are_refused);
  RUN_TEST(test_what_is_no_fault_is_refused);
  RUN_TEST(test_what_is_no_script_is_refused);
  RUN_TEST(test_bytes_that_are_no_yaml_are_refused);
  RUN_TEST(test_too_many_faults_are_refused_where_they_become_too_many);
  RUN_TEST(test_events_come_in_the_order_of_their_times_and_equal_ones_as_they_were_given);
  plan_free(&play_plan);
  return UNITY_END();
}
