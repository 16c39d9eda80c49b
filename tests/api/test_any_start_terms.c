/* Tables for any start of missions with the field's terms: robots that differ in class and ready time, looks, scans, a
 * deadline. What a crew earns by the table on the ground is what was learnt for it. */
#include <math.h>
#include <string.h>

#include "quarter/any_start.h"
#include "quarter/deployment.h"
#include "quarter/start_regions.h"
#include "support/tables.h"
#include "support/terms_games.h"

enum { ROOM = 1024 * 1024, CREWS_MOST = 2000, CASES = 40 };

static qtr_mission mission;
static qtr_game game;
static qtr_routes own_routes;
static qtr_certificate own_certificate;
static qtr_regions regions;
static uint64_t scratch[1 << 14];

static uint8_t steps[256 * 1024];
static qtr_cell start[256];
static uint16_t region[256];
static uint8_t entries[ROOM], bytes[ROOM];
static qtr_any_start any;
static qtr_policy policy;

static struct {
  uint16_t start_of[QTR_MAX_SEEKERS];
  double worth;
  qtr_aim aim;
} crew[CREWS_MOST];
static unsigned crews;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

/* ---- set-up ---- */

static void learn_on(void) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  TEST_ASSERT_EQUAL_INT(QTR_OK, ground_init(&table_ground, &table_game, &table_travel));
  TEST_ASSERT_EQUAL_INT(QTR_OK, learner_init(&table_learner, table_ground, NULL, &config));
  for (int i = 0; i < 3000 && qtr_learner_step(table_learner) == QTR_LEARNING; i++) {}
}

static void learn_own(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &table_travel, NULL), case_note);
  table_mission = mission;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_game_init(&table_game, &table_mission, &table_travel, NULL));
  learn_on();
  qtr_play_to_routes(qtr_learner_best(table_learner), &table_game, &own_routes);
  qtr_learner_certificate(table_learner, &own_certificate);
}

/* False: the map is of more parts. */
static bool begin(uint32_t most) {
  const qtr_any_start_asked asked = {.game = &game, .regions = &regions, .any_cleared = false};
  const qtr_any_start_blocks blocks = {steps, start, region, entries, sizeof entries};
  qtr_any_start_sizes sizes;
  if (qtr_start_regions_build(&regions, &game, most, &table_travel, scratch, sizeof scratch) != QTR_OK) return false;
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_needs(&sizes, &asked));
  TEST_ASSERT_TRUE(sizes.steps <= sizeof steps && sizes.start <= sizeof start && sizes.region <= sizeof region);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_init(&any, &asked, &blocks, &table_travel));
  crews = 0;
  return true;
}

static void note_crew(void) {
  TEST_ASSERT_LESS_THAN_UINT(CREWS_MOST, crews);
  memcpy(crew[crews].start_of, any.start_of, sizeof any.start_of);
  crew[crews].aim = table_mission.aim;
  crew[crews++].worth = qtr_learner_best(table_learner)->score.worth;
}

/* Ways home come out of the ways there, against a search for them. */
static void expect_ways_home(void) {
  static qtr_game searched;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&searched, &table_mission, &table_travel, NULL), case_note);
  for (unsigned i = 0; i < table_mission.seekers; i++)
    for (unsigned place = 0; place < searched.board.places; place++) {
      const unsigned from = (unsigned)searched.board.places + searched.board.start_of[i];
      if (qtr_board_steps(&searched.board, i, from, place) == QTR_NEVER) continue;
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(qtr_game_way_home(&searched, i, place), qtr_game_way_home(&table_game, i, place),
                                       case_note);
    }
}

