/* profiles: host mcu */
/* The learner: the optimum of small games by enumeration, a certificate that never grows worse, and a textbook
 * backup. */
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "learn/learner.h"
#include "quarter/learner.h"
#include "support/brute.h"
#include "support/learning.h"
#include "support/random.h"
#include "unity.h"

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_learner *learner;
static qtr_learner_config config;
static brute_game brute;

void setUp(void) {
  qtr_learner_config_default(&config);
  learning_by_episodes = false;
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void set_up_game(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_mission_check(&mission, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
}

static void begin(void) {
  set_up_game();
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, learner_init(&learner, ground, NULL, &config), case_note);
}

/* Forget the first game's care and the prices: the certificate must come from Q-learning alone. Returns with Q at the
 * bound under random prices, valid and weak. */
static void weaken(test_random *random) {
  for (unsigned place = 0; place < mission.places; place++)
    learner->bound.price[place] = mission.aim.kind == QTR_TIME ? 0.0 : 12.0 * random_unit(random);
  learner->bound.filling = 0; /* C is of other prices */
  qtr_bound_settle(&learner->bound);
  learner->phase = QTR_PHASE_EPISODES;
  learner->upper = mission.aim.kind == QTR_TIME ? 0.0 : 1e6;
  learner->ground_upper = learner->upper;
  learner->best.score.value *= 1e-3;
  learner->best.score.expected_time = 1e9;
  learner->best.score.worth = mission.aim.kind == QTR_TIME ? -1e9 : learner->best.score.value;
}

/* ---- certificates ---- */

static double maximised(double objective) {
  return mission.aim.kind == QTR_TIME ? -objective : objective;
}

static void expect_no_worse(const qtr_certificate *now, const qtr_certificate *before) {
  /* The last bits are rounding's. */
  TEST_ASSERT_TRUE_MESSAGE(maximised(now->bound) <= maximised(before->bound) + 1e-12 * (1.0 + fabs(before->bound)),
                           case_note);
  TEST_ASSERT_TRUE_MESSAGE(maximised(now->objective) >= maximised(before->objective), case_note);
  TEST_ASSERT_TRUE_MESSAGE(maximised(now->bound) >= maximised(now->objective), case_note);
  TEST_ASSERT_TRUE_MESSAGE(now->gap >= 0.0, case_note);
}

/* Learn to the end, watching the certificate at every step. */
static enum qtr_learning learn(qtr_certificate *certificate) {
  enum qtr_learning state;
  unsigned steps = 0;
  qtr_learner_certificate(learner, certificate);
  do {
    const qtr_certificate before = *certificate;
    state = qtr_learner_step(learner);
    qtr_learner_certificate(learner, certificate);
    expect_no_worse(certificate, &before);
    TEST_ASSERT_EQUAL_MESSAGE(state == QTR_CERTIFIED, certificate->certified, case_note);
    TEST_ASSERT_TRUE_MESSAGE(++steps < 2000000, case_note);
  } while (state == QTR_LEARNING);
  return state;
}

/* The certificate holds for the true optimum, and its figures are those of the best game. */
static void expect_truth(const qtr_certificate *certificate, double optimum) {
  const double slack = 1e-9 * fmax(1e-3, fabs(optimum));
  TEST_ASSERT_TRUE_MESSAGE(maximised(certificate->bound) >= optimum - slack, case_note);
  TEST_ASSERT_TRUE_MESSAGE(maximised(certificate->objective) <= optimum + slack, case_note);
  if (certificate->certified)
    TEST_ASSERT_TRUE_MESSAGE(optimum - maximised(certificate->objective) <= config.gap * certificate->objective + slack,
                             case_note);
  const double figure = mission.aim.kind == QTR_TIME ? certificate->expected_time : certificate->value;
  TEST_ASSERT_TRUE_MESSAGE(figure == certificate->objective, case_note);
}

/* The best game replayed by the other implementation: its choices are allowed and earn what is reported. */
static void expect_best_game_is_played(const qtr_certificate *certificate) {
  const qtr_play *best = qtr_learner_best(learner);
  brute_state state;
  double worth = 0.0;
  unsigned made = 0;
  bool on = true;
  brute_begin(&brute, &state);
  while (on) {
    const int seeker = brute_chooser(&brute, &state);
    if (seeker < 0) {
      worth += brute_pass(&brute, &state, &on);
      continue;
    }
    TEST_ASSERT_TRUE_MESSAGE(made < best->choices, case_note);
    TEST_ASSERT_EQUAL_INT_MESSAGE(seeker, best->seeker[made], case_note);
    const int choice = best->choice[made] == QTR_STAND_DOWN ? BRUTE_GONE : best->choice[made];
    TEST_ASSERT_TRUE_MESSAGE(choice == BRUTE_GONE ? brute_may_stand_down(&brute, &state, seeker)
                                                  : brute_choices(&brute, &state, state.node[seeker]) >> choice & 1u,
                             case_note);
    worth += brute_choose(&brute, &state, seeker, choice);
    made++;
  }
  TEST_ASSERT_EQUAL_MESSAGE(made, best->choices, case_note);
  TEST_ASSERT_EQUAL_MESSAGE(0, brute_unvisited(&brute, &state), case_note);
  TEST_ASSERT_TRUE_MESSAGE(fabs(worth - maximised(certificate->objective)) <= 1e-9 * fmax(1e-3, fabs(worth)),
                           case_note);
}

/* Open ground and even odds: many plays are nearly as good as one another. */
static void even_game(test_random *random) {
  do mission_random(&mission, random, (mission_size){20, 16, 8, 2});
  while (mission.places < 6 || mission.columns < 8 || mission.rows < 8);
  for (unsigned place = 0; place < mission.places; place++) mission.weight[place] = random_in(random, 4, 6);
  brute_set_up(&brute, &mission);
}

static void random_game(test_random *random, unsigned columns, unsigned rows) {
  const bool crowd = random_chance(random, 50);
  mission_random(&mission, random, (mission_size){columns, rows, crowd ? 5 : 6, crowd ? 3 : 2});
  brute_set_up(&brute, &mission);
}

/* ---- against enumeration ---- */

static void test_learner_finds_and_certifies_the_optimum(void) {
  for (unsigned number = 0; number < 400; number++) {
    test_random random = random_case("small games", number);
    qtr_certificate certificate;
    learning_by_episodes = number % 2 != 0;
    random_game(&random, 9, 7);
    begin();
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_CERTIFIED, learn(&certificate), case_note);
    expect_truth(&certificate, brute_optimum(&brute));
    expect_best_game_is_played(&certificate);
  }
}

