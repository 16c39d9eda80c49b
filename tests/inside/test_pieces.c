/* profiles: host mcu */
/* What is told of a route put together from pieces of others, against the same route followed place by place. */
#include <math.h>
#include <string.h>

#include "search/pieces.h"
#include "search/play.h"
#include "search/route.h"
#include "support/terms_games.h"
#include "unity.h"

enum { GAMES = 500, TRIES = 60 };

static qtr_mission mission;
static qtr_travel travel;
static qtr_game game;
static qtr_play play;
static qtr_routes routes;
static qtr_pieces pieces;

void setUp(void) {
}

void tearDown(void) {
}

static void begin(void) {
  TEST_ASSERT_EQUAL_INT_MESSAGE(QTR_OK, qtr_game_init(&game, &mission, &travel, NULL), case_note);
  qtr_play_by_rate(&play, &game);
  qtr_play_to_routes(&play, &game, &routes);
  pieces.game = &game;
  pieces.routes = &routes;
  for (unsigned i = 0; qtr_pieces_tell(&game) && i < game.board.seekers; i++) qtr_pieces_refresh(&pieces, i);
}

/* A route under construction, once as a piece and once as places. */
typedef struct {
  qtr_piece piece;
  unsigned length;
  uint16_t place[3 * QTR_MAX_PLACES];
} twice;

static void add(twice *both, unsigned seeker, unsigned from_route, unsigned from, unsigned to) {
  both->piece = qtr_pieces_join(&pieces, seeker, both->piece, qtr_pieces_of(&pieces, from_route, from, to));
  for (unsigned i = from; i < to; i++) both->place[both->length++] = routes.place[from_route][i];
}

static void add_reversed(twice *both, unsigned seeker, unsigned from_route, unsigned from, unsigned to) {
  for (unsigned i = to; i-- > from;) {
    const uint16_t place = routes.place[from_route][i];
    both->piece = qtr_pieces_join(&pieces, seeker, both->piece, qtr_pieces_single(&pieces, place));
    both->place[both->length++] = place;
  }
}

static void expect_worth(const twice *both, unsigned seeker) {
  char text[300];
  const double followed = qtr_route_evaluate(&game, seeker, both->place, both->length).worth;
  const double told = qtr_pieces_worth(&pieces, seeker, both->piece);
  snprintf(text, sizeof text, "%s: %.15g expected, %.15g told", case_note, followed, told);
  if (told == HUGE_VAL) return; /* for who stands on the first place */
  if (followed == -HUGE_VAL || told == -HUGE_VAL)
    TEST_ASSERT_TRUE_MESSAGE(followed == told, text);
  else
    TEST_ASSERT_TRUE_MESSAGE(fabs(told - followed) <= 1e-11 * (1.0 + fabs(followed)), text);
}

/* Some of the seeker's own route, some of another's, either way round, and some of its own again. */
static void try_a_route(test_random *random) {
  const unsigned seeker = random_below(random, game.board.seekers);
  const unsigned other = random_below(random, game.board.seekers);
  if (!qtr_pieces_fit(&game, seeker, other)) return;
  const unsigned first = random_below(random, routes.length[seeker] + 1u);
  const unsigned second = random_in(random, first, routes.length[seeker]);
  const unsigned from = random_below(random, routes.length[other] + 1u);
  const unsigned to = random_in(random, from, routes.length[other]);
  twice both = {.piece = qtr_no_piece};
  add(&both, seeker, seeker, 0, first);
  if (seeker != other && random_chance(random, 50)) add(&both, seeker, other, from, to);
  if (random_chance(random, 50)) add_reversed(&both, seeker, seeker, first, second);
  add(&both, seeker, seeker, second, routes.length[seeker]);
  expect_worth(&both, seeker);
}

static void test_a_route_of_pieces_is_worth_what_following_it_says(void) {
  static const mission_size size = {9, 9, 12, 3};
  if (!QTR_RECREATES) TEST_IGNORE_MESSAGE("built without pieces");
  for (unsigned seed = 1; seed <= random_cases(GAMES); seed++) {
    test_random random = random_case("plain", seed);
    mission_random(&mission, &random, size);
    mission.rule = QTR_RULE_FREE;
    begin();
    for (unsigned i = 0; i < TRIES; i++) try_a_route(&random);
  }
}

static void test_the_same_under_each_term_that_is_told_of(void) {
#if QTR_TERMS
  unsigned told = 0;
  for (unsigned feature = 0; feature < TERMS_FEATURES; feature++) {
    for (unsigned seed = 1; seed <= random_cases(GAMES); seed++) {
      terms_game_make(&mission, seed, 1u << feature);
      test_random random = {seed};
      begin();
      if (!qtr_pieces_tell(&game)) continue;
      told |= 1u << feature;
      for (unsigned i = 0; i < TRIES; i++) try_a_route(&random);
    }
  }
  const unsigned untold = TERMS_ENDURANCE | TERMS_DEADLINE | TERMS_HOME;
  TEST_ASSERT_EQUAL_HEX(TERMS_ANY & ~untold, told & ~untold);
#else
  TEST_IGNORE_MESSAGE("built without terms");
#endif
}

int main(void) {
  UNITY_BEGIN();
  RUN_TEST(test_a_route_of_pieces_is_worth_what_following_it_says);
  RUN_TEST(test_the_same_under_each_term_that_is_told_of);
  return UNITY_END();
}