static void make_table(void) {
  qtr_routes routes;
  uint16_t number[QTR_MAX_PLACES];
  TEST_ASSERT_TRUE(qtr_any_start_next(&any));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_add(&any, &own_routes, NULL));
  while (qtr_any_start_next(&any)) {
    if (qtr_any_start_game(&any, &table_game, &table_mission, number) != QTR_OK) continue;
    expect_ways_home();
    learn_on();
    if (table_mission.places == mission.places) note_crew();
    qtr_play_to_routes(qtr_learner_best(table_learner), &table_game, &routes);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_any_start_add(&any, &routes, number), case_note);
  }
  qtr_any_start_finish(&any);
  const qtr_table_content content = qtr_any_start_content(&any, &own_certificate, 1);
  const int32_t written = qtr_table_write(&content, bytes, sizeof bytes);
  TEST_ASSERT_EQUAL_INT32_MESSAGE(qtr_table_size(&content), written, case_note);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_policy_open(&policy, bytes, (uint32_t)written));
}

/* ---- what robots earn ---- */

static bool deploy(qtr_deployment *deployment, const uint16_t *start_of) {
  qtr_cell from[QTR_MAX_SEEKERS];
  for (unsigned i = 0; i < mission.seekers; i++) from[i] = qtr_policy_cell(&policy, policy.board.places + start_of[i]);
  return qtr_deployment_init(deployment, &policy, from, NULL) == QTR_OK;
}

/* By a game of these very starts, measured anew. */
static double earn(const qtr_deployment *deployment, uint32_t *off_table) {
  qtr_steps visit[QTR_MAX_PLACES];
  qtr_score score;
  uint64_t home = 0;
  for (unsigned place = 0; place < QTR_MAX_PLACES; place++) visit[place] = QTR_NEVER;
  for (unsigned i = 0; i < policy.board.seekers; i++) {
    unsigned node = (unsigned)policy.board.places + table_game.board.start_of[i];
    qtr_steps now = qtr_board_ready(&table_game.board, i);
    qtr_joint joint;
    uint16_t place;
    qtr_joint_start(&joint, &policy.board, deployment->start_of, NULL);
    while ((place = qtr_policy_play(&policy, &joint, (int)i, NULL, off_table)) != QTR_STAND_DOWN) {
      now += qtr_board_steps(&table_game.board, i, node, place);
      node = place;
      visit[node] = now;
    }
    home += (uint64_t)now + qtr_game_way_home(&table_game, i, node);
  }
  qtr_game_score(&table_game, visit, home, &score);
  return score.worth;
}

/* A crew may meet a state of another one's best play, and go on by that: as good, within the two gaps; and where coming
 * home counts, whole, but perhaps not as good, for that one's homes are others. */
static void expect_earned(unsigned n) {
  qtr_deployment deployment;
  uint32_t off_table = 0;
  if (!deploy(&deployment, crew[n].start_of)) return;
  table_mission = mission;
  table_mission.aim = crew[n].aim;
  for (unsigned i = 0; i < mission.seekers; i++) table_mission.start[i] = start[crew[n].start_of[i]];
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&table_game, &table_mission, &table_travel, NULL), case_note);
  const double worth = earn(&deployment, &off_table);
  const double slack = 1e-4 * fabs(crew[n].worth) + 1e-9;
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(0, off_table, case_note);
  if (mission.aim.home_weight > 0.0)
    TEST_ASSERT_TRUE_MESSAGE(isfinite(worth) && worth <= crew[n].worth + slack, case_note);
  else
    TEST_ASSERT_TRUE_MESSAGE(fabs(worth - crew[n].worth) <= slack || mission.aim.kind != crew[n].aim.kind, case_note);
}

/* From where the mission starts they earn what its certificate says, coming home counted. */
static void expect_own_earned(void) {
  qtr_deployment home;
  uint32_t off_table = 0;
  qtr_deployment_home(&home, &policy);
  table_mission = mission;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&table_game, &table_mission, &table_travel, NULL), case_note);
  const double figure = earn(&home, &off_table) * (mission.aim.kind == QTR_TIME ? -1.0 : 1.0);
  TEST_ASSERT_EQUAL_UINT32_MESSAGE(0, off_table, case_note);
  TEST_ASSERT_TRUE_MESSAGE(fabs(figure - own_certificate.objective) <= 1e-9 * fmax(1.0, fabs(figure)), case_note);
}

