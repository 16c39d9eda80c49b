/* Tables that open and are not true of their own map, or of their own play: refused by every host command, in one
 * line. */
#include <math.h>
#include <string.h>

#include "host/table/table_check.h"
#include "support/forging.h"
#include "support/tool_run.h"

#define FORGED QUARTER_SOURCE_DIR "/tests/data/forged/"

static qtr_policy policy;
static tool_result result;
static fault why;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* Sealed, the table_copy opens as a robot opens it; what the host says of it. */
static int check_copy(void) {
  why.text[0] = '\0';
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, table_forge(&policy, table_copy, table_size), case_note);
  return table_check(&policy, "forged.qtr", &why);
}

static void expect_refused(const char *says) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(-1, check_copy(), case_note);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(why.text, says), why.text);
  TEST_ASSERT_EQUAL_STRING_LEN("forged.qtr: ", why.text, 12);
  TEST_ASSERT_NULL(strchr(why.text, '\n'));
  table_take(&policy);
}

/* ---- travel times ---- */

static void test_every_exported_table_is_true_of_its_map(void) {
  for (unsigned number = 0; number < 400; number++) {
    test_random random = random_case("true", number);
    mission_random(&table_mission, &random, (mission_size){14, 12, 10, 5});
    table_learn(number % 4 == 3 ? 200 : number % 4);
    table_export();
    table_take(&policy);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, table_check(&policy, case_note, &why), why.text);
  }
}

/* Too short and too long, by one step and by many; what the robot's own checks let pass, the host's do not. */
static void test_travel_time_that_the_map_does_not_give_is_refused(void) {
  unsigned opened = 0;
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("times", number);
    table_random(&random, (mission_size){9, 7, 5, 3});
    table_take(&policy);
    for (unsigned node = 0; node < (unsigned)policy.board.places + policy.board.starts; node++) {
      for (unsigned place = 0; place < policy.board.places; place++) {
        const qtr_steps steps = qtr_board_steps(&policy.board, 0, node, place);
        const qtr_steps wrong = random_chance(&random, 60) ? steps + 1 : steps - 1;
        table_set_steps(table_copy, &policy, node, place, wrong);
        if (table_forge(&policy, table_copy, table_size) == QTR_OK) {
          TEST_ASSERT_EQUAL_INT_MESSAGE(-1, table_check(&policy, case_note, &why), case_note);
          opened++;
        }
        table_take(&policy);
      }
    }
  }
  TEST_ASSERT_GREATER_THAN(300, opened);
}

static void test_fault_names_the_way(void) {
  table_draw("1..S..2", 1);
  table_take(&policy);
  table_set_steps(table_copy, &policy, 0, 1, 5);
  expect_refused("from place 0 to place 1 it says 5 steps, the map gives 6 steps");
  table_set_steps(table_copy, &policy, 2, 0, 4);
  expect_refused("from start 0 to place 0 it says 4 steps, the map gives 3 steps");
}

/* A wall across the corridor, and one taken away. */
static void test_reach_that_the_map_does_not_give_is_refused(void) {
  table_draw("1..S..2", 1);
  table_take(&policy);
  table_copy[table_size - 1] = 0x7F & ~0x10;
  expect_refused("the map gives no way");
  table_draw("1S.#.S2", 0);
  table_take(&policy);
  table_copy[table_size - 1] = 0x7F;
  expect_refused("it says no way");
}

/* ---- the certificate ---- */

static void set_double(uint32_t offset, double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  qtr_store64(table_copy + offset, bits);
}

static double get_double(uint32_t offset) {
  const uint64_t bits = qtr_load64(table_bytes + offset);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static void test_gap_that_is_not_between_value_and_bound_is_refused(void) {
  for (uint8_t objective = 0; objective < 2; objective++) {
    mission_draw(&table_mission, "1..S..2/.#~..1./3.....S");
    table_mission.aim.kind = objective;
    table_learn(1000);
    table_export();
    table_take(&policy);
    const double reached = get_double(objective == 1 ? QTR_POLICY_TIME : QTR_POLICY_VALUE);
    set_double(QTR_POLICY_BOUND, reached * (objective == 1 ? 0.75 : 1.25));
    set_double(QTR_POLICY_GAP, 0.2);
    expect_refused("gap of 0.2");
    set_double(QTR_POLICY_BOUND, reached * (objective == 1 ? 0.75 : 1.25));
    set_double(QTR_POLICY_GAP, 0.25);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, check_copy(), why.text);
  }
}

