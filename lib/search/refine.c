#include "search/refine.h"

#include <math.h>
#include <string.h>

#include "model/rounding.h"
#include "quarter/random.h"
#include "quarter/status.h"
#include "search/route.h"

#define SEGMENT_MOST 3 /* places that are moved together */
#define WORTHLESS (-1e300)
#define PIECES_ROUNDING 1e-9 /* relative: far more than sums of pieces are wrong by */
#define SHAKES_MOST 3        /* random moves in a round */

static inline bool is_told(const qtr_refinery *r) {
  return QTR_RECREATES && r->told;
}

static void set_route(qtr_refinery *r, qtr_routes *routes, unsigned seeker, const uint16_t *places, unsigned length,
                      qtr_route_score score) {
  memcpy(routes->place[seeker], places, length * sizeof *places);
  routes->length[seeker] = (uint16_t)length;
  routes->score[seeker] = score;
  if (is_told(r)) qtr_pieces_refresh(&r->pieces, seeker);
}

/* ---- who may come beside whom ---- */

void qtr_refine_begin(qtr_refinery *r, const qtr_vicinity *vicinity) {
#if QTR_VICINITY_PLACES > 1
  r->vicinity = vicinity;
#else
  (void)r;
  (void)vicinity;
#endif
}

static inline bool goes_by_vicinity(const qtr_refinery *r) {
#if QTR_VICINITY_PLACES > 1
  return r->vicinity != NULL && qtr_vicinity_in_use(r->vicinity);
#else
  (void)r;
  return false;
#endif
}

#if QTR_VICINITY_PLACES > 1

/* Whether the place before `at` on one route may come right before the one at `next` on another. A start is near all
 * places, the end of a route none. */
static bool may_join(const qtr_refinery *r, const uint16_t *route, unsigned at, const uint16_t *other, unsigned length,
                     unsigned next) {
  if (next >= length) return false;
  return at == 0 || qtr_vicinity_has(r->vicinity, route[at - 1], other[next]);
}

/* Any of the joints that an exchange makes, as of try_exchange(). */
static bool exchange_is_near(const qtr_refinery *r, const qtr_routes *routes, unsigned first, unsigned from,
                             unsigned count, unsigned second, unsigned at, unsigned other) {
  const uint16_t *x = routes->place[first], *y = routes->place[second];
  const unsigned in_x = routes->length[first], in_y = routes->length[second];
  if (!goes_by_vicinity(r)) return true;
  return may_join(r, y, at, x, in_x, from) || (other > 0 && may_join(r, x, from, y, in_y, at)) ||
         (count > 0 && may_join(r, x, from + count, y, in_y, at + other)) ||
         (other > 0 && may_join(r, y, at + other, x, in_x, from + count));
}

/* Either end of a run that is to come where `at` others come before it: `to` is the place behind it then. */
static bool shift_is_near(const qtr_refinery *r, const qtr_routes *routes, unsigned seeker, unsigned from,
                          unsigned count, unsigned at) {
  const uint16_t *x = routes->place[seeker];
  const unsigned to = at < from ? at : at + count;
  if (!goes_by_vicinity(r)) return true;
  return may_join(r, x, to, x, routes->length[seeker], from) ||
         may_join(r, x, from + count, x, routes->length[seeker], to);
}

static bool reverse_is_near(const qtr_refinery *r, const qtr_routes *routes, unsigned seeker, unsigned from,
                            unsigned to) {
  const uint16_t *x = routes->place[seeker];
  if (!goes_by_vicinity(r)) return true;
  return may_join(r, x, from, x, routes->length[seeker], to - 1) ||
         (to < routes->length[seeker] && qtr_vicinity_has(r->vicinity, x[from], x[to]));
}

#else

#define exchange_is_near(r, routes, first, from, count, second, at, other) true
#define shift_is_near(r, routes, seeker, from, count, at) true
#define reverse_is_near(r, routes, seeker, from, to) true

#endif

/* ---- what a move would bring, told from pieces: whether it is worth following the routes that it makes ---- */

/* As close to a gain as what the sums are wrong by. */
static bool is_promising(double after, double before) {
  return after >= before - PIECES_ROUNDING * fabs(before);
}

static bool reverse_is_promising(const qtr_refinery *r, const qtr_routes *routes, unsigned seeker, unsigned from,
                                 unsigned to, qtr_piece reversed) {
  const qtr_pieces *p = &r->pieces;
  qtr_piece all = qtr_pieces_join(p, seeker, qtr_pieces_of(p, seeker, 0, from), reversed);
  all = qtr_pieces_join(p, seeker, all, qtr_pieces_of(p, seeker, to, routes->length[seeker]));
  return is_promising(qtr_pieces_worth(p, seeker, all), routes->score[seeker].worth);
}

