#include "search/pieces.h"

#include "model/rounding.h"

bool qtr_pieces_tell(const qtr_game *game) {
  const qtr_objective *objective = &game->objective;
  return QTR_RECREATES && objective->kind != QTR_DEADLINE && game->board.terms.end == NULL &&
         objective->terms.home_weight == 0.0;
}

bool qtr_pieces_fit(const qtr_game *game, unsigned seeker, unsigned other) {
  return !QTR_TERMS || game->board.class_of[seeker] == game->board.class_of[other];
}

void qtr_pieces_refresh(qtr_pieces *p, unsigned route) {
  const qtr_board *board = &p->game->board;
  const uint16_t *place = p->routes->place[route];
  const unsigned length = p->routes->length[route];
  qtr_piece behind = qtr_no_piece;
  qtr_steps now = qtr_board_ready(board, route);
  for (unsigned i = 0; i < length; i++) {
    const unsigned node = i > 0 ? place[i - 1] : (unsigned)board->places + board->start_of[route];
    now += qtr_steps_between(board, route, node, place[i]);
    p->when[place[i]] = now;
  }
  for (unsigned i = length; i-- > 0;) {
    behind = qtr_pieces_join(p, route, qtr_pieces_single(p, place[i]), behind);
    p->weight[place[i]] = behind.weight;
    p->value[place[i]] = behind.value;
  }
}
