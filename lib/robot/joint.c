#include "quarter/joint.h"

#include <stddef.h>

#include "core/apart.h"
#include "quarter/status.h"
#include "robot/bits.h"
#include "robot/board.h"
#include "robot/joint.h"

/* At a node with no steps to go. There alone, and never between two nodes, a seeker chooses: what is chosen is carried
 * out. */
static bool is_idle(const qtr_joint *joint, unsigned seeker) {
  return (joint->node[seeker] != QTR_STAND_DOWN) && (joint->remaining[seeker] == 0u);
}

/* At a start, with steps to go: bound for nothing, but not idle. */
static bool is_unready(const qtr_joint *joint, const qtr_board *board, unsigned seeker) {
  return (joint->node[seeker] >= board->places) && (joint->node[seeker] != QTR_STAND_DOWN);
}

bool qtr_joint_can_choose(const qtr_joint *joint, const qtr_board *board, int seeker) {
  return (seeker >= 0) && (seeker < board->seekers) && is_idle(joint, (unsigned)seeker);
}

/* Whether a seeker that is at a place by then is home by its end. */
static bool comes_home(const qtr_board *board, unsigned seeker, unsigned place, qtr_steps when) {
  if (board->terms.end == NULL) {
    return true;
  }
  const qtr_steps home =
      qtr_load_steps(board->terms.home, board->step_bytes, ((uint32_t)seeker * board->places) + place);
  return (home != QTR_NEVER) && ((when + home) <= qtr_load32(board->terms.end + (4u * seeker)));
}

/* Whether a seeker can be at a place from its next node and free moment on, and home by its end. */
static bool is_feasible(const qtr_joint *joint, const qtr_board *board, unsigned seeker, unsigned place) {
  const qtr_steps steps = qtr_steps_between(board, seeker, joint->node[seeker], place);
  return (steps != QTR_NEVER) &&
         (!QTR_TERMS || comes_home(board, seeker, place, joint->now + joint->remaining[seeker] + steps));
}

static bool is_out(const qtr_joint *joint, unsigned seeker) {
  return joint->node[seeker] == QTR_STAND_DOWN;
}

static bool is_alone(const qtr_joint *joint, const qtr_board *board) {
  unsigned in = 0;
  for (unsigned i = 0; i < board->seekers; i++) {
    in += is_out(joint, i) ? 0u : 1u;
  }
  return in == 1u;
}

/* The place that a look is at. */
static uint32_t look_of(const qtr_board *board, unsigned place) {
  return qtr_load16(board->terms.look_of + (2u * place));
}

/* Alone in the game a seeker may choose the lowest of the looks at a place, and no other. All of them lie in one cell:
 * where one may be chosen, so may every lower one that has not been made. */
QTR_APART static void keep_lowest_looks(const qtr_joint *joint, const qtr_board *board, qtr_places *choices) {
  if ((board->terms.look_of == NULL) || !is_alone(joint, board)) {
    return;
  }
  unsigned place = board->places;
  while (place-- > 0u) {
    const uint32_t of = look_of(board, place);
    unsigned lower = place;
    while (lower-- > 0u) {
      if (place_is_in(choices, lower) && (look_of(board, lower) == of)) {
        place_take(choices, place);
      }
    }
  }
}

/* The places that an idle seeker may choose of those not in `taken`, added to `choices` (may be NULL: then only the
 * answer counts), and whether there are any. */
static bool find_open(const qtr_joint *joint, const qtr_board *board, unsigned seeker, const qtr_places *taken,
                      qtr_places *choices) {
  bool any = false;
  for (unsigned place = 0; place < board->places; place++) {
    if (place_is_in(taken, place) || !is_feasible(joint, board, seeker, place)) {
      continue;
    }
    if (choices == NULL) {
      return true;
    }
    place_put(choices, place);
    any = true;
  }
  if (QTR_TERMS && any) {
    keep_lowest_looks(joint, board, choices);
  }
  return any;
}

/* By Table 1 places that others are bound for come in when fewer places than seekers are left; so too when a seeker has
 * no others within its reach. */
bool qtr_joint_options(const qtr_joint *joint, const qtr_board *board, unsigned seeker, qtr_places *choices) {
  const bool may_follow = board->rule == QTR_RULE_PAPER;
  bool follows = may_follow && (joint->unvisited < board->seekers);
  for (;;) {
    qtr_places taken = joint->visited;
    for (unsigned w = 0; !follows && (w < QTR_PLACE_WORDS); w++) {
      taken.word[w] |= joint->bound.word[w];
    }
    if (find_open(joint, board, seeker, &taken, choices)) {
      return true;
    }
    if (follows || !may_follow) {
      return false;
    }
    follows = true;
  }
}