/* Two pieces of one route that change places: from..middle-1 and middle..to-1. */
static bool swap_is_promising(const qtr_refinery *r, const qtr_routes *routes, unsigned seeker, unsigned from,
                              unsigned middle, unsigned to) {
  const qtr_pieces *p = &r->pieces;
  qtr_piece all = qtr_pieces_join(p, seeker, qtr_pieces_of(p, seeker, 0, from), qtr_pieces_of(p, seeker, middle, to));
  all = qtr_pieces_join(p, seeker, all, qtr_pieces_of(p, seeker, from, middle));
  all = qtr_pieces_join(p, seeker, all, qtr_pieces_of(p, seeker, to, routes->length[seeker]));
  return is_promising(qtr_pieces_worth(p, seeker, all), routes->score[seeker].worth);
}

/* What a seeker's route is worth with `piece` in place of from..to-1. */
static double worth_with(const qtr_refinery *r, const qtr_routes *routes, unsigned seeker, unsigned from, unsigned to,
                         qtr_piece piece) {
  const qtr_pieces *p = &r->pieces;
  qtr_piece all = qtr_pieces_join(p, seeker, qtr_pieces_of(p, seeker, 0, from), piece);
  all = qtr_pieces_join(p, seeker, all, qtr_pieces_of(p, seeker, to, routes->length[seeker]));
  return qtr_pieces_worth(p, seeker, all);
}

static bool exchange_is_promising(const qtr_refinery *r, const qtr_routes *routes, unsigned first, unsigned from,
                                  unsigned count, unsigned second, unsigned at, unsigned other) {
  const qtr_pieces *p = &r->pieces;
  if (!qtr_pieces_fit(p->game, first, second)) return true;
  const double a = worth_with(r, routes, first, from, from + count, qtr_pieces_of(p, second, at, at + other));
  const double b = worth_with(r, routes, second, at, at + other, qtr_pieces_of(p, first, from, from + count));
  return is_promising(a + b, routes->score[first].worth + routes->score[second].worth);
}

/* ---- moves: each is tried in the refinery's scratch and kept if it betters the sum ---- */

static unsigned append(uint16_t *route, unsigned length, const uint16_t *places, unsigned count) {
  for (unsigned i = 0; i < count; i++) route[length + i] = places[i];
  return length + count;
}

static unsigned append_reversed(uint16_t *route, unsigned length, const uint16_t *places, unsigned count) {
  for (unsigned i = 0; i < count; i++) route[length + i] = places[count - 1 - i];
  return length + count;
}

/* A move within a route leaves the other ones as they are, so its own score decides. */
static bool keep_one(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned seeker, unsigned length) {
  const qtr_route_score score = qtr_route_evaluate(game, seeker, r->a, length);
  if (!qtr_route_is_better(score, routes->score[seeker])) return false;
  set_route(r, routes, seeker, r->a, length, score);
  return true;
}

static bool keep_two(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned first, unsigned first_length,
                     unsigned second, unsigned second_length) {
  const qtr_route_score one = qtr_route_evaluate(game, first, r->a, first_length);
  const qtr_route_score other = qtr_route_evaluate(game, second, r->b, second_length);
  const qtr_route_score before = qtr_route_sum(routes->score[first], routes->score[second]);
  /* Neither route may lose, for what one loses may be too little for the sum to show. */
  const bool none_loses = one.worth >= routes->score[first].worth && other.worth >= routes->score[second].worth;
  if (!qtr_route_is_worth_more(qtr_route_sum(one, other), before) &&
      !(none_loses && qtr_route_is_sooner(qtr_route_sum(one, other), before)))
    return false;
  set_route(r, routes, first, r->a, first_length, one);
  set_route(r, routes, second, r->b, second_length, other);
  return true;
}

/* Turn the places from..to-1 of a route round. */
static bool try_reverse(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned seeker, unsigned from,
                        unsigned to) {
  const uint16_t *route = routes->place[seeker];
  unsigned length = append(r->a, 0, route, from);
  length = append_reversed(r->a, length, route + from, to - from);
  length = append(r->a, length, route + to, routes->length[seeker] - to);
  return keep_one(r, routes, game, seeker, length);
}

