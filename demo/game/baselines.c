#include "baselines.h"

#include <limits.h>
#include <string.h>

static bool is_left_out(const baseline *b, unsigned place) {
  if (qtr_places_has(&b->blocked, place)) return true;
  if (b->crew == NULL) return qtr_places_has(&b->scanned, place);
  for (int i = 0; i < b->robots; i++)
    if (qtr_places_has(&b->crew[i].scanned, place) || (i != b->self && b->crew[i].target == place)) return true;
  return false;
}

/* How many looks at its place come before one. */
static int round_of(const baseline *b, unsigned look) {
  int before = 0;
  for (unsigned other = 0; other < look; other++)
    before += qtr_policy_place(b->policy, other) == qtr_policy_place(b->policy, look);
  return before;
}

static void choose(baseline *b) {
  const qtr_board *board = &b->policy->board;
  qtr_steps least = QTR_NEVER;
  int first = INT_MAX;
  b->target = QTR_STAND_DOWN;
  if (b->found) return;
  for (unsigned place = 0; place < board->places; place++) {
    const qtr_steps steps = place == b->node ? 0 : qtr_board_steps(board, (unsigned)b->self, b->node, place);
    const int round = round_of(b, place);
    if (steps == QTR_NEVER || is_left_out(b, place) || round > first || (round == first && steps >= least)) continue;
    least = steps;
    first = round;
    b->target = (uint16_t)place;
  }
}

/* Who has nothing to do looks again: what another was bound for may be free now. */
static uint16_t target(void *self) {
  baseline *b = self;
  if (b->target == QTR_STAND_DOWN) choose(b);
  return b->target;
}

static void visited(void *self, uint16_t place) {
  baseline *b = self;
  qtr_places_add(&b->scanned, place);
  b->node = place;
  choose(b);
}

static void blocked(void *self, uint16_t place) {
  baseline *b = self;
  qtr_places_add(&b->blocked, place);
  choose(b);
}

static void found(void *self) {
  baseline *b = self;
  b->found = true;
  b->target = QTR_STAND_DOWN;
}

static bool hear(void *self, const qtr_signal *signal) {
  if (signal->kind == QTR_SIGNAL_FOUND) found(self);
  return true;
}

static bool announce(void *self, qtr_signal *signal) {
  (void)self;
  (void)signal;
  return false;
}

/* Territories are nothing to it. */
static bool known(void *self, unsigned index, qtr_signal *signal) {
  const baseline *b = self;
  if (!b->found || index > 0) return false;
  *signal = (qtr_signal){.kind = QTR_SIGNAL_FOUND};
  return true;
}

void baseline_init(baseline *b, const qtr_policy *policy, int self, baseline *crew) {
  memset(b, 0, sizeof *b);
  b->policy = policy;
  b->self = self;
  b->crew = crew;
  b->robots = policy->board.seekers;
  b->node = (unsigned)policy->board.places + policy->board.start_of[self];
  b->target = QTR_STAND_DOWN;
}

robot_pilot baseline_pilot(baseline *b) {
  return (robot_pilot){b, 0, 0, target, visited, blocked, found, hear, announce, known};
}
