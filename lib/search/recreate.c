#include "search/recreate.h"

#include <math.h>
#include <string.h>

#include "model/rounding.h"
#include "quarter/random.h"
#include "quarter/status.h"
#include "robot/board.h"
#include "search/route.h"

/* Of 10, 15, 20, 30 and 40 places, and 2 to 32 times the heat, these did best on 50 to 128 places and 1 to 8 robots. */
#define REMOVED 30     /* places of a string at most; and of a ruin, but where its strings are many and short */
#define BLINK_MEAN 100 /* of so many positions one is passed over */
#define STAGES 44      /* of a run, each cooler than the one before */
#define COOLING 0.9    /* 0.01 over all of them */
#define HOT 16.0

static unsigned draw(qtr_recreation *r, unsigned below) {
  return qtr_lcg_below(&r->random, below);
}

/* ---- ruin ---- */

static unsigned average_length(const qtr_recreation *r, unsigned *placed) {
  const qtr_schedule *s = &r->trial;
  unsigned routes = 0;
  *placed = 0;
  for (unsigned i = 0; i < qtr_routes_count(s->game); i++) {
    *placed += s->routes.length[i];
    routes += s->routes.length[i] > 0;
  }
  return routes > 0 ? *placed / routes : 0;
}

/* The number of a place on its route. That of what nobody visits has no times, nor numbers kept. */
static unsigned number_of(const qtr_schedule *s, uint16_t place) {
  const unsigned route = s->route_of[place];
  unsigned at = 0;
  if (route < s->game->board.seekers) return s->at[place];
  while (s->routes.place[route][at] != place) at++;
  return at;
}

static void take_out(qtr_recreation *r, unsigned route, unsigned from, unsigned count) {
  for (unsigned i = 0; i < count; i++) r->removed[r->count++] = r->trial.routes.place[route][from + i];
  qtr_schedule_remove(&r->trial, route, from, count);
  r->touched[route] = true;
}

/* Take out a string of so many places with this one among them; now and then one of a place more, which leaves some
 * place within it where it is. */
static void remove_string(qtr_recreation *r, uint16_t place, unsigned count) {
  const unsigned route = r->trial.route_of[place];
  const unsigned length = r->trial.routes.length[route];
  const unsigned at = number_of(&r->trial, place);
  const bool split = count > 1 && count < length && draw(r, 2) == 0;
  const unsigned span = split ? count + 1 : count;
  const unsigned first = at + 1 > span ? at + 1 - span : 0;
  const unsigned last = at < length - span ? at : length - span;
  const unsigned from = first + draw(r, last - first + 1);
  if (!split) {
    take_out(r, route, from, span);
    return;
  }
  const unsigned kept = 1 + draw(r, count - 1);
  take_out(r, route, from + kept + 1, count - kept);
  take_out(r, route, from, kept);
}

static bool is_whole(const qtr_schedule *s, uint16_t place, const bool *ruined) {
  return s->route_of[place] != QTR_NO_ROUTE && !ruined[s->route_of[place]];
}

/* The first of those near `seed` that is on a route that has not been ruined; QTR_STAND_DOWN: none is, or it is not
 * known who is near. */
static uint16_t first_near(const qtr_recreation *r, uint16_t seed, const bool *ruined) {
  for (unsigned i = 0; qtr_vicinity_in_use(r->vicinity) && i < QTR_VICINITY; i++)
    if (is_whole(&r->trial, r->vicinity->near[seed][i], ruined)) return r->vicinity->near[seed][i];
  return QTR_STAND_DOWN;
}

