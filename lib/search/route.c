#include "search/route.h"

#include <math.h>

#include "model/rounding.h"
#include "robot/board.h"
#include "search/play.h"

#define ROUNDING 1e-12 /* relative: more than adding up a route is wrong by */

/* What nobody visits is worth nothing, and takes until the end. */
static qtr_route_score evaluate_left_out(const qtr_game *game, const uint16_t *places, unsigned length) {
  qtr_route_score score = {0.0, 0.0};
  for (unsigned i = 0; i < length; i++) score.time += game->probability[places[i]] * (double)game->objective.terms.end;
  return score;
}

/* Under the free rule seekers do not hinder one another: a game's worth is the sum over its routes, each by itself. */
qtr_route_score qtr_route_evaluate(const qtr_game *game, unsigned seeker, const uint16_t *places, unsigned length) {
  const qtr_board *board = &game->board;
  if (seeker == board->seekers && seeker < qtr_routes_count(game)) return evaluate_left_out(game, places, length);
  if (seeker >= board->seekers) return (qtr_route_score){-HUGE_VAL, HUGE_VAL};
  const qtr_steps end = qtr_board_end(board, seeker);
  unsigned node = (unsigned)board->places + board->start_of[seeker];
  qtr_route_score score = {0.0, 0.0};
  qtr_steps now = qtr_board_ready(board, seeker);
  for (unsigned i = 0; i < length; i++) {
    const qtr_steps steps = qtr_board_steps(board, seeker, node, places[i]);
    if (steps == QTR_NEVER) return (qtr_route_score){-HUGE_VAL, HUGE_VAL};
    now += steps;
    if (end != QTR_NEVER && now + qtr_board_home(board, seeker, places[i]) > end)
      return (qtr_route_score){-HUGE_VAL, HUGE_VAL};
    score.worth += qtr_game_worth(game, places[i], now);
    score.time += game->probability[places[i]] * (double)now;
    node = places[i];
  }
  const double home = qtr_objective_leave(&game->objective, now + qtr_game_way_home(game, seeker, node));
  score.worth += home;
  score.time -= home;
  return score;
}

qtr_route_score qtr_route_sum(qtr_route_score a, qtr_route_score b) {
  return (qtr_route_score){a.worth + b.worth, a.time + b.time};
}

bool qtr_route_is_worth_more(qtr_route_score after, qtr_route_score before) {
  return after.worth > before.worth + ROUNDING * fabs(before.worth);
}

bool qtr_route_is_sooner(qtr_route_score after, qtr_route_score before) {
  return after.time < before.time - ROUNDING * before.time;
}

bool qtr_route_is_better(qtr_route_score after, qtr_route_score before) {
  return qtr_route_is_worth_more(after, before) || (after.worth >= before.worth && qtr_route_is_sooner(after, before));
}
