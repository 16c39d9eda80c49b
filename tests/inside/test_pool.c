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
static qtr_duals duals;
static double charge[PLACES_MOST * PLACES_MOST];
static double least[QTR_MAX_SEEKERS];
static unsigned routes; /* enumerated, that must be listed */

void setUp(void) {
}

void tearDown(void) {
}

/* Some triples, with tolls that C takes by halves. */
static void charge_tolls(test_random *random) {
  for (unsigned i = 0; i < PLACES_MOST * PLACES_MOST; i++) charge[i] = 0.0;
  for (unsigned tries = random_below(random, 8); tries > 0 && game.board.places >= 3; tries--) {
    uint16_t *of = duals.triple[duals.triples].place;
    const double toll = random_unit(random) * fabs(bound.price[0]);
    of[0] = (uint16_t)random_below(random, game.board.places - 2u);
    of[1] = (uint16_t)random_in(random, of[0] + 1, game.board.places - 2u);
    of[2] = (uint16_t)random_in(random, of[1] + 1, game.board.places - 1u);
    duals.toll[duals.triples++] = toll;
    for (unsigned i = 0; i < 3; i++)
      for (unsigned j = 0; j < 3; j++)
        if (i != j) charge[of[i] * game.board.places + of[j]] += 0.5 * toll;
  }
  qtr_gains_charge(&bound.gains, charge);
  qtr_gains_fill(&bound.gains, duals.place);
}

/* A random game under random prices, half of them with several looks at some places, and what routes are to collect. */
static void begin(test_random *random) {
  const bool again = random_chance(random, 50);
  qtr_play play;
  mission_random(&mission, random, (mission_size){9, 7, again ? PLACES_MOST / 2 : PLACES_MOST, 3});
  if (again) mission_look_again(&mission, random, PLACES_MOST);
  mission.aim.kind = random_chance(random, 50) ? QTR_TIME : QTR_DISCOUNTED;
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, ground_init(&ground, &game, &travel), case_note);
  qtr_play_by_rate(&play, &game);
  qtr_bound_init(&bound, gains, ground, play.visit);
  for (unsigned steps = random_below(random, 20); steps > 0 && qtr_bound_improve(&bound, play.score.worth); steps--) {}
  for (unsigned place = 0; place < game.board.places; place++)
    bound.price[place] += fabs(bound.price[place]) * (random_unit(random) - 0.5);
  bound.filling = 0; /* C is of other prices */
  qtr_bound_settle(&bound);
  qtr_pool_init(&pool, block, sizeof block, &bound);
  qtr_pool_duals(&pool, &duals);
  const double gap = qtr_pool_upper(&pool, &duals) - play.score.worth;
  TEST_ASSERT_TRUE_MESSAGE(gap >= -1e-9 * fabs(play.score.worth), case_note);
  for (unsigned squad = 0; squad < pool.squads; squad++)
    least[squad] = duals.squad[squad] - gap - random_unit(random) * 0.1 * fabs(play.score.worth);
  charge_tolls(random);
  qtr_pool_begin(&pool, &duals, least);
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

static bool has(const route *r, unsigned place) {
  for (unsigned i = 0; i < r->length; i++)
    if (r->place[i] == place) return true;
  return false;
}

static double tolls_of(const route *r) {
  double tolls = 0.0;
  for (uint32_t t = 0; t < duals.triples; t++) {
    const uint16_t *of = duals.triple[t].place;
    if (has(r, of[0]) + has(r, of[1]) + has(r, of[2]) >= 2) tolls += duals.toll[t];
  }
  return tolls;
}

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
  return net - tolls_of(r);
}

static bool has_places(const qtr_label *label, const route *r) {
  unsigned held = 0;
  for (unsigned place = 0; place < game.board.places; place++) held += qtr_label_has(label, place);
  for (unsigned i = 0; i < r->length; i++)
    if (!qtr_label_has(label, r->place[i])) return false;
  return held == r->length;
}