/* Move `count` places at `from` to where `at` others of the same route come before them. */
static bool try_shift(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned seeker, unsigned from,
                      unsigned count, unsigned at) {
  const uint16_t *route = routes->place[seeker];
  const unsigned least = at < from ? at : from;
  const unsigned most = at < from ? from + count : at + count;
  if (!shift_is_near(r, routes, seeker, from, count, at)) return false;
  if (is_told(r) && !swap_is_promising(r, routes, seeker, least, at < from ? from : from + count, most)) return false;
  uint16_t *rest = r->b;
  unsigned left = append(rest, 0, route, from);
  left = append(rest, left, route + from + count, routes->length[seeker] - from - count);
  unsigned length = append(r->a, 0, rest, at);
  length = append(r->a, length, route + from, count);
  length = append(r->a, length, rest + at, left - at);
  return keep_one(r, routes, game, seeker, length);
}

/* Exchange the places from..from+count-1 of one route for at..at+other-1 of another. With other = 0 they move over;
 * with both up to the ends the tails change hands. */
static bool try_exchange(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned first, unsigned from,
                         unsigned count, unsigned second, unsigned at, unsigned other) {
  if (!exchange_is_near(r, routes, first, from, count, second, at, other)) return false;
  if (is_told(r) && !exchange_is_promising(r, routes, first, from, count, second, at, other)) return false;
  const uint16_t *x = routes->place[first];
  const uint16_t *y = routes->place[second];
  unsigned a = append(r->a, 0, x, from);
  a = append(r->a, a, y + at, other);
  a = append(r->a, a, x + from + count, routes->length[first] - from - count);
  unsigned b = append(r->b, 0, y, at);
  b = append(r->b, b, x + from, count);
  b = append(r->b, b, y + at + other, routes->length[second] - at - other);
  return keep_two(r, routes, game, first, a, second, b);
}

/* ---- neighbourhoods: true if something was bettered; when stopped, nothing more is ---- */

static bool may_go_on(const qtr_game *game) {
  return qtr_watch_go_on(&game->mission->watch);
}

/* Or-opt: short runs of places elsewhere into the same route, in their order. */
static bool search_shifts(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned seeker) {
  const unsigned length = routes->length[seeker];
  for (unsigned count = 1; count <= SEGMENT_MOST && count < length; count++)
    for (unsigned from = 0; from + count <= length && may_go_on(game); from++)
      for (unsigned at = 0; at + count <= length; at++)
        if (at != from && try_shift(r, routes, game, seeker, from, count, at)) return true;
  return false;
}

/* Ways differ by direction on terrain: what is turned round is put together anew, place by place. */
static bool search_reversals_from(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned seeker,
                                  unsigned from) {
  const uint16_t *route = routes->place[seeker];
  qtr_piece reversed = is_told(r) ? qtr_pieces_single(&r->pieces, route[from]) : (qtr_piece){0};
  for (unsigned to = from + 2; to <= routes->length[seeker]; to++) {
    if (is_told(r))
      reversed = qtr_pieces_join(&r->pieces, seeker, qtr_pieces_single(&r->pieces, route[to - 1]), reversed);
    if (!reverse_is_near(r, routes, seeker, from, to)) continue;
    if (is_told(r) && !reverse_is_promising(r, routes, seeker, from, to, reversed)) continue;
    if (try_reverse(r, routes, game, seeker, from, to)) return true;
  }
  return false;
}

/* 2-opt. */
static bool search_reversals(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned seeker) {
  for (unsigned from = 0; from + 1 < routes->length[seeker] && may_go_on(game); from++)
    if (search_reversals_from(r, routes, game, seeker, from)) return true;
  return false;
}

/* A run of places for nothing or for one place: with runs on both sides there would be three times as many tries. */
static bool search_exchanges_of(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned first,
                                unsigned from, unsigned count, unsigned second) {
  for (unsigned at = 0; at <= routes->length[second]; at++)
    for (unsigned other = 0; other <= 1 && at + other <= routes->length[second]; other++)
      if (try_exchange(r, routes, game, first, from, count, second, at, other)) return true;
  return false;
}

static bool search_exchanges(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned first,
                             unsigned second) {
  for (unsigned count = 1; count <= SEGMENT_MOST; count++)
    for (unsigned from = 0; from + count <= routes->length[first] && may_go_on(game); from++)
      if (search_exchanges_of(r, routes, game, first, from, count, second)) return true;
  return false;
}

/* 2-opt*: all that comes after a point in one route for all after a point in another one. */
static bool search_tails(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned first, unsigned second) {
  for (unsigned from = 0; from <= routes->length[first] && may_go_on(game); from++)
    for (unsigned at = 0; at <= routes->length[second]; at++)
      if (try_exchange(r, routes, game, first, from, routes->length[first] - from, second, at,
                       routes->length[second] - at))
        return true;
  return false;
}

