/* profiles: host mcu */
/* Episodes of the paper's setting, one by one: what the last backup brings, whose play is reported, and how targets
 * that two seekers went for become routes. */
#include <math.h>
#include <string.h>

#include "learn/learner.h"
#include "support/settings.h"
#include "support/tables.h"

static qtr_environment *aggregate;
static qtr_certificate certificate;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void begin(uint64_t seed, const qtr_environment *learnt_on) {
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  config.setting = QTR_SETTING_PAPER;
  config.seed = seed;
  config.gap = 0.0;
  config.exploration.first = config.exploration.last = 1.0;
  TEST_ASSERT_EQUAL_INT(QTR_OK, learner_init(&table_learner, table_ground, learnt_on, &config));
}

static void set_up(const char *rows, uint8_t seekers) {
  mission_draw(&table_mission, rows);
  if (seekers > 0) mission_crew(&table_mission, seekers);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_mission_check(&table_mission, NULL));
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_game_init(&table_game, &table_mission, &table_travel, NULL));
  TEST_ASSERT_EQUAL_INT(QTR_OK, ground_init(&table_ground, &table_game, &table_travel));
}

/* Episodes alone: the steps that tune prices go by without one. */
static void play_episodes(uint64_t episodes) {
  do {
    TEST_ASSERT_EQUAL_INT(QTR_LEARNING, qtr_learner_step(table_learner));
    qtr_learner_certificate(table_learner, &certificate);
  } while (certificate.episodes < episodes);
}

/* One place, three steps off: Q(s0, place) is w gamma^2 as soon as the one choice of the game has been backed up, and
 * what comes after the end of the game is worth nothing. */
static void test_last_choice_of_an_episode_is_backed_up(void) {
  set_up("S..1", 0);
  begin(1, NULL);
  play_episodes(1);
  TEST_ASSERT_EQUAL_UINT64(1, certificate.updates);
  TEST_ASSERT_TRUE(fabs(certificate.max_q - 10.0 * 0.99 * 0.99) < 1e-5);
}

/* The game that prices are tuned by is better than what one episode teaches, and counts for nothing. */
static void test_first_episode_reports_what_it_learnt_however_bad(void) {
  unsigned worse = 0;
  set_up("1........S2.......3", 0);
  qtr_play_by_rate(&table_learner->play, &table_game);
  const double by_rate = table_learner->play.score.value;
  for (uint64_t seed = 1; seed <= 40; seed++) {
    begin(seed, NULL);
    play_episodes(1);
    worse += certificate.value < by_rate - 1e-9;
    qtr_play_score(&table_learner->play, &table_game);
    TEST_ASSERT_TRUE(certificate.value == table_learner->play.score.value); /* the greedy play of that episode */
  }
  TEST_ASSERT_GREATER_THAN(5, worse);
}

/* From then on the best play stays, though later ones are worse, and better ones take its place. */
static void test_best_play_of_all_episodes_is_reported(void) {
  unsigned worse = 0;
  unsigned better = 0;
  set_up("1...4....S2...5...3", 0);
  for (uint64_t seed = 1; seed <= 40; seed++) {
    begin(seed, NULL);
    play_episodes(1);
    double best = certificate.value;
    for (uint64_t episode = 2; episode <= 30; episode++) {
      table_learner->replayed = false; /* the greedy game is played again, changed or not */
      play_episodes(episode);
      qtr_play_score(&table_learner->play, &table_game);
      const double played = table_learner->play.score.value;
      worse += played < best;
      better += played > best;
      best = played > best ? played : best;
      TEST_ASSERT_TRUE(certificate.value == best);
    }
  }
  TEST_ASSERT_GREATER_THAN(20, worse);
  TEST_ASSERT_GREATER_THAN(20, better);
}

/* ---- replays left out ---- */

enum { EPISODES = 150 };

typedef struct {
  double value[EPISODES], max_q[EPISODES];
  unsigned left_out; /* replays */
} course;

