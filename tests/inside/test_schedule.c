/* profiles: host mcu */
/* What an insertion changes, as a schedule has it from its sums, against the route walked anew with and without the
 * place: with forbidden ground, classes, scans, looks, ready times, ends, deadlines and ways home. */
#include <math.h>

#include "search/route.h"
#include "search/schedule.h"
#include "support/terms_games.h"
#include "unity.h"

enum { GAMES = 400, PLAIN = 1000 };

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_play play;
static qtr_routes routes;
static qtr_schedule schedule;

void setUp(void) {
}

void tearDown(void) {
}

static void begin(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  qtr_play_by_rate(&play, &game);
  qtr_play_to_routes(&play, &game, &routes);
  qtr_schedule_begin(&schedule, &game, &routes);
}

/* The change that walking the whole route finds. */
static double walked(unsigned route, unsigned at, uint16_t place) {
  uint16_t with[QTR_MAX_PLACES];
  const uint16_t *without = schedule.routes.place[route];
  const unsigned length = schedule.routes.length[route];
  for (unsigned i = 0; i < length; i++) with[i < at ? i : i + 1] = without[i];
  with[at] = place;
  return qtr_route_evaluate(&game, route, with, length + 1).worth -
         qtr_route_evaluate(&game, route, without, length).worth;
}

static void expect_change(unsigned route, unsigned at, uint16_t place) {
  char text[300];
  const double expected = walked(route, at, place);
  const double found = qtr_schedule_try(&schedule, route, at, place);
  snprintf(text, sizeof text, "%s: place %u at %u of route %u: %.15g expected, %.15g found", case_note, place, at,
           route, expected, found);
  if (expected == -HUGE_VAL || found == -HUGE_VAL)
    TEST_ASSERT_TRUE_MESSAGE(expected == found, text);
  else
    TEST_ASSERT_TRUE_MESSAGE(fabs(expected - found) <= 1e-9 * (1.0 + fabs(expected)), text);
}

/* The best of all positions of a route, or of some, is found as it is one by one. */
static void expect_best(test_random *random, unsigned route, uint16_t place) {
  const unsigned end = schedule.routes.length[route] + 1u;
  const unsigned from = random_below(random, end);
  qtr_insertion one_by_one = {random_chance(random, 50) ? -HUGE_VAL : walked(route, from, place), route, from};
  qtr_insertion best = one_by_one;
  for (unsigned at = from; at < end; at++) {
    const double gain = qtr_schedule_try(&schedule, route, at, place);
    if (gain > one_by_one.gain) one_by_one = (qtr_insertion){gain, route, at};
  }
  qtr_schedule_find(&schedule, route, from, end, place, &best);
  TEST_ASSERT_TRUE_MESSAGE(best.gain == one_by_one.gain && best.at == one_by_one.at, case_note);
}

/* Every place into every position of every route, then on from one of them. */
static void expect_changes(test_random *random) {
  for (uint16_t place = 0; place < game.board.places; place++) {
    const unsigned home = schedule.route_of[place];
    if (home >= game.board.seekers) continue;
    unsigned from = 0;
    while (schedule.routes.place[home][from] != place) from++;
    qtr_schedule_remove(&schedule, home, from, 1);
    for (unsigned route = 0; route < game.board.seekers; route++)
      for (unsigned at = 0; at <= schedule.routes.length[route]; at++) expect_change(route, at, place);
    for (unsigned route = 0; route < game.board.seekers; route++) expect_best(random, route, place);
    unsigned route = random_below(random, game.board.seekers);
    unsigned at = random_below(random, schedule.routes.length[route] + 1u);
    if (qtr_schedule_try(&schedule, route, at, place) == -HUGE_VAL) route = home, at = from;
    qtr_schedule_insert(&schedule, route, at, place);
  }
}

static void test_an_insertion_changes_what_walking_the_route_says(void) {
  static const mission_size size = {8, 8, 10, 3};
  for (unsigned seed = 1; seed <= random_cases(PLAIN); seed++) {
    test_random random = random_case("plain", seed);
    mission_random(&mission, &random, size);
    mission.rule = QTR_RULE_FREE;
    begin();
    expect_changes(&random);
  }
}

static void test_an_insertion_changes_what_walking_the_route_says_under_each_term(void) {
#if QTR_TERMS
  for (unsigned feature = 0; feature <= TERMS_FEATURES; feature++) {
    for (unsigned seed = 1; seed <= random_cases(GAMES); seed++) {
      terms_game_make(&mission, seed, feature < TERMS_FEATURES ? 1u << feature : terms_mix(seed));
      test_random random = {seed};
      begin();
      expect_changes(&random);
    }
  }
#else
  TEST_IGNORE_MESSAGE("built without terms");
#endif
}

/* gamma^max(t-1, 0): the first step of a delay costs a place nothing that is visited at step 0. */
static void test_a_place_at_the_start_itself_loses_a_step_less(void) {
  mission_draw(&mission, "S.12");
  mission.place[0] = mission.start[0];
  begin();
  const uint16_t first = schedule.routes.place[0][0];
  TEST_ASSERT_EQUAL_UINT(0, first);
  qtr_schedule_remove(&schedule, 0, 1, 1);
  const double before = QTR_REWARD_SCALE / 3.0;
  const double after = QTR_REWARD_SCALE * (2.0 / 3.0 * pow(0.99, 2.0) + 1.0 / 3.0 * pow(0.99, 5.0));
  TEST_ASSERT_TRUE(fabs(qtr_schedule_try(&schedule, 0, 0, 1) - (after - before)) < 1e-12);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_an_insertion_changes_what_walking_the_route_says);
  RUN_TEST(test_an_insertion_changes_what_walking_the_route_says_under_each_term);
  RUN_TEST(test_a_place_at_the_start_itself_loses_a_step_less);
  return UNITY_END();
}
