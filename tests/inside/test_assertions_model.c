#define _POSIX_C_SOURCE 200809L
/* What the learner's model of the game and its aggregates rest on is asserted, and each assertion can fail. */
#include <math.h>
#include <string.h>

#include "aggregate/environment.h"
#include "aggregate/nearby.h"
#include "quarter/belief.h"
#include "quarter/spots.h"
#include "support/death.h"
#include "support/settings.h"
#include "support/tables.h"

static qtr_regions regions;
static uint64_t scratch[(QTR_REGIONS_SCRATCH_BYTES + 7) / 8];
static qtr_regions_config limits;
static qtr_environment *seen; /* the ground by regions */
static qtr_situation situation;
static qtr_outcome outcome;

/* Two seekers at one start, three places; cell 11 is blocked. */
void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
  table_draw("1..S..2/..~.#.3", 2);
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  limits = region_limits(3, 5);
  TEST_ASSERT_EQUAL_INT(QTR_OK, qtr_regions_build(&regions, &grid, &limits, scratch, sizeof scratch));
  const qtr_aggregation how = aggregation_of(NULL, &regions);
  TEST_ASSERT_EQUAL_INT(QTR_OK, aggregate_init(&seen, &table_game, &how, &table_travel));
}

void tearDown(void) {
}

/* ---- what a game is played for ---- */

static void discount_by_nothing(void) {
  qtr_objective objective;
  const qtr_aim aim = {.kind = QTR_DISCOUNTED, .gamma = 1.0};
  qtr_objective_init(&objective, &aim, NULL);
}

static void visit_before_the_stretch(void) {
  qtr_objective_begin(&outcome, 0);
  qtr_objective_collect(&table_game.objective, &outcome, 0.5, 0, 3);
}

static void visit_after_the_stretch(void) {
  qtr_objective_begin(&outcome, 0);
  qtr_objective_collect(&table_game.objective, &outcome, 0.5, 4, 3);
}

static void earn_more_than_there_is(void) {
  const qtr_steps visit[3] = {1, 1, 1};
  qtr_score score;
  table_game.probability[0] += 0.1;
  qtr_game_score(&table_game, visit, 0, &score);
}

static void speak_of_no_objective(void) {
  qtr_objective_in_words(QTR_OBJECTIVES);
}

static void test_objective(void) {
  expect_death("what comes later is worth less", discount_by_nothing);
  expect_death("a visit is not before its stretch", visit_before_the_stretch);
  expect_death("nor after it", visit_after_the_stretch);
  expect_death("no game earns more than all places at once", earn_more_than_there_is);
  expect_death("an objective has words", speak_of_no_objective);
}

/* ---- likelihoods ---- */

static void weigh_without_end(void) {
  table_mission.weight[0] = HUGE_VAL;
  qtr_game_init(&table_game, &table_mission, &table_travel, NULL);
}

static void find_what_is_not_left(void) {
  qtr_state state;
  qtr_game_start(&table_game, &state);
  state.unvisited = 0.0;
  qtr_game_choose(&table_game, &state, 0, 0);
  qtr_game_choose(&table_game, &state, 1, 1);
  qtr_game_pass(&table_game, &state, &outcome);
}

static void find_on_the_ground_what_is_not_left(void) {
  qtr_environment_start(table_ground, &situation);
  situation.unvisited = 0.0;
  qtr_environment_choose(table_ground, &situation, 0, 0);
  qtr_environment_choose(table_ground, &situation, 1, 1);
  qtr_environment_pass(table_ground, &situation, &outcome);
}

static void believe_in_nothing(void) {
  double estimate[1];
  qtr_belief belief;
  memset(&belief, 0, sizeof belief);
  belief.places = 1;
  qtr_belief_estimate(&belief, estimate);
}

static void search_elsewhere(void) {
  double posterior[QTR_MAX_PLACES];
  qtr_belief belief;
  qtr_search search;
  qtr_belief_init(&belief, 3, NULL, 1.0, 1.0);
  qtr_search_begin(&search, &belief);
  search.places = 2;
  qtr_search_posterior(&search, &belief, posterior);
}

static void test_likelihoods(void) {
  expect_death("likelihoods make up 1", weigh_without_end);
  expect_death("a game finds no more than is left", find_what_is_not_left);
  expect_death("nor does its aggregate", find_on_the_ground_what_is_not_left);
  expect_death("a belief is in something", believe_in_nothing);
  expect_death("a search is of the belief's places", search_elsewhere);
}

