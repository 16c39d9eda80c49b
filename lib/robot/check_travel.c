#include "quarter/status.h"
#include "robot/board.h"
#include "robot/checks.h"
#include "robot/layout.h"

/* Of a class's matrix. */
typedef struct {
  const qtr_policy *policy;
  unsigned of_class;
} matrix;

static qtr_steps steps_in(const matrix *of, unsigned node, unsigned place) {
  return qtr_board_class_steps(&of->policy->board, of->of_class, node, place);
}

static bool is_way(const matrix *of, unsigned node, unsigned place) {
  return steps_in(of, node, place) != QTR_NEVER;
}

/* A place that the class may not visit: there is no way to it from anywhere, itself included. */
static bool is_avoided(const matrix *of, unsigned place) {
  return !is_way(of, place, place);
}

/* The first place that a node reaches; `places` if there is none. */
static unsigned first_in_reach(const matrix *of, unsigned node) {
  unsigned place = 0;
  while ((place < of->policy->board.places) && !is_way(of, node, place)) {
    place++;
  }
  return place;
}

/* Moves can be undone, so a map falls into parts: what lies in one part is in reach of one another, and of nothing
 * else. A node thus reaches what the first place in its reach does, and two places reach each other or neither does,
 * but for those that the class keeps away from. */
static bool reach_agrees(const matrix *of, unsigned node) {
  const unsigned places = of->policy->board.places;
  const unsigned first = first_in_reach(of, node);
  for (unsigned place = 0; place < places; place++) {
    const bool way = is_way(of, node, place);
    if ((first < places) && (way != is_way(of, first, place))) {
      return false;
    }
    const bool both = (node < places) && !is_avoided(of, node) && !is_avoided(of, place);
    if (both && (way != is_way(of, place, node))) {
      return false;
    }
  }
  return true;
}

/* Without scans a way takes no time where it ends in the cell that it begins in, and nowhere else; with scans none
 * takes less than the scan of its place. */
static bool times_fit_cells(const matrix *of, unsigned node) {
  const unsigned places = of->policy->board.places;
  const bool has_scans = (of->policy->features & (unsigned)QTR_FEATURE_TERMS) != 0u;
  for (unsigned place = 0; place < places; place++) {
    const bool is_here = qtr_policy_cell(of->policy, node) == qtr_policy_cell(of->policy, place);
    const qtr_steps scan = steps_in(of, place, place);
    if ((scan != 0u) && !has_scans) {
      return false;
    }
    if ((scan != QTR_NEVER) && (is_here != (steps_in(of, node, place) == scan))) {
      return false;
    }
    if ((scan != QTR_NEVER) && (steps_in(of, node, place) < scan)) {
      return false;
    }
  }
  return true;
}

/* Two places share a cell where, and only where, they are looks at one. */
static bool cells_are_apart(const qtr_policy *policy, unsigned node) {
  for (unsigned place = 0; (node < policy->board.places) && (place < node); place++) {
    const bool is_here = qtr_policy_cell(policy, node) == qtr_policy_cell(policy, place);
    if (is_here != (qtr_policy_place(policy, node) == qtr_policy_place(policy, place))) {
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
  for (unsigned of_class = 0; of_class < qtr_board_classes(&policy->board); of_class++) {
    const matrix of = {policy, of_class};
    for (unsigned node = 0; node < qtr_board_nodes(&policy->board); node++) {
      if (!reach_agrees(&of, node) || !times_fit_cells(&of, node) || !cells_are_apart(policy, node)) {
        return QTR_ERR_TRAVEL;
      }
    }
  }
  for (unsigned place = 0; place < places; place++) {
    if (!some_seeker_reaches(policy, place)) {
      return QTR_ERR_TRAVEL;
    }
  }
  return QTR_OK;
}
