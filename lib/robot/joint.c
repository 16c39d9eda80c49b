#include "quarter/joint.h"

#include <stddef.h>

#include "quarter/status.h"
#include "robot/bits.h"
#include "robot/board.h"

/* At a node with no steps to go. There alone, and never between two nodes, a seeker chooses: what is chosen is carried
 * out. */
static bool is_idle(const qtr_joint *joint, unsigned seeker) {
  return (joint->node[seeker] != QTR_STAND_DOWN) && (joint->remaining[seeker] == 0u);
}

/* For numbers from outside, too. */
static bool can_choose(const qtr_joint *joint, const qtr_board *board, int seeker) {
  return (seeker >= 0) && (seeker < board->seekers) && is_idle(joint, (unsigned)seeker);
}

static bool is_open(const qtr_joint *joint, unsigned place, bool follows) {
  return !place_is_in(&joint->visited, place) && (follows || !place_is_in(&joint->bound, place));
}

/* The places that an idle seeker may choose, added to `choices` (may be NULL: then only the answer counts), and whether
 * there are any. By Table 1 those that others are bound for come in when fewer places than seekers are left; so too
 * when a seeker has no others within its reach. */
static bool find_choices(const qtr_joint *joint, const qtr_board *board, unsigned seeker, qtr_places *choices) {
  const unsigned most = (board->rule == QTR_RULE_PAPER) ? 1u : 0u;
  bool any = false;
  for (unsigned follows = (joint->unvisited < board->seekers) ? most : 0; (follows <= most) && !any; follows++) {
    for (unsigned place = 0; place < board->places; place++) {
      if (!is_open(joint, place, follows > 0u)) {
        continue;
      }
      if (qtr_steps_between(board, seeker, joint->node[seeker], place) == QTR_NEVER) {
        continue;
      }
      if (choices == NULL) {
        return true;
      }
      place_put(choices, place);
      any = true;
    }
  }
  return any;
}

/* Nothing comes back within a seeker's reach later: whoever has nothing to choose is out of the game. */
static void stand_down_the_useless(qtr_joint *joint, const qtr_board *board) {
  for (unsigned i = 0; i < board->seekers; i++) {
    if (is_idle(joint, i) && !find_choices(joint, board, i, NULL)) {
      joint->node[i] = QTR_STAND_DOWN;
    }
  }
}

static void visit(qtr_joint *joint, unsigned place) {
  /* A place is visited once, and `unvisited` counts the others. */
  QTR_ASSERT((joint->unvisited > 0u) && !place_is_in(&joint->visited, place));
  place_put(&joint->visited, place);
  place_take(&joint->bound, place);
  joint->unvisited--;
}

void qtr_joint_start(qtr_joint *joint, const qtr_board *board, const uint16_t *start_of, const qtr_places *cleared) {
  if (start_of == NULL) {
    start_of = board->start_of;
  }
  qtr_places_clear(&joint->visited);
  qtr_places_clear(&joint->bound);
  joint->unvisited = board->places;
  for (unsigned place = 0; (cleared != NULL) && (place < board->places); place++) {
    if (place_is_in(cleared, place)) {
      visit(joint, place);
    }
  }
  for (unsigned i = 0; i < board->seekers; i++) {
    QTR_ASSERT(start_of[i] < board->starts); /* as qtr_board_init() and qtr_deployment_init() see to */
    joint->node[i] = (uint16_t)(board->places + start_of[i]);
    joint->remaining[i] = 0;
  }
  stand_down_the_useless(joint, board);
}

/* Whether a seeker's turn comes before that of one with a lower number. */
static bool is_before(const qtr_joint *joint, const qtr_board *board, int seeker, int other) {
  if (joint->node[seeker] != joint->node[other]) {
    return joint->node[seeker] < joint->node[other];
  }
  return board->keys.kind[seeker] < board->keys.kind[other];
}

