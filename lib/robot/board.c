#include "robot/board.h"

#include "quarter/status.h"

/* Places first, then starts: a place's number is its node, and no table of the two is needed. */
unsigned qtr_board_nodes(const qtr_board *board) {
  return (unsigned)board->places + board->starts;
}

/* The copy that is called. */
extern inline qtr_steps qtr_steps_between(const qtr_board *board, unsigned seeker, unsigned node, unsigned place);

/* No way, for numbers that are none: who asks out of range goes nowhere, and reads nothing. */
qtr_steps qtr_board_steps(const qtr_board *board, unsigned seeker, unsigned node, unsigned place) {
  if (((seeker >= board->seekers) && (seeker != QTR_ANY_SEEKER)) || (node >= qtr_board_nodes(board)) ||
      (place >= board->places)) {
    return QTR_NEVER;
  }
  return qtr_steps_between(board, seeker, node, place);
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

static int check_seats(const qtr_board *board) {
  for (unsigned i = 0; i < board->seekers; i++) {
    if (board->start_of[i] >= board->starts) {
      return QTR_ERR_ARGUMENT;
    }
  }
  return QTR_OK;
}

/* The base of the digit that a key has for steps that remain; QTR_NEVER is no way and gets no digit. */
static qtr_steps find_longest(const qtr_board *board) {
  const unsigned nodes = qtr_board_nodes(board);
  qtr_steps longest = 0;
  for (unsigned node = 0; node < nodes; node++) {
    for (unsigned place = 0; place < board->places; place++) {
      const qtr_steps steps = qtr_board_steps(board, QTR_ANY_SEEKER, node, place);
      if ((steps != QTR_NEVER) && (steps > longest)) {
        longest = steps;
      }
    }
  }
  return longest;
}

int qtr_board_init_built(qtr_board *board, uint32_t config_id) {
  if (config_id != QTR_CONFIG_ID) {
    return QTR_ERR_CONFIG;
  }
  int status = qtr_board_check(board);
  if (status == QTR_OK) {
    status = check_seats(board);
  }
  if (status != QTR_OK) {
    return status;
  }
  board->keys.places = board->places;
  board->keys.nodes = (uint16_t)qtr_board_nodes(board);
  board->keys.seekers = board->seekers;
  board->keys.clock = 0; /* the rules ask no clock what is allowed */
  for (unsigned i = 0; i < board->seekers; i++) {
    board->keys.kind[i] = 0; /* all travel alike */
  }
  board->keys.longest = find_longest(board);
  /* Sums over a whole game must fit qtr_steps: told by the upper halves, which need no wider numbers. */
  if ((((board->keys.longest >> 16) + 1u) * (board->places + 1u)) > 0xFFFFu) {
    return QTR_ERR_LIMIT;
  }
  qtr_key_measure(&board->keys);
  return QTR_OK;
}
