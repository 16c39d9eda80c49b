/* Pieces of routes, and what a route is worth that is put together from them, without following it: local search asks
 * this of every move, and follows only the routes of those that can be a gain.
 *
 * A piece is known by what it is worth whenever it begins. Under expected time, begun at step t, that is value - weight
 * t, with weight its likelihood and value -P times the steps since its first visit, summed up; discounted, gamma^(t-1)
 * of value, what it would be worth at step 1. Two pieces one after the other are one again.
 */
#ifndef QUARTER_SEARCH_PIECES_H
#define QUARTER_SEARCH_PIECES_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "model/rounding.h" /* ahead of what computes below */
#include "quarter/config.h"
#include "quarter/game.h"
#include "quarter/play.h"
#include "robot/board.h"

typedef struct {
  double weight, value;
  uint16_t first, last; /* its places; QTR_STAND_DOWN: it is empty */
  qtr_steps steps;      /* from its first visit to its last; QTR_NEVER: there is no way */
} qtr_piece;

/* Of each place on a route: its visit, and the piece from there to the route's end. Small builds search without. */
#define QTR_PIECED_PLACES (QTR_RECREATES ? QTR_MAX_PLACES : 1)
typedef struct {
  const qtr_game *game;
  const qtr_routes *routes;
  qtr_steps when[QTR_PIECED_PLACES];
  double weight[QTR_PIECED_PLACES];
  double value[QTR_PIECED_PLACES];
} qtr_pieces;

/* Whether worths are told at all: not by a deadline, nor where seekers have an end or count their way home. */
bool qtr_pieces_tell(const qtr_game *game);

/* Whether pieces of one seeker's route are alike on another's. */
bool qtr_pieces_fit(const qtr_game *game, unsigned seeker, unsigned other);

/* A route is another one now; its places must be reachable one from the other. */
void qtr_pieces_refresh(qtr_pieces *pieces, unsigned route);

/* ---- the innermost of the search's loops ---- */

static const qtr_piece qtr_no_piece = {0.0, 0.0, QTR_STAND_DOWN, QTR_STAND_DOWN, 0};

/* What a piece is worth that comes `steps` later than it is said of. */
static inline qtr_piece qtr_pieces_later(const qtr_pieces *p, qtr_piece piece, qtr_steps steps) {
  if (p->game->objective.kind == QTR_TIME)
    piece.value -= piece.weight * (double)steps;
  else
    piece.value *= qtr_objective_power(&p->game->objective, steps);
  return piece;
}

static inline qtr_piece qtr_pieces_single(const qtr_pieces *p, uint16_t place) {
  const double probability = p->game->probability[place];
  if (p->game->objective.kind == QTR_TIME) return (qtr_piece){probability, 0.0, place, place, 0};
  return (qtr_piece){0.0, p->game->objective.scale * probability, place, place, 0};
}

/* One piece after another, as a seeker goes. */
static inline qtr_piece qtr_pieces_join(const qtr_pieces *p, unsigned seeker, qtr_piece a, qtr_piece b) {
  if (a.first == QTR_STAND_DOWN) return b;
  if (b.first == QTR_STAND_DOWN) return a;
  const qtr_steps way = qtr_steps_between(&p->game->board, seeker, a.last, b.first);
  qtr_piece joined = a;
  joined.last = b.last;
  joined.steps = QTR_NEVER;
  if (a.steps == QTR_NEVER || b.steps == QTR_NEVER || way == QTR_NEVER) return joined;
  joined.steps = a.steps + way + b.steps;
  joined.weight += b.weight;
  joined.value += qtr_pieces_later(p, b, a.steps + way).value;
  return joined;
}

/* The places from..to-1 of a route: all from `from` on, less all from `to` on. */
static inline qtr_piece qtr_pieces_of(const qtr_pieces *p, unsigned route, unsigned from, unsigned to) {
  const uint16_t *place = p->routes->place[route];
  if (from >= to) return qtr_no_piece;
  const uint16_t first = place[from], last = place[to - 1];
  qtr_piece piece = {p->weight[first], p->value[first], first, last, p->when[last] - p->when[first]};
  if (to == p->routes->length[route]) return piece;
  const uint16_t next = place[to];
  const qtr_piece rest = {p->weight[next], p->value[next], next, next, 0};
  piece.value -= qtr_pieces_later(p, rest, p->when[next] - p->when[first]).value;
  piece.weight -= rest.weight;
  return piece;
}

/* What a piece is worth as a seeker's whole route: -HUGE_VAL if there is no way; HUGE_VAL where it cannot be told. */
static inline double qtr_pieces_worth(const qtr_pieces *p, unsigned seeker, qtr_piece piece) {
  const qtr_board *board = &p->game->board;
  if (piece.first == QTR_STAND_DOWN) return 0.0;
  const qtr_steps way =
      qtr_steps_between(board, seeker, (unsigned)board->places + board->start_of[seeker], piece.first);
  if (way == QTR_NEVER || piece.steps == QTR_NEVER) return -HUGE_VAL;
  const qtr_steps when = qtr_board_ready(board, seeker) + way;
  if (p->game->objective.kind == QTR_TIME) return piece.value - piece.weight * (double)when;
  return when == 0 ? HUGE_VAL : qtr_pieces_later(p, piece, when - 1).value;
}

#endif