/* ---- targets, and what is seen of the way to them ---- */

static void begin_a_tour_elsewhere(void) {
  qtr_targets *targets = &table_ground->targets;
  targets->first[3 * targets->count + 0] = 1;
  qtr_targets_duration(targets, 0, 3, 0);
}

static void tour_a_place_twice(void) {
  const qtr_spot_ground ground = {table_game.board.places, table_game.steps, table_game.probability,
                                  &table_game.objective};
  const uint16_t place[2] = {0, 0};
  qtr_spot_tour tour;
  qtr_spot_tour_nearest(&tour, &ground, 3, place, 2);
}

static void walk_through_walls(void) {
  qtr_walk walk = qtr_walk_at(table_mission.start[0]);
  memset(table_mission.cost, 0, qtr_mission_cells(&table_mission));
  qtr_sight_walk(&seen->sight, &walk, qtr_targets_tour(&seen->targets, 0), 2);
}

static void walk_beyond_the_tour(void) {
  qtr_walk walk = qtr_walk_at(table_mission.start[0]);
  walk.stage = 1;
  qtr_sight_left(&seen->sight, &walk, qtr_targets_tour(&seen->targets, 0), 3);
}

static void stand_in_a_wall(void) {
  const qtr_walk walk = qtr_walk_at(11);
  qtr_sight_digit(&seen->sight, &walk, true);
}

static void test_targets_and_sight(void) {
  expect_death("a tour begins in its target", begin_a_tour_elsewhere);
  expect_death("a tour visits each place once", tour_a_place_twice);
  expect_death("a way leads over free cells", walk_through_walls);
  expect_death("a stage is one of the tour's", walk_beyond_the_tour);
  expect_death("who is seen is in a region", stand_in_a_wall);
}

/* ---- regions: spoilt by their own watch, between two of their steps ---- */

static bool is_covered(void) {
  for (uint32_t cell = 0; cell < qtr_mission_cells(&table_mission); cell++)
    if (table_mission.cost[cell] > 0 && regions.of[cell] == QTR_NO_REGION) return false;
  return true;
}

static bool shrink_the_diameter(void *context) {
  (void)context;
  if (is_covered()) limits.diameter = 0;
  return true;
}

static bool shrink_the_size(void *context) {
  (void)context;
  if (is_covered()) limits.max_size = 1;
  return true;
}

static bool count_a_cell_twice(void *context) {
  (void)context;
  if (is_covered()) regions.size[0]++;
  return true;
}

/* What is asked after the regions have been numbered: once for each, and at the end. */
static uint32_t asked, asked_before_numbering;

static bool count_askings(void *context) {
  (void)context;
  asked++;
  return true;
}

static bool leave_a_cell_out(void *context) {
  (void)context;
  if (++asked == asked_before_numbering) regions.of[0] = QTR_NO_REGION;
  return true;
}

static void build(bool (*spoil)(void *)) {
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  limits.watch.go_on = spoil;
  for (uint32_t cell = 0; cell < qtr_grid_cells(&grid); cell++) regions.of[cell] = QTR_NO_REGION;
  qtr_regions_build(&regions, &grid, &limits, scratch, sizeof scratch);
}

static void build_too_wide(void) {
  build(shrink_the_diameter);
}

static void build_too_large(void) {
  build(shrink_the_size);
}

static void build_apart(void) {
  build(count_a_cell_twice);
}

static void build_with_holes(void) {
  build(count_askings);
  asked_before_numbering = asked - regions.count - 1;
  asked = 0;
  build(leave_a_cell_out);
}

static void search_after_a_search_left_half_done(void) {
  static qtr_nearby nearby;
  const qtr_grid grid = qtr_mission_grid(&table_mission);
  qtr_nearby_init(&nearby, scratch, &grid);
  nearby.time[0] = 0;
  qtr_nearby_measure(&nearby, 0, 5);
}

static void test_regions(void) {
  expect_death("a representative is within the diameter", build_too_wide);
  expect_death("a region has no more cells than it may", build_too_large);
  expect_death("a region is connected", build_apart);
  expect_death("every free cell is in a region", build_with_holes);
  expect_death("a search begins anew", search_after_a_search_left_half_done);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_objective);
  RUN_TEST(test_likelihoods);
  RUN_TEST(test_targets_and_sight);
  RUN_TEST(test_regions);
  return UNITY_END();
}