static void test_value_that_the_routes_do_not_earn_is_refused(void) {
  table_draw("1..S..2/.#~..1./3.....S", 0);
  table_take(&policy);
  const double value = get_double(QTR_POLICY_VALUE);
  set_double(QTR_POLICY_VALUE, value * 1.00001);
  set_double(QTR_POLICY_BOUND, value * 1.00001);
  set_double(QTR_POLICY_GAP, 0.0);
  expect_refused("its routes earn");
  set_double(QTR_POLICY_TIME, get_double(QTR_POLICY_TIME) * 0.99999);
  expect_refused("by its routes it takes");
}

/* ---- regions ---- */

static void learn_any_start(const char *drawing) {
  write_file("map.txt", drawing);
  run_tool(&result, "learn map.txt --starts any --start-regions 4 -q -o any.qtr");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  FILE *file = fopen("any.qtr", "rb");
  TEST_ASSERT_NOT_NULL(file);
  table_size = (uint32_t)fread(table_bytes, 1, sizeof table_bytes, file);
  fclose(file);
  table_take(&policy);
  TEST_ASSERT_TRUE(policy.any_start);
}

static void test_region_on_both_sides_of_a_wall_is_refused(void) {
  learn_any_start("1..S#..\n....#..\n....#S2\n");
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, check_copy(), why.text);
  table_take(&policy);
  const uint32_t regions = policy.at[SECTION_REGIONS];
  unsigned cell = 5; /* the right of the wall, but no region's start */
  for (unsigned s = 0; s < policy.board.starts; s++)
    if (qtr_policy_cell(&policy, policy.board.places + s) == cell) cell = 6;
  memcpy(table_copy + regions + 2 * cell, table_copy + regions, 2);
  expect_refused("cut off from its region");
}

/* ---- every host command ---- */

static void expect_all_refuse(const char *name, const char *says) {
  static const char *const commands[][2] = {
      {"inspect", ""}, {"inspect", "--json"}, {"simulate", ""}, {"draw", "-o picture.svg"}};
  for (unsigned i = 0; i < sizeof commands / sizeof commands[0]; i++) {
    const char *words = commands[i][0];
    run_tool(&result, "%s '%s%s' %s", words, FORGED, name, commands[i][1]);
    TEST_ASSERT_EQUAL_INT_MESSAGE(2, result.status, words);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("", result.out, words);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, name), result.err);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(result.err, says), result.err);
    TEST_ASSERT_EQUAL_PTR_MESSAGE(result.err + strlen(result.err) - 1, strchr(result.err, '\n'), result.err);
  }
  TEST_ASSERT_NULL(fopen("picture.svg", "r"));
}

static void test_every_host_command_refuses_a_place_that_nobody_reaches(void) {
  expect_all_refuse("unreachable-column.qtr", "leave a place out of reach");
}

static void test_every_host_command_refuses_a_way_through_a_wall(void) {
  expect_all_refuse("walled-off.qtr", "from place 1 to place 0 it says 3 steps, the map gives no way");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_exported_table_is_true_of_its_map);
  RUN_TEST(test_travel_time_that_the_map_does_not_give_is_refused);
  RUN_TEST(test_fault_names_the_way);
  RUN_TEST(test_reach_that_the_map_does_not_give_is_refused);
  RUN_TEST(test_gap_that_is_not_between_value_and_bound_is_refused);
  RUN_TEST(test_value_that_the_routes_do_not_earn_is_refused);
  RUN_TEST(test_region_on_both_sides_of_a_wall_is_refused);
  RUN_TEST(test_every_host_command_refuses_a_place_that_nobody_reaches);
  RUN_TEST(test_every_host_command_refuses_a_way_through_a_wall);
  return UNITY_END();
}