/* The place nearest to `seed` on a route that has not been ruined, as its own seeker goes; the seed itself first. */
static uint16_t nearest(const qtr_recreation *r, uint16_t seed, const bool *ruined) {
  const qtr_schedule *s = &r->trial;
  const uint16_t near = first_near(r, seed, ruined);
  if (near != QTR_STAND_DOWN) return near;
  uint16_t found = QTR_STAND_DOWN;
  qtr_steps least = QTR_NEVER;
  for (uint16_t place = 0; place < s->game->board.places; place++) {
    const unsigned route = s->route_of[place];
    if (!is_whole(s, place, ruined)) continue;
    const unsigned seeker = route < s->game->board.seekers ? route : 0;
    const qtr_steps steps = qtr_steps_between(&s->game->board, seeker, seed, place);
    if (steps >= least && found != QTR_STAND_DOWN) continue;
    least = steps;
    found = place;
  }
  return found;
}

static uint16_t draw_placed(qtr_recreation *r, unsigned placed) {
  unsigned i = draw(r, placed);
  for (uint16_t place = 0;; place++)
    if (r->trial.route_of[place] != QTR_NO_ROUTE && i-- == 0) return place;
}

/* Where fewer routes are than strings, each is ruined again. */
static uint16_t next_to_ruin(const qtr_recreation *r, uint16_t seed, bool *ruined) {
  const uint16_t place = nearest(r, seed, ruined);
  if (place != QTR_STAND_DOWN) return place;
  memset(ruined, 0, QTR_MAX_ROUTES * sizeof *ruined);
  return nearest(r, seed, ruined);
}

/* As many strings as make some REMOVED / 2 places on average, each of a route of its own, near a place drawn. */
static void ruin(qtr_recreation *r) {
  unsigned placed;
  const unsigned average = average_length(r, &placed);
  const unsigned longest = average < REMOVED ? average : REMOVED;
  const unsigned most = 4 * REMOVED / (1 + longest) - 1;
  bool ruined[QTR_MAX_ROUTES] = {false};
  const uint16_t seed = draw_placed(r, placed);
  uint16_t place = seed;
  r->count = 0;
  for (unsigned strings = 1 + draw(r, most); strings > 0 && place != QTR_STAND_DOWN; strings--) {
    const unsigned route = r->trial.route_of[place];
    const unsigned length = r->trial.routes.length[route];
    ruined[route] = true;
    remove_string(r, place, 1 + draw(r, length < longest ? length : longest));
    place = next_to_ruin(r, seed, ruined);
  }
}

/* ---- recreate ---- */

enum order { BY_CHANCE, LIKELIEST, FARTHEST, NEAREST };

static double order_of(qtr_recreation *r, enum order order, uint16_t place) {
  const qtr_game *game = r->trial.game;
  const double away = (double)qtr_board_steps(&game->board, 0, game->board.places, place);
  switch (order) {
  case BY_CHANCE: return (double)draw(r, 1u << 20);
  case LIKELIEST: return -game->probability[place];
  case FARTHEST: return -away;
  default: return away;
  }
}

/* How often which, as the paper has it. */
static void set_order(qtr_recreation *r) {
  static const uint8_t orders[] = {BY_CHANCE, BY_CHANCE, BY_CHANCE, BY_CHANCE, LIKELIEST, LIKELIEST,
                                   LIKELIEST, LIKELIEST, FARTHEST,  FARTHEST,  NEAREST};
  const enum order order = (enum order)orders[draw(r, sizeof orders)];
  for (unsigned i = 0; i < r->count; i++) r->order[i] = order_of(r, order, r->removed[i]);
}

static void sort_removed(qtr_recreation *r) {
  set_order(r);
  for (unsigned i = 1; i < r->count; i++) {
    const uint16_t place = r->removed[i];
    const double order = r->order[i];
    unsigned at = i;
    for (; at > 0 && r->order[at - 1] > order; at--) {
      r->order[at] = r->order[at - 1];
      r->removed[at] = r->removed[at - 1];
    }
    r->order[at] = order;
    r->removed[at] = place;
  }
}

static bool blinks(qtr_recreation *r) {
  if (--r->positions_to_blink > 0) return false;
  r->positions_to_blink = 1 + draw(r, 2 * BLINK_MEAN - 1);
  return true;
}