static void test_crews_earn_on_the_ground_what_was_learnt_for_them(void) {
  unsigned played = 0;
  for (unsigned number = 0; number < CASES; number++) {
    test_random random = random_case("crews", number);
    const unsigned features = random_below(&random, TERMS_ANY + 1) & ~(unsigned)TERMS_ENDURANCE;
    terms_game_make(&mission, random_below(&random, 100000), features);
    learn_own();
    if (!begin(random_in(&random, 3, 5))) continue;
    make_table();
    expect_own_earned();
    for (unsigned n = 0; n < crews; n++) expect_earned(n);
    played += crews;
  }
  TEST_ASSERT_GREATER_THAN_UINT(CASES * 5, played);
}

/* ---- which crews ---- */

/* Two alike and one that is ready later: 6 multisets of 3 regions, times 3. */
static void test_seekers_that_are_not_alike_are_no_multiset(void) {
  mission_draw(&mission, "1..S..2.3");
  mission_crew(&mission, 3);
  mission.ready[1] = 5;
  learn_own();
  TEST_ASSERT_TRUE(begin(3));
  TEST_ASSERT_TRUE(qtr_any_start_count_crews(&any) == 18.0);
  unsigned seen[3] = {0};
  TEST_ASSERT_TRUE(qtr_any_start_next(&any));
  while (qtr_any_start_next(&any)) {
    TEST_ASSERT_TRUE(any.start_of[0] <= any.start_of[2]);
    seen[any.start_of[1]]++;
  }
  for (unsigned r = 0; r < 3; r++) TEST_ASSERT_EQUAL_UINT(6, seen[r]);
}

static void test_robots_that_must_be_home_in_time_are_refused(void) {
  qtr_any_start_sizes sizes;
  mission_draw(&mission, "1..S..2");
  mission.robot_class[0].endurance = 50;
  learn_own();
  const qtr_any_start_asked asked = {&game, NULL, false};
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_any_start_needs(&sizes, &asked));
}

static void test_looks_are_not_cleared_one_by_one(void) {
  qtr_any_start_sizes sizes;
  mission_draw(&mission, "1..S..2");
  mission.detection[0] = 0.5;
  mission.looks[0] = 2;
  for (unsigned place = 0; place < 2; place++) mission.robot_class[0].scan[place] = 1;
  learn_own();
  const qtr_any_start_asked both = {&game, NULL, true};
  const qtr_any_start_asked starts = {&game, NULL, false};
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, qtr_any_start_needs(&sizes, &both));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_any_start_needs(&sizes, &starts));
}

/* ---- where they may not start ---- */

static void test_starts_of_no_use_to_a_robot_are_refused(void) {
  mission_draw(&mission, "1..S..~~.2#...");
  mission_crew(&mission, 2);
  mission.classes = 2;
  qtr_robot_class_default(&mission.robot_class[1]);
  mission.robot_class[1].smooth_only = true;
  mission.class_of[1] = 1;
  learn_own();
  TEST_ASSERT_TRUE(begin(4));
  TEST_ASSERT_EQUAL_UINT16(any.regions - 1, any.inhabited);
  make_table();
  qtr_deployment deployment;
  const qtr_cell rough_first[2] = {6, 0}, rough_second[2] = {0, 6}, cut_off[2] = {11, 0};
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_deployment_init(&deployment, &policy, rough_first, NULL));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_START, qtr_deployment_init(&deployment, &policy, rough_second, NULL));
  TEST_ASSERT_EQUAL_INT(QTR_ERR_START, qtr_deployment_init(&deployment, &policy, cut_off, NULL));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_crews_earn_on_the_ground_what_was_learnt_for_them);
  RUN_TEST(test_seekers_that_are_not_alike_are_no_multiset);
  RUN_TEST(test_robots_that_must_be_home_in_time_are_refused);
  RUN_TEST(test_looks_are_not_cleared_one_by_one);
  RUN_TEST(test_starts_of_no_use_to_a_robot_are_refused);
  return UNITY_END();
}