static void test_learning_from_a_weak_bound_ends_at_the_optimum_too(void) {
  uint64_t updates = 0;
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("weak bound", number);
    qtr_certificate certificate;
    even_game(&random);
    learning_by_episodes = number % 4 != 0;
    begin();
    weaken(&random);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_CERTIFIED, learn(&certificate), case_note);
    expect_truth(&certificate, brute_optimum(&brute));
    expect_best_game_is_played(&certificate);
    updates += certificate.updates;
  }
  TEST_ASSERT_GREATER_THAN(1000, updates);
}

/* At 10 ^ -308 a double ends. What lies beyond is worth nothing, and must not be worth less. A game whose nearest place
 * lies beyond is refused: test_discount.c. */
static void test_worth_that_underflows_leaves_the_certificate_true(void) {
  for (unsigned number = 0; number < 200; number++) {
    test_random random = random_case("steep discount", number);
    qtr_certificate certificate;
    learning_by_episodes = number % 2 != 0;
    mission_random(&mission, &random, (mission_size){random_chance(&random, 50) ? 60 : 8, 3, 5, 2});
    for (unsigned cell = 0; cell < (unsigned)mission.columns * mission.rows; cell++)
      if (mission.cost[cell] > 0 && random_chance(&random, 50))
        mission.cost[cell] = (uint8_t)random_in(&random, 1, 255);
    mission.aim.kind = QTR_DISCOUNTED;
    mission.aim.gamma = 0.01 + 0.6 * random_unit(&random);
    brute_set_up(&brute, &mission);
    if (qtr_game_init(&game, &mission, &travel, NULL) == QTR_ERR_DISCOUNT) continue;
    begin();
    if (random_chance(&random, 50)) weaken(&random);
    learn(&certificate);
    const double optimum = brute_optimum(&brute);
    const double slack = 1e-9 * optimum + 1e-300;
    TEST_ASSERT_TRUE_MESSAGE(certificate.bound >= optimum - slack, case_note);
    TEST_ASSERT_TRUE_MESSAGE(certificate.objective <= optimum + slack, case_note);
    if (optimum < 1e-30) continue; /* too little for a Q entry to tell from nothing */
    TEST_ASSERT_TRUE_MESSAGE(certificate.certified, case_note);
    TEST_ASSERT_TRUE_MESSAGE(certificate.objective >= optimum * (1.0 - 2e-5), case_note);
  }
}