static void try_insertion(qtr_recreation *r, uint16_t place, unsigned route, unsigned at, qtr_insertion *best) {
  if (blinks(r)) return;
  const double gain = qtr_schedule_try(&r->trial, route, at, place);
  if (gain > best->gain) *best = (qtr_insertion){gain, route, at};
}

/* Everywhere on a route, but for the positions passed over. */
static void try_route(qtr_recreation *r, uint16_t place, unsigned route, qtr_insertion *best) {
  const unsigned end = r->trial.routes.length[route] + 1u;
  unsigned at = 0;
  while (at + r->positions_to_blink <= end) {
    const unsigned passed = at + r->positions_to_blink - 1;
    qtr_schedule_find(&r->trial, route, at, passed, place, best);
    r->positions_to_blink = 1;
    blinks(r);
    at = passed + 1;
  }
  qtr_schedule_find(&r->trial, route, at, end, place, best);
  r->positions_to_blink -= end - at;
}

/* Before and behind each place that is near, and first on each route. */
static qtr_insertion find_near_insertion(qtr_recreation *r, uint16_t place) {
  const qtr_schedule *s = &r->trial;
  const unsigned seekers = s->game->board.seekers;
  qtr_insertion best = {-HUGE_VAL, 0, 0};
  for (unsigned route = 0; route < seekers; route++) try_insertion(r, place, route, 0, &best);
  for (unsigned i = 0; i < QTR_VICINITY; i++) {
    const uint16_t near = r->vicinity->near[place][i];
    const unsigned route = s->route_of[near];
    if (route >= seekers) continue;
    if (s->at[near] > 0) try_insertion(r, place, route, s->at[near], &best);
    try_insertion(r, place, route, s->at[near] + 1u, &best);
  }
  return best;
}

static qtr_insertion find_insertion(qtr_recreation *r, uint16_t place) {
  const qtr_schedule *s = &r->trial;
  qtr_insertion best = {-HUGE_VAL, 0, 0};
  if (qtr_vicinity_in_use(r->vicinity)) best = find_near_insertion(r, place);
  if (best.gain != -HUGE_VAL) return best;
  for (unsigned route = 0; route < s->game->board.seekers; route++) try_route(r, place, route, &best);
  return best;
}

/* Where places may be left out, one that nobody gains by visiting is. */
static void leave_out_at_a_loss(const qtr_schedule *s, qtr_insertion *best) {
  const unsigned seekers = s->game->board.seekers;
  if (qtr_routes_count(s->game) > seekers && best->gain < 0.0)
    *best = (qtr_insertion){0.0, seekers, s->routes.length[seekers]};
}

/* False: some place found nowhere to go. */
static bool recreate(qtr_recreation *r) {
  sort_removed(r);
  for (unsigned i = 0; i < r->count; i++) {
    qtr_insertion best = find_insertion(r, r->removed[i]);
    leave_out_at_a_loss(&r->trial, &best);
    if (best.gain == -HUGE_VAL) return false;
    qtr_schedule_insert(&r->trial, best.route, best.at, r->removed[i]);
    r->touched[best.route] = true;
  }
  return true;
}

/* ---- annealing ---- */

/* Exponentially distributed with mean 1, nearly: the tosses until a coin shows heads, and a fraction, in place of the
 * logarithm, which differs between C libraries. */
static double draw_exponential(qtr_recreation *r) {
  double tosses = 0.0;
  while (draw(r, 2) == 0) tosses += 1.0;
  return 0.6931471805599453 * (tosses + (double)draw(r, 1u << 20) / (double)(1u << 20));
}

static qtr_route_score evaluate(qtr_recreation *r) {
  qtr_routes *routes = &r->trial.routes;
  qtr_route_score sum = {0.0, 0.0};
  for (unsigned i = 0; i < qtr_routes_count(r->trial.game); i++) {
    if (r->touched[i]) routes->score[i] = qtr_route_evaluate(r->trial.game, i, routes->place[i], routes->length[i]);
    sum = qtr_route_sum(sum, routes->score[i]);
  }
  return sum;
}