static void stand_down_if_useless(qtr_joint *joint, const qtr_board *board, unsigned seeker) {
  if (!qtr_joint_options(joint, board, seeker, NULL)) {
    joint->node[seeker] = QTR_STAND_DOWN;
  }
}

/* Nothing comes back within a seeker's reach later: whoever has nothing to choose is out of the game. Those who are not
 * ready yet go with the first choice: then it is known what that costs. */
static void stand_down_the_useless(qtr_joint *joint, const qtr_board *board, bool is_start) {
  for (unsigned i = 0; i < board->seekers; i++) {
    if (is_idle(joint, i) || (QTR_TERMS && !is_start && is_unready(joint, board, i))) {
      stand_down_if_useless(joint, board, i);
    }
  }
}

/* Who follows another one to a place may find it visited: then it just arrives. */
static void visit(qtr_joint *joint, unsigned place) {
  if (place_is_in(&joint->visited, place)) {
    return;
  }
  QTR_ASSERT(joint->unvisited > 0u);
  place_put(&joint->visited, place);
  place_take(&joint->bound, place);
  joint->unvisited--;
}

void qtr_joint_begin(qtr_joint *joint, const qtr_board *board, const uint16_t *start_of, const qtr_places *cleared) {
  bytes_clear(joint, (uint32_t)sizeof *joint);
  joint->unvisited = board->places;
  for (unsigned place = 0; place < board->places; place++) {
    if (place_is_in(cleared, place)) {
      visit(joint, place);
    }
  }
  for (unsigned i = 0; i < board->seekers; i++) {
    QTR_ASSERT(start_of[i] < board->starts); /* as qtr_board_init() and qtr_deployment_init() see to */
    joint->node[i] = (uint16_t)(board->places + start_of[i]);
    joint->remaining[i] = QTR_TERMS ? qtr_board_ready(board, i) : 0u;
  }
  stand_down_the_useless(joint, board, true);
}

void qtr_joint_start(qtr_joint *joint, const qtr_board *board, const uint16_t *start_of, const qtr_places *cleared) {
  qtr_places none;
  qtr_places_clear(&none);
  qtr_joint_begin(joint, board, (start_of != NULL) ? start_of : board->start_of, (cleared != NULL) ? cleared : &none);
}

/* Of those whose turn it could be, the one of the lowest comes first. */
static uint32_t turn_of(const qtr_joint *joint, const qtr_board *board, unsigned seeker) {
  return ((uint32_t)joint->node[seeker] << 8) | kind_of_seeker(&board->keys, seeker);
}

int qtr_joint_chooser(const qtr_joint *joint, const qtr_board *board) {
  int chooser = QTR_NOBODY;
  uint32_t lowest = UINT32_MAX;
  for (unsigned i = 0; i < board->seekers; i++) {
    const uint32_t rank = turn_of(joint, board, i);
    if (is_idle(joint, i) && (rank < lowest)) {
      chooser = (int)i;
      lowest = rank;
    }
  }
  /* Whoever has nothing to choose has been stood down: the chooser has a place to go to. */
  QTR_ASSERT((chooser == QTR_NOBODY) || qtr_joint_options(joint, board, (unsigned)chooser, NULL));
  return chooser;
}

static bool other_can_visit(const qtr_joint *joint, const qtr_board *board, unsigned seeker, unsigned place) {
  for (unsigned i = 0; i < board->seekers; i++) {
    if ((i != seeker) && !is_out(joint, i) && is_feasible(joint, board, i, place)) {
      return true;
    }
  }
  return false;
}

/* Where all are alike, whoever can reach one of these places can reach them all, for ways go both ways: then the first
 * tells. */
static bool first_tells(const qtr_board *board) {
  return !QTR_TERMS || ((qtr_board_classes(board) == 1u) && (board->terms.end == NULL));
}

static bool others_can_visit(const qtr_joint *joint, const qtr_board *board, unsigned seeker,
                             const qtr_places *choices) {
  for (unsigned place = 0; place < board->places; place++) {
    if (!place_is_in(choices, place)) {
      continue;
    }
    if (!other_can_visit(joint, board, seeker, place)) {
      return false;
    }
    if (first_tells(board)) {
      return true;
    }
  }
  return true;
}