static void note_episode(course *made, unsigned episode) {
  const double before = table_learner->max_q;
  table_learner->max_q = -HUGE_VAL;
  play_episodes(episode + 1);
  if (table_learner->max_q == -HUGE_VAL) {
    made->left_out++;
    table_learner->max_q = before;
  }
  qtr_learner_certificate(table_learner, &certificate);
  made->value[episode] = certificate.objective;
  made->max_q[episode] = certificate.max_q;
}

static void note_course(course *made, const qtr_environment *learnt_on, double explored, bool always) {
  begin(1, learnt_on);
  table_learner->explorer.rate = table_learner->explorer.plan.last = explored;
  made->left_out = 0;
  for (unsigned episode = 0; episode < EPISODES; episode++) {
    if (always) table_learner->replayed = false;
    note_episode(made, episode);
  }
}

static const qtr_environment *random_aggregate(test_random *random) {
  const qtr_spots_config spots = spot_limits(3, 6, 0.0);
  const qtr_aggregation how = aggregation_of(&spots, NULL);
  if (random_chance(random, 50)) return NULL;
  TEST_ASSERT_EQUAL_INT(QTR_OK, aggregate_init(&aggregate, &table_game, &how, &table_travel));
  return aggregate;
}

/* The greedy game is played again only where it may have changed: whoever plays it after each episode sees the same. */
static void test_replays_left_out_would_have_changed_nothing(void) {
  static course some, all;
  unsigned left_out = 0;
  for (unsigned number = 0; number < 40; number++) {
    test_random random = random_case("replays", number);
    mission_random(&table_mission, &random, (mission_size){8, 7, 7, 3});
    table_mission.rule = QTR_RULE_FREE;
    TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_game_init(&table_game, &table_mission, &table_travel, NULL));
    TEST_ASSERT_EQUAL_INT(QTR_OK, ground_init(&table_ground, &table_game, &table_travel));
    const qtr_environment *learnt_on = random_aggregate(&random);
    const double explored = random_unit(&random);
    note_course(&some, learnt_on, explored, false);
    note_course(&all, learnt_on, explored, true);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0, all.left_out, case_note);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(all.value, some.value, sizeof all.value, case_note);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(all.max_q, some.max_q, sizeof all.max_q, case_note);
    left_out += some.left_out;
  }
  TEST_ASSERT_GREATER_THAN(40 * EPISODES / 4, left_out);
}

/* By the paper's rule two seekers go for the one target. On the ground its places are the first one's alone. */
static void test_target_of_two_seekers_is_on_one_route(void) {
  const qtr_spots_config spots = spot_limits(2, 3, 0.0);
  qtr_aggregation how = aggregation_of(&spots, NULL);
  how.rule = QTR_RULE_PAPER;
  set_up("1.2..S", 2);
  TEST_ASSERT_EQUAL_INT(QTR_OK, aggregate_init(&aggregate, &table_game, &how, &table_travel));
  TEST_ASSERT_EQUAL(1, aggregate->targets.count);
  begin(1, aggregate);
  play_episodes(3);
  const qtr_play *best = qtr_learner_best(table_learner);
  unsigned visits[2] = {0, 0};
  for (unsigned i = 0; i < best->choices; i++)
    if (best->choice[i] != QTR_STAND_DOWN) visits[best->choice[i]]++;
  TEST_ASSERT_EQUAL(1, visits[0]);
  TEST_ASSERT_EQUAL(1, visits[1]);
  TEST_ASSERT_EQUAL_UINT32(3, best->visit[1]);
  TEST_ASSERT_EQUAL_UINT32(5, best->visit[0]);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_last_choice_of_an_episode_is_backed_up);
  RUN_TEST(test_first_episode_reports_what_it_learnt_however_bad);
  RUN_TEST(test_best_play_of_all_episodes_is_reported);
  RUN_TEST(test_replays_left_out_would_have_changed_nothing);
  RUN_TEST(test_target_of_two_seekers_is_on_one_route);
  return UNITY_END();
}
