#include "robot/board.h"

#include <stdbool.h>
#include <stddef.h>

#include "core/apart.h"
#include "quarter/status.h"

/* Places first, then starts: a place's number is its node, and no table of the two is needed. */
unsigned qtr_board_nodes(const qtr_board *board) {
  return (unsigned)board->places + board->starts;
}

/* The copies that are called. */
extern inline qtr_steps qtr_load_steps(const uint8_t *times, unsigned bytes, uint32_t i);
extern inline qtr_steps qtr_steps_of_class(const qtr_board *board, unsigned of_class, unsigned node, unsigned place);

unsigned qtr_board_classes(const qtr_board *board) {
  return (QTR_TERMS && (board->classes > 1u)) ? board->classes : 1u;
}

/* No way, for numbers that are none: who asks out of range goes nowhere, and reads nothing. */
qtr_steps qtr_board_class_steps(const qtr_board *board, unsigned of_class, unsigned node, unsigned place) {
  if ((of_class >= qtr_board_classes(board)) || (node >= qtr_board_nodes(board)) || (place >= board->places)) {
    return QTR_NEVER;
  }
  return qtr_steps_of_class(board, of_class, node, place);
}

qtr_steps qtr_board_steps(const qtr_board *board, unsigned seeker, unsigned node, unsigned place) {
  if (seeker >= board->seekers) {
    return QTR_NEVER;
  }
  return qtr_board_class_steps(board, QTR_TERMS ? board->class_of[seeker] : 0u, node, place);
}

QTR_APART qtr_steps qtr_board_ready(const qtr_board *board, unsigned seeker) {
  return (QTR_TERMS && (board->terms.ready != NULL)) ? qtr_load32(board->terms.ready + (4u * seeker)) : 0u;
}

qtr_steps qtr_board_end(const qtr_board *board, unsigned seeker) {
  return (QTR_TERMS && (board->terms.end != NULL)) ? qtr_load32(board->terms.end + (4u * seeker)) : QTR_NEVER;
}

qtr_steps qtr_board_home(const qtr_board *board, unsigned seeker, unsigned place) {
  QTR_ASSERT((board->terms.home != NULL) && (seeker < board->seekers) && (place < board->places));
  return qtr_load_steps(board->terms.home, board->step_bytes, ((uint32_t)seeker * board->places) + place);
}

/* A seat is a start's number and not a cell, for who sets out together starts at one node. */
void qtr_board_load_seats(qtr_board *board, const uint8_t *bytes) {
  for (unsigned i = 0; i < board->seekers; i++) {
    board->start_of[i] = (uint16_t)qtr_load16(bytes + (2u * i));
  }
}

void qtr_board_store_seats(const qtr_board *board, uint8_t *bytes) {
  for (unsigned i = 0; i < board->seekers; i++) {
    qtr_store16(bytes + (2u * i), board->start_of[i]);
  }
}

static bool is_width(unsigned bytes) {
  return (bytes == 1u) || (bytes == 2u) || (bytes == 4u);
}

/* What the arrays of this build hold is told apart from what no board can be: the former may be well elsewhere. */
int qtr_board_check(const qtr_board *board) {
  if ((board->places > QTR_MAX_PLACES) || (board->seekers > QTR_MAX_SEEKERS)) {
    return QTR_ERR_LIMIT;
  }
  if ((board->places == 0u) || (board->seekers == 0u) || (board->rule > QTR_RULE_PAPER)) {
    return QTR_ERR_ARGUMENT;
  }
  if ((board->starts == 0u) || (board->starts > QTR_MAX_STARTS) || !is_width(board->step_bytes)) {
    return QTR_ERR_ARGUMENT;
  }
  return QTR_OK;
}

#if QTR_TERMS
static bool are_alike(const qtr_board *board, unsigned i, unsigned other) {
  if (board->class_of[i] != board->class_of[other]) {
    return false;
  }
  return ((board->terms.rules & (unsigned)QTR_BY_HOME) == 0u) ||
         ((board->start_of[i] == board->start_of[other]) &&
          (qtr_board_ready(board, i) == qtr_board_ready(board, other)));
}

/* A kind goes by the lowest number of those that are of it. */
static void find_kind(qtr_board *board, unsigned i) {
  unsigned kind = 0;
  while (!are_alike(board, i, kind)) {
    kind++;
  }
  board->keys.kind[i] = (uint8_t)kind;
}
#endif

static bool seat_is_sound(const qtr_board *board, unsigned i) {
  return (board->start_of[i] < board->starts) && (!QTR_TERMS || (board->class_of[i] < qtr_board_classes(board)));
}

/* The longest time is the base of the digit that a key has for steps that remain, on the way or until a seeker is
 * ready; QTR_NEVER is no way and gets no digit. */
int qtr_board_derive(qtr_board *board) {
  const uint32_t nodes = qtr_board_nodes(board);
  const uint32_t times = qtr_board_classes(board) * nodes * board->places;
  qtr_steps longest = 0;
  for (unsigned i = 0; i < board->seekers; i++) {
    if (!seat_is_sound(board, i)) {
      return QTR_ERR_ARGUMENT;
    }
#if QTR_TERMS
    find_kind(board, i);
    const qtr_steps ready = qtr_board_ready(board, i);
    longest = (ready > longest) ? ready : longest;
#endif
  }
  for (uint32_t i = 0; i < times; i++) {
    const qtr_steps steps = qtr_load_steps(board->steps, board->step_bytes, i);
    longest = ((steps != QTR_NEVER) && (steps > longest)) ? steps : longest;
  }
  /* Sums over a whole game must fit qtr_steps: told by the upper halves, which need no wider numbers. */
  if ((((longest >> 16) + 1u) * (board->places + 1u)) > 0xFFFFu) {
    return QTR_ERR_LIMIT;
  }
  board->keys.longest = longest;
  board->keys.places = board->places;
  board->keys.nodes = (uint16_t)nodes;
  board->keys.seekers = board->seekers;
  board->keys.clock = QTR_TERMS ? board->terms.clock : 0u;
  qtr_key_measure(&board->keys);
  return QTR_OK;
}

int qtr_board_init_built(qtr_board *board, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  const int status = qtr_board_check(board);
  return (status == QTR_OK) ? qtr_board_derive(board) : status;
}
