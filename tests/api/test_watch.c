/* profiles: host mcu */
/* Long work ended early by the caller's watch, at every moment in turn: what is known stays valid, a plan that exists
 * is kept, and learning goes on from there to the same optimum. */
#include "support/settings.h"
#include "support/tables.h"

static uint64_t asked, allowed; /* times that the watch was asked, and may say yes */
static qtr_environment *aggregate;
static double optimum;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static bool allow(void *context) {
  TEST_ASSERT_EQUAL_PTR(&allowed, context);
  return ++asked <= allowed;
}

static void watch_mission(uint64_t times) {
  table_mission.watch = (qtr_watch){allow, &allowed};
  asked = 0;
  allowed = times;
}

/* The bound bounds, and the best game earns what it says: it is exported, and the certificate is that of its routes. */
static void expect_valid(void) {
  qtr_certificate certificate;
  qtr_policy policy;
  qtr_learner_certificate(table_learner, &certificate);
  const double sign = table_mission.aim.kind == QTR_TIME ? -1.0 : 1.0;
  const double slack = 2e-5 * optimum; /* within which it is known */
  TEST_ASSERT_TRUE_MESSAGE(sign * certificate.bound >= sign * optimum - slack, case_note);
  TEST_ASSERT_TRUE_MESSAGE(sign * certificate.objective <= sign * optimum + slack, case_note);
  qtr_play again = *qtr_learner_best(table_learner);
  for (unsigned place = 0; place < QTR_MAX_PLACES; place++) again.visit[place] = QTR_NEVER;
  qtr_play_score(&again, &table_game);
  TEST_ASSERT_TRUE_MESSAGE(again.score.value == certificate.value, case_note);
  TEST_ASSERT_TRUE_MESSAGE(again.score.expected_time == certificate.expected_time, case_note);
  table_export();
  table_open(&policy);
}

/* Whether the spots were made before a stop. */
static bool make_spots(void) {
  const qtr_spots_config spots = spot_limits(4, 6, 0.0);
  const qtr_aggregation how = aggregation_of(&spots, NULL);
  const int status = aggregate_init(&aggregate, &table_game, &how, &table_travel);
  if (status == QTR_OK) return true;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_ERR_STOPPED, status, case_note);
  TEST_ASSERT_TRUE_MESSAGE(asked > allowed, case_note);
  return false;
}

/* From the travel times to the proof, `spots` or not. False: stopped before there was a plan. */
static bool run(bool spots, uint8_t setting) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  config.setting = setting;
  const int status = qtr_game_init(&table_game, &table_mission, &table_travel, NULL);
  if (status == QTR_ERR_STOPPED) TEST_ASSERT_LESS_THAN_MESSAGE(table_mission.places, table_game.measured, case_note);
  if (status == QTR_ERR_STOPPED) return false;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, status, case_note);
  const qtr_environment *on = spots && make_spots() ? aggregate : NULL;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&table_ground, &table_game, &table_travel), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&table_learner, table_ground, on, &config), case_note);
  const int most = setting == QTR_SETTING_PAPER ? 30 : 2000;
  for (int steps = 0; steps < most && asked <= allowed && qtr_learner_step(table_learner) == QTR_LEARNING; steps++) {}
  return true;
}

static void go_on_to_the_end(void) {
  allowed = UINT64_MAX;
  for (int steps = 0; steps < 5000 && qtr_learner_step(table_learner) == QTR_LEARNING; steps++) {}
  expect_valid();
}

static void draw_mission(const char *test, unsigned number) {
  test_random random = random_case(test, number);
  mission_random(&table_mission, &random, (mission_size){12, 10, 8, 3});
  table_mission.rule = QTR_RULE_FREE;
}

/* The optimum of the mission, and how often the watch is asked on the way to it. */
static uint64_t learn_unstopped(bool spots, uint8_t setting) {
  qtr_certificate certificate;
  watch_mission(UINT64_MAX);
  TEST_ASSERT_TRUE(run(false, QTR_SETTING_CERTIFIED));
  qtr_learner_certificate(table_learner, &certificate);
  TEST_ASSERT_TRUE_MESSAGE(certificate.gap <= 1e-5, case_note);
  optimum = certificate.objective;
  watch_mission(UINT64_MAX);
  run(spots, setting);
  return asked;
}

