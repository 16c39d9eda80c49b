/* The tool against exact optima that were found elsewhere (tests/data/reference), and against its own exact solver. */
#include "support/tool_run.h"

static tool_result learnt, solved;

void setUp(void) {
}
void tearDown(void) {
}

static void check_case(const char *name, int robots, const char *objective, double optimum) {
  char message[128];
  snprintf(message, sizeof message, "%s, %s", name, objective);
  run_tool(&learnt, "learn %s/tests/data/reference/%s --robots %d --objective %s --json", QUARTER_SOURCE_DIR, name,
           robots, objective);
  run_tool(&solved, "exact %s/tests/data/reference/%s --robots %d --objective %s --json", QUARTER_SOURCE_DIR, name,
           robots, objective);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, learnt.status, message);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, solved.status, message);
  TEST_ASSERT_TRUE_MESSAGE(json_is(learnt.out, "certified", "true"), message);
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-5 * optimum, optimum, json_value(learnt.out, "objective_value"), message);
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-5 * optimum, optimum, json_value(learnt.out, "objective_bound"), message);
  TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-6 * optimum, optimum, json_value(solved.out, "objective_value"), message);
}

/* Lines such as: case01.txt 2 places 3 robots 2 value 9.72 expected_time 3.8 */
static void test_learner_and_exact_solver_agree_with_the_reference(void) {
  char line[256];
  int cases = 0;
  FILE *values = fopen(QUARTER_SOURCE_DIR "/tests/data/reference/values.txt", "r");
  TEST_ASSERT_NOT_NULL(values);
  while (fgets(line, sizeof line, values) != NULL) {
    char name[64];
    int robots;
    double value, time;
    if (sscanf(line, "%63s %*d places %*d robots %d value %lf expected_time %lf", name, &robots, &value, &time) != 4)
      continue;
    check_case(name, robots, "discounted", value);
    check_case(name, robots, "time", time);
    cases++;
  }
  fclose(values);
  TEST_ASSERT_EQUAL_INT(15, cases);
}

static void test_paper_rule_agrees_with_the_exact_solver(void) {
  static const char *const names[] = {"case01.txt", "case03.txt", "case04.txt", "case05.txt", "case13.txt"};
  for (int i = 0; i < 10; i++) {
    const char *name = names[i / 2];
    const char *objective = i % 2 == 0 ? "discounted" : "time";
    run_tool(&learnt, "learn %s/tests/data/reference/%s --robots 2 --rule paper --objective %s --json",
             QUARTER_SOURCE_DIR, name, objective);
    run_tool(&solved, "exact %s/tests/data/reference/%s --robots 2 --rule paper --objective %s --json",
             QUARTER_SOURCE_DIR, name, objective);
    const double optimum = json_value(solved.out, "objective_value");
    TEST_ASSERT_TRUE_MESSAGE(json_is(learnt.out, "certified", "true"), name);
    TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(1e-5 * optimum, optimum, json_value(learnt.out, "objective_value"), name);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learner_and_exact_solver_agree_with_the_reference);
  RUN_TEST(test_paper_rule_agrees_with_the_exact_solver);
  return UNITY_END();
}
