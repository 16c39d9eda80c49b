#include "quarter/status.h"
#include "robot/board.h"
#include "robot/checks.h"

static bool is_way(const qtr_policy *policy, unsigned node, unsigned place) {
  return qtr_board_class_steps(&policy->board, 0, node, place) != QTR_NEVER;
}

/* The first place that a node reaches; `places` if there is none. */
static unsigned first_in_reach(const qtr_policy *policy, unsigned node) {
  unsigned place = 0;
  while ((place < policy->board.places) && !is_way(policy, node, place)) {
    place++;
  }
  return place;
}

/* Moves can be undone, so a map falls into parts: what lies in one part is in reach of one another, and of nothing
 * else. A node thus reaches what the first place in its reach does, and two places reach each other or neither does. */
static bool reach_agrees(const qtr_policy *policy, unsigned node) {
  const unsigned places = policy->board.places;
  const unsigned first = first_in_reach(policy, node);
  for (unsigned place = 0; place < places; place++) {
    const bool way = is_way(policy, node, place);
    if ((first < places) && (way != is_way(policy, first, place))) {
      return false;
    }
    if ((node < places) && (way != is_way(policy, place, node))) {
      return false;
    }
  }
  return true;
}

/* A way takes no time where it ends in the cell that it begins in, and nowhere else. No two places share a cell. */
static bool times_fit_cells(const qtr_policy *policy, unsigned node) {
  const unsigned places = policy->board.places;
  for (unsigned place = 0; place < places; place++) {
    const bool is_here = qtr_policy_cell(policy, node) == qtr_policy_cell(policy, place);
    if (is_here != (qtr_board_class_steps(&policy->board, 0, node, place) == 0u)) {
      return false;
    }
    if (is_here && (node < places) && (node != place)) {
      return false;
    }
  }
  return true;
}

static bool some_seeker_reaches(const qtr_policy *policy, unsigned place) {
  const qtr_board *board = &policy->board;
  for (unsigned i = 0; i < board->seekers; i++) {
    if (qtr_board_steps(board, i, (unsigned)board->places + board->start_of[i], place) != QTR_NEVER) {
      return true;
    }
  }
  return false;
}

int qtr_check_travel(const qtr_policy *policy) {
  const unsigned places = policy->board.places;
  for (unsigned node = 0; node < qtr_board_nodes(&policy->board); node++) {
    if (!reach_agrees(policy, node) || !times_fit_cells(policy, node)) {
      return QTR_ERR_TRAVEL;
    }
  }
  for (unsigned place = 0; place < places; place++) {
    if (!some_seeker_reaches(policy, place)) {
      return QTR_ERR_TRAVEL;
    }
  }
  return QTR_OK;
}
