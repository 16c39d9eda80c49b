/* What README.md shows of the host command is what it prints now. */
#include <string.h>

#include "support/tool_run.h"

static tool_result result;
static char readme[1 << 16];

void setUp(void) {
  read_text(QUARTER_SOURCE_DIR "/README.md", readme, sizeof readme);
}

void tearDown(void) {
}

/* But for where the checkout is, and how long it took. */
static const char *part_that_stays(char *line) {
  char *const seconds = strstr(line, " bytes), ");
  if (seconds != NULL) seconds[strlen(" bytes)")] = '\0';
  const char *const checkout = strstr(line, QUARTER_SOURCE_DIR "/");
  return checkout != NULL ? checkout + strlen(QUARTER_SOURCE_DIR "/") : line;
}

static void test_learning_its_mission_prints_what_readme_shows(void) {
  int lines = 0;
  run_tool(&result, "learn '%s/demo/missions/turtlebot3_world/mission.yaml' -o patrol.qtr --c patrol.c --profile mcu",
           QUARTER_SOURCE_DIR);
  TEST_ASSERT_EQUAL_INT_MESSAGE(0, result.status, result.err);
  for (char *line = strtok(result.out, "\n"); line != NULL; line = strtok(NULL, "\n"), lines++) {
    const char *const shown = part_that_stays(line);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(readme, shown), shown);
  }
  TEST_ASSERT_EQUAL_INT(10, lines);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learning_its_mission_prints_what_readme_shows);
  return UNITY_END();
}
