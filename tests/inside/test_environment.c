/* profiles: host mcu */
/* The environment behind its aggregation unit: without aggregation it is the game; spots earn what their tours earn on
 * the ground; regions make times equal for all of their cells. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "aggregate/environment.h"
#include "learn/learner.h"
#include "quarter/learner.h"
#include "support/learning.h"
#include "support/missions.h"
#include "support/random.h"
#include "support/settings.h"
#include "unity.h"

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground, *aggregate;
static qtr_regions regions;
static qtr_learner *learner;
static uint8_t region_times;

void setUp(void) {
  region_times = QTR_TIMES_STANDING;
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void set_up_game(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
}

/* The rule that targets are chosen by is the mission's; the ground is played by the free one. */
static void set_up_aggregate(const qtr_spots_config *spots, uint8_t order, const qtr_regions *by_regions) {
  qtr_aggregation how = aggregation_of(spots, by_regions);
  how.rule = mission.rule;
  how.spot_order = order;
  how.region_times = region_times;
  game.board.rule = QTR_RULE_FREE;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, aggregate_init(&aggregate, &game, &how, &travel), case_note);
}

static uint16_t random_choice(test_random *random, const qtr_joint *joint, const qtr_board *board, int seeker) {
  qtr_places choices;
  uint16_t some[QTR_MAX_PLACES + 1];
  unsigned count = 0;
  const bool may_stand_down = qtr_joint_choices(joint, board, seeker, &choices);
  for (uint16_t target = 0; target < board->places; target++)
    if (qtr_places_has(&choices, target)) some[count++] = target;
  if (may_stand_down && random_chance(random, 20)) return QTR_STAND_DOWN;
  return some[random_below(random, count)];
}

/* ---- without aggregation ---- */

static void expect_same_key(const qtr_situation *situation, const qtr_state *state) {
  qtr_key seen, true_key;
  qtr_environment_key(ground, situation, &seen);
  qtr_joint_key(&true_key, &state->joint, &game.board.keys);
  TEST_ASSERT_EQUAL_MEMORY_MESSAGE(true_key.word, seen.word, 4u * game.board.keys.words, case_note);
}

static void test_without_aggregation_it_is_the_game(void) {
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("the game itself", number);
    qtr_situation situation;
    qtr_state state;
    int seeker;
    mission_random(&mission, &random, (mission_size){8, 7, 7, 3});
    set_up_game();
    qtr_environment_start(ground, &situation);
    qtr_game_start(&game, &state);
    while ((seeker = qtr_joint_chooser(&state.joint, &game.board)) != QTR_NOBODY) {
      qtr_outcome seen, truth;
      const uint16_t choice = random_choice(&random, &state.joint, &game.board, seeker);
      TEST_ASSERT_EQUAL_INT_MESSAGE(seeker, qtr_joint_chooser(&situation.joint, &ground->board), case_note);
      TEST_ASSERT_TRUE_MESSAGE(qtr_environment_choose(ground, &situation, seeker, choice) ==
                                   qtr_game_choose(&game, &state, seeker, choice),
                               case_note);
      expect_same_key(&situation, &state);
      qtr_environment_pass(ground, &situation, &seen);
      qtr_game_pass(&game, &state, &truth);
      TEST_ASSERT_TRUE_MESSAGE(fabs(seen.reward - truth.reward) <= 1e-12 * (1.0 + fabs(truth.reward)), case_note);
      TEST_ASSERT_TRUE_MESSAGE(fabs(seen.discount - truth.discount) <= 1e-15, case_note);
      TEST_ASSERT_EQUAL_UINT32_MESSAGE(state.joint.now, situation.joint.now, case_note);
    }
  }
}

/* Each choice there is, made and taken back, leaves the situation as it was, to the byte. */
static void try_every_choice(const qtr_environment *e, const qtr_situation *situation, int seeker) {
  qtr_situation tried = *situation;
  qtr_places choices;
  qtr_joint_choices(&situation->joint, &e->board, seeker, &choices);
  for (unsigned target = 0; target <= e->board.places; target++) {
    const uint16_t choice = target < e->board.places ? (uint16_t)target : QTR_STAND_DOWN;
    if (choice != QTR_STAND_DOWN && !qtr_places_has(&choices, target)) continue;
    qtr_environment_choose(e, &tried, seeker, choice);
    qtr_environment_undo(e, &tried, situation, seeker, choice);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(situation, &tried, sizeof tried, case_note);
  }
}