/* Whose places go over matters where a run is given for another one, so those pairs come in both orders; tails are
 * traded. */
static bool search_pair(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned first, unsigned second) {
  if (first == second) return search_shifts(r, routes, game, first) || search_reversals(r, routes, game, first);
  return search_exchanges(r, routes, game, first, second) ||
         (first < second && search_tails(r, routes, game, first, second));
}

/* The first move found that betters is made. A local optimum of all these neighbourhoods at once is left only by
 * shaking. */
static void descend(qtr_refinery *r, qtr_routes *routes, const qtr_game *game) {
  const unsigned count = qtr_routes_count(game);
  unsigned settled = 0;
  /* Round the pairs of routes until each has been seen since the last gain. */
  for (unsigned pair = 0; settled < count * count; pair = (pair + 1) % (count * count)) {
    settled++;
    while (search_pair(r, routes, game, pair / count, pair % count)) settled = 0;
  }
}

/* ---- shaking ---- */

static unsigned draw(qtr_refinery *r, unsigned below) {
  return qtr_lcg_below(&r->random, below);
}

/* Take a few places out of one route and put them somewhere into another, better or not: against the score of a
 * worthless route every move is a gain. */
static void shake(qtr_refinery *r, qtr_routes *routes, const qtr_game *game) {
  const unsigned count_of_routes = qtr_routes_count(game);
  const unsigned first = draw(r, count_of_routes);
  const unsigned second = draw(r, count_of_routes);
  const unsigned length = routes->length[first];
  if (length == 0) return;
  const unsigned from = draw(r, length);
  const unsigned most = length - from < SEGMENT_MOST ? length - from : SEGMENT_MOST;
  const unsigned count = 1 + draw(r, most);
  routes->score[first].worth = WORTHLESS;
  if (first == second) {
    try_shift(r, routes, game, first, from, count, draw(r, length - count + 1));
  } else {
    try_exchange(r, routes, game, first, from, count, second, draw(r, routes->length[second] + 1u), 0);
  }
  routes->score[first] = qtr_route_evaluate(game, first, routes->place[first], routes->length[first]);
}

static qtr_route_score evaluate_all(qtr_routes *routes, const qtr_game *game) {
  qtr_route_score sum = {0.0, 0.0};
  for (unsigned seeker = 0; seeker < qtr_routes_count(game); seeker++) {
    routes->score[seeker] = qtr_route_evaluate(game, seeker, routes->place[seeker], routes->length[seeker]);
    sum = qtr_route_sum(sum, routes->score[seeker]);
  }
  return sum;
}

/* What it tells is of routes that can be followed. */
static void begin_pieces(qtr_refinery *r, const qtr_routes *routes, const qtr_game *game, bool possible) {
  r->told = possible && qtr_pieces_tell(game);
  r->pieces.game = game;
  r->pieces.routes = routes;
}

static void refresh_pieces(qtr_refinery *r, const qtr_game *game) {
  for (unsigned seeker = 0; is_told(r) && seeker < game->board.seekers; seeker++)
    qtr_pieces_refresh(&r->pieces, seeker);
}

/* Iterated local search: shake the best routes, descend, keep what is better. The learner's proof has no use for where
 * its first game came from, so nothing here needs to be optimal. */
void qtr_refine(qtr_refinery *r, qtr_routes *routes, const qtr_game *game, unsigned rounds, uint64_t seed) {
  r->random = seed * 0x9E3779B97F4A7C15u + 1u;
  /* Moves take places from route to route: what is no division at first never becomes one. */
  QTR_ASSERT(qtr_routes_are_division(routes, qtr_routes_count(game)));
  const qtr_route_score given = evaluate_all(routes, game);
  begin_pieces(r, routes, game, given.worth > -HUGE_VAL);
  refresh_pieces(r, game);
  descend(r, routes, game);
  qtr_route_score best = evaluate_all(routes, game);
  /* Each move that is kept betters the sum. */
  QTR_ASSERT(!qtr_route_is_worth_more(given, best));
  r->best = *routes;
  for (unsigned round = 0; round < rounds && may_go_on(game); round++) {
    for (unsigned shakes = 1 + draw(r, SHAKES_MOST); shakes > 0; shakes--) shake(r, routes, game);
    descend(r, routes, game);
    const qtr_route_score score = evaluate_all(routes, game);
    if (qtr_route_is_better(score, best)) {
      best = score;
      r->best = *routes;
    } else {
      *routes = r->best;
      refresh_pieces(r, game);
    }
  }
}