static qtr_route_score sum_all(const qtr_game *game, const qtr_routes *routes) {
  qtr_route_score sum = {0.0, 0.0};
  for (unsigned i = 0; i < qtr_routes_count(game); i++) sum = qtr_route_sum(sum, routes->score[i]);
  return sum;
}

static void copy_route(qtr_routes *to, const qtr_routes *from, unsigned i) {
  memcpy(to->place[i], from->place[i], from->length[i] * sizeof from->place[i][0]);
  to->length[i] = from->length[i];
  to->score[i] = from->score[i];
}

static void keep(qtr_recreation *r) {
  for (unsigned i = 0; i < qtr_routes_count(r->trial.game); i++)
    if (r->touched[i]) copy_route(&r->now, &r->trial.routes, i);
}

static void undo(qtr_recreation *r) {
  for (unsigned i = 0; i < qtr_routes_count(r->trial.game); i++)
    if (r->touched[i]) qtr_schedule_set(&r->trial, i, &r->now);
}

static void note_best(qtr_recreation *r, qtr_route_score score) {
  if (!qtr_route_is_better(score, sum_all(r->trial.game, &r->best))) return;
  for (unsigned i = 0; i < qtr_routes_count(r->trial.game); i++) copy_route(&r->best, &r->now, i);
  r->found = true;
}

static void try_one(qtr_recreation *r) {
  const qtr_game *game = r->trial.game;
  memset(r->touched, 0, sizeof r->touched);
  ruin(r);
  const bool whole = recreate(r);
  const qtr_route_score score = evaluate(r);
  if (!whole || score.worth <= sum_all(game, &r->now).worth - r->temperature * draw_exponential(r)) {
    undo(r);
    return;
  }
  keep(r);
  note_best(r, score);
}

/* What a visit loses on average that comes later by an eighth of its time, times HOT: games that differ by what two
 * late places lose are all alike at first. */
static double hot(const qtr_schedule *s) {
  double loss = 0.0;
  unsigned placed = 0;
  for (uint16_t place = 0; place < s->game->board.places; place++) {
    if (s->route_of[place] >= s->game->board.seekers) continue;
    const qtr_steps when = s->when[place];
    loss += qtr_game_worth(s->game, place, when) - qtr_game_worth(s->game, place, when + when / 8 + 1);
    placed++;
  }
  return placed > 0 ? HOT * loss / (double)placed : 0.0;
}

void qtr_recreation_begin(qtr_recreation *r, const qtr_game *game, const qtr_vicinity *vicinity,
                          const qtr_routes *routes, uint32_t rounds, uint64_t seed) {
  r->vicinity = vicinity;
  qtr_schedule_begin(&r->trial, game, routes);
  r->now = r->trial.routes;
  r->best = r->trial.routes;
  r->random = seed * 0x9E3779B97F4A7C15u + 1u;
  r->positions_to_blink = BLINK_MEAN;
  r->temperature = hot(&r->trial);
  r->rounds = rounds;
  r->round = 0;
  r->found = false;
}

void qtr_recreation_adopt(qtr_recreation *r, const qtr_routes *routes) {
  qtr_schedule_begin(&r->trial, r->trial.game, routes);
  r->now = r->trial.routes;
  note_best(r, sum_all(r->trial.game, &r->now));
}

bool qtr_recreation_is_over(const qtr_recreation *r) {
  return r->round >= r->rounds;
}

void qtr_recreation_go_on(qtr_recreation *r, uint32_t rounds) {
  const uint32_t stage = r->rounds / STAGES + 1;
  for (uint32_t i = 0; i < rounds && !qtr_recreation_is_over(r); i++) {
    if (!qtr_watch_go_on(&r->trial.game->mission->watch)) return;
    try_one(r);
    if (++r->round % stage == 0) r->temperature *= COOLING;
  }
}