static void take_choices_back(const qtr_environment *e, test_random *random) {
  qtr_situation situation;
  qtr_outcome outcome;
  int seeker;
  memset(&situation, 0, sizeof situation);
  qtr_environment_start(e, &situation);
  while ((seeker = qtr_joint_chooser(&situation.joint, &e->board)) != QTR_NOBODY) {
    try_every_choice(e, &situation, seeker);
    qtr_environment_choose(e, &situation, seeker, random_choice(random, &situation.joint, &e->board, seeker));
    qtr_environment_pass(e, &situation, &outcome);
  }
}

/* Each cell a region of its own. */
static void set_regions_of_one(void) {
  regions.count = qtr_mission_cells(&mission);
  for (qtr_cell cell = 0; cell < regions.count; cell++) {
    regions.of[cell] = (qtr_region)cell;
    regions.representative[cell] = cell;
    regions.size[cell] = 1;
  }
}

static void test_choice_taken_back_leaves_no_trace(void) {
  for (unsigned number = 0; number < 100; number++) {
    test_random random = random_case("taken back", number);
    const qtr_spots_config spots = spot_limits(3, 8, 0.0);
    mission_random(&mission, &random, (mission_size){8, 7, 8, 3});
    set_up_game();
    take_choices_back(ground, &random);
    set_regions_of_one();
    set_up_aggregate(&spots, QTR_SPOT_BEST, random_chance(&random, 50) ? &regions : NULL);
    take_choices_back(aggregate, &random);
  }
}

/* ---- spots ---- */

static qtr_spots_config random_spots(test_random *random) {
  const qtr_spots_config config =
      spot_limits((uint8_t)random_in(random, 1, 4), (qtr_steps)random_in(random, 1, 12), 0.0);
  return config;
}

/* Steps of the visits, walked place by place. */
static qtr_steps walk_tour(qtr_steps *visit, unsigned node, qtr_steps now, const qtr_tour *tour) {
  for (unsigned i = 0; i < tour->places; i++) {
    now += qtr_board_steps(&game.board, 0, node, tour->place[i]);
    if (visit[tour->place[i]] > now) visit[tour->place[i]] = now;
    node = tour->place[i];
  }
  return now;
}

static void test_spots_earn_what_their_tours_earn_on_the_ground(void) {
  for (unsigned number = 0; number < 300; number++) {
    test_random random = random_case("spots", number);
    qtr_situation situation;
    qtr_outcome outcome;
    qtr_score score;
    qtr_steps visit[QTR_MAX_PLACES];
    double earned = 0.0, discount = 1.0;
    int seeker;
    mission_random(&mission, &random, (mission_size){8, 7, 8, 3});
    set_up_game();
    const qtr_spots_config spots = random_spots(&random);
    set_up_aggregate(&spots, random_chance(&random, 50) ? QTR_SPOT_BEST : QTR_SPOT_NEAREST, NULL);
    for (unsigned place = 0; place < mission.places; place++) visit[place] = QTR_NEVER;
    qtr_environment_start(aggregate, &situation);
    while ((seeker = qtr_joint_chooser(&situation.joint, &aggregate->board)) != QTR_NOBODY) {
      const uint16_t choice = random_choice(&random, &situation.joint, &aggregate->board, seeker);
      const unsigned from = situation.at[seeker];
      earned += discount * qtr_environment_choose(aggregate, &situation, seeker, choice);
      if (choice != QTR_STAND_DOWN)
        walk_tour(visit, from, situation.joint.now, &aggregate->targets.tour[situation.at[seeker]]);
      qtr_environment_pass(aggregate, &situation, &outcome);
      earned += discount * outcome.reward;
      discount *= outcome.discount;
    }
    qtr_game_score(&game, visit, 0, &score);
    TEST_ASSERT_TRUE_MESSAGE(fabs(earned - score.worth) <= 1e-9 * (1.0 + fabs(score.worth)), case_note);
    TEST_ASSERT_TRUE_MESSAGE(fabs(situation.unvisited) < 1e-9, case_note);
  }
}

/* The best of all divisions and orders of the spots, tried one by one: each seeker in turn takes a spot more or is
 * done. */
