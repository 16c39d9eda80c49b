/* Two plans side by side, against what each table says of itself. */
#include "support/tool_run.h"

static tool_result r, told;

static void learn(const char *words) {
  run_tool(&r, "learn -q %s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
}

void setUp(void) {
  write_file("area.txt", "S.....\n.##.#.\n......\n");
  write_file("two.yaml",
             "map: area.txt\nobjective: time\nrobots: [{column: 0, row: 0}, {column: 5, row: 0, name: Eve}]\n"
             "places: [{column: 3, row: 0, name: Door, weight: 3}, {column: 0, row: 2}, {column: 5, row: 2}]\n");
  write_file("one.yaml",
             "map: area.txt\nobjective: time\nrobots: [{column: 0, row: 0}]\n"
             "places: [{column: 3, row: 0, name: Door, weight: 3}, {column: 0, row: 2}, {column: 5, row: 2}]\n");
}

void tearDown(void) {
}

static void compare(const char *words, const char *const *expected) {
  run_tool(&r, "compare %s", words);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, r.status, r.err);
  for (; *expected != NULL; expected++) TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, *expected), r.out);
}

static void refuse(const char *words, const char *text) {
  run_tool(&r, "compare %s", words);
  TEST_ASSERT_EQUAL_INT(2, r.status);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.err, text), r.err);
  TEST_ASSERT_EQUAL_STRING("", r.out);
}

/* By hand: one robot is at Door after 3 steps, at 2 after 7 and at 1 after 12: 0.6 * 3 + 0.2 * 7 + 0.2 * 12 = 5.6. Eve
 * is at Door after 2 and at 2 after 6, the other one at 1 after 2: 2.8. */
static void test_value_and_visits_stand_side_by_side(void) {
  learn("one.yaml -o one.qtr");
  learn("two.yaml -o two.qtr");
  compare("one.qtr two.qtr",
          (const char *const[]){"  expected time     ", "1 robot, 3 places", "2 robots, 3 places", "\n  Door  ",
                                "two.qtr is better by 50 %: 2.8 steps against 5.6 steps", "of 3 places in both", NULL});
}

static void test_figures_are_those_of_the_tables(void) {
  learn("one.yaml -o one.qtr");
  learn("two.yaml -o two.qtr");
  run_tool(&r, "compare one.qtr two.qtr --json");
  TEST_ASSERT_EQUAL_INT(0, r.status);
  const char *first = strstr(r.out, "\"input\": \"one.qtr\""), *second = strstr(r.out, "\"input\": \"two.qtr\"");
  TEST_ASSERT_TRUE(first != NULL && second != NULL);
  run_tool(&told, "inspect one.qtr --json");
  TEST_ASSERT_EQUAL_DOUBLE(json_value(told.out, "objective_value"), json_value(first, "objective_value"));
  TEST_ASSERT_EQUAL_DOUBLE(json_value(told.out, "objective_bound"), json_value(first, "objective_bound"));
  run_tool(&told, "inspect two.qtr --json");
  TEST_ASSERT_EQUAL_DOUBLE(json_value(told.out, "objective_value"), json_value(second, "objective_value"));
  TEST_ASSERT_TRUE(json_is(r.out, "one_mission", "true") && json_is(r.out, "second_is_better", "true"));
  TEST_ASSERT_TRUE(json_value(r.out, "difference") < 0);
  TEST_ASSERT_NOT_NULL_MESSAGE(strstr(r.out, "{\"first\": {\"place\": 0, \"name\": \"Door\", \"seeker\": 0, "), r.out);
}

static void test_a_plan_is_worth_what_it_is_worth(void) {
  learn("two.yaml -o two.qtr");
  compare("two.qtr two.qtr",
          (const char *const[]){"both are worth the same", "0 by another robot, 0 sooner, 0 later", NULL});
}

static void test_places_of_two_missions_are_matched_by_name(void) {
  learn("two.yaml -o two.qtr");
  write_file("new.yaml",
             "map: area.txt\nobjective: time\nrobots: [{column: 0, row: 0}]\n"
             "places: [{column: 5, row: 1}, {column: 3, row: 0, name: Door}, {column: 5, row: 0, name: Gate}]\n");
  learn("new.yaml -o new.qtr");
  compare("two.qtr new.qtr",
          (const char *const[]){"two missions: ", "do not tell which plan is better", "\n  Gate ", "of 1 place in both",
                                "; 2 in the first alone; 2 in the second alone", NULL});
  TEST_ASSERT_NULL(strstr(r.out, "is better by"));
  run_tool(&r, "compare two.qtr new.qtr --json");
  TEST_ASSERT_TRUE(json_is(r.out, "one_mission", "false") && json_is(r.out, "second_is_better", "null"));
}

static void test_other_objectives_cannot_be_compared(void) {
  learn("two.yaml -o two.qtr");
  learn("two.yaml --objective discounted -o worth.qtr");
  learn("two.yaml --objective discounted --gamma 0.9 -o less.qtr");
  refuse("two.qtr worth.qtr", "--objective");
  refuse("worth.qtr less.qtr", "--gamma");
}

static void test_two_tables_are_wanted(void) {
  learn("two.yaml -o two.qtr");
  refuse("two.qtr", "name two tables");
  refuse("two.qtr two.qtr two.qtr", "name two tables");
  refuse("two.qtr two.yaml", "two.yaml");
  refuse("two.qtr nowhere.qtr", "nowhere.qtr");
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_value_and_visits_stand_side_by_side);
  RUN_TEST(test_figures_are_those_of_the_tables);
  RUN_TEST(test_a_plan_is_worth_what_it_is_worth);
  RUN_TEST(test_places_of_two_missions_are_matched_by_name);
  RUN_TEST(test_other_objectives_cannot_be_compared);
  RUN_TEST(test_two_tables_are_wanted);
  return UNITY_END();
}