int qtr_joint_chooser(const qtr_joint *joint, const qtr_board *board) {
  int chooser = QTR_NOBODY;
  for (int i = 0; i < board->seekers; i++) {
    if (is_idle(joint, (unsigned)i) && ((chooser == QTR_NOBODY) || is_before(joint, board, i, chooser))) {
      chooser = i;
    }
  }
  /* Whoever has nothing to choose has been stood down: the chooser has a place to go to. */
  QTR_ASSERT((chooser == QTR_NOBODY) || find_choices(joint, board, (unsigned)chooser, NULL));
  return chooser;
}

static bool other_can_reach(const qtr_joint *joint, const qtr_board *board, int seeker, unsigned place) {
  for (unsigned i = 0; i < board->seekers; i++) {
    if (((int)i == seeker) || (joint->node[i] == QTR_STAND_DOWN)) {
      continue;
    }
    if (qtr_steps_between(board, i, joint->node[i], place) != QTR_NEVER) {
      return true;
    }
  }
  return false;
}

bool qtr_joint_choices(const qtr_joint *joint, const qtr_board *board, int seeker, qtr_places *choices) {
  qtr_places_clear(choices);
  if (!can_choose(joint, board, seeker) || !find_choices(joint, board, (unsigned)seeker, choices)) {
    return false;
  }
  if (board->rule == QTR_RULE_PAPER) {
    return false;
  }
  /* Ways go both ways, so whoever can reach one of these places can reach them all. */
  unsigned place = 0;
  while (!place_is_in(choices, place)) {
    place++;
  }
  return other_can_reach(joint, board, seeker, place);
}

/* A place on the seeker's own cell takes no time: it is visited at once, and the seeker chooses again at the same
 * moment. */
bool qtr_joint_choose(qtr_joint *joint, const qtr_board *board, int seeker, uint16_t choice) {
  if (!can_choose(joint, board, seeker)) {
    return false;
  }
  if (choice == QTR_STAND_DOWN) {
    joint->node[seeker] = QTR_STAND_DOWN;
    return false;
  }
  const qtr_steps steps = qtr_board_steps(board, (unsigned)seeker, joint->node[seeker], choice);
  if ((steps == QTR_NEVER) || place_is_in(&joint->visited, choice)) {
    return false;
  }
  QTR_ASSERT(steps <= board->keys.longest); /* keys have room for the longest way and no longer one */
  joint->node[seeker] = choice;
  joint->remaining[seeker] = steps;
  if (steps == 0u) {
    visit(joint, choice);
  } else {
    place_put(&joint->bound, choice);
  }
  stand_down_the_useless(joint, board);
  return steps == 0u;
}

/* Until then nothing happens: no one arrives, so no one chooses. */
static qtr_steps least_remaining(const qtr_joint *joint, const qtr_board *board) {
  qtr_steps least = QTR_NEVER;
  for (unsigned i = 0; i < board->seekers; i++) {
    if ((joint->remaining[i] > 0u) && (joint->remaining[i] < least)) {
      least = joint->remaining[i];
    }
  }
  return least;
}

/* To the next arrival, of one seeker or of several at once. Who follows another one to a place may find it visited:
 * then it just arrives. */
qtr_steps qtr_joint_advance(qtr_joint *joint, const qtr_board *board, qtr_places *arrived) {
  const qtr_steps least = least_remaining(joint, board);
  if ((joint->unvisited == 0u) || (least == QTR_NEVER)) {
    return 0;
  }
  for (unsigned i = 0; i < board->seekers; i++) {
    if (joint->remaining[i] == 0u) {
      continue;
    }
    /* Who is on its way is bound for a place, which the others know; another may have visited it by now. */
    QTR_ASSERT(joint->node[i] < board->places);
    QTR_ASSERT(place_is_in(&joint->bound, joint->node[i]) || place_is_in(&joint->visited, joint->node[i]));
    joint->remaining[i] -= least;
    if ((joint->remaining[i] > 0u) || place_is_in(&joint->visited, joint->node[i])) {
      continue;
    }
    visit(joint, joint->node[i]);
    if (arrived != NULL) {
      place_put(arrived, joint->node[i]);
    }
  }
  stand_down_the_useless(joint, board);
  return least;
}