static double try_spots(qtr_steps *visit, unsigned taken, unsigned seeker, unsigned node, qtr_steps now) {
  double best = -HUGE_VAL;
  if (seeker == mission.seekers) {
    qtr_score score;
    if (taken + 1 != 1u << aggregate->targets.count) return best;
    qtr_game_score(&game, visit, 0, &score);
    return score.worth;
  }
  const unsigned next = seeker + 1;
  const unsigned start = next < mission.seekers ? (unsigned)mission.places + game.board.start_of[next] : 0;
  best = try_spots(visit, taken, next, start, 0);
  for (unsigned target = 0; target < aggregate->targets.count; target++) {
    const uint16_t first = qtr_targets_first(&aggregate->targets, node, target);
    if ((taken >> target & 1u) != 0 || first == QTR_STAND_DOWN) continue;
    qtr_steps with[QTR_MAX_PLACES];
    memcpy(with, visit, sizeof with);
    const qtr_tour *tour = &aggregate->targets.tour[first];
    const qtr_steps end = walk_tour(with, node, now, tour);
    const double worth = try_spots(with, taken | 1u << target, seeker, tour->place[tour->places - 1], end);
    if (worth > best) best = worth;
  }
  return best;
}

static void test_the_best_policy_of_the_spots_is_found(void) {
  for (unsigned number = 0; number < 150; number++) {
    test_random random = random_case("best of the spots", number);
    qtr_steps visit[QTR_MAX_PLACES];
    qtr_learner_config config;
    qtr_certificate certificate;
    do mission_random(&mission, &random, (mission_size){8, 7, 8, 2});
    while (mission.places < 4);
    mission.rule = QTR_RULE_FREE;
    set_up_game();
    const qtr_spots_config spots = spot_limits(4, 9, 0.0);
    set_up_aggregate(&spots, QTR_SPOT_BEST, NULL);
    if (aggregate->targets.count > 5) continue;
    qtr_learner_config_default(&config);
    config.ground_search = false;
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&learner, ground, aggregate, &config), case_note);
    while (qtr_learner_step(learner) == QTR_LEARNING) {}
    qtr_learner_certificate(learner, &certificate);
    for (unsigned place = 0; place < mission.places; place++) visit[place] = QTR_NEVER;
    const double best = try_spots(visit, 0, 0, (unsigned)mission.places + game.board.start_of[0], 0);
    const double found = mission.aim.kind == QTR_TIME ? -certificate.expected_time : certificate.value;
    TEST_ASSERT_TRUE_MESSAGE(fabs(found - best) <= 2e-5 * fabs(best) + 1e-12, case_note);
    TEST_ASSERT_TRUE_MESSAGE(learner->ground_upper >= best - 1e-9 * fabs(best), case_note);
    TEST_ASSERT_TRUE_MESSAGE(learner->upper >= best - 1e-9 * fabs(best), case_note);
  }
}

/* ---- regions ---- */

/* A corridor of nine cells in three regions of three, each seen from its middle. */
static void draw_corridor(const char *rows) {
  mission_draw(&mission, rows);
  mission.rule = QTR_RULE_FREE;
  set_up_game();
  regions.count = 3;
  for (unsigned cell = 0; cell < 9; cell++) regions.of[cell] = (qtr_region)(cell / 3);
  for (unsigned region = 0; region < 3; region++) {
    regions.representative[region] = (qtr_cell)(3 * region + 1);
    regions.size[region] = 3;
  }
  set_up_aggregate(NULL, QTR_SPOT_BEST, &regions);
}

static void test_times_are_equal_for_all_cells_of_a_region(void) {
  draw_corridor("S..1....3");
  for (unsigned cell = 0; cell < 9; cell++) {
    qtr_situation situation;
    qtr_environment_start(aggregate, &situation);
    situation.walk[0].cell = (qtr_cell)cell;
    qtr_environment_choose(aggregate, &situation, 0, 1);
    /* from the middles 1, 4 and 7 to cell 8 */
    TEST_ASSERT_EQUAL_UINT32(7 - 3 * (cell / 3), situation.joint.remaining[0]);
  }
}

/* The paper's first solution (section 5.2.3): one state, but a time for each cell. */
static void test_true_times_differ_between_the_cells_of_a_region(void) {
  region_times = QTR_TIMES_TRUE;
  draw_corridor("S..1....3");
  mission_crew(&mission, 2);
  set_up_game();
  set_up_aggregate(NULL, QTR_SPOT_BEST, &regions);
  qtr_situation situation;
  qtr_outcome outcome;
  qtr_environment_start(aggregate, &situation);
  qtr_environment_choose(aggregate, &situation, 0, 1);
  qtr_environment_choose(aggregate, &situation, 1, 0);
  TEST_ASSERT_EQUAL_UINT32(8, situation.joint.remaining[0]);
  qtr_environment_pass(aggregate, &situation, &outcome);
  /* 3 steps and then the 5 that are left: what is earned on the ground */
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, pow(0.99, 2) * 2.5 + pow(0.99, 7) * 7.5, outcome.reward);
  TEST_ASSERT_EQUAL_UINT32(8, situation.joint.now);
}

