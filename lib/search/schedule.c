#include "search/schedule.h"

#include <math.h>
#include <string.h>

#include "model/rounding.h"
#include "robot/board.h"
#include "search/route.h"

#define GAME_STEP_BYTES 4u /* of a game's times, which a table's need not have */

static bool is_a_seekers(const qtr_schedule *s, unsigned route) {
  return route < s->game->board.seekers;
}

static bool has_end(const qtr_schedule *s) {
  return QTR_TERMS && s->game->board.terms.end != NULL;
}

/* ---- times ---- */

/* What one visit has at stake: what a delay costs is in proportion to it. */
static double at_stake(const qtr_schedule *s, uint16_t place) {
  if (s->game->objective.kind == QTR_TIME) return s->game->probability[place];
  return qtr_game_worth(s->game, place, s->when[place]);
}

static void time_visits(qtr_schedule *s, unsigned route) {
  const qtr_board *board = &s->game->board;
  unsigned node = (unsigned)board->places + board->start_of[route];
  qtr_steps now = qtr_board_ready(board, route);
  for (unsigned i = 0; i < s->routes.length[route]; i++) {
    const uint16_t place = s->routes.place[route][i];
    now += qtr_steps_between(board, route, node, place);
    s->when[place] = now;
    s->at[place] = (uint16_t)i;
    node = place;
  }
}

static void sum_up_behind(qtr_schedule *s, unsigned route) {
  double behind = s->game->objective.terms.home_weight;
  for (unsigned i = s->routes.length[route]; i-- > 0;) {
    const uint16_t place = s->routes.place[route][i];
    behind += at_stake(s, place);
    s->behind[place] = behind;
  }
}

static void find_spare(qtr_schedule *s, unsigned route) {
  const qtr_steps end = qtr_board_end(&s->game->board, route);
  qtr_steps spare = QTR_NEVER;
  for (unsigned i = s->routes.length[route]; i-- > 0 && end != QTR_NEVER;) {
    const uint16_t place = s->routes.place[route][i];
    const qtr_steps left = end - s->when[place] - qtr_board_home(&s->game->board, route, place);
    if (left < spare) spare = left;
    s->spare[place] = spare;
  }
}

static void refresh(qtr_schedule *s, unsigned route) {
  if (!is_a_seekers(s, route)) return;
  time_visits(s, route);
  sum_up_behind(s, route);
  if (has_end(s)) find_spare(s, route);
}

/* ---- insertions ---- */

/* A visit that is tried. */
typedef struct {
  unsigned route, at;
  uint16_t place;
  unsigned before; /* the node that the seeker comes from, and when it leaves that */
  qtr_steps left;
  qtr_steps when;
} visit;

static double loss_one_by_one(const qtr_schedule *s, unsigned route, unsigned at, int64_t delay) {
  double loss = (double)delay * s->game->objective.terms.home_weight;
  for (unsigned i = at; i < s->routes.length[route]; i++) {
    const uint16_t place = s->routes.place[route][i];
    const qtr_steps when = s->when[place];
    loss += qtr_game_worth(s->game, place, when) - qtr_game_worth(s->game, place, (qtr_steps)((int64_t)when + delay));
  }
  return loss;
}

static inline double worth_of_kind(const qtr_schedule *s, uint8_t kind, uint16_t place, qtr_steps when) {
  if (kind == QTR_TIME) return s->game->probability[place] * (s->game->objective.time_end - (double)when);
  return qtr_game_worth(s->game, place, when);
}

/* What it costs that the places from `at` on are visited so much later. A visit at step 0 counts as at step 1, so the
 * first step of a delay costs it nothing. */
static inline double loss_of_kind(const qtr_schedule *s, uint8_t kind, unsigned route, unsigned at, int64_t delay) {
  const uint16_t next = s->routes.place[route][at];
  if (kind == QTR_TIME) return (double)delay * s->behind[next];
  if (kind == QTR_DISCOUNTED && delay >= 0 && s->when[next] > 0)
    return s->behind[next] * (1.0 - qtr_objective_power(&s->game->objective, (qtr_steps)delay));
  return loss_one_by_one(s, route, at, delay);
}

static bool is_home_in_time(const qtr_schedule *s, const visit *v) {
  const qtr_steps end = qtr_board_end(&s->game->board, v->route);
  return end == QTR_NEVER || (uint64_t)v->when + qtr_board_home(&s->game->board, v->route, v->place) <= end;
}

/* Whether those behind can be visited so much later; without an end of its own a seeker always can. */
static bool can_wait(const qtr_schedule *s, const visit *v, int64_t delay) {
  const uint16_t next = s->routes.place[v->route][v->at];
  return qtr_board_end(&s->game->board, v->route) == QTR_NEVER || delay <= (int64_t)s->spare[next];
}

/* At the end of a route the way home is another one. */
static inline double loss_at_end(const qtr_schedule *s, const visit *v) {
  if (s->game->objective.terms.home_weight == 0.0) return 0.0;
  return qtr_objective_leave(&s->game->objective, v->left + qtr_game_way_home(s->game, v->route, v->before)) -
         qtr_objective_leave(&s->game->objective, v->when + qtr_game_way_home(s->game, v->route, v->place));
}

static inline double loss_before_another(const qtr_schedule *s, const visit *v) {
  const uint16_t next = s->routes.place[v->route][v->at];
  const qtr_steps on = qtr_steps_between(&s->game->board, v->route, v->place, next);
  if (on == QTR_NEVER) return HUGE_VAL;
  const int64_t delay = (int64_t)v->when + on - (int64_t)s->when[next];
  if (has_end(s) && !can_wait(s, v, delay)) return HUGE_VAL;
  return loss_of_kind(s, s->game->objective.kind, v->route, v->at, delay);
}