static void test_long_corridors_are_certified(void) {
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("corridors", number);
    qtr_certificate certificate;
    learning_by_episodes = number % 2 != 0;
    mission_random(&mission, &random, (mission_size){100, 1, 5, 2});
    for (unsigned cell = 0; cell < mission.columns; cell++)
      mission.cost[cell] = random_chance(&random, 30) ? 1 : (uint8_t)random_in(&random, 200, 255);
    mission.aim.gamma = random_chance(&random, 50) ? 0.9999 : 0.999;
    brute_set_up(&brute, &mission);
    begin();
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_CERTIFIED, learn(&certificate), case_note);
    expect_truth(&certificate, brute_optimum(&brute));
  }
}

/* ---- a table that is too small ---- */

/* As if the array held so many slots alone. */
static void shrink_table(uint32_t slots) {
  learner->table.slots = slots;
  learner->table.slots_limit = slots;
  memset(learner->table.word, 0, slots * learner->table.entry_words * sizeof learner->table.word[0]);
}

static void test_full_table_ends_with_a_gap_that_is_true(void) {
  unsigned left_open = 0;
  unsigned refused = 0;
  for (unsigned number = 0; number < 60; number++) {
    test_random random = random_case("small table", number);
    qtr_certificate certificate;
    learning_by_episodes = true;
    even_game(&random);
    begin();
    weaken(&random);
    shrink_table(random_in(&random, 4, 40));
    const enum qtr_learning state = learn(&certificate);
    expect_truth(&certificate, brute_optimum(&brute));
    left_open += state == QTR_CONVERGED;
    refused += learner->table.refused > 0;
  }
  TEST_ASSERT_GREATER_THAN(10, left_open);
  TEST_ASSERT_GREATER_THAN(20, refused);
}

/* ---- the gap asked for ---- */

static void test_wide_gap_stops_sooner_and_within_it(void) {
  uint64_t wide = 0;
  uint64_t narrow = 0;
  for (unsigned number = 0; number < 40; number++) {
    test_random random = random_case("gaps", number);
    qtr_certificate certificate;
    learning_by_episodes = true;
    even_game(&random);
    const double optimum = brute_optimum(&brute);
    config.gap = 0.2;
    begin();
    weaken(&random);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_CERTIFIED, learn(&certificate), case_note);
    expect_truth(&certificate, optimum);
    TEST_ASSERT_TRUE_MESSAGE(certificate.gap <= 0.2 * (1.0 + 1e-12), case_note);
    wide += certificate.episodes;
    config.gap = 1e-5;
    begin();
    weaken(&random);
    learn(&certificate);
    narrow += certificate.episodes;
  }
  TEST_ASSERT_LESS_THAN(narrow / 2, wide);
}

static void test_gap_of_zero_is_closed_to_the_last_bits(void) {
  for (unsigned number = 0; number < 100; number++) {
    test_random random = random_case("no gap", number);
    qtr_certificate certificate;
    learning_by_episodes = number % 2 != 0;
    random_game(&random, 9, 7);
    config.gap = 0.0;
    begin();
    if (random_chance(&random, 50)) weaken(&random);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_CERTIFIED, learn(&certificate), case_note);
    expect_truth(&certificate, brute_optimum(&brute));
    TEST_ASSERT_TRUE_MESSAGE(certificate.gap <= QTR_LEAST_GAP * 1.001, case_note);
  }
}

static void test_few_price_steps_leave_the_rest_to_games(void) {
  uint64_t games = 0;
  for (unsigned number = 0; number < 100; number++) {
    test_random random = random_case("few prices", number);
    qtr_certificate certificate;
    learning_by_episodes = true;
    random_game(&random, 9, 7);
    config.price_steps = 1 + number % 20;
    begin();
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_CERTIFIED, learn(&certificate), case_note);
    expect_truth(&certificate, brute_optimum(&brute));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32_MESSAGE(config.price_steps, certificate.price_steps, case_note);
    games += certificate.episodes;
  }
  TEST_ASSERT_GREATER_THAN_UINT64(100, games);
}