/* Some moments of a run, the first ones all. */
static void stop_everywhere(const char *test, bool spots, uint8_t setting, bool goes_on) {
  for (unsigned number = 0; number < 3; number++) {
    draw_mission(test, number);
    const uint64_t all = learn_unstopped(spots, setting);
    for (uint64_t moment = 0; moment < all; moment += 1 + moment / 4 + all / 50) {
      watch_mission(moment);
      if (!run(spots, setting)) continue;
      expect_valid();
      if (!goes_on) continue;
      go_on_to_the_end();
      TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(2e-5 * optimum, optimum,
                                        table_mission.aim.kind == QTR_TIME
                                            ? qtr_learner_best(table_learner)->score.expected_time
                                            : qtr_learner_best(table_learner)->score.value,
                                        case_note);
    }
  }
}

static void test_a_stop_at_any_moment_leaves_all_valid_and_learning_goes_on(void) {
  stop_everywhere("ground", false, QTR_SETTING_CERTIFIED, true);
}

static void test_a_stop_with_spots(void) {
  stop_everywhere("spots", true, QTR_SETTING_CERTIFIED, false);
}

static void test_a_stop_in_the_paper_setting(void) {
  stop_everywhere("paper", false, QTR_SETTING_PAPER, false);
}

static void test_being_asked_changes_nothing(void) {
  static uint8_t unwatched[TABLE_MOST];
  for (unsigned number = 0; number < 20; number++) {
    draw_mission("asked", number);
    run(false, QTR_SETTING_CERTIFIED);
    table_export();
    const uint32_t size = table_size;
    memcpy(unwatched, table_bytes, size);
    watch_mission(UINT64_MAX);
    run(false, QTR_SETTING_CERTIFIED);
    table_export();
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(size, table_size, case_note);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(unwatched, table_bytes, size, case_note);
    table_mission.watch = (qtr_watch){NULL, NULL};
  }
}

/* Work between two askings is bounded however large the mission: places^2 and slots grow, askings grow with them. */
static void test_more_work_asks_more_often(void) {
  mission_draw(&table_mission, "S..1..2..3/........../5..4......");
  watch_mission(UINT64_MAX);
  run(false, QTR_SETTING_CERTIFIED);
  const uint64_t few = asked;
  mission_draw(&table_mission, "S..1..2..3/12..4..5.3/5..4...6..");
  watch_mission(UINT64_MAX);
  run(false, QTR_SETTING_CERTIFIED);
  TEST_ASSERT_TRUE(few > table_mission.places / 3u);
  TEST_ASSERT_TRUE(asked > few);
}

static void test_regions_are_stopped_at_any_moment_or_are_the_same(void) {
  static qtr_regions regions, whole;
  static uint64_t scratch[(QTR_REGIONS_SCRATCH_BYTES + 7) / 8];
  draw_mission("regions", 3);
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  qtr_regions_config config;
  qtr_regions_default(&config);
  config.max_size = 5;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_regions_build(&whole, &grid, &config, scratch, sizeof scratch));
  config.watch = (qtr_watch){allow, &allowed};
  asked = 0;
  allowed = UINT64_MAX;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch));
  TEST_ASSERT_EQUAL_MEMORY(whole.of, regions.of, sizeof whole.of);
  const uint64_t all = asked;
  TEST_ASSERT_TRUE(all > whole.count);
  for (allowed = 0; allowed < all; allowed++) {
    asked = 0;
    TEST_ASSERT_EQUAL_INT(QTR_ERR_STOPPED, qtr_regions_build(&regions, &grid, &config, scratch, sizeof scratch));
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_stop_at_any_moment_leaves_all_valid_and_learning_goes_on);
  RUN_TEST(test_a_stop_with_spots);
  RUN_TEST(test_a_stop_in_the_paper_setting);
  RUN_TEST(test_being_asked_changes_nothing);
  RUN_TEST(test_more_work_asks_more_often);
  RUN_TEST(test_regions_are_stopped_at_any_moment_or_are_the_same);
  return UNITY_END();
}
