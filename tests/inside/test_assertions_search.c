#define _POSIX_C_SOURCE 200809L
/* What bound, search and learner rest on is asserted, and each assertion can fail. */
#include <math.h>
#include <string.h>

#include "learn/episode.h"
#include "support/death.h"
#include "support/forging.h"
#include "support/settings.h"

static qtr_regions regions;
static uint64_t scratch[(QTR_REGIONS_SCRATCH_BYTES + 7) / 8];
static qtr_environment *seen; /* an aggregate of the ground */
static qtr_situation situation;
static qtr_routes routes;
static qtr_play play;

/* Two seekers at one start, three places, learnt to the end. */
void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  learning_by_episodes = true;
  table_draw("1..S..2/..~...3", 2);
  play = table_learner->best;
  qtr_play_to_routes(&play, &table_game, &routes);
  qtr_environment_start(table_ground, &situation);
}

void tearDown(void) {
}

/* ---- the bound ---- */

static void begin_bound(const qtr_environment *environment) {
  qtr_bound_init(&table_learner->bound, table_learner->bound.gains.gain, environment, play.visit);
}

static void bound_a_place_in_two_targets(void) {
  table_ground->targets.spots.spot_of[0] = 1;
  begin_bound(table_ground);
}

static void bound_estimates(void) {
  qtr_regions_config limits;
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  const qtr_aggregation how = aggregation_of(NULL, &regions);
  qtr_regions_default(&limits);
  qtr_regions_build(&regions, &grid, &limits, scratch, sizeof scratch);
  aggregate_init(&seen, &table_game, &how, &table_travel);
  begin_bound(seen);
}

static void bound_ways_without_time(void) {
  qtr_store32(table_game.steps + 4 * 1, 0); /* from place 0 to place 1 */
  begin_bound(table_ground);
}

static void bound_walks_that_stand_still(void) {
  table_learner->bound.gains.way[0].slots = 0;
  qtr_bound_improve(&table_learner->bound, 0.0);
}

static void pay_for_leaving_out(void) {
  table_learner->bound.price[0] = -1.0;
  table_learner->bound.filling = 0; /* C is of other prices */
  qtr_bound_settle(&table_learner->bound);
}

static void test_bound(void) {
  expect_death("targets divide the places", bound_a_place_in_two_targets);
  expect_death("estimates bound nothing", bound_estimates);
  expect_death("a way takes time", bound_ways_without_time);
  expect_death("walks move on in time", bound_walks_that_stand_still);
  expect_death("a place left out costs nothing", pay_for_leaving_out);
}

/* ---- the Q-table ---- */

enum { TABLE_WORDS = 8192 };
static qtr_qtable table;
static uint32_t words[TABLE_WORDS];

/* Keys 0, 1, 2 ... up to where the next one makes the table grow. */
static void fill_table(void) {
  qtr_key_shape shape = {.places = 20, .nodes = 20, .longest = 99, .seekers = 1};
  qtr_key key = {{0}};
  qtr_key_measure(&shape);
  TEST_ASSERT_EQUAL(1, shape.words);
  qtr_qtable_init(&table, words, TABLE_WORDS, &shape, false);
  for (; table.entries < table.slots / 8 * 7; key.word[0]++) qtr_qtable_set(&table, &key, 1.0);
}

static void store_a_key_beyond_the_greatest(void) {
  const qtr_key key = {{UINT32_MAX, UINT32_MAX}};
  table.entry_words = 2;
  qtr_qtable_set(&table, &key, 1.0);
}

static void search_where_no_slot_is_free(void) {
  const qtr_key key = {{0}};
  double value;
  table.entries = table.slots;
  qtr_qtable_get(&table, &key, &value);
}

static void search_while_it_grows(void) {
  const qtr_key key = {{0}};
  double value;
  table.swept = 0;
  table.before = 1;
  qtr_qtable_get(&table, &key, &value);
}

static void round_what_is_no_number(void) {
  qtr_qtable_round_up(&table, (double)NAN);
}

/* The key lies where it is not looked for, until the table grows. */
static void find_a_key_by_growing(void) {
  const qtr_key key = {{1000000}};
  double value;
  for (uint32_t slot = 0; slot < table.slots; slot++) {
    uint32_t *word = &table.word[slot * table.entry_words];
    const uint32_t before = *word;
    if (before == 0) continue;
    *word = key.word[0];
    if (!qtr_qtable_get(&table, &key, &value)) break;
    *word = before;
  }
  qtr_qtable_set(&table, &key, 1.0);
}

static void test_qtable(void) {
  fill_table();
  expect_death("keys leave room for the tag", store_a_key_beyond_the_greatest);
  expect_death("a slot is free", search_where_no_slot_is_free);
  expect_death("entries lie where they are sought", search_while_it_grows);
  expect_death("a bound stays one", round_what_is_no_number);
  expect_death("growing makes no entries", find_a_key_by_growing);
}

/* ---- plays and routes ---- */

