/* profiles: host mcu */
/* Where robots set out, and what is cleared before they do: checked against the table, which stays as it is. */
#include <string.h>

#include "quarter/deployment.h"
#include "quarter/seeker.h"
#include "support/tables.h"

static qtr_policy policy;
static qtr_policy as_opened;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
  TEST_ASSERT_EQUAL_MEMORY(&as_opened, &policy, sizeof policy);
}

static void take(void) {
  table_open(&policy);
  as_opened = policy;
}

static int deploy(qtr_deployment *deployment, const qtr_cell *starts) {
  return qtr_deployment_init(deployment, &policy, starts, NULL);
}

static void test_seekers_are_put_at_starts_of_the_table_and_nowhere_else(void) {
  qtr_deployment deployment;
  table_draw("S..1..S/...2...", 0);
  take();
  const qtr_cell swapped[2] = {6, 0};
  const qtr_cell off_start[2] = {0, 1};
  const qtr_cell off_map[2] = {0, 14};
  TEST_ASSERT_EQUAL_INT(QTR_OK, deploy(&deployment, swapped));
  TEST_ASSERT_EQUAL_UINT16(1, deployment.start_of[0]);
  TEST_ASSERT_EQUAL_UINT16(0, deployment.start_of[1]);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_START, deploy(&deployment, off_start));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_START, deploy(&deployment, off_map));
  TEST_ASSERT_EQUAL_UINT16(1, deployment.start_of[0]);
}

/* Home, all play from where the mission says; elsewhere from their regions' starts; and home again. */
static void test_seekers_play_from_home_or_from_their_regions(void) {
  const qtr_cell home = 3;
  const qtr_cell left = 0;
  const qtr_cell right = 13;
  const qtr_cell wall = 4;
  qtr_deployment deployment;
  table_draw_regions();
  take();
  TEST_ASSERT_EQUAL_INT(QTR_OK, deploy(&deployment, &right));
  TEST_ASSERT_EQUAL_UINT16(1, deployment.start_of[0]);
  TEST_ASSERT_EQUAL_INT(QTR_OK, deploy(&deployment, &left));
  TEST_ASSERT_EQUAL_UINT16(0, deployment.start_of[0]);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_START, deploy(&deployment, &wall));
  TEST_ASSERT_EQUAL_UINT16(0, deployment.start_of[0]);
  TEST_ASSERT_EQUAL_INT(QTR_OK, deploy(&deployment, &home));
  TEST_ASSERT_EQUAL_UINT16(2, deployment.start_of[0]);
}

static void test_cells_are_of_the_regions_that_the_table_says(void) {
  table_draw_regions();
  take();
  TEST_ASSERT_EQUAL_UINT(0, qtr_policy_region(&policy, 0));
  TEST_ASSERT_EQUAL_UINT(1, qtr_policy_region(&policy, 13));
  TEST_ASSERT_EQUAL_UINT(QTR_POLICY_NO_REGION, qtr_policy_region(&policy, 4));
  TEST_ASSERT_EQUAL_UINT(QTR_POLICY_NO_REGION, qtr_policy_region(&policy, 14));
  TEST_ASSERT_EQUAL_UINT(QTR_POLICY_NO_REGION, qtr_policy_region(&policy, QTR_NO_CELL));
}

static void test_told_nothing_all_is_as_the_mission_says(void) {
  qtr_deployment deployment;
  table_draw("S..1..S/...2...", 0);
  take();
  TEST_ASSERT_EQUAL_INT(QTR_OK, deploy(&deployment, NULL));
  for (unsigned i = 0; i < 2; i++) TEST_ASSERT_EQUAL_UINT16(policy.board.start_of[i], deployment.start_of[i]);
  for (unsigned place = 0; place < QTR_MAX_PLACES; place++)
    TEST_ASSERT_FALSE(qtr_places_has(&deployment.cleared, place));
}

static void test_seekers_of_one_policy_are_deployed_apart(void) {
  const qtr_cell right = 13;
  qtr_seeker at_home, elsewhere;
  qtr_deployment deployment;
  qtr_places cleared;
  table_draw_regions();
  take();
  qtr_places_clear(&cleared);
  qtr_places_add(&cleared, 0);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, &policy, &right, &cleared));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_seeker_init(&elsewhere, &policy, 0, &deployment, 0));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_seeker_init(&at_home, &policy, 0, NULL, 0));
  TEST_ASSERT_EQUAL_UINT16(2 + 1, elsewhere.division.joint.node[0]);
  TEST_ASSERT_EQUAL_UINT16(1, qtr_seeker_target(&elsewhere));
  TEST_ASSERT_EQUAL_UINT(1, qtr_seeker_left(&elsewhere, NULL));
  TEST_ASSERT_EQUAL_UINT(2, qtr_seeker_left(&at_home, NULL));
  TEST_ASSERT_TRUE(elsewhere.identity != at_home.identity);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_seekers_are_put_at_starts_of_the_table_and_nowhere_else);
  RUN_TEST(test_seekers_play_from_home_or_from_their_regions);
  RUN_TEST(test_cells_are_of_the_regions_that_the_table_says);
  RUN_TEST(test_told_nothing_all_is_as_the_mission_says);
  RUN_TEST(test_seekers_of_one_policy_are_deployed_apart);
  return UNITY_END();
}