static void test_steps_after_the_end_change_nothing(void) {
  qtr_certificate end;
  qtr_certificate later;
  mission_draw(&mission, "1..S..2/..1...1");
  begin();
  const enum qtr_learning state = learn(&end);
  for (int i = 0; i < 10; i++) TEST_ASSERT_EQUAL_INT(state, qtr_learner_step(learner));
  qtr_learner_certificate(learner, &later);
  TEST_ASSERT_EQUAL_UINT64(end.episodes, later.episodes);
  TEST_ASSERT_EQUAL_UINT64(end.updates, later.updates);
  TEST_ASSERT_TRUE(end.bound == later.bound);
  TEST_ASSERT_TRUE(end.objective == later.objective);
}

static bool say(void *answer) {
  return *(const bool *)answer;
}

static void test_a_stop_while_the_table_grows_is_no_loss(void) {
  learning_by_episodes = true;
  qtr_certificate undisturbed;
  qtr_certificate stopped;
  bool may_go_on = true;
  test_random random = random_case("growth", 1);
  mission_draw(&mission, "1..S..2/..1...1");
  mission.watch = (qtr_watch){say, &may_go_on};
  begin();
  weaken(&random);
  learn(&undisturbed);
  random = random_case("growth", 1);
  begin();
  weaken(&random);
  const qtr_qtable *table = &learner->table;
  while (table->slots < table->slots_limit && table->cleared % table->slots == 0)
    qtr_qtable_make_room(&learner->table, table->slots);
  if (table->cleared % table->slots == 0) return; /* the largest table of a small build doubles in two shares */
  const uint32_t cleared = table->cleared;
  may_go_on = false;
  TEST_ASSERT_EQUAL_INT(QTR_LEARNING, qtr_learner_step(learner));
  qtr_learner_certificate(learner, &stopped);
  TEST_ASSERT_EQUAL_UINT64(0, stopped.updates);
  TEST_ASSERT_GREATER_THAN_UINT32(cleared, table->cleared);
  TEST_ASSERT_LESS_THAN_UINT32(table->before, table->swept);
  may_go_on = true;
  learn(&stopped);
  TEST_ASSERT_EQUAL_UINT64(undisturbed.updates, stopped.updates);
  TEST_ASSERT_EQUAL_DOUBLE(undisturbed.bound, stopped.bound);
}

/* ---- by hand ---- */

/* One seeker, a place at 2 steps to its left and one at 3 to its right (5 apart), each of probability 1/2, gamma 0.99.
 * The first episode goes left, the better way, and is backed up from its end (Eq. 4.7):
 * Q(right) = 5 * 0.99^4, Q(left) = 5 * 0.99^1 + 0.99^2 * Q(right). */
static void test_first_episode_backs_up_as_in_the_textbook(void) {
  learning_by_episodes = true;
  const double right = 5.0 * pow(0.99, 4);
  const double left = 5.0 * 0.99 + 0.99 * 0.99 * right;
  qtr_certificate certificate;
  test_random random = random_case("by hand", 1);
  mission_draw(&mission, "1.S..1");
  begin();
  weaken(&random);
  qtr_learner_step(learner);
  qtr_learner_certificate(learner, &certificate);
  TEST_ASSERT_TRUE(fabs(certificate.value - left) < 1e-12);
  TEST_ASSERT_TRUE(certificate.bound >= left);
  TEST_ASSERT_TRUE(certificate.bound < left + 1e-6);
}

static void test_near_place_is_visited_first_and_each_seeker_takes_its_side(void) {
  qtr_certificate certificate;
  mission_draw(&mission, "2...S..1");
  mission_crew(&mission, 2);
  begin();
  TEST_ASSERT_EQUAL_INT(QTR_CERTIFIED, learn(&certificate));
  TEST_ASSERT_EQUAL_UINT32(4, qtr_learner_best(learner)->visit[0]);
  TEST_ASSERT_EQUAL_UINT32(3, qtr_learner_best(learner)->visit[1]);
  const double value = 10.0 * (2.0 / 3.0 * pow(0.99, 3) + 1.0 / 3.0 * pow(0.99, 2));
  TEST_ASSERT_TRUE(fabs(certificate.value - value) < 1e-12);
  TEST_ASSERT_TRUE(fabs(certificate.expected_time - 11.0 / 3.0) < 1e-12);
}

static void test_everything_at_the_start_is_found_at_once(void) {
  qtr_certificate certificate;
  for (uint8_t objective = 0; objective < 2; objective++) {
    mission_draw(&mission, "S1");
    mission.start[0] = mission.place[0];
    mission.aim.kind = objective;
    begin();
    TEST_ASSERT_EQUAL_INT(QTR_CERTIFIED, learn(&certificate));
    TEST_ASSERT_TRUE(certificate.value == 10.0);
    TEST_ASSERT_TRUE(certificate.expected_time == 0.0);
    TEST_ASSERT_TRUE(certificate.gap == 0.0);
  }
}