static void explore_without_numbers(void) {
  const double q[2] = {(double)NAN, (double)NAN};
  qtr_exploration_plan plan;
  qtr_explorer explorer;
  qtr_exploration_default(&plan);
  plan.kind = QTR_EXPLORE_SOFTMAX;
  qtr_explorer_init(&explorer, &plan, 1);
  qtr_explorer_pick(&explorer, q, 2);
}

static void play_out_of_turn(void) {
  play.seeker[0] ^= 1;
  qtr_play_score(&play, &table_game);
}

static void share_a_place(void) {
  routes.length[0] = routes.length[1] = 1;
  routes.place[0][0] = routes.place[1][0] = 2;
}

static void play_a_place_twice(void) {
  share_a_place();
  qtr_play_routes(&play, &table_game, &routes);
}

static void refine_a_place_twice(void) {
  share_a_place();
  qtr_refine(&table_learner->refinery, &routes, &table_game, 0, 1);
}

static bool halve_the_likelihoods(void *context) {
  (void)context;
  for (unsigned place = 0; place < table_game.board.places; place++) table_game.probability[place] /= 2.0;
  return true;
}

static void lose_by_refining(void) {
  table_mission.watch.go_on = halve_the_likelihoods;
  qtr_refine(&table_learner->refinery, &routes, &table_game, 0, 1);
}

static void test_plays_and_routes(void) {
  expect_death("the largest Q is a number", explore_without_numbers);
  expect_death("a play is by turns", play_out_of_turn);
  expect_death("routes that are played share no place", play_a_place_twice);
  expect_death("nor do those that are searched", refine_a_place_twice);
  expect_death("a search never loses", lose_by_refining);
}

/* ---- episodes ---- */

static void list_for_who_is_on_the_way(void) {
  qtr_environment_choose(table_ground, &situation, 0, 0);
  qtr_episode_list(table_learner, &situation, 0);
}

static void note_more_than_a_game(void) {
  qtr_episode_list(table_learner, &situation, 0);
  table_learner->play.choices = QTR_MAX_CHOICES;
  qtr_episode_note(table_learner, 0);
}

static void back_up_more_than_there_is(void) {
  const qtr_trace trace = {.outcome = {.reward = 0.0, .discount = 1.5}};
  qtr_episode_backup(&trace, 1.0);
}

static void beat_the_bound(void) {
  qtr_certificate certificate;
  table_learner->best.score.worth += 1.0;
  qtr_learner_certificate(table_learner, &certificate);
}

static void test_episodes(void) {
  expect_death("whose turn it is has a choice", list_for_who_is_on_the_way);
  expect_death("a game is no longer than its trace", note_more_than_a_game);
  expect_death("what comes later counts no more", back_up_more_than_there_is);
  expect_death("nothing beats the bound", beat_the_bound);
}

/* ---- the certified setting: an episode, spoilt by the mission's watch ---- */

/* As if a poor game were the best one known: the episode is played to its end. */
static void learn(bool (*spoil)(void *)) {
  qtr_qtable_init(&table_learner->table, learning_memory.table, QTR_QTABLE_WORDS, &table_learner->environment->keys,
                  false);
  table_learner->phase = QTR_PHASE_EPISODES;
  table_learner->upper = table_learner->ground_upper = 1000.0;
  table_learner->best.score.worth = 0.01;
  table_mission.watch.go_on = spoil;
  qtr_learner_step(table_learner);
}

static void learn_undisturbed(void) {
  learn(NULL);
}

static bool lower_the_entry(void *context) {
  (void)context;
  qtr_trace *trace = &table_learner->trace[table_learner->play.choices];
  qtr_qtable_set(&table_learner->table, &trace->key, -1.0);
  trace->q = 100.0;
  return true;
}

static void raise_an_entry(void) {
  learn(lower_the_entry);
}

static bool lower_the_first_q(void *context) {
  (void)context;
  table_learner->trace[0].q = table_learner->trace[0].runner_up = -100.0;
  return true;
}

/* On spots, where the ground's bound knows nothing of Q. */
static void earn_more_than_q(void) {
  const qtr_spots_config spots = spot_limits(2, 1, 0.0);
  const qtr_aggregation how = aggregation_of(&spots, NULL);
  qtr_learner_config config;
  qtr_learner_config_default(&config);
  aggregate_init(&seen, &table_game, &how, &table_travel);
  learner_init(&table_learner, table_ground, seen, &config);
  learn(lower_the_first_q);
}

static bool forget_the_best(void *context) {
  (void)context;
  table_learner->best.score.worth = -1.0;
  return false;
}

static void know_less_than_before(void) {
  learn(forget_the_best);
}

static void test_certified_setting(void) {
  TEST_ASSERT_FALSE(is_death(learn_undisturbed));
  expect_death("Q never rises", raise_an_entry);
  expect_death("Q is what can be earned or more", earn_more_than_q);
  expect_death("what is known stays known", know_less_than_before);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_bound);
  RUN_TEST(test_qtable);
  RUN_TEST(test_plays_and_routes);
  RUN_TEST(test_episodes);
  RUN_TEST(test_certified_setting);
  return UNITY_END();
}