static inline double gain_at(const qtr_schedule *s, unsigned route, unsigned at, uint16_t place) {
  const qtr_board *board = &s->game->board;
  visit v = {.route = route, .at = at, .place = place};
  v.before = at > 0 ? s->routes.place[route][at - 1] : (unsigned)board->places + board->start_of[route];
  v.left = at > 0 ? s->when[v.before] : qtr_board_ready(board, route);
  const qtr_steps there = qtr_steps_between(board, route, v.before, place);
  if (there == QTR_NEVER) return -HUGE_VAL;
  v.when = v.left + there;
  if (has_end(s) && !is_home_in_time(s, &v)) return -HUGE_VAL;
  const double loss = at == s->routes.length[route] ? loss_at_end(s, &v) : loss_before_another(s, &v);
  return qtr_game_worth(s->game, place, v.when) - loss;
}

double qtr_schedule_try(const qtr_schedule *s, unsigned route, unsigned at, uint16_t place) {
  return gain_at(s, route, at, place);
}

/* Without ends and ways home: what gain_at() looks at then, at a third of the cost. */
static inline void find_plain(const qtr_schedule *s, unsigned route, unsigned from, unsigned to, uint16_t place,
                              uint8_t kind, qtr_insertion *best) {
  const qtr_board *board = &s->game->board;
  const uint16_t *on = s->routes.place[route];
  const uint32_t length = s->routes.length[route];
  const uint32_t own = QTR_TERMS ? board->class_of[route] * ((uint32_t)board->places + board->starts) : 0;
  const uint8_t *back = board->steps + GAME_STEP_BYTES * ((size_t)(own + place) * board->places);
  uint32_t before = from > 0 ? on[from - 1] : (uint32_t)board->places + board->start_of[route];
  qtr_steps left = from > 0 ? s->when[before] : qtr_board_ready(board, route);
  qtr_insertion found = *best;
  for (unsigned at = from; at < to; at++) {
    const qtr_steps there = qtr_load_steps(board->steps, GAME_STEP_BYTES, (own + before) * board->places + place);
    const qtr_steps when = left + there;
    double gain = worth_of_kind(s, kind, place, when);
    bool can = there != QTR_NEVER;
    if (at < length) {
      const uint16_t next = on[at];
      const qtr_steps way = qtr_load_steps(back, GAME_STEP_BYTES, next);
      before = next;
      left = s->when[next];
      can = can && way != QTR_NEVER;
      if (can) gain -= loss_of_kind(s, kind, route, at, (int64_t)when + way - (int64_t)left);
    }
    if (can && gain > found.gain) found = (qtr_insertion){gain, route, at};
  }
  *best = found;
}

void qtr_schedule_find(const qtr_schedule *s, unsigned route, unsigned from, unsigned to, uint16_t place,
                       qtr_insertion *best) {
  const qtr_objective *objective = &s->game->objective;
  const bool plain = !has_end(s) && objective->terms.home_weight == 0.0 && s->game->board.step_bytes == GAME_STEP_BYTES;
  if (plain && objective->kind == QTR_TIME) {
    find_plain(s, route, from, to, place, QTR_TIME, best);
  } else if (plain && objective->kind == QTR_DISCOUNTED) {
    find_plain(s, route, from, to, place, QTR_DISCOUNTED, best);
  } else {
    for (unsigned at = from; at < to; at++) {
      const double gain = gain_at(s, route, at, place);
      if (gain > best->gain) *best = (qtr_insertion){gain, route, at};
    }
  }
}

/* ---- changes ---- */

void qtr_schedule_insert(qtr_schedule *s, unsigned route, unsigned at, uint16_t place) {
  uint16_t *places = s->routes.place[route];
  memmove(places + at + 1, places + at, (s->routes.length[route] - at) * sizeof *places);
  places[at] = place;
  s->routes.length[route]++;
  s->route_of[place] = (uint8_t)route;
  refresh(s, route);
}

void qtr_schedule_remove(qtr_schedule *s, unsigned route, unsigned from, unsigned count) {
  uint16_t *places = s->routes.place[route];
  for (unsigned i = from; i < from + count; i++) s->route_of[places[i]] = QTR_NO_ROUTE;
  memmove(places + from, places + from + count, (s->routes.length[route] - from - count) * sizeof *places);
  s->routes.length[route] = (uint16_t)(s->routes.length[route] - count);
  refresh(s, route);
}

void qtr_schedule_set(qtr_schedule *s, unsigned route, const qtr_routes *from) {
  memcpy(s->routes.place[route], from->place[route], from->length[route] * sizeof from->place[route][0]);
  s->routes.length[route] = from->length[route];
  s->routes.score[route] = from->score[route];
  for (unsigned i = 0; i < from->length[route]; i++) s->route_of[from->place[route][i]] = (uint8_t)route;
  refresh(s, route);
}

void qtr_schedule_begin(qtr_schedule *s, const qtr_game *game, const qtr_routes *routes) {
  s->game = game;
  memset(s->route_of, (int)QTR_NO_ROUTE, sizeof s->route_of);
  for (unsigned route = 0; route < qtr_routes_count(game); route++) {
    qtr_schedule_set(s, route, routes);
    s->routes.score[route] = qtr_route_evaluate(game, route, s->routes.place[route], s->routes.length[route]);
  }
}