/* Every seeker clears a row of its own; then one place fewer than seekers is left, far apart, and under the paper's
 * rule all go on to all of them, one close behind the other. No game has more choices. */
static void draw_crowd(unsigned seekers) {
  const unsigned rings = (QTR_STATIC_PLACES - (seekers - 1)) / seekers;
  qtr_mission_default(&mission);
  mission.columns = (uint16_t)(rings + 1 + 2 * seekers * seekers);
  mission.rows = (uint16_t)seekers;
  mission.rule = QTR_RULE_PAPER;
  memset(mission.cost, 1, (size_t)mission.columns * mission.rows);
  for (unsigned row = 0; row < seekers; row++) {
    mission.start[mission.seekers++] = (qtr_cell)(row * mission.columns);
    for (unsigned ring = 1; ring <= rings; ring++)
      mission.place[mission.places++] = (qtr_cell)(row * mission.columns + ring);
  }
  for (unsigned far = 1; far < seekers; far++) mission.place[mission.places++] = (qtr_cell)(rings + far * 2 * seekers);
  for (unsigned place = 0; place < mission.places; place++) mission.weight[place] = 1.0;
}

static void test_crowd_under_the_papers_rule_fits_the_games_arrays(void) {
  for (unsigned seekers = 2; seekers <= QTR_MAX_SEEKERS; seekers += seekers < 8 ? 1 : 8) {
    draw_crowd(seekers);
    begin();
    TEST_ASSERT_LESS_OR_EQUAL(QTR_MAX_CHOICES, qtr_learner_best(learner)->choices);
    TEST_ASSERT_EQUAL(mission.places + (seekers - 1) * (seekers - 1), qtr_learner_best(learner)->choices);
  }
}

/* ---- set-up ---- */

static void test_gap_that_is_no_number_is_refused(void) {
  static const double wrong[] = {-1e-9, (double)NAN, (double)INFINITY, -(double)INFINITY};
  mission_draw(&mission, "S1");
  begin();
  for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    config.gap = wrong[i];
    TEST_ASSERT_EQUAL_INT(QTR_ERR_ARGUMENT, learner_init(&learner, ground, NULL, &config));
  }
}

static void test_caller_of_another_build_is_refused(void) {
  mission_draw(&mission, "S1");
  begin();
  const qtr_learner_blocks blocks = QTR_LEARNER_BLOCKS(learning_memory);
  TEST_ASSERT_EQUAL_INT(QTR_ERR_CONFIG,
                        qtr_learner_init_built(&learner, &blocks, ground, NULL, &config, QTR_CONFIG_ID + 1u));
}

static void test_defaults_are_those_documented(void) {
  TEST_ASSERT_TRUE(config.gap == 1e-5);
  TEST_ASSERT_EQUAL_UINT64(1, config.seed);
  TEST_ASSERT_EQUAL_UINT32(0, config.price_steps);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_learner_finds_and_certifies_the_optimum);
  RUN_TEST(test_learning_from_a_weak_bound_ends_at_the_optimum_too);
  RUN_TEST(test_worth_that_underflows_leaves_the_certificate_true);
  RUN_TEST(test_long_corridors_are_certified);
  RUN_TEST(test_full_table_ends_with_a_gap_that_is_true);
  RUN_TEST(test_wide_gap_stops_sooner_and_within_it);
  RUN_TEST(test_gap_of_zero_is_closed_to_the_last_bits);
  RUN_TEST(test_few_price_steps_leave_the_rest_to_games);
  RUN_TEST(test_steps_after_the_end_change_nothing);
  RUN_TEST(test_a_stop_while_the_table_grows_is_no_loss);
  RUN_TEST(test_first_episode_backs_up_as_in_the_textbook);
  RUN_TEST(test_near_place_is_visited_first_and_each_seeker_takes_its_side);
  RUN_TEST(test_everything_at_the_start_is_found_at_once);
  RUN_TEST(test_crowd_under_the_papers_rule_fits_the_games_arrays);
  RUN_TEST(test_gap_that_is_no_number_is_refused);
  RUN_TEST(test_caller_of_another_build_is_refused);
  RUN_TEST(test_defaults_are_those_documented);
  return UNITY_END();
}