/* Seeker 0 takes the place at cell 8 (7 steps from cell 1), seeker 1 the one at cell 3 (2 steps from cell 1). Seeker 1
 * arrives after 2; by then seeker 0 stands on cell 2, still in the first region: 7 steps again. */
static void test_an_aggregated_episode_by_hand(void) {
  qtr_situation situation;
  qtr_outcome outcome;
  draw_corridor("S..1....3");
  mission_crew(&mission, 2);
  set_up_game();
  set_up_aggregate(NULL, QTR_SPOT_BEST, &regions);
  qtr_environment_start(aggregate, &situation);
  qtr_environment_choose(aggregate, &situation, 0, 1);
  qtr_environment_choose(aggregate, &situation, 1, 0);
  qtr_environment_pass(aggregate, &situation, &outcome);
  /* Eq. 4.7: gamma^(tau - 1) R, R = w P = 10 / 4 for the place of weight 1 */
  TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.99 * 2.5 + pow(0.99, 2) * pow(0.99, 6) * 7.5, outcome.reward);
  TEST_ASSERT_EQUAL_UINT32(2 + 7, situation.joint.now);
}

static void test_cells_of_one_region_share_their_key_and_others_do_not(void) {
  qtr_key first, other;
  draw_corridor("S..1....3");
  for (unsigned cell = 0; cell < 9; cell++) {
    qtr_situation situation;
    qtr_environment_start(aggregate, &situation);
    qtr_environment_key(aggregate, &situation, &first);
    situation.walk[0].cell = (qtr_cell)cell;
    qtr_environment_key(aggregate, &situation, &other);
    const bool same = memcmp(first.word, other.word, 4u * aggregate->keys.words) == 0;
    TEST_ASSERT_EQUAL(cell < 3, same);
  }
}

static void test_certified_setting_refuses_regions(void) {
  qtr_learner_config config;
  draw_corridor("S..1....3");
  qtr_learner_config_default(&config);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, learner_init(&learner, ground, aggregate, &config));
  config.setting = QTR_SETTING_PAPER;
  TEST_ASSERT_EQUAL_INT(QTR_OK, learner_init(&learner, ground, aggregate, &config));
}

/* ---- the paper setting ---- */

static void test_exploring_finds_the_optimum_that_the_certificate_proves(void) {
  for (unsigned number = 0; number < 40; number++) {
    test_random random = random_case("paper setting", number);
    qtr_learner_config config;
    qtr_certificate proven, explored;
    mission_random(&mission, &random, (mission_size){6, 5, 4, 2});
    set_up_game();
    qtr_learner_config_default(&config);
    TEST_ASSERT_EQUAL_INT(QTR_OK, learner_init(&learner, ground, NULL, &config));
    while (qtr_learner_step(learner) == QTR_LEARNING) {}
    qtr_learner_certificate(learner, &proven);
    config.setting = QTR_SETTING_PAPER;
    config.gap = 0.0;
    config.exploration.kind = (uint8_t)(number % 3);
    config.exploration.first = number % 3 == QTR_EXPLORE_SOFTMAX ? 1000.0 : 0.5;
    config.exploration.last = config.exploration.first;
    TEST_ASSERT_EQUAL_INT(QTR_OK, learner_init(&learner, ground, NULL, &config));
    for (unsigned step = 0; step < 4000; step++) qtr_learner_step(learner);
    qtr_learner_certificate(learner, &explored);
    const double slack = 2e-5 * fabs(proven.objective);
    TEST_ASSERT_TRUE_MESSAGE(fabs(explored.objective - proven.objective) <= slack, case_note);
    const double max_q = mission.aim.kind == QTR_TIME ? -explored.max_q : explored.max_q;
    TEST_ASSERT_TRUE_MESSAGE(fabs(max_q - proven.objective) <= slack + 1e-6, case_note);
  }
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_without_aggregation_it_is_the_game);
  RUN_TEST(test_choice_taken_back_leaves_no_trace);
  RUN_TEST(test_spots_earn_what_their_tours_earn_on_the_ground);
  RUN_TEST(test_the_best_policy_of_the_spots_is_found);
  RUN_TEST(test_times_are_equal_for_all_cells_of_a_region);
  RUN_TEST(test_true_times_differ_between_the_cells_of_a_region);
  RUN_TEST(test_an_aggregated_episode_by_hand);
  RUN_TEST(test_cells_of_one_region_share_their_key_and_others_do_not);
  RUN_TEST(test_certified_setting_refuses_regions);
  RUN_TEST(test_exploring_finds_the_optimum_that_the_certificate_proves);
  return UNITY_END();
}
