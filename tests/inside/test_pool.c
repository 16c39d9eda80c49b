/* Routes within the gap, against an enumeration of all routes. */
#include <math.h>
#include <string.h>

#include "quarter/game.h"
#include "robot/board.h"
#include "search/play.h"
#include "search/pool.h"
#include "support/learning.h"
#include "support/missions.h"
#include "support/random.h"
#include "unity.h"

#define PLACES_MOST 6u
#define POOL_BYTES (1u << 20)

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_environment *ground;
static qtr_bound bound;
static double gains[QTR_GAINS_BYTES(1) / sizeof(double) + 1];
static qtr_pool pool;
static double block[POOL_BYTES / sizeof(double)];
static double target;
static unsigned routes; /* enumerated, that must be listed */

void setUp(void) {
}

void tearDown(void) {
}

/* A random game under random prices, and a target below what they prove. */
static void begin(test_random *random) {
  qtr_play play;
  mission_random(&mission, random, (mission_size){9, 7, PLACES_MOST, 3});
  mission.aim.kind = random_chance(random, 50) ? QTR_TIME : QTR_DISCOUNTED;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  qtr_play_by_rate(&play, &game);
  qtr_bound_init(&bound, gains, ground, play.visit);
  for (unsigned steps = random_below(random, 20); steps > 0 && qtr_bound_improve(&bound, play.score.worth); steps--) {}
  for (unsigned place = 0; place < mission.places; place++)
    bound.price[place] += fabs(bound.price[place]) * (random_unit(random) - 0.5);
  qtr_bound_settle(&bound);
  target = play.score.worth - random_unit(random) * 0.1 * fabs(play.score.worth);
  qtr_pool_begin(&pool, block, sizeof block, &bound, target);
}

static enum qtr_listing list(void) {
  enum qtr_listing status;
  do status = qtr_pool_go_on(&pool, 5);
  while (status == QTR_LISTING);
  return status;
}

/* ---- all routes ---- */

typedef struct {
  unsigned length;
  uint16_t place[PLACES_MOST];
} route;

static double net_of(const route *r, unsigned seeker) {
  unsigned node = (unsigned)game.board.places + game.board.start_of[seeker];
  qtr_steps when = 0;
  double net = 0.0;
  for (unsigned i = 0; i < r->length; i++) {
    const qtr_steps way = qtr_board_steps(&game.board, seeker, node, r->place[i]);
    if (way == QTR_NEVER) return -HUGE_VAL;
    when += way;
    net += qtr_game_worth(&game, r->place[i], when) - bound.price[r->place[i]];
    node = r->place[i];
  }
  return net;
}

static bool has_places(const qtr_label *label, const route *r) {
  unsigned held = 0;
  for (unsigned place = 0; place < mission.places; place++) held += qtr_label_has(label, place);
  for (unsigned i = 0; i < r->length; i++)
    if (!qtr_label_has(label, r->place[i])) return false;
  return held == r->length;
}

/* One with the same places that is no worse. */
static void expect_listed(const route *r, unsigned seeker, double net) {
  double worth = net;
  for (unsigned i = 0; i < r->length; i++) worth += bound.price[r->place[i]];
  for (uint32_t label = 0; label < pool.labels; label++) {
    if (!qtr_pool_is_route(&pool, label) || !has_places(qtr_pool_label(&pool, label), r)) continue;
    if (qtr_pool_label(&pool, label)->squad != pool.squad_of[seeker]) continue;
    TEST_ASSERT_TRUE_MESSAGE(qtr_pool_worth(&pool, label) >= worth - 1e-9 * fmax(1.0, fabs(worth)), case_note);
    routes++;
    return;
  }
  TEST_FAIL_MESSAGE(case_note);
}

static void enumerate(route *r, unsigned seeker) {
  const double net = net_of(r, seeker);
  const double least = pool.squad[pool.squad_of[seeker]].most - pool.gap;
  if (net > least + 1e-9 * fmax(1.0, fabs(least))) expect_listed(r, seeker, net);
  for (uint16_t place = 0; place < mission.places; place++) {
    bool been = false;
    for (unsigned i = 0; i < r->length; i++) been = been || r->place[i] == place;
    if (been) continue;
    r->place[r->length++] = place;
    enumerate(r, seeker);
    r->length--;
  }
}

static void test_every_route_within_the_gap_is_listed_or_a_better_one_with_its_places(void) {
  routes = 0;
  for (unsigned number = 0; number < random_cases(120); number++) {
    test_random random = random_case("routes", number);
    begin(&random);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_LISTED, list(), case_note);
    for (unsigned seeker = 0; seeker < mission.seekers; seeker++) {
      route r = {0, {0}};
      enumerate(&r, seeker);
    }
  }
  TEST_ASSERT_GREATER_THAN(random_cases(1000), routes);
}

/* What is listed is what it says: the places in the order of their visits are worth so much, and on no two routes of a
 * squad are the places the same. */
static void test_listed_routes_are_worth_what_their_places_bring(void) {
  for (unsigned number = 0; number < random_cases(120); number++) {
    test_random random = random_case("worths", number);
    begin(&random);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_LISTED, list(), case_note);
    unsigned seen[QTR_MAX_SEEKERS][1u << PLACES_MOST] = {{0}};
    for (uint32_t label = 0; label < pool.labels; label++) {
      route r = {0, {0}};
      unsigned seeker = 0, set = 0;
      double worth;
      if (!qtr_pool_is_route(&pool, label)) continue;
      r.length = qtr_pool_places(&pool, label, r.place);
      while (pool.squad_of[seeker] != qtr_pool_label(&pool, label)->squad) seeker++;
      worth = net_of(&r, seeker);
      for (unsigned i = 0; i < r.length; i++) worth += bound.price[r.place[i]];
      TEST_ASSERT_TRUE_MESSAGE(fabs(qtr_pool_worth(&pool, label) - worth) <= 1e-9 * fmax(1.0, fabs(worth)), case_note);
      for (unsigned i = 0; i < r.length; i++) set |= 1u << r.place[i];
      TEST_ASSERT_EQUAL_MESSAGE(1, ++seen[pool.squad_of[seeker]][set], case_note);
    }
  }
}

static void test_full_block_is_told(void) {
  test_random random = random_case("small block", 1);
  do begin(&random);
  while (mission.places < PLACES_MOST);
  bound.price[0] = 0.0;
  qtr_bound_settle(&bound);
  qtr_pool_begin(&pool, block, 2048 + 10 * (size_t)pool.stride, &bound, -1e9);
  TEST_ASSERT_EQUAL_INT(QTR_POOL_FULL, list());
  TEST_ASSERT_LESS_OR_EQUAL(pool.labels_most, pool.labels);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_route_within_the_gap_is_listed_or_a_better_one_with_its_places);
  RUN_TEST(test_listed_routes_are_worth_what_their_places_bring);
  RUN_TEST(test_full_block_is_told);
  return UNITY_END();
}