bool qtr_joint_may_leave(const qtr_joint *joint, const qtr_board *board, unsigned seeker, const qtr_places *choices) {
  if (board->rule == QTR_RULE_PAPER) {
    return false;
  }
  return (QTR_TERMS && ((board->terms.rules & (unsigned)QTR_ANYONE_MAY_LEAVE) != 0u)) ||
         others_can_visit(joint, board, seeker, choices);
}

bool qtr_joint_choices(const qtr_joint *joint, const qtr_board *board, int seeker, qtr_places *choices) {
  qtr_places_clear(choices);
  return qtr_joint_can_choose(joint, board, seeker) && qtr_joint_options(joint, board, (unsigned)seeker, choices) &&
         qtr_joint_may_leave(joint, board, (unsigned)seeker, choices);
}

/* A place on the seeker's own cell takes no time: it is visited at once, and the seeker chooses again at the same
 * moment. */
bool qtr_joint_go(qtr_joint *joint, const qtr_board *board, unsigned seeker, unsigned choice) {
  if (choice == QTR_STAND_DOWN) {
    joint->node[seeker] = QTR_STAND_DOWN;
    return false;
  }
  const qtr_steps steps = qtr_steps_between(board, seeker, joint->node[seeker], choice);
  QTR_ASSERT(steps <= board->keys.longest); /* keys have room for the longest way and no longer one */
  joint->node[seeker] = (uint16_t)choice;
  joint->remaining[seeker] = steps;
  if (steps == 0u) {
    visit(joint, choice);
  } else {
    place_put(&joint->bound, choice);
  }
  stand_down_the_useless(joint, board, false);
  return steps == 0u;
}

bool qtr_joint_choose(qtr_joint *joint, const qtr_board *board, int seeker, uint16_t choice) {
  if (!qtr_joint_can_choose(joint, board, seeker)) {
    return false;
  }
  const bool is_allowed =
      (choice == QTR_STAND_DOWN) || ((choice < board->places) && !place_is_in(&joint->visited, choice) &&
                                     is_feasible(joint, board, (unsigned)seeker, choice));
  return is_allowed && qtr_joint_go(joint, board, (unsigned)seeker, choice);
}

/* Until then nothing happens: no one arrives, so no one chooses. 0: nobody is on the way. */
static qtr_steps least_remaining(const qtr_joint *joint, const qtr_board *board) {
  qtr_steps least = QTR_NEVER; /* one less than it, so that 0 steps are more than all others */
  for (unsigned i = 0; i < board->seekers; i++) {
    const qtr_steps steps = joint->remaining[i] - 1u;
    least = (steps < least) ? steps : least;
  }
  return least + 1u;
}

/* Where a seeker is bound for comes up: a place, which it visits, or the moment at which it is ready, at its start. */
static void arrive(qtr_joint *joint, const qtr_board *board, unsigned seeker) {
  const unsigned node = joint->node[seeker];
  if (!QTR_TERMS || (node < board->places)) {
    visit(joint, node);
  }
}

/* Who is on its way is bound for a place, which the others know, though another may have visited it by now; or it is
 * not ready. */
static bool is_bound(const qtr_joint *joint, const qtr_board *board, unsigned seeker) {
  const unsigned node = joint->node[seeker];
  if (node >= board->places) {
    return QTR_TERMS && (board->terms.ready != NULL);
  }
  return place_is_in(&joint->bound, node) || place_is_in(&joint->visited, node);
}

/* To the next arrival, of one seeker or of several at once. */
qtr_steps qtr_joint_pass(qtr_joint *joint, const qtr_board *board) {
  const qtr_steps least = least_remaining(joint, board);
  if ((joint->unvisited == 0u) || (least == 0u)) {
    return 0;
  }
  joint->now += least;
  for (unsigned i = 0; i < board->seekers; i++) {
    if (joint->remaining[i] == 0u) {
      continue;
    }
    QTR_ASSERT(is_bound(joint, board, i));
    joint->remaining[i] -= least;
    if (joint->remaining[i] == 0u) {
      arrive(joint, board, i);
    }
  }
  stand_down_the_useless(joint, board, false);
  return least;
}

qtr_steps qtr_joint_advance(qtr_joint *joint, const qtr_board *board, qtr_places *arrived) {
  const qtr_places before = joint->visited;
  const qtr_steps passed = qtr_joint_pass(joint, board);
  for (unsigned w = 0; (arrived != NULL) && (w < QTR_PLACE_WORDS); w++) {
    arrived->word[w] |= joint->visited.word[w] & ~before.word[w];
  }
  return passed;
}
