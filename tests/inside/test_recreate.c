/* profiles: host mcu */
/* Ruin and recreate: divisions stay divisions that can be played, nothing gets worse, a seed decides all, the watch is
 * obeyed, and small games come out as an enumeration of all plays has them. */
#include <math.h>
#include <string.h>

#include "search/recreate.h"
#include "search/route.h"
#include "support/brute.h"
#include "support/scattered.h"
#include "support/terms_games.h"
#include "unity.h"

enum { SMALL = 60, TERMS = 150, ROUNDS = 2000, MOST = QTR_MAX_PLACES < 128 ? QTR_MAX_PLACES : 128 };

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_vicinity vicinity; /* of small games: all are near one another */
static qtr_play play;
static qtr_routes routes;
static qtr_recreation recreation, again;

void setUp(void) {
  snprintf(case_note, sizeof case_note, "by hand");
}

void tearDown(void) {
}

static void begin(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  qtr_play_by_rate(&play, &game);
  qtr_play_to_routes(&play, &game, &routes);
}

static double worth_of(const qtr_routes *of) {
  double worth = 0.0;
  for (unsigned i = 0; i < qtr_routes_count(&game); i++)
    worth += qtr_route_evaluate(&game, i, of->place[i], of->length[i]).worth;
  return worth;
}

static unsigned placed_by(const qtr_routes *of) {
  unsigned placed = 0;
  for (unsigned i = 0; i < qtr_routes_count(&game); i++) placed += of->length[i];
  return placed;
}

static void expect_division(const qtr_routes *of) {
  TEST_ASSERT_TRUE_MESSAGE(qtr_routes_are_division(of, qtr_routes_count(&game)), case_note);
  TEST_ASSERT_EQUAL_UINT_MESSAGE(placed_by(&routes), placed_by(of), case_note);
  TEST_ASSERT_TRUE_MESSAGE(worth_of(of) > -HUGE_VAL, case_note);
}

static void run(qtr_recreation *r, uint32_t rounds, uint64_t seed) {
  qtr_recreation_begin(r, &game, &vicinity, &routes, rounds, seed);
  while (!qtr_recreation_is_over(r)) {
    qtr_recreation_go_on(r, rounds / 4);
    expect_division(&r->now);
    expect_division(&r->best);
    TEST_ASSERT_TRUE_MESSAGE(worth_of(&r->best) >= worth_of(&routes), case_note);
  }
}

/* ---- what comes of it ---- */

static void test_small_games_come_out_as_an_enumeration_has_them(void) {
  static const mission_size size = {7, 7, 6, 3};
  for (unsigned seed = 1; seed <= random_cases(SMALL); seed++) {
    test_random random = random_case("small", seed);
    brute_game brute;
    mission_random(&mission, &random, size);
    mission.rule = QTR_RULE_FREE;
    begin();
    run(&recreation, ROUNDS, seed);
    brute_set_up(&brute, &mission);
    const double optimum = brute_optimum(&brute);
    TEST_ASSERT_TRUE_MESSAGE(fabs(worth_of(&recreation.best) - optimum) <= 1e-9 * fabs(optimum), case_note);
  }
}

static void test_divisions_stay_playable_and_never_lose_under_all_terms(void) {
#if QTR_TERMS
  for (unsigned seed = 1; seed <= random_cases(TERMS); seed++) {
    terms_game_make(&mission, seed, terms_mix(seed));
    begin();
    run(&recreation, ROUNDS / 4, seed);
  }
#else
  TEST_IGNORE_MESSAGE("built without terms");
#endif
}

static void test_the_scores_told_are_those_of_the_routes(void) {
  scattered_make(&mission, &game, &travel, 1, 20, MOST, QTR_MAX_SEEKERS < 3 ? QTR_MAX_SEEKERS : 3, QTR_TIME);
  begin();
  run(&recreation, ROUNDS, 1);
  for (unsigned i = 0; i < game.board.seekers; i++) {
    const qtr_routes *best = &recreation.best;
    const qtr_route_score score = qtr_route_evaluate(&game, i, best->place[i], best->length[i]);
    TEST_ASSERT_TRUE(score.worth == best->score[i].worth && score.time == best->score[i].time);
  }
}

static void test_other_routes_are_gone_on_from_and_the_best_stays(void) {
  scattered_make(&mission, &game, &travel, 2, 20, MOST, 2, QTR_DISCOUNTED);
  begin();
  run(&recreation, ROUNDS, 1);
  const double best = worth_of(&recreation.best);
  qtr_recreation_adopt(&recreation, &routes);
  TEST_ASSERT_TRUE(worth_of(&recreation.best) == best);
  qtr_recreation_begin(&again, &game, &vicinity, &routes, ROUNDS, 1);
  qtr_recreation_adopt(&again, &recreation.best);
  TEST_ASSERT_TRUE(worth_of(&again.best) == best && again.found);
}

/* ---- how ---- */

static bool are_same(const qtr_routes *a, const qtr_routes *b) {
  for (unsigned i = 0; i < qtr_routes_count(&game); i++) {
    if (a->length[i] != b->length[i]) return false;
    if (memcmp(a->place[i], b->place[i], a->length[i] * sizeof a->place[i][0]) != 0) return false;
  }
  return true;
}

static void test_a_seed_decides_all_however_the_rounds_are_cut(void) {
  scattered_make(&mission, &game, &travel, 3, 20, MOST, 2, QTR_TIME);
  begin();
  run(&recreation, ROUNDS, 7);
  qtr_recreation_begin(&again, &game, &vicinity, &routes, ROUNDS, 7);
  while (!qtr_recreation_is_over(&again)) qtr_recreation_go_on(&again, 1);
  TEST_ASSERT_TRUE(are_same(&recreation.best, &again.best) && are_same(&recreation.now, &again.now));
  run(&again, ROUNDS, 8);
  TEST_ASSERT_FALSE(are_same(&recreation.now, &again.now));
}

static unsigned allowed;

static bool allow(void *context) {
  (void)context;
  return allowed > 0 && allowed-- > 0;
}

static void test_the_watch_ends_it_after_any_round_and_it_goes_on_from_there(void) {
  scattered_make(&mission, &game, &travel, 4, 20, MOST, 2, QTR_TIME);
  begin();
  run(&recreation, 100, 5);
  mission.watch.go_on = allow;
  qtr_recreation_begin(&again, &game, &vicinity, &routes, 100, 5);
  for (unsigned stops = 0; stops < 100; stops++) {
    allowed = stops % 3;
    qtr_recreation_go_on(&again, 100);
    TEST_ASSERT_EQUAL_UINT(0, allowed);
    expect_division(&again.best);
  }
  TEST_ASSERT_EQUAL_UINT(99, again.round);
  mission.watch.go_on = NULL;
  qtr_recreation_go_on(&again, 100);
  TEST_ASSERT_TRUE(are_same(&recreation.best, &again.best));
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_small_games_come_out_as_an_enumeration_has_them);
  RUN_TEST(test_divisions_stay_playable_and_never_lose_under_all_terms);
  RUN_TEST(test_the_scores_told_are_those_of_the_routes);
  RUN_TEST(test_other_routes_are_gone_on_from_and_the_best_stays);
  RUN_TEST(test_a_seed_decides_all_however_the_rounds_are_cut);
  RUN_TEST(test_the_watch_ends_it_after_any_round_and_it_goes_on_from_there);
  return UNITY_END();
}