/* One with the same places that is no worse. */
static void expect_listed(const route *r, unsigned seeker, double net) {
  double worth = net + tolls_of(r);
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

/* Whether it goes back if it goes on to a place (search/looks.h). */
static bool goes_back(const route *r, unsigned place) {
  for (unsigned i = 0; i < r->length; i++)
    if (qtr_looks_is_before(&bound.gains.looks, place, r->place[i])) return true;
  return false;
}

static void enumerate(route *r, unsigned seeker) {
  const double net = net_of(r, seeker);
  const double enough = least[pool.squad_of[seeker]];
  if (net > enough + 1e-9 * fmax(1.0, fabs(enough))) expect_listed(r, seeker, net);
  for (uint16_t place = 0; place < game.board.places; place++) {
    if (has(r, place) || goes_back(r, place)) continue;
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
      worth = net_of(&r, seeker) + tolls_of(&r);
      for (unsigned i = 0; i < r.length; i++) worth += bound.price[r.place[i]];
      TEST_ASSERT_TRUE_MESSAGE(fabs(qtr_pool_worth(&pool, label) - worth) <= 1e-9 * fmax(1.0, fabs(worth)), case_note);
      for (unsigned i = 0; i < r.length; i++) set |= 1u << r.place[i];
      TEST_ASSERT_EQUAL_MESSAGE(1, ++seen[pool.squad_of[seeker]][set], case_note);
    }
  }
}

/* A route as it was when it was kept. */
typedef struct {
  route r;
  unsigned squad;
  double worth;
} kept;

static void expect_kept(const kept *k) {
  for (uint32_t label = 0; label < pool.kept; label++) {
    route r = {0, {0}};
    if (!qtr_pool_is_route(&pool, label) || qtr_pool_label(&pool, label)->squad != k->squad) continue;
    r.length = qtr_pool_places(&pool, label, r.place);
    if (r.length != k->r.length || memcmp(r.place, k->r.place, r.length * sizeof r.place[0]) != 0) continue;
    TEST_ASSERT_TRUE_MESSAGE(fabs(qtr_pool_worth(&pool, label) - k->worth) <= 1e-9 * fmax(1.0, fabs(k->worth)),
                             case_note);
    return;
  }
  TEST_FAIL_MESSAGE(case_note);
}

/* Whatever is listed behind them, by whatever prices. */
static void test_routes_that_are_kept_stay_what_they_are(void) {
  static kept list_of[1u << PLACES_MOST];
  static uint32_t numbers[1u << PLACES_MOST];
  for (unsigned number = 0; number < random_cases(120); number++) {
    test_random random = random_case("kept", number);
    unsigned count = 0;
    begin(&random);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_LISTED, list(), case_note);
    for (uint32_t label = 0; label < pool.labels; label++) {
      if (!qtr_pool_is_route(&pool, label) || !random_chance(&random, 20) || count == 1u << PLACES_MOST) continue;
      kept *k = &list_of[count++];
      k->r.length = qtr_pool_places(&pool, label, k->r.place);
      k->squad = qtr_pool_label(&pool, label)->squad;
      k->worth = qtr_pool_worth(&pool, label);
      numbers[count - 1] = label;
      qtr_pool_mark(&pool, label);
    }
    qtr_pool_keep_marked(&pool, numbers, count);
    for (unsigned i = 0; i < count; i++) TEST_ASSERT_TRUE_MESSAGE(qtr_pool_is_route(&pool, numbers[i]), case_note);
    TEST_ASSERT_EQUAL_MESSAGE(count, pool.routes, case_note);
    for (unsigned place = 0; place < game.board.places; place++) duals.place[place] *= 1.0 + 0.2 * random_unit(&random);
    qtr_gains_fill(&bound.gains, duals.place);
    qtr_pool_begin(&pool, &duals, least);
    TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_LISTED, list(), case_note);
    for (unsigned i = 0; i < count; i++) expect_kept(&list_of[i]);
  }
}

static void test_full_block_is_told(void) {
  test_random random = random_case("small block", 1);
  do begin(&random);
  while (game.board.places < PLACES_MOST);
  for (unsigned squad = 0; squad < pool.squads; squad++) least[squad] = -1e9;
  pool.labels_most = 10;
  qtr_pool_begin(&pool, &duals, least);
  TEST_ASSERT_EQUAL_INT(QTR_POOL_FULL, list());
  TEST_ASSERT_LESS_OR_EQUAL(pool.labels_most, pool.labels);
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_every_route_within_the_gap_is_listed_or_a_better_one_with_its_places);
  RUN_TEST(test_listed_routes_are_worth_what_their_places_bring);
  RUN_TEST(test_routes_that_are_kept_stay_what_they_are);
  RUN_TEST(test_full_block_is_told);
  return UNITY_END();
}
